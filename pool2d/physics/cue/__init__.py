"""The cue: its body, and what it does once it has struck."""
