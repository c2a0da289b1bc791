"""The window: the only part that knows pygame."""

import os

# pygame greets on standard output, which is ours.
os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
