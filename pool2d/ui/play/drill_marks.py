"""What a drill asks for, marked on the cloth."""

from __future__ import annotations

import math

import pygame

from ...draw import pen, theme
from ...draw.view import View
from ...game.drills.drill import RestArea, Step
from ...table.table import Table

# How strongly an area of the cloth is marked, of 255.
_TINT = 42


def draw(surface: pygame.Surface, view: View, table: Table, step: Step) -> None:
    """Mark the pocket that is called, and where balls have to come to rest."""
    for rest in step.rest:
        _area(surface, view, table, rest)
    for pocket in table.geometry.pockets:
        if pocket.name == step.pocket:
            pen.ring(surface, theme.ACCENT, view.to_screen(pocket.x, pocket.y), pocket.radius * view.scale, 2.5)


def _area(surface: pygame.Surface, view: View, table: Table, rest: RestArea) -> None:
    """Tint where a ball has to come to rest, its middle within."""
    color = theme.IVORY if rest.ball == table.furniture.cue else theme.GUIDE_BALL
    if rest.at is not None:
        centre, radius = view.to_screen(*rest.at), rest.within * view.scale
        if math.isfinite(radius):
            pen.disc(surface, (*color[:3], _TINT), centre, radius)
            pen.ring(surface, color, centre, radius, 1.5)
        return
    size = table.knobs.table
    left, top = view.to_screen(max(0.0, rest.x[0]), min(size.width, rest.y[1]))
    right, bottom = view.to_screen(min(size.length, rest.x[1]), max(0.0, rest.y[0]))
    box = pygame.Rect(round(left), round(top), round(right - left), round(bottom - top))
    tint = pygame.Surface(box.size, pygame.SRCALPHA)
    tint.fill((*color[:3], _TINT))
    surface.blit(tint, box)
    pygame.draw.rect(surface, color, box, 1)
