"""The base of all widgets, and the simple ones: heading, gap, button, toggle, tabs.

A widget has a place and takes the events that its form hands it. Each works by mouse and by keyboard; colours and
measures come from `draw.theme`.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from itertools import accumulate, pairwise

import pygame

from ...draw import pen, shapes, text, theme


class Widget:
    """What every control has.

    `rows` is its height in rows of the form, `rect` its place in pixels. `hint` is shown while the pointer rests on
    it. A `greedy` one gets every key while it has the focus, Tab and Esc too. The form draws a ring round the
    focused widget, wider and taller than it by `margin`, in units of the grid; one that is not `ringed` shows its
    focus itself. The form keeps two fields up to date: `held`, whether the mouse button is down on it, and
    `pointer`, where the pointer is while it is over it.
    """

    rows = 1.0
    focusable = True
    greedy = False
    ringed = True
    margin = (1.5, 0.0)
    hint = ""

    def __init__(self) -> None:
        self.rect = pygame.Rect(0, 0, 0, 0)
        self.held = False
        self.pointer: tuple[int, int] | None = None

    @property
    def pressed(self) -> bool:
        """Whether it looks pressed: the button is down on it and the pointer still over it, so a release would act."""
        return self.held and self.pointer is not None

    def press(self, pos: tuple[int, int]) -> None:
        """The button went down on it."""

    def drag(self, pos: tuple[int, int]) -> None:
        """The pointer moved with the button down."""

    def release(self, pos: tuple[int, int]) -> None:
        """The button went up again."""

    def leave(self) -> None:
        """It loses the focus."""

    def key(self, key: int, mod: int) -> bool:
        """Take a key while it has the focus; returns whether it had a use for it."""
        return False

    def type(self, words: str) -> None:
        """Take typed text while it has the focus."""

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        """Draw it in its place."""


def plate(surface: pygame.Surface, rect: pygame.Rect, color: theme.Color, unit: int, edge: theme.Color | None) -> None:
    """A rounded rectangle, with an edge or without."""
    shapes.rounded(surface, rect, color, unit * 3 // 4, edge, max(1, unit // 6))


def face(pressed: bool, hovered: bool) -> theme.Color:
    """The fill colour of something that can be pressed."""
    return theme.FACE_DOWN if pressed else theme.FACE_LIT if hovered else theme.FACE


def ring(surface: pygame.Surface, widget: Widget, unit: int) -> None:
    """Draw the ring that marks the focus."""
    wider, taller = widget.margin
    rect = widget.rect.inflate(round(unit * wider), round(unit * taller))
    shapes.rounded(surface, rect, None, unit, theme.ACCENT, max(2, unit // 5))


def scroll_mark(rect: pygame.Rect, first: int, seen: int, whole: int, unit: int) -> pygame.Rect | None:
    """The scroll bar's handle at the right edge of `rect`; None where everything is in sight.

    `first` is the first row in sight, `seen` how many are, `whole` how many there are.
    """
    if whole <= seen:
        return None
    room = rect.height - unit
    height = max(2 * unit, room * seen // whole)
    top = rect.top + unit // 2 + (room - height) * first // (whole - seen)
    return pygame.Rect(rect.right - unit, top, max(2, unit * 5 // 8), height)


def tone(hovered: bool) -> theme.Color:
    """The colour of an edge."""
    return theme.QUIET if hovered else theme.EDGE


class Heading(Widget):
    """A text that does nothing, wrapped into as many lines as its rows have room for."""

    focusable = False

    def __init__(
        self, words: Callable[[], str], color: theme.Color = theme.QUIET, large: bool = False, lines: int = 1
    ) -> None:
        super().__init__()
        self.words = words
        self.color = color
        self.large = large
        self.lines = lines
        self.rows = max(1.0, 0.8 * lines)

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        size = unit * 5 // 2 if self.large else unit * 7 // 4
        words = self.words()
        if self.lines == 1:
            line = text.fitted(words, size, self.rect.width)
            text.draw(surface, line, size, self.color, (self.rect.left, self.rect.centery), (0.0, 0.5))
            return
        pitch = text.font(size).get_linesize()
        for i, line in enumerate(text.in_lines(words, size, self.rect.width, self.lines)):
            text.draw(surface, line, size, self.color, (self.rect.left, self.rect.top + i * pitch))


class Gap(Widget):
    """Empty space between other widgets."""

    focusable = False

    def __init__(self, rows: float) -> None:
        super().__init__()
        self.rows = rows


class Button(Widget):
    """Calls `do` when it is pressed and released, or on Enter or Space; greyed, and without effect, while `barred`."""

    rows = 1.5
    margin = (0.75, 0.3)

    def __init__(
        self, label: str, do: Callable[[], None], hint: str = "", strong: bool = False,
        barred: Callable[[], bool] = bool,
    ) -> None:  # fmt: skip
        super().__init__()
        self.label = label
        self.do = do
        self.barred = barred
        self.hint = hint
        self.strong = strong

    def release(self, pos: tuple[int, int]) -> None:
        if self.rect.collidepoint(pos) and not self.barred():
            self.do()

    def key(self, key: int, mod: int) -> bool:
        if key in (pygame.K_RETURN, pygame.K_KP_ENTER, pygame.K_SPACE):
            if not self.barred():
                self.do()
            return True
        return False

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        box = self.rect.inflate(0, -unit // 2)
        if self.barred():
            plate(surface, box, theme.FACE, unit, theme.EDGE)
            label = text.fitted(self.label, unit * 7 // 4, box.width - unit)
            text.draw(surface, label, unit * 7 // 4, theme.QUIET, box.center, (0.5, 0.5))
            return
        color = face(self.pressed, hovered)
        if self.strong:
            color = theme.ACCENT_DOWN if self.pressed else theme.ACCENT_LIT if hovered else theme.ACCENT
        plate(surface, box, color, unit, None if self.strong else tone(hovered))
        label = text.fitted(self.label, unit * 7 // 4, box.width - unit)
        sunk = (box.centerx, box.centery + (unit // 8 if self.pressed else 0))
        text.draw(surface, label, unit * 7 // 4, theme.BACKGROUND if self.strong else theme.TEXT, sunk, (0.5, 0.5))


class Toggle(Widget):
    """A switch that is on or off."""

    rows = 1.25

    def __init__(self, label: str, get: Callable[[], bool], put: Callable[[bool], None], hint: str = "") -> None:
        super().__init__()
        self.label = label
        self.get = get
        self.put = put
        self.hint = hint

    def press(self, pos: tuple[int, int]) -> None:
        self.put(not self.get())

    def key(self, key: int, mod: int) -> bool:
        if key in (pygame.K_RETURN, pygame.K_SPACE, pygame.K_LEFT, pygame.K_RIGHT):
            self.put(not self.get())
            return True
        return False

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        color = theme.ACCENT if focused else theme.TEXT
        label = text.fitted(self.label, unit * 7 // 4, self.rect.width - 5 * unit)
        text.draw(surface, label, unit * 7 // 4, color, (self.rect.left, self.rect.centery), (0.0, 0.5))
        track = pygame.Rect(0, 0, unit * 4, unit * 2)
        track.midright = self.rect.midright
        on = self.get()
        lit = theme.ACCENT_LIT if hovered else theme.ACCENT
        unlit = theme.QUIET if hovered else theme.EDGE
        shapes.rounded(surface, track, lit if on else unlit, unit)
        x = track.right - unit if on else track.left + unit
        pen.disc(surface, theme.TEXT, (x, track.centery), unit * (0.65 if self.pressed else 0.8))


class Tabs(Widget):
    """Names side by side, one of which is open; `shown` gives the text for a name, which has the room it needs."""

    rows = 1.5

    def __init__(
        self, names: Sequence[str], get: Callable[[], str], put: Callable[[str], None],
        shown: Callable[[str], str] = str,
    ) -> None:  # fmt: skip
        super().__init__()
        self.names = list(names)
        self.get = get
        self.put = put
        self.shown = shown
        self._unit = 8

    def press(self, pos: tuple[int, int]) -> None:
        at = bisect_right([left for left, _ in self.spans()], pos[0]) - 1
        self.put(self.names[max(at, 0)])

    def key(self, key: int, mod: int) -> bool:
        if key in (pygame.K_LEFT, pygame.K_RIGHT):
            step = 1 if key == pygame.K_RIGHT else -1
            self.put(self.names[(self.names.index(self.get()) + step) % len(self.names)])
            return True
        return False

    def spans(self) -> list[tuple[int, int]]:
        """Where each tab begins and ends, in pixels: what the texts leave is shared out evenly."""
        widths = self._widths(self._size())
        spare = (self.rect.width - sum(widths)) / len(widths)
        edges = [self.rect.left + round(edge) for edge in accumulate((width + spare for width in widths), initial=0.0)]
        return list(pairwise(edges))

    def _widths(self, size: int) -> list[int]:
        return [text.font(size).size(self.shown(name))[0] for name in self.names]

    def _size(self) -> int:
        """The height of the texts: less than usual only where they would not find room."""
        size = max(1, self._unit * 3 // 2)
        while size > 1 and sum(self._widths(size)) + len(self.names) * self._unit > self.rect.width:
            size -= 1
        return size

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        self._unit = unit
        size = self._size()
        for name, (left, right) in zip(self.names, self.spans(), strict=True):
            over = self.pointer is not None and hovered and left <= self.pointer[0] < right
            tab = pygame.Rect(left, self.rect.top, right - left - 1, self.rect.height)
            tab.inflate_ip(-unit // 4, -unit // 2)
            here = name == self.get()
            plate(surface, tab, theme.FACE_LIT if here else theme.FACE, unit, tone(over) if here else None)
            color = theme.TEXT if here or over else theme.QUIET
            text.draw(surface, self.shown(name), size, color, tab.center, (0.5, 0.5))
