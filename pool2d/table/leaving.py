"""A ball that has left the table, on its way to the floor: seen and heard, but of no more consequence."""

from __future__ import annotations

import math
from typing import Final

from ..physics.values import Ball

# How high the bed is above the floor, m: rules ask for about 0.75 to 0.79.
BED: Final = 0.76
# How long such a ball is followed at most, s. It falls from the bed to the floor in 0.39.
FOLLOWED: Final = 0.6
# A ball that is slower, m/s, has come to rest on a rail, and is taken off.
_RESTS: Final = 1e-6


def taken_off(ball: Ball) -> bool:
    """Whether a ball that is off has come to rest beside the bed: a hand takes it, and it does not fall."""
    return math.hypot(ball.vx, ball.vy, ball.vz) < _RESTS


def place(ball: Ball, gravity: float, s: float) -> tuple[float, float, float]:
    """Where a ball is, x, y and z in m, `s` seconds after it went over the edge as it is given."""
    if taken_off(ball):
        return ball.x, ball.y, ball.z
    return ball.x + ball.vx * s, ball.y + ball.vy * s, ball.z + (ball.vz - 0.5 * gravity * s) * s


def landing(ball: Ball, gravity: float) -> tuple[float, float]:
    """After how many seconds a ball meets the floor, and how fast, m/s; or how it is when it is followed no more."""
    fallen = math.sqrt(ball.vz * ball.vz + 2.0 * gravity * max(0.0, ball.z + BED))
    return min((ball.vz + fallen) / gravity, FOLLOWED), fallen
