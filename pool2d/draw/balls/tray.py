"""Pocketed balls: sinking into the hole, and then in a row above the table."""

from __future__ import annotations

from collections.abc import Sequence

import pygame

from ...game.falling import Fall
from ...physics.orientation import FACING, Quaternion
from ...table.furniture import Look
from .. import theme
from . import ball_art
from .ball_art import Placed

# The part of its size that a ball seems to lose on its way down, and how dark it grows.
_SHRINK, _DARKEN = 0.3, 0.95
# The row: the balls' radius in parts of its height, and their pitch in radii.
_RADIUS, _PITCH = 0.36, 2.3


def sinking(fall: Fall, ball: Placed) -> Placed:
    """How to draw a ball that sinks into a pocket: smaller and darker the deeper it is."""
    return ball._replace(
        radius=ball.radius * (1.0 - _SHRINK * fall.depth),
        alpha=round(255.0 * (1.0 - _DARKEN * fall.depth**1.5)),
        shadow=False,
    )


def draw(
    surface: pygame.Surface,
    room: pygame.Rect,
    looks: Sequence[Look],
    style: theme.Style,
    orientation: Quaternion = FACING,
) -> None:
    """Draw balls in a row in the middle of `room`, in pixels, closer together where they are many, all facing alike."""
    if not looks:
        return
    radius = room.height * _RADIUS
    pitch = min(_PITCH * radius, (room.width - 2.4 * radius) / max(1, len(looks) - 1))
    width = pitch * (len(looks) - 1) + 2.8 * radius
    trough = pygame.Rect(0, 0, round(width), round(2.5 * radius))
    trough.center = room.center
    pygame.draw.rect(surface, theme.BACKGROUND, trough, border_radius=trough.height // 2)
    pygame.draw.rect(surface, theme.FACE_LIT, trough, 1, border_radius=trough.height // 2)
    left = room.centerx - pitch * (len(looks) - 1) / 2.0
    row = [
        Placed(look, (left + i * pitch, room.centery), radius, orientation, shadow=False)
        for i, look in enumerate(looks)
    ]
    ball_art.draw_all(surface, row, style)
