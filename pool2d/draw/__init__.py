"""Pixels from values: surfaces in, surfaces out; nothing here knows a scene."""

import os

# pygame greets on standard output, which is ours.
os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
