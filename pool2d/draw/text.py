"""Text in the one bundled font: measured, wrapped and cached. Whatever it holds, what is drawn can be shown."""

from __future__ import annotations

from bisect import bisect_right
from functools import lru_cache
from pathlib import Path

import pygame

from ..config.assets import asset
from ..printable import LONGEST, printable
from .theme import Color

# Font files that could not be read, by anybody so far; as long as the fonts below, which stand in for them.
unreadable: set[Path] = set()


@lru_cache(maxsize=32)
def font(size: int) -> pygame.font.Font:
    """The font at a height of `size` pixels; pygame's own where the file is missing or damaged."""
    path = asset("fonts", "OpenSans-Semibold.ttf")
    size = max(1, size)
    try:
        made = pygame.font.Font(path, size)
        # A damaged file is only found out when the font is used.
        made.size("x")
        return made
    except (OSError, pygame.error):
        unreadable.add(path)
        return pygame.font.Font(None, size)


@lru_cache(maxsize=512)
def picture(text: str, size: int, color: Color) -> pygame.Surface:
    """One line of text as a surface."""
    return font(size).render(printable(text), True, color)


def draw(
    surface: pygame.Surface,
    text: str,
    size: int,
    color: Color,
    place: tuple[float, float],
    anchor: tuple[float, float] = (0.0, 0.0),
) -> pygame.Rect:
    """Draw one line; `anchor` says which point of it is put at `place`: (0, 0) top left, (0.5, 0.5) centre."""
    image = picture(text, size, color)
    corner = (round(place[0] - anchor[0] * image.get_width()), round(place[1] - anchor[1] * image.get_height()))
    return surface.blit(image, corner)


@lru_cache(maxsize=256)
def fitted(text: str, size: int, width: int) -> str:
    """The text, or as much of its beginning as fits into `width` pixels, with an ellipsis."""
    text = printable(text)
    if font(size).size(text)[0] <= width:
        return text
    return text[: _room(text, size, width, "\N{HORIZONTAL ELLIPSIS}")] + "\N{HORIZONTAL ELLIPSIS}"


def in_lines(text: str, size: int, width: int, most: int) -> tuple[str, ...]:
    """The text in lines no wider than `width` pixels; what is beyond the last of `most` is told by an ellipsis."""
    lines = wrap(text, size, width)
    if len(lines) <= most:
        return lines
    last = lines[most - 1] + " \N{HORIZONTAL ELLIPSIS}"
    return (*lines[: most - 1], last if font(size).size(last)[0] <= width else fitted(last, size, width))


@lru_cache(maxsize=128)
def wrap(text: str, size: int, width: int) -> tuple[str, ...]:
    """The text in lines no wider than `width` pixels; a word longer than that is broken."""
    lines: list[str] = []
    for word in map(printable, text[:LONGEST].split()):
        if lines and font(size).size(f"{lines[-1]} {word}")[0] <= width:
            lines[-1] += " " + word
            continue
        while font(size).size(word)[0] > width and len(word) > 1:
            cut = max(1, _room(word, size, width))
            lines.append(word[:cut])
            word = word[cut:]
        lines.append(word)
    return tuple(lines)


def _room(text: str, size: int, width: int, end: str = "") -> int:
    """How many of the first letters, and `end`, fit into `width` pixels."""
    return bisect_right(range(1, len(text) + 1), width, key=lambda count: font(size).size(text[:count] + end)[0])
