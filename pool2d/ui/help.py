"""The page that lists what keys and hands do."""

from __future__ import annotations

import pygame

from . import text, theme
from .hud import Screen
from .keys import BINDINGS, HANDS
from .scene import Scene


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
        self.below.draw(surface)
        screen = Screen(*surface.get_size())
        rows = [*HANDS, ("", ""), *((binding.shown, binding.does) for binding in BINDINGS if binding.shown)]
        unit = screen.unit
        size = screen.small
        pitch = min(size * 5 // 3, (screen.height - 10 * unit) // (len(rows) + 2))
        left = max(text.font(size).size(name)[0] for name, _ in rows)
        right = max(text.font(size).size(does)[0] for _, does in rows)
        page = pygame.Rect(0, 0, left + right + 9 * unit, pitch * (len(rows) + 2) + 5 * unit)
        page.center = surface.get_rect().center
        veil = pygame.Surface(surface.get_size(), pygame.SRCALPHA)
        veil.fill(theme.VEIL)
        surface.blit(veil, (0, 0))
        panel = pygame.Surface(page.size, pygame.SRCALPHA)
        pygame.draw.rect(panel, theme.PANEL, panel.get_rect(), border_radius=unit)
        surface.blit(panel, page)
        x, y = page.left + 3 * unit, page.top + 2 * unit
        text.draw(surface, "What keys and hands do", screen.large, theme.TEXT, (x, y))
        y += 2 * pitch + unit
        for name, does in rows:
            text.draw(surface, name, size, theme.ACCENT, (x, y))
            text.draw(surface, does, size, theme.TEXT, (x + left + 3 * unit, y))
            y += pitch
