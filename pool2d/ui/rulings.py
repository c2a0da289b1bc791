"""What the rules say, for the player's eyes."""

from __future__ import annotations

from collections.abc import Sequence

from ..game.rules import Note, label, say


def told(note: Note, names: Sequence[str]) -> str:
    """A note of a ruling as a sentence; `names` are the players'."""
    return say(note, names)


def option(key: str) -> str:
    """What one of the options of `Ask.options` is called."""
    return label(key)
