"""The picture of the table behind everything, kept sharp without holding anything up."""

from __future__ import annotations

from collections.abc import Hashable

import pygame

from ..table import Table
from . import table_art, theme
from .view import View

# So many frames after the last change the picture is drawn in full.
_REST = 8


class Background:
    """Shows the table's picture; while the window or the table is being changed, a quick one in its place."""

    def __init__(self) -> None:
        self._made: Hashable = None
        self._picture: pygame.Surface | None = None
        # The last one drawn in full, which is what gets stretched, and its view.
        self._full: tuple[pygame.Surface, View] | None = None
        self._waiting = 0

    def show(self, surface: pygame.Surface, table: Table, view: View) -> None:
        """Fill the surface with the table as it is now."""
        size = surface.get_size()
        made = (table_art.content(table), size, view)
        if made != self._made:
            self._change(table, size, view)
            self._made = made
        elif self._waiting:
            self._waiting -= 1
            if not self._waiting:
                self._take(table_art.draw(table, size, view), view)
        assert self._picture is not None
        surface.blit(self._picture, (0, 0))

    def _change(self, table: Table, size: tuple[int, int], view: View) -> None:
        """Take a picture that is there already, or else a quick one until things rest."""
        ready = table_art.kept(table, size, view) if self._picture else table_art.draw(table, size, view)
        self._waiting = 0 if ready else _REST
        if ready:
            self._take(ready, view)
        elif self._full and isinstance(self._made, tuple) and self._made[0] == table_art.content(table):
            self._picture = _stretched(*self._full, size, view)
        else:
            self._full = None
            self._picture = table_art.draft(table, size, view)

    def _take(self, picture: pygame.Surface, view: View) -> None:
        self._picture = picture
        self._full = (picture, view)


def _stretched(picture: pygame.Surface, old: View, size: tuple[int, int], new: View) -> pygame.Surface:
    """A picture brought from one view to another."""
    factor = new.scale / old.scale
    width, height = picture.get_size()
    large = pygame.transform.smoothscale(picture, (round(width * factor), round(height * factor)))
    shown = pygame.Surface(size)
    shown.fill(theme.BACKGROUND)
    shown.blit(large, (round(new.left - old.left * factor), round(new.bottom - old.bottom * factor)))
    return shown
