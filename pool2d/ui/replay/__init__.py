"""Recorded matches on the screen."""
