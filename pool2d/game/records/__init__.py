"""Matches written down as they are played, and played again."""
