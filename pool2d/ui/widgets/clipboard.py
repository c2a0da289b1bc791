"""The system's clipboard, where there is one."""

from __future__ import annotations

import pygame

# A system without a clipboard, a pygame without the module, one that is too old.
_NONE = (pygame.error, AttributeError, NotImplementedError)


def get() -> str | None:
    """The text on the system's clipboard; None where there is no clipboard."""
    try:
        return pygame.scrap.get_text()
    except _NONE:
        return None


def put(words: str) -> bool:
    """Put a text on the system's clipboard; False where there is no clipboard."""
    try:
        pygame.scrap.put_text(words)
    except _NONE:
        return False
    return True
