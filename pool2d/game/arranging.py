"""Arranging balls by hand in practice: which can be added, where there is room, and setting a shot up again."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from ..physics.values import Ball, Layout, Shot
from ..table.outline import Point
from ..table.table import Table
from .actions import Stroke
from .session import Session

# Places are tried on rings this far apart, in radii of the ball.
_RING = 0.5


def missing(table: Table, layout: Layout) -> list[str]:
    """The ids of the table's set of balls that are not on the table, the lowest number first."""
    here = {ball.id for ball in layout.on_table()}
    balls = dict.fromkeys((table.furniture.cue, *table.furniture.balls))
    return sorted((ball for ball in balls if ball not in here), key=lambda ball: int(ball) if ball.isdecimal() else 0)


def room_near(table: Table, layout: Layout, ball: Ball) -> Point | None:
    """The place nearest to a ball's own where it has room, m; None where the table has none."""
    radius = table.body_of(ball)[0]
    for x, y in _places(table, ball.x, ball.y, _RING * radius):
        if table.has_room(x, y, radius, layout, ignore=ball.id):
            return x, y
    return None


def latest(session: Session) -> tuple[Layout, Shot] | None:
    """The layout before the last stroke, wherever the balls are now, and its shot; None before the first."""
    for moment in reversed(session.match.history):
        if moment.rollout is not None and isinstance(moment.action, Stroke):
            return moment.rollout.start, moment.action.shot
    return None


def mirrored_shot(shot: Shot, ends: bool = False) -> Shot:
    """The shot mirrored as `placing.mirrored` mirrors the balls: sides swapped, or with `ends` the ends."""
    angle = 180.0 - shot.angle if ends else -shot.angle
    return replace(shot, angle=angle % 360.0, side=-shot.side if shot.side else 0.0)


def _places(table: Table, x: float, y: float, step: float) -> Iterator[Point]:
    """Points on rings round (x, y), m, from the middle outward, `step` apart, as far as the table goes."""
    yield x, y
    size = table.knobs.table
    for ring in range(1, math.ceil(math.hypot(size.length, size.width) / step) + 1):
        count = 6 * ring
        for i in range(count):
            turn = math.tau * i / count
            yield x + ring * step * math.cos(turn), y + ring * step * math.sin(turn)
