"""Players at work without a screen: matches against each other, drills, and what both say of them."""
