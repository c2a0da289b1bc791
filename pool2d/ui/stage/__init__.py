"""A table on the screen and a shot running on it, for play and replay alike."""
