"""What a tip that is moving, or stands, does to a ball that it meets."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ..detect import NOISE

if TYPE_CHECKING:
    from ..body import Body
    from ..flight.impact import Vector
    from ..values import Shot


def lines(shot: Shot) -> tuple[Vector, Vector]:
    """The unit vectors of a stroke: along the cue, and from where the tip meets the ball to the ball's centre."""
    a, b = shot.side, shot.height
    tilt, aim = math.radians(shot.elevation), math.radians(shot.angle)
    cos, sin, ca, sa = math.cos(tilt), math.sin(tilt), math.cos(aim), math.sin(aim)
    depth = math.sqrt(max(0.0, 1.0 - a * a - b * b))
    # In the table's frame turned to the aim: x ahead, y left, z up.
    ahead, up = depth * cos - b * sin, -depth * sin - b * cos
    return (cos * ca, cos * sa, -sin), (ahead * ca - a * sa, ahead * sa + a * ca, up)


def push(
    ball: Body, n: Vector, cue: Vector, speed: float, mass: float, restitution: float, cone: float
) -> tuple[float, float]:
    """Let a tip that moves at `speed` along the `cue`, of this mass, and a ball part; n points into the ball.

    It is the impulse of the stroke, for a ball that may move already: along the cue, or past the angle of the friction
    `cone` along the nearest line within it. Restitution holds along that line. Where that does not part them, as the
    ball's spin has its surface run ahead of the tip, friction is left out. Returns the cue's speed after it, and how
    fast the two part along n, m/s.
    """
    for line in (_within(cue, n, cone), n):
        closing, ease, share = _approach(ball, n, cue, speed, mass, line)
        impulse = (1.0 + restitution) * closing / ease
        onward = speed - impulse * share / mass
        turned = _dot(line, n) * impulse / ball.mass
        parting = _dot(n, _moving(ball)) + turned - onward * _dot(cue, n)
        if closing > 0.0 and parting >= -NOISE:
            _give(ball, n, line, impulse)
            return onward, max(0.0, parting)
    return speed, 0.0


def _within(cue: Vector, n: Vector, cone: float) -> Vector:
    """The line of the cue, or the nearest to it that is no further than `cone` from n, radians."""
    along = _dot(cue, n)
    if along >= math.cos(cone):
        return cue
    across = _sum(1.0, cue, -along, n)
    size = math.sqrt(_dot(across, across))
    # Against the very end of the cue there is no such line.
    c, s = math.cos(cone), math.sin(cone) / size if size > 0.0 else 0.0
    return _sum(c, n, s, across)


def _approach(
    ball: Body, n: Vector, cue: Vector, speed: float, mass: float, line: Vector
) -> tuple[float, float, float]:
    """How fast tip and ball near each other along a line, m/s; what eases it, 1/kg; how much of it the cue feels."""
    share = _dot(cue, line)
    arm = _cross(n, line)
    # The ball's surface is at -R n from its centre.
    surface = _dot(_moving(ball), line) - ball.radius * _dot(_turning(ball), arm)
    ease = (_dot(line, line) + 2.5 * _dot(arm, arm)) / ball.mass + share * share / mass
    return speed * share - surface, ease, share


def _give(ball: Body, n: Vector, line: Vector, impulse: float) -> None:
    """Give a ball an impulse along a line, where n points into it."""
    arm = _cross(n, line)
    rate, turn = impulse / ball.mass, -2.5 * impulse / (ball.mass * ball.radius)
    ball.vx += rate * line[0]
    ball.vy += rate * line[1]
    ball.vz += rate * line[2]
    ball.wx += turn * arm[0]
    ball.wy += turn * arm[1]
    ball.wz += turn * arm[2]


def _dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _sum(p: float, a: Vector, q: float, b: Vector) -> Vector:
    return p * a[0] + q * b[0], p * a[1] + q * b[1], p * a[2] + q * b[2]


def _moving(ball: Body) -> Vector:
    return ball.vx, ball.vy, ball.vz


def _turning(ball: Body) -> Vector:
    return ball.wx, ball.wy, ball.wz
