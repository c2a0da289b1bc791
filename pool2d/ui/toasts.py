"""Short notes that slide in at the upper right, stay while they are read, and slide out."""

from __future__ import annotations

from dataclasses import dataclass

import pygame

from ..draw import shapes, text, theme
from ..printable import printable
from .screen import Screen

# How long a note slides, s, and how long it stays: so much, and more for each letter.
_SLIDE, _STAY, _LETTER = 0.18, 2.5, 0.05
# More than this many at once would cover the table; the others wait.
_MOST = 4
_LONGEST = 400


@dataclass(slots=True)
class Toast:
    """What is said, whether something is wrong, and for how long it has been in sight, s."""

    words: str
    wrong: bool
    age: float = 0.0

    @property
    def life(self) -> float:
        return 2.0 * _SLIDE + _STAY + _LETTER * len(self.words)

    @property
    def sight(self) -> float:
        """How far it has come in, 0 to 1."""
        part = min(self.age, self.life - self.age) / _SLIDE
        part = min(max(part, 0.0), 1.0)
        return part * part * (3.0 - 2.0 * part)


class Toasts:
    """The notes in sight, the oldest on top, and those that wait. `still` ones appear without sliding."""

    def __init__(self) -> None:
        self.notes: list[Toast] = []
        self.still = False

    def say(self, words: str, wrong: bool = False) -> None:
        """Show a note, of some lines at most; one that is there already stays longer instead."""
        words = printable(words, _LONGEST)
        for note in self.notes:
            if note.words == words:
                note.age = min(note.age, _SLIDE)
                return
        self.notes.append(Toast(words, wrong))

    def update(self, dt: float) -> None:
        for note in self.notes[:_MOST]:
            note.age += dt
        self.notes = [note for note in self.notes if note.age < note.life]

    def draw(self, surface: pygame.Surface) -> None:
        screen = Screen(*surface.get_size())
        y = float(screen.top.bottom + screen.unit)
        for note in self.notes[:_MOST]:
            part = 1.0 if self.still else note.sight
            y += part * (self._draw(surface, screen, note, round(y), part) + screen.unit)

    def _draw(self, surface: pygame.Surface, screen: Screen, note: Toast, y: int, part: float) -> int:
        """Draw one note, come in so far; returns its height."""
        unit, size = screen.unit, screen.small
        lines = text.wrap(note.words, size, min(64 * unit, screen.width - 8 * unit))
        pitch = text.font(size).get_linesize()
        width = max(text.font(size).size(line)[0] for line in lines) + 4 * unit
        box = pygame.Rect(0, y, width, pitch * len(lines) + 2 * unit)
        box.left = screen.width - round(part * (width + unit))
        shapes.panel(surface, box, unit)
        color = theme.WARNING if note.wrong else theme.ACCENT
        pygame.draw.rect(surface, color, (box.left + unit, box.top + unit, max(2, unit // 3), box.height - 2 * unit))
        for i, line in enumerate(lines):
            text.draw(surface, line, size, theme.TEXT, (box.left + 5 * unit // 2, box.top + unit + i * pitch))
        return box.height
