"""A line of text to type in, with a cursor, a selection and the clipboard."""

from __future__ import annotations

import pygame

from ...draw import text, theme
from . import clipboard
from .widget import Widget, plate, tone


class TextField(Widget):
    """A line of text to type in.

    `start` and `cursor` are indices between letters; the text between them, in either order, is selected, and
    typing replaces it. Left, Right, Home and End move the cursor (Ctrl by words, Shift selecting); Ctrl+A, C, X and
    V select all, copy, cut and paste.
    """

    rows = 2.4
    # Its cursor and its edge show the focus.
    ringed = False

    def __init__(self, label: str, value: str = "", limit: int = 40) -> None:
        super().__init__()
        self.label = label
        self.value = value
        self.limit = limit
        # What an empty field stands for.
        self.instead = ""
        self.cursor = self.start = len(value)
        self._size = 14
        # How far the text is moved to the left to keep the cursor in sight, in pixels.
        self._shift = 0

    @property
    def selected(self) -> tuple[int, int]:
        """The selection as two indices, the lower first; the same twice where nothing is selected."""
        return min(self.start, self.cursor), max(self.start, self.cursor)

    def select_all(self) -> None:
        self.start, self.cursor = 0, len(self.value)

    def type(self, words: str) -> None:
        """Insert a text in place of the selection, as much of it as the field may hold."""
        first, last = self.selected
        room = self.limit - len(self.value) + last - first
        new = "".join(char for char in words if char.isprintable())[: max(0, room)]
        self.value = self.value[:first] + new + self.value[last:]
        self.start = self.cursor = first + len(new)

    def press(self, pos: tuple[int, int]) -> None:
        self.start = self.cursor = self._at(pos[0])

    def drag(self, pos: tuple[int, int]) -> None:
        self.cursor = self._at(pos[0])

    def key(self, key: int, mod: int) -> bool:
        ctrl = bool(mod & (pygame.KMOD_CTRL | pygame.KMOD_META))
        if ctrl and key in (pygame.K_a, pygame.K_c, pygame.K_x, pygame.K_v):
            self._edit(key)
        elif key in (pygame.K_BACKSPACE, pygame.K_DELETE):
            if self.start == self.cursor:
                self.start = self._step(-1 if key == pygame.K_BACKSPACE else 1, ctrl)
            self.type("")
        elif key in (pygame.K_LEFT, pygame.K_RIGHT, pygame.K_HOME, pygame.K_END):
            self._move(key, ctrl, bool(mod & pygame.KMOD_SHIFT))
        else:
            # A letter comes again as text; taking it here keeps it from meaning something else below.
            return key < 128 and chr(key).isprintable() and not ctrl
        return True

    def _edit(self, key: int) -> None:
        first, last = self.selected
        if key == pygame.K_a:
            self.select_all()
        elif key == pygame.K_v:
            self.type(clipboard.get() or "")
        elif first != last:
            clipboard.put(self.value[first:last])
            if key == pygame.K_x:
                self.type("")

    def _move(self, key: int, ctrl: bool, shift: bool) -> None:
        back = key in (pygame.K_LEFT, pygame.K_HOME)
        if key in (pygame.K_HOME, pygame.K_END):
            self.cursor = 0 if back else len(self.value)
        elif self.start != self.cursor and not shift:
            # As everywhere, an arrow first leaves the selection, on its own side.
            self.cursor = self.selected[0 if back else 1]
        else:
            self.cursor = self._step(-1 if back else 1, ctrl)
        if not shift:
            self.start = self.cursor

    def _step(self, by: int, word: bool) -> int:
        """The index a letter, or with `word` a word, to the right of the cursor, or to the left for `by` = -1."""
        at = min(max(self.cursor + by, 0), len(self.value))
        while word and 0 < at < len(self.value) and not (self.value[at - 1] == " " != self.value[at]):
            at += by
        return at

    def _at(self, x: int) -> int:
        """The index between letters that is nearest to a pixel's x."""
        left = self.rect.left + self._size * 4 // 7 - self._shift
        width = text.font(self._size).size
        return min(range(len(self.value) + 1), key=lambda at: abs(left + width(self.value[:at])[0] - x))

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        size = self._size = unit * 7 // 4
        text.draw(surface, text.fitted(self.label, size, self.rect.width), size, theme.QUIET, self.rect.topleft)
        box = pygame.Rect(self.rect.left, self.rect.bottom - unit * 7 // 2, self.rect.width, unit * 3)
        plate(surface, box, theme.FACE, unit, theme.ACCENT if focused else tone(hovered))
        inner = box.inflate(-2 * unit, -unit // 2)
        width = text.font(size).size
        caret = width(self.value[: self.cursor])[0]
        self._shift = min(max(self._shift, caret - inner.width + 2), caret)
        before = surface.get_clip()
        surface.set_clip(inner.inflate(2, 0).clip(before))
        left = inner.left - self._shift
        first, last = (width(self.value[:at])[0] for at in self.selected)
        if focused and first != last:
            surface.fill(theme.SELECTED, (left + first, inner.top, last - first, inner.height))
        # What is typed in is seen around the cursor; left alone, that it goes on is told.
        shown = self.value if focused else text.fitted(self.value, size, inner.width)
        text.draw(surface, shown, size, theme.TEXT, (left if focused else inner.left, box.centery), (0.0, 0.5))
        if not self.value and not focused:
            text.draw(surface, self.instead, size, theme.QUIET, (inner.left, box.centery), (0.0, 0.5))
        if focused:
            surface.fill(theme.ACCENT, (left + caret, inner.top, max(1, unit // 6), inner.height))
        surface.set_clip(before)
