"""Balls that go: sinking into a hole or flying off the table, and then in a row above it."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import pygame

from ...game.falling import Fall, Leaving, falling, flying_off
from ...physics.orientation import FACING, BallRotation, Quaternion
from ...physics.rollout import Rollout
from ...physics.values import Ball
from ...table.furniture import Look
from ...table.table import Table
from .. import pen, theme
from . import ball_art
from .ball_art import Placed

# The part of its size that a ball seems to lose on its way down, and how dark it grows.
_SHRINK, _DARKEN = 0.3, 0.95
# The row: the balls' radius in parts of its height, and their pitch in radii.
_RADIUS, _PITCH = 0.36, 2.3


def going(
    rollout: Rollout, turning: BallRotation, table: Table, t: float, place: Callable[[Ball, Quaternion], Placed]
) -> list[Placed]:
    """How to draw the balls that are on their way into a pocket or to the floor, `t` s into the shot.

    `place` says how a ball is drawn that is so turned. They lie below those that are on the table.
    """
    start = rollout.start
    sunk = falling(rollout, turning, table.geometry.pockets, t)
    left = flying_off(rollout, turning, table, t)
    return [
        *(sinking(one, place(start[one.ball]._replace(x=one.x, y=one.y, z=one.z), one.orientation)) for one in sunk),
        *(leaving(one, place(start[one.ball]._replace(x=one.x, y=one.y, z=one.z), one.orientation)) for one in left),
    ]


def leaving(ball: Leaving, placed: Placed) -> Placed:
    """How to draw a ball that has gone over the edge of the table: it fades, and throws no shadow on it."""
    return placed._replace(alpha=round(255.0 * (1.0 - ball.part**2)), shadow=False, fine=True)


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
    off: Sequence[bool] = (),
) -> None:
    """Draw balls in a row in the middle of `room`, in pixels, closer together where they are many, all facing alike.

    Those that are `off`, not in a pocket but beside the table, are ringed.
    """
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
    for ball, is_off in zip(row, off, strict=False):
        if is_off:
            pen.ring(surface, theme.WARNING, ball.centre, radius + 2.0, 1.6)
