"""Widgets that hold a value: slider, selector, list box."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import pygame

from ...config.knobs import Knob
from ...draw import pen, shapes, text, theme
from .widget import Widget, face, plate, scroll_mark, tone

_BACK = "\N{SINGLE LEFT-POINTING ANGLE QUOTATION MARK}"
_ON = "\N{SINGLE RIGHT-POINTING ANGLE QUOTATION MARK}"


class Slider(Widget):
    """A number within a knob's range. Left and Right move it (Shift finely, Ctrl coarsely); Delete resets it.

    `shown` gives the text for a value.
    """

    rows = 1.9

    def __init__(
        self, label: str, knob: Knob, get: Callable[[], float], put: Callable[[float], None],
        reset: Callable[[], None], hint: str = "", shown: Callable[[float], str] = str,
    ) -> None:  # fmt: skip
        super().__init__()
        self.label = label
        self.knob = knob
        self.shown = shown
        self.get = get
        self.put = put
        self.reset = reset
        self.hint = hint
        # Where a range spans several powers of ten, equal steps are equal ratios.
        self._log = knob.lo > 0.0 and knob.hi / knob.lo >= 50.0
        self._unit = 8

    def part(self, value: float) -> float:
        """Where a value lies in the range, from 0 to 1."""
        lo, hi = self.knob.lo, self.knob.hi
        return math.log(value / lo) / math.log(hi / lo) if self._log else (value - lo) / (hi - lo)

    def value(self, part: float) -> float:
        """The value at a place in the range, from 0 to 1, rounded to three or four digits."""
        lo, hi = self.knob.lo, self.knob.hi
        part = min(max(part, 0.0), 1.0)
        exact = lo * math.pow(hi / lo, part) if self._log else lo + part * (hi - lo)
        return min(max(float(f"{exact:.4g}"), lo), hi)

    def press(self, pos: tuple[int, int]) -> None:
        self.drag(pos)

    def drag(self, pos: tuple[int, int]) -> None:
        track = self._track()
        self.put(self.value((pos[0] - track.left) / max(1, track.width)))

    def key(self, key: int, mod: int) -> bool:
        if key in (pygame.K_LEFT, pygame.K_RIGHT):
            step = 0.001 if mod & pygame.KMOD_SHIFT else 0.1 if mod & pygame.KMOD_CTRL else 0.01
            self.put(self.value(self.part(self.get()) + (step if key == pygame.K_RIGHT else -step)))
        elif key in (pygame.K_HOME, pygame.K_END):
            self.put(self.knob.lo if key == pygame.K_HOME else self.knob.hi)
        elif key in (pygame.K_DELETE, pygame.K_BACKSPACE):
            self.reset()
        else:
            return False
        return True

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        self._unit = unit
        track, value = self._track(), self.get()
        top = self.rect.top + unit // 2
        color = theme.ACCENT if focused else theme.TEXT
        said = text.fitted(self.shown(value), unit * 7 // 4, self.rect.width * 2 // 3)
        told = text.draw(surface, said, unit * 7 // 4, theme.ACCENT, (self.rect.right, top), (1.0, 0.0))
        label = text.fitted(self.label, unit * 7 // 4, told.left - self.rect.left - unit)
        text.draw(surface, label, unit * 7 // 4, color, (self.rect.left, top))
        shapes.rounded(surface, track, theme.EDGE, track.height)
        x = round(track.left + self.part(value) * track.width)
        filled = pygame.Rect(track.left, track.top, x - track.left, track.height)
        shapes.rounded(surface, filled, theme.ACCENT, track.height)
        if focused or hovered or self.held:
            pen.disc(surface, theme.ACCENT_DOWN if self.held else theme.EDGE, (x, track.centery), unit * 1.3)
        pen.disc(surface, theme.TEXT, (x, track.centery), unit * 0.85)

    def _track(self) -> pygame.Rect:
        unit = self._unit
        return pygame.Rect(
            self.rect.left + unit, self.rect.bottom - unit * 7 // 4, self.rect.width - 2 * unit, unit // 2
        )


class Selector(Widget):
    """One of a few names, shown on one line: a click on its left or right half, Left or Right turn to another.

    `shown` gives the text for a name.
    """

    rows = 1.25

    def __init__(
        self, label: str, options: Callable[[], Sequence[str]], get: Callable[[], str], put: Callable[[str], None],
        hint: str = "", shown: Callable[[str], str] = str,
    ) -> None:  # fmt: skip
        super().__init__()
        self.label = label
        self.options = options
        self.get = get
        self.put = put
        self.hint = hint
        self.shown = shown

    def turn(self, by: int) -> None:
        options = list(self.options())
        at = options.index(self.get()) if self.get() in options else 0
        if options:
            self.put(options[(at + by) % len(options)])

    def press(self, pos: tuple[int, int]) -> None:
        self.turn(-1 if pos[0] < self._middle() else 1)

    def key(self, key: int, mod: int) -> bool:
        if key in (pygame.K_LEFT, pygame.K_RIGHT, pygame.K_SPACE, pygame.K_RETURN):
            self.turn(-1 if key == pygame.K_LEFT else 1)
            return True
        return False

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        size = unit * 7 // 4
        color = theme.ACCENT if focused else theme.TEXT
        box = pygame.Rect(self._middle() - self.rect.width * 3 // 10, self.rect.top, 0, self.rect.height)
        box.width = self.rect.right - box.left
        label = text.fitted(self.label, size, box.left - self.rect.left - unit // 2)
        text.draw(surface, label, size, color, (self.rect.left, self.rect.centery), (0.0, 0.5))
        box.inflate_ip(0, -unit // 2)
        plate(surface, box, face(self.pressed, hovered), unit, tone(hovered))
        over = 0 if self.pointer is None or not hovered else -1 if self.pointer[0] < self._middle() else 1
        back, on = (theme.TEXT if over == side else theme.QUIET for side in (-1, 1))
        text.draw(surface, _BACK, size, back, (box.left + unit, box.centery), (0.0, 0.5))
        text.draw(surface, _ON, size, on, (box.right - unit, box.centery), (1.0, 0.5))
        said = text.fitted(self.shown(self.get()), size, box.width - 5 * unit)
        text.draw(surface, said, size, theme.TEXT, box.center, (0.5, 0.5))

    def _middle(self) -> int:
        """The x that divides the halves, in pixels: a click to its left turns back."""
        return self.rect.left + self.rect.width * 7 // 10


class ListBox(Widget):
    """Names below each other, one of which is chosen; it scrolls to keep that one in sight.

    `shown` gives the text for a name.
    """

    def __init__(
        self, options: Callable[[], Sequence[str]], get: Callable[[], str], put: Callable[[str], None], lines: int = 8,
        shown: Callable[[str], str] = str,
    ) -> None:  # fmt: skip
        super().__init__()
        self.shown = shown
        self.options = options
        self.get = get
        self.put = put
        self.lines = lines
        self.rows = float(lines)

    def first(self) -> int:
        """The index of the first name in sight."""
        options = list(self.options())
        at = options.index(self.get()) if self.get() in options else 0
        return max(0, min(at - self.lines // 2, len(options) - self.lines))

    def press(self, pos: tuple[int, int]) -> None:
        options = list(self.options())
        line = self.first() + (pos[1] - self.rect.top) * self.lines // max(1, self.rect.height)
        if 0 <= line < len(options):
            self.put(options[line])

    def key(self, key: int, mod: int) -> bool:
        options = list(self.options())
        steps = {
            pygame.K_UP: -1, pygame.K_DOWN: 1, pygame.K_PAGEUP: 1 - self.lines, pygame.K_PAGEDOWN: self.lines - 1,
            pygame.K_HOME: -len(options), pygame.K_END: len(options),
        }  # fmt: skip
        if key not in steps or not options:
            return False
        at = options.index(self.get()) if self.get() in options else -1
        self.put(options[min(max(at + steps[key], 0), len(options) - 1)])
        return True

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        plate(surface, self.rect, theme.FACE, unit, tone(hovered))
        pitch = self.rect.height / self.lines
        first = self.first()
        mark = scroll_mark(self.rect, first, self.lines, len(self.options()), unit)
        width = self.rect.width - (0 if mark is None else unit)
        for i, name in enumerate(list(self.options())[first : first + self.lines]):
            line = pygame.Rect(self.rect.left, round(self.rect.top + i * pitch), width, round(pitch))
            over = hovered and self.pointer is not None and line.collidepoint(self.pointer)
            if name == self.get() or over:
                color = theme.SELECTED if name == self.get() else theme.FACE_LIT
                plate(surface, line.inflate(-unit // 2, -unit // 4), color, unit, None)
            shown = text.fitted(self.shown(name), unit * 7 // 4, line.width - 3 * unit)
            text.draw(surface, shown, unit * 7 // 4, theme.TEXT, (line.left + unit * 3 // 2, line.centery), (0.0, 0.5))
        if mark is not None:
            shapes.rounded(surface, mark, theme.QUIET if hovered else theme.EDGE, unit)
