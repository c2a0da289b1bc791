"""How the balls of a rollout turn: the orientation of each at any moment.

Spin is linear in time within a motion, so a step of Magnus' series to fourth order turns a ball by the
rotation vector h w + h^3/12 (dw/dt x w), both taken at the step's middle; where the axis stays as it is,
that is exact for any step. (Iserles, Nørsett 1999, "On the solution of linear differential equations in
Lie groups", eq. 4.3 ff.) The steps are counted from a motion's start, and what they end in is remembered:
the answer does not depend on which moments were asked for before.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Mapping

from .motion import Motion
from .rollout import Rollout

# (w, x, y, z) of unit length; it turns what is fixed to the ball into the table's axes.
Quaternion = tuple[float, float, float, float]
Vector = tuple[float, float, float]

# As a ball is made: its number on top, upright.
FACING: Quaternion = (1.0, 0.0, 0.0, 0.0)
# The angle of one step where the axis moves, rad.
_STEP = 0.25
# Below this sine between the spin and its rate, the axis stays as it is but for rounding.
_STEADY = 1e-12


def product(a: Quaternion, b: Quaternion) -> Quaternion:
    """First the turn `b`, then the turn `a`."""
    aw, ax, ay, az = a
    bw, bx, by, bz = b
    return (
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    )


def turn(x: float, y: float, z: float) -> Quaternion:
    """The turn about the axis (x, y, z) by that vector's length, rad."""
    angle = math.sqrt(x * x + y * y + z * z)
    if angle == 0.0:
        return FACING
    part = math.sin(0.5 * angle) / angle
    return math.cos(0.5 * angle), part * x, part * y, part * z


def unit(q: Quaternion) -> Quaternion:
    """The same turn, with rounding taken out of its length."""
    length = math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
    return q[0] / length, q[1] / length, q[2] / length, q[3] / length


def matrix(q: Quaternion) -> tuple[Vector, Vector, Vector]:
    """The rows of the turn's matrix; `q` may have any length but 0."""
    w, x, y, z = q
    two = 2.0 / (w * w + x * x + y * y + z * z)
    return (
        (1.0 - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y)),
        (two * (x * y + w * z), 1.0 - two * (x * x + z * z), two * (y * z - w * x)),
        (two * (x * z - w * y), two * (y * z + w * x), 1.0 - two * (x * x + y * y)),
    )


class BallRotation:
    """The orientation of every ball of a rollout; `start` gives it at the beginning, else it is FACING."""

    def __init__(self, rollout: Rollout, start: Mapping[str, Quaternion]) -> None:
        self._tracks = rollout.tracks
        self._duration = rollout.duration
        self._start = {ball_id: unit(start.get(ball_id, FACING)) for ball_id in rollout.start}
        self._balls: dict[str, _TurningBall] = {}

    def at(self, ball_id: str, t: float) -> Quaternion:
        """How a ball lies `t` seconds into the shot, clamped to its beginning and end."""
        ball = self._balls.get(ball_id)
        if ball is None:
            track = self._tracks.get(ball_id, [])
            ball = self._balls[ball_id] = _TurningBall(track, self._duration, self._start[ball_id])
        return ball.at(min(max(t, 0.0), self._duration))

    def orientations(self, t: float) -> dict[str, Quaternion]:
        """How all balls lie `t` seconds into the shot."""
        return {ball_id: self.at(ball_id, t) for ball_id in self._start}


class _TurningBall:
    """One ball's pieces in order of time, and how it lies where each begins, as far as was asked for."""

    def __init__(self, track: list[Motion], duration: float, start: Quaternion) -> None:
        ends = [*(motion.t0 for motion in track[1:]), duration]
        self._pieces = [
            piece for motion, end in zip(track, ends, strict=False) if end > motion.t0 for piece in _pieces(motion, end)
        ]
        self._times = [piece.t0 for piece in self._pieces]
        self._start = start
        self._known = 0

    def at(self, t: float) -> Quaternion:
        i = bisect_right(self._times, t) - 1
        if i < 0:
            return self._start
        if self._known == 0:
            self._pieces[0].knots.append(self._start)
            self._known = 1
        while self._known <= i:
            piece = self._pieces[self._known]
            piece.knots.append(self._pieces[self._known - 1].at(piece.t0))
            self._known += 1
        return self._pieces[i].at(t)


class _Piece:
    """A stretch of time in which the spin is `spin` + `rate` s; `knots` is how the ball lies at each step."""

    __slots__ = ("t0", "spin", "rate", "step", "knots")

    def __init__(self, t0: float, t1: float, spin: Vector, rate: Vector) -> None:
        self.t0 = t0
        self.spin = spin
        self.rate = rate
        self.knots: list[Quaternion] = []
        last = [w + (t1 - t0) * b for w, b in zip(spin, rate, strict=True)]
        fastest = max(math.hypot(*spin), math.hypot(*last))
        steady = math.hypot(*_cross(rate, spin)) <= _STEADY * math.hypot(*rate) * math.hypot(*spin)
        self.step = math.inf if steady else _STEP / fastest

    def at(self, t: float) -> Quaternion:
        s = t - self.t0
        if self.step == math.inf:
            # The axis stays: there is no bend.
            (wx, wy, wz), (bx, by, bz), half = self.spin, self.rate, 0.5 * s
            return product(turn(s * (wx + half * bx), s * (wy + half * by), s * (wz + half * bz)), self.knots[0])
        count = int(s / self.step)
        while len(self.knots) <= count:
            self.knots.append(product(self._turned((len(self.knots) - 1) * self.step, self.step), self.knots[-1]))
        begun = count * self.step
        return product(self._turned(begun, s - begun), self.knots[count])

    def _turned(self, s: float, h: float) -> Quaternion:
        """The turn from `s` seconds into the piece until `h` seconds later."""
        (wx, wy, wz), (bx, by, bz) = self.spin, self.rate
        s += 0.5 * h
        middle = (wx + bx * s, wy + by * s, wz + bz * s)
        bend = _cross(self.rate, middle)
        third = h * h * h / 12.0
        return turn(h * middle[0] + third * bend[0], h * middle[1] + third * bend[1], h * middle[2] + third * bend[2])


def _pieces(motion: Motion, end: float) -> list[_Piece]:
    """A motion until `end`, cut where its spin about the vertical runs out."""
    wx, wy, wz = motion.wx, motion.wy, motion.wz
    bx, by = motion.bx, motion.by
    if wz == 0.0:
        return [_Piece(motion.t0, end, (wx, wy, 0.0), (bx, by, 0.0))]
    spin, rate = (wx, wy, wz), (bx, by, -math.copysign(motion.bz, wz))
    lasts = abs(wz) / motion.bz if motion.bz > 0.0 else math.inf
    if motion.t0 + lasts >= end:
        return [_Piece(motion.t0, end, spin, rate)]
    left = (wx + bx * lasts, wy + by * lasts, 0.0)
    cut = motion.t0 + lasts
    return [_Piece(motion.t0, cut, spin, rate), _Piece(cut, end, left, (bx, by, 0.0))]


def _cross(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
