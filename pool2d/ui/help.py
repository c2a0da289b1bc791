"""The page that lists what keys and hands do."""

from __future__ import annotations

import pygame

from . import shapes, text, theme
from .dialog import ground
from .hud import Screen
from .keys import HANDS, HELD, KEYS, rows
from .scene import Scene
from .words import say

Line = tuple[str, str]


class Help:
    """A page over another scene; any key or click goes back to it."""

    def __init__(self, below: Scene) -> None:
        self.below = below

    @property
    def still(self) -> bool:
        return True

    def handle(self, event: pygame.event.Event) -> Scene | None:
        return self.below if event.type in (pygame.KEYDOWN, pygame.MOUSEBUTTONDOWN) else self

    def update(self, dt: float) -> Scene | None:
        return self

    def draw(self, surface: pygame.Surface) -> None:
        ground(self.below).draw(surface)
        screen = Screen(*surface.get_size())
        lines = [*hands(), ("", ""), *keys()]
        size, pitch, left, right = _measures(lines, screen)
        unit = screen.unit
        page = pygame.Rect(0, 0, left + right + 9 * unit, pitch * len(lines) + 2 * screen.large + 5 * unit)
        page.center = surface.get_rect().center
        shapes.veil(surface)
        shapes.panel(surface, page, unit)
        x, y = page.left + 3 * unit, page.top + 2 * unit
        text.draw(surface, say("help.title"), screen.large, theme.TEXT, (x, y))
        y += 2 * screen.large + unit
        for name, does in lines:
            text.draw(surface, name, size, theme.ACCENT, (x, y))
            text.draw(surface, does, size, theme.TEXT, (x + left + 3 * unit, y))
            y += pitch


def hands() -> list[Line]:
    """What hands do: the grip and what it leads to."""
    return [(say(f"hand.{name}.name"), say(f"hand.{name}.does")) for name in HANDS]


def keys() -> list[Line]:
    """What keys do at present: the keys and what they lead to."""
    lines = []
    for actions in rows():
        shown = KEYS.shown(*actions)
        name = say("help.hold", keys=shown) if actions[0] in HELD else shown
        lines.append((name, say(f"help.{actions[0]}")))
    return lines


def _measures(lines: list[Line], screen: Screen) -> tuple[int, int, int, int]:
    """The largest letters that let all lines into the window: their size, the pitch, and both columns' widths."""
    unit = screen.unit
    for size in range(screen.small, 0, -1):
        left, right = (max(text.font(size).size(line[i])[0] for line in lines) for i in (0, 1))
        pitch = min(size * 5 // 3, (screen.height - 2 * screen.large - 7 * unit) // len(lines))
        if pitch >= text.font(size).get_linesize() * 4 // 5 and left + right + 9 * unit <= screen.width:
            break
    return size, pitch, left, right
