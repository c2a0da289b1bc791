"""A row of a list page: a name, a note on its right, perhaps a text below, and a cross that deletes it."""

from __future__ import annotations

from collections.abc import Callable

import pygame

from ...draw import text, theme
from .widget import Button, face, plate, tone


class ListRow(Button):
    """A row that opens something when it is clicked, or by Enter.

    `remove`, where given, deletes that: on Delete or a click on the cross, the second time, the first asking to
    confirm by what `sure` asks.
    """

    def __init__(
        self, label: str, do: Callable[[], None], note: str = "", below: str = "",
        remove: Callable[[], None] | None = None, sure: str = "",
    ) -> None:  # fmt: skip
        super().__init__(label, do)
        self.note = note
        self.below = below
        self.remove = remove
        self.sure = sure
        self.rows = 2.0 if below else 1.4
        self._asked = False
        self._cross = 0

    def release(self, pos: tuple[int, int]) -> None:
        if not self.rect.collidepoint(pos):
            return
        if self.remove is not None and pos[0] > self.rect.right - self._cross:
            self._throw()
        else:
            self.do()

    def leave(self) -> None:
        self._asked = False

    def key(self, key: int, mod: int) -> bool:
        if key == pygame.K_DELETE and self.remove is not None:
            self._throw()
            return True
        return super().key(key, mod)

    def _throw(self) -> None:
        if self._asked and self.remove is not None:
            self.remove()
        self._asked = not self._asked

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        box = self.rect.inflate(0, -unit // 2)
        plate(surface, box, face(self.pressed, hovered), unit, tone(hovered))
        large, small = unit * 7 // 4, unit * 3 // 2
        line = box.top + (box.height * 3 // 10 if self.below else box.height // 2)
        right = box.right - unit
        if self.remove is not None:
            cross = self.sure if self._asked else "\N{MULTIPLICATION SIGN}"
            color = theme.WARNING if self._asked else theme.TEXT if hovered else theme.QUIET
            right = text.draw(surface, cross, large, color, (right, line), (1.0, 0.5)).left - unit
            self._cross = self.rect.right - right
        if self.note:
            note = text.fitted(self.note, small, (right - box.left) // 2)
            right = text.draw(surface, note, small, theme.ACCENT, (right, line), (1.0, 0.5)).left - unit
        room = right - box.left - unit
        text.draw(surface, text.fitted(self.label, large, room), large, theme.TEXT, (box.left + unit, line), (0.0, 0.5))
        if self.below:
            told = text.fitted(self.below, small, box.width - 2 * unit)
            place = (box.left + unit, box.top + box.height * 7 // 10)
            text.draw(surface, told, small, theme.QUIET, place, (0.0, 0.5))
