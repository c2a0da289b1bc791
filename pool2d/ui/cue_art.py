"""The cue, seen from above."""

from __future__ import annotations

import math

import pygame

from ..physics.values import Ball
from ..table import Table
from . import pen, theme
from .aim import Aim
from .view import View

_LENGTH = 1.45


def draw(surface: pygame.Surface, table: Table, ball: Ball, aim: Aim, back: float, view: View) -> None:
    """The cue behind a ball, drawn `back` m away from it, its tip where the aim's side has it."""
    radius = table.body_of(ball)[0]
    angle = math.radians(aim.angle)
    ahead, right = (math.cos(angle), math.sin(angle)), (math.sin(angle), -math.cos(angle))
    # Seen from above a raised cue is shorter.
    flat = math.cos(math.radians(aim.elevation))
    gap = radius * math.sqrt(1.0 - aim.side * aim.side) + 0.006 + back * flat

    def at(distance: float, aside: float) -> tuple[float, float]:
        along = -(gap + distance * flat)
        across = aim.side * radius + aside
        return view.to_screen(
            ball.x + ahead[0] * along + right[0] * across, ball.y + ahead[1] * along + right[1] * across
        )

    for start, end, thin, thick, color in (
        (0.0, 1.0, 0.0062, 0.0105, theme.CUE_SHAFT),
        (1.0, _LENGTH, 0.0105, 0.0145, theme.CUE_BUTT),
        (0.0, 0.022, 0.0062, 0.0063, theme.SIGHT),
        (0.0, 0.010, 0.0060, 0.0060, theme.CUE_TIP),
    ):
        pen.polygon(surface, color, [at(start, thin), at(end, thick), at(end, -thick), at(start, -thin)])
