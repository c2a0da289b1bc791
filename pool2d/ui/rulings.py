"""What the rules say, for the screen."""

from __future__ import annotations

from collections.abc import Sequence

from ..game.rules import Note, label, say


def told(note: Note, names: Sequence[str]) -> str:
    """A note as a sentence."""
    return say(note, names)


def option(key: str) -> str:
    """What an option is called."""
    return label(key)
