"""The cue once it has struck."""
