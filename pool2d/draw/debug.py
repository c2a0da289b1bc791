"""The geometry that the physics sees, drawn by a small pen that a test can record."""

from __future__ import annotations

from typing import Protocol

import pygame

from ..physics.detect import Jaw, Pocket, Rail
from ..table.table import Table
from . import pen, theme
from .view import View


class Pen(Protocol):
    """Draws in metres, on the table."""

    def line(self, what: str, ax: float, ay: float, bx: float, by: float) -> None: ...

    def circle(self, what: str, x: float, y: float, radius: float) -> None: ...

    def box(self, what: str, left: float, bottom: float, right: float, top: float) -> None: ...


_COLORS: dict[str, theme.Color] = {
    "nose": (255, 236, 120),
    "jaw": (255, 170, 90),
    "drop": (255, 110, 110),
    "contact": (130, 210, 255),
    "broad phase": (150, 120, 190),
}


class ScreenPen:
    """A pen that draws on a surface; `what` a line stands for decides its colour."""

    def __init__(self, surface: pygame.Surface, view: View) -> None:
        self.surface = surface
        self.view = view

    def line(self, what: str, ax: float, ay: float, bx: float, by: float) -> None:
        pen.line(self.surface, _COLORS[what], self.view.to_screen(ax, ay), self.view.to_screen(bx, by), 1.2)

    def circle(self, what: str, x: float, y: float, radius: float) -> None:
        if radius * self.view.scale >= 1.0:
            pen.ring(self.surface, _COLORS[what], self.view.to_screen(x, y), radius * self.view.scale, 1.2)

    def box(self, what: str, left: float, bottom: float, right: float, top: float) -> None:
        corners = [(left, bottom), (right, bottom), (right, top), (left, top)]
        for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1], strict=True):
            self.line(what, ax, ay, bx, by)


def draw_geometry(pen: Pen, table: Table) -> None:
    """Noses, jaws and drops, how near to them a ball's centre comes, and the broad phase's boxes."""
    reach = table.reach(table.knobs.ball.radius)
    for box in table.boxes():
        pen.box("broad phase", *box)
    for element in table.elements:
        if isinstance(element, Rail):
            nx, ny = -element.dy * reach, element.dx * reach
            pen.line("nose", element.ax, element.ay, element.bx, element.by)
            pen.line("contact", element.ax + nx, element.ay + ny, element.bx + nx, element.by + ny)
        elif isinstance(element, Jaw):
            pen.circle("jaw", element.x, element.y, element.radius)
            pen.circle("contact", element.x, element.y, element.radius + reach)
        elif isinstance(element, Pocket):
            pen.circle("drop", element.x, element.y, element.radius)
