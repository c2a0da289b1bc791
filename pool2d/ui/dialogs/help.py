"""The page that lists what keys and hands do."""

from __future__ import annotations

import math
from typing import NamedTuple

import pygame

from ... import __version__
from ...compiled import engine
from ...draw import shapes, text, theme
from ..frame import Frame
from ..scene import Scene
from ..screen import Screen
from ..wording.keys import HANDS, HELD, rows
from ..wording.words import Words
from .dialog import Overlay

Line = tuple[str, str]


class Help(Overlay):
    """The page that lists keys and mouse actions, over another scene; any key or click returns to that."""

    def __init__(self, below: Scene) -> None:
        super().__init__(below)
        self._page: _Page | None = None
        self._screen = Screen(1280, 720)

    @property
    def still(self) -> bool:
        return True

    def handle(self, event: pygame.event.Event) -> Scene | None:
        return self.below if event.type in (pygame.KEYDOWN, pygame.MOUSEBUTTONDOWN) else self

    def lay_out(self, size: tuple[int, int]) -> None:
        super().lay_out(size)
        self._screen = Screen(*size)
        self._page = _laid([*hands(self.words), ("", ""), *keys(self.words)], self._screen)

    def draw(self, frame: Frame) -> None:
        super().draw(frame)
        if self._page is not None:
            self._draw(frame.surface, self._screen, self._page)

    def _draw(self, surface: pygame.Surface, screen: Screen, page: _Page) -> None:
        unit = screen.unit
        box = pygame.Rect(0, 0, page.width, page.height)
        box.center = surface.get_rect().center
        shapes.panel(surface, box, unit)
        x, top = box.left + 3 * unit, box.top + 2 * unit
        title = text.draw(surface, self.words.say("help.title"), screen.large, theme.TEXT, (x, top))
        runs = self.words.say(f"help.{engine()}", version=__version__)
        right = box.right - 3 * unit
        runs = text.fitted(runs, page.size, max(0, right - title.right - 2 * unit))
        text.draw(surface, runs, page.size, theme.TEXT, (right, title.centery), (1.0, 0.5))
        top += 2 * screen.large + unit
        for column in page.columns:
            left, right = _widths(column, page.size)
            for i, (name, does) in enumerate(column):
                text.draw(surface, name, page.size, theme.ACCENT, (x, top + i * page.pitch))
                text.draw(surface, does, page.size, theme.TEXT, (x + left + 2 * unit, top + i * page.pitch))
            x += left + right + 5 * unit


def hands(words: Words) -> list[Line]:
    """What the mouse does, as pairs of an action's name and its effect, in the present language."""
    return [(words.say(f"hand.{name}.name"), words.say(f"hand.{name}.does")) for name in HANDS]


def keys(words: Words) -> list[Line]:
    """What the keys do, as pairs of the keys bound at present and their effect."""
    lines = []
    for actions in rows():
        shown = words.key(*actions)
        name = words.say("help.hold", keys=shown) if actions[0] in HELD else shown
        lines.append((name, words.say(f"help.{actions[0]}")))
    return lines


class _Page(NamedTuple):
    """A laid-out page: the columns of lines; size of the letters, line spacing, width and height, in pixels."""

    columns: list[list[Line]]
    size: int
    pitch: int
    width: int
    height: int


def _laid(lines: list[Line], screen: Screen) -> _Page:
    """The layout in that number of columns which lets the letters be largest."""
    page = None
    for size in range(screen.small, 0, -1):
        for count in (1, 2, 3):
            page = _in_columns(lines, count, size, screen)
            if page.width <= screen.width and page.height <= screen.height:
                return page
    assert page is not None
    return page


def _in_columns(lines: list[Line], count: int, size: int, screen: Screen) -> _Page:
    unit, pitch = screen.unit, text.font(size).get_linesize()
    most = math.ceil(len(lines) / count)
    columns = [lines[i : i + most] for i in range(0, len(lines), most)]
    width = sum(sum(_widths(column, size)) + 5 * unit for column in columns) + 3 * unit
    return _Page(columns, size, pitch, width, pitch * most + 2 * screen.large + 5 * unit)


def _widths(lines: list[Line], size: int) -> tuple[int, int]:
    """How wide the two columns of a list are, names and effects, in pixels."""
    left, right = (max(text.font(size).size(line[i])[0] for line in lines) for i in (0, 1))
    return left, right
