"""A table's knobs by what its balls did: tracked shots, or measurements made by hand, and what they are most like."""
