"""Somebody who measures at a table: plays there, pockets and all, and reads off paths and clocks what is asked for."""

from __future__ import annotations

import math
from itertools import pairwise

from pool2d import Ball, Layout, Rollout, Shot, Table, simulate


def struck(table: Table, speed: float) -> Rollout:
    """A centre ball from a quarter of the length, along the middle of the bottom half: no pocket is on its way."""
    size = table.knobs.table
    cue = table.furniture.cue
    return simulate(table, Layout([Ball(cue, size.length / 4, 0.3 * size.width)]), Shot(0.0, speed, ball=cue))


def lag(table: Table) -> float:
    """Seconds of the lag that dies at the head cushion: the hardest that does not touch it again, by halving."""
    soft, hard = 0.1, 20.0
    while hard - soft > 1e-6:
        speed = 0.5 * (soft + hard)
        cushions = [event.where for event in struck(table, speed).events if event.rails]
        soft, hard = (soft, speed) if len(cushions) > 1 else (speed, hard)
    return struck(table, soft).duration


def hard(table: Table, speed: float) -> tuple[float, float]:
    """Lengths that a hard ball runs, and seconds to its first cushion, off its path."""
    roll = struck(table, speed)
    (cue,) = roll.start
    xs = [x for _, x, _ in roll.path(cue, 0.002)]
    way = math.fsum(abs(b - a) for a, b in pairwise(xs))
    room = table.knobs.table.length - 2.0 * table.reach(table.body_of(roll.start[cue])[0])
    return way / room, next(event.t for event in roll.events if event.rails)


def spin(table: Table, rate: float) -> tuple[float, float]:
    """Turns of a ball that is set spinning at `rate`, rad/s, and the seconds until it stops, by adding up its spin."""
    cue = table.furniture.cue
    size = table.knobs.table
    roll = simulate(table, Layout([Ball(cue, size.length / 2, size.width / 2, wz=rate)]))
    steps = 2000
    angle = math.fsum(roll.at(roll.duration * (i + 0.5) / steps)[cue].wz for i in range(steps)) * roll.duration / steps
    return angle / math.tau, roll.duration


def oblique(table: Table, angle: float, speed: float) -> float:
    """Degrees from the normal at which a ball rolls off the lower rail, from two places of its path."""
    size, cue = table.knobs.table, table.furniture.cue
    turn, radius = math.radians(angle), table.knobs.ball.radius
    vx, vy = speed * math.sin(turn), -speed * math.cos(turn)
    ball = Ball(cue, 0.2 * size.length - 0.2, 0.2, vx, vy, -vy / radius, vx / radius)
    roll = simulate(table, Layout([ball]))
    touch = next(event.t for event in roll.events if event.rails)
    rolls = next(event.t for event in roll.events if event.kind == "sliding_rolling" and event.t > touch)
    one, other = roll.at(rolls)[cue], roll.at(rolls + 0.1)[cue]
    return math.degrees(math.atan2(other.x - one.x, other.y - one.y))


def rebound(table: Table, speed: float, line: float) -> float:
    """Part of its speed that a ball keeps that rolls into the foot cushion, by its speeds at a line before it."""
    size, cue, radius = table.knobs.table, table.furniture.cue, table.knobs.ball.radius
    ball = Ball(cue, size.length - table.reach(radius) - line, 0.3 * size.width, speed, 0.0, 0.0, speed / radius)
    roll = simulate(table, Layout([ball]))
    touch = next(event.t for event in roll.events if event.rails)
    back = next(t for t, x, _ in roll.path(cue, 1e-4) if t > touch and x < ball.x)
    assert roll.at(back)[cue].phase == "rolling"
    return -roll.at(back)[cue].vx / speed
