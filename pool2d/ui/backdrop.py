"""The table without its balls, as any camera sees it; drawn once and then cut out and scaled."""

from __future__ import annotations

import math
from collections.abc import Hashable

import pygame

from ..table import Table
from . import table_art, theme
from .view import View

# What is seen from nearer is cut out of a picture this many times as large.
_NEAR = 2


class Backdrop:
    """Remembers the whole table, the larger picture of it once that is needed, and the part last cut out."""

    def __init__(self) -> None:
        self._key: Hashable = None
        self._whole = pygame.Surface((1, 1))
        self._large: pygame.Surface | None = None
        self._seen: View | None = None
        self._part = pygame.Surface((1, 1))

    def draw(self, surface: pygame.Surface, table: Table, home: View, view: View) -> None:
        """Draw the table as `view` has it; `home` is the view of the whole table."""
        size = surface.get_size()
        if (home, size, table) != self._key:
            self._key = (home, size, table)
            self._whole = table_art.draw(table, size, home)
            self._large = self._seen = None
        if view == home:
            surface.blit(self._whole, (0, 0))
            return
        if self._large is None:
            self._large = table_art.draw(table, (size[0] * _NEAR, size[1] * _NEAR), home.zoomed(_NEAR))
        if view != self._seen:
            self._seen = view
            self._part = _cut(self._large, size, home.zoomed(_NEAR), view)
        surface.blit(self._part, (0, 0))


def _cut(picture: pygame.Surface, size: tuple[int, int], given: View, view: View) -> pygame.Surface:
    """What `view` shows, scaled out of a picture drawn in the view `given`."""
    factor = view.scale / given.scale
    left, top = given.to_screen(*view.to_table(0.0, 0.0))
    right, bottom = given.to_screen(*view.to_table(float(size[0]), float(size[1])))
    box = pygame.Rect(math.floor(left), math.floor(top), 0, 0)
    box.width, box.height = math.ceil(right) - box.left, math.ceil(bottom) - box.top
    box = box.clip(picture.get_rect())
    part = pygame.Surface(size).convert() if pygame.display.get_surface() else pygame.Surface(size)
    part.fill(theme.BACKGROUND)
    scaled = pygame.transform.smoothscale(
        picture.subsurface(box), (round(box.width * factor), round(box.height * factor))
    )
    part.blit(scaled, (round((box.left - left) * factor), round((box.top - top) * factor)))
    return part
