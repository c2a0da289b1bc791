"""A table's knobs by what its balls did: tracked shots, and the launches and knobs that they are most like."""
