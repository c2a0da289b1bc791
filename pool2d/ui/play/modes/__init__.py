"""The ways to play: practice, a match, a drill."""
