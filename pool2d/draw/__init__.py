"""Pixels from values: surfaces in, surfaces out; nothing here knows a scene."""
