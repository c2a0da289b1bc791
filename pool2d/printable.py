"""Where text from outside becomes text that is shown, in a window or on a terminal.

A file, a file's name, a clipboard may hold anything: control characters that steer a terminal, marks that turn the
direction of writing round, characters without width, halves of characters, NUL, or far more than anybody reads.
"""

from __future__ import annotations

import unicodedata

# What no screen shows in one line.
LONGEST = 2000


def is_shown(char: str) -> bool:
    """Whether a character can be shown as it is: one with a look, or a blank of any width."""
    return char.isprintable() or unicodedata.category(char) == "Zs"


def printable(text: str, most: int = LONGEST) -> str:
    """Text on one line of up to `most` characters; what has no look of its own is shown as its escape."""
    if len(text) > most:
        text = text[: max(0, most - 3)] + "..."
    if text.isprintable():
        return text
    return "".join(char if is_shown(char) else repr(char)[1:-1] for char in text)
