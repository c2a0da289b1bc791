"""A ball on the cloth between two events, in closed form.

With the slip at the cloth u = (vx - R wy, vy + R wx), a ball that slides is slowed by mu_s g against
u, whose direction stays constant, so its path is a parabola; after 2|u| / (7 mu_s g) it rolls, at
v - 2u/7. A rolling ball is slowed by mu_r g along its way. The spin about the vertical falls on its
own at 5 mu_sp g / (2R). (Coriolis 1835; Alciatore TP 4.1, TP A.4.)
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any, Final, final

from .body import Body
from .roots import INF
from .values import AIRBORNE, OFF, POCKETED, RESTING, ROLLING, SLIDING, SPINNING, Ball, Phase

# Below this a slip or a speed is rounding, m/s.
STILL: Final = 1e-9


@final
class ClothNumbers:
    """What motions read of the cloth: its friction for sliding, rolling and spinning balls, and gravity, m/s2."""

    __slots__ = ("mu_slide", "mu_roll", "mu_spin", "gravity")

    def __init__(self, mu_slide: float, mu_roll: float, mu_spin: float, gravity: float) -> None:
        self.mu_slide = mu_slide
        self.mu_roll = mu_roll
        self.mu_spin = mu_spin
        self.gravity = gravity


@final
class Motion:
    """One ball from `t0` until `t1`: place and height quadratic in time, spin linear.

    (x, y), (vx, vy), (wx, wy, wz) hold at `t0`; (hx, hy) is half the acceleration, (bx, by) the rate
    of the horizontal spin and `bz` the speed at which |wz| falls. `t1` is where the phase ends by
    itself, infinite for a ball at rest. `end` is where it
    ends, by itself or at the table; (left, bottom, right, top) is the box of `bound`. A ball in the air is at the
    height z and rises at vz, both at `t0`, with hz half its acceleration, until its lowest point is at `floor`; that is
    infinite where it is in the air still at `t1`. A ball that lies on a rail's top keeps its z.
    """

    __slots__ = (
        "id", "index", "phase", "t0", "t1", "x", "y", "z", "vx", "vy", "vz", "hx", "hy", "hz", "wx", "wy", "wz",
        "bx", "by", "bz", "floor", "end", "left", "bottom", "right", "top",
    )  # fmt: skip

    def __init__(
        self, body: Body, phase: Phase, t0: float, t1: float,
        hx: float = 0.0, hy: float = 0.0, bx: float = 0.0, by: float = 0.0, bz: float = 0.0,
    ) -> None:  # fmt: skip
        self.id = body.id
        self.index = body.index
        self.phase: Phase = phase
        self.t0 = t0
        self.t1 = t1
        self.x = body.x
        self.y = body.y
        self.vx = body.vx
        self.vy = body.vy
        self.wx = body.wx
        self.wy = body.wy
        self.wz = body.wz
        self.z = body.z
        self.vz = body.vz
        self.hz = 0.0
        self.floor = INF
        self.hx = hx
        self.hy = hy
        self.bx = bx
        self.by = by
        self.bz = bz
        self.end = t1
        self.left = self.right = body.x
        self.bottom = self.top = body.y

    def __reduce__(self) -> tuple[Any, ...]:
        """What copies and pickles are made of, as compiled classes have to say: all but the box."""
        ball = self.at(self.t0)
        rates = (self.hx, self.hy, self.hz, self.bx, self.by, self.bz)
        return _restored, (ball, self.index, self.t0, self.t1, rates, self.floor)

    def move(self, body: Body, t: float) -> None:
        """Bring `body` to where this motion is at time `t`."""
        s = t - self.t0
        body.x = self.x + (self.vx + self.hx * s) * s
        body.y = self.y + (self.vy + self.hy * s) * s
        body.vx = self.vx + 2.0 * self.hx * s
        body.vy = self.vy + 2.0 * self.hy * s
        body.wx = self.wx + self.bx * s
        body.wy = self.wy + self.by * s
        body.wz = toward_zero(self.wz, self.bz * s)
        body.t = t
        if self.aloft():
            body.z = self.z + (self.vz + self.hz * s) * s
            body.vz = self.vz + 2.0 * self.hz * s

    def aloft(self) -> bool:
        """Whether the ball is off the cloth: in the air, or on a rail's top."""
        return self.phase == AIRBORNE or self.z != 0.0

    def stays(self) -> bool:
        """Whether the ball stays where it is, at rest or spinning on the spot."""
        return self.vx == 0.0 == self.vy and self.hx == 0.0 == self.hy and self.phase != AIRBORNE

    def bound(self, first: float, last: float) -> None:
        """Work out the box that holds the path between two times, s after the start.

        The path is a Bezier curve: it lies within its control points.
        """
        x0, x2 = self.x + (self.vx + self.hx * first) * first, self.x + (self.vx + self.hx * last) * last
        y0, y2 = self.y + (self.vy + self.hy * first) * first, self.y + (self.vy + self.hy * last) * last
        half = 0.5 * (last - first)
        x1 = x0 + (self.vx + 2.0 * self.hx * first) * half
        y1 = y0 + (self.vy + 2.0 * self.hy * first) * half
        self.left, self.right = min(min(x0, x1), x2), max(max(x0, x1), x2)
        self.bottom, self.top = min(min(y0, y1), y2), max(max(y0, y1), y2)

    def coasts(self) -> bool:
        """Whether the ball moves without friction, which it has had in advance: only then `wz` lasts."""
        return self.bz == 0.0 and self.t1 < INF

    def place(self, t: float) -> tuple[float, float]:
        """Where the ball is at time `t`, m: what `at` says of it."""
        s = t - self.t0
        return self.x + (self.vx + self.hx * s) * s, self.y + (self.vy + self.hy * s) * s

    def at(self, t: float) -> Ball:
        """The ball at time `t`, within [t0, t1]."""
        s = t - self.t0
        return Ball(
            self.id,
            self.x + (self.vx + self.hx * s) * s,
            self.y + (self.vy + self.hy * s) * s,
            self.vx + 2.0 * self.hx * s,
            self.vy + 2.0 * self.hy * s,
            self.wx + self.bx * s,
            self.wy + self.by * s,
            toward_zero(self.wz, self.bz * s),
            self.phase,
            None,
            None,
            self.z + (self.vz + self.hz * s) * s,
            self.vz + 2.0 * self.hz * s,
        )


def _restored(
    ball: Ball, index: int, t0: float, t1: float, rates: tuple[float, float, float, float, float, float], floor: float
) -> Motion:
    hx, hy, hz, bx, by, bz = rates
    motion = Motion(Body(ball, index, 0.0, 0.0), ball.phase, t0, t1, hx, hy, bx, by, bz)
    motion.hz = hz
    motion.floor = floor
    return motion


def toward_zero(value: float, by: float) -> float:
    """`value` brought nearer to zero by `by`, and not past it."""
    if value > 0.0:
        return value - by if value > by else 0.0
    return value + by if value < -by else 0.0


def start(body: Body, t: float, cloth: ClothNumbers) -> Motion:
    """The motion of `body` from time `t` on, in the phase its velocity and spin put it."""
    radius = body.radius
    ux = body.vx - radius * body.wy
    uy = body.vy + radius * body.wx
    slip = math.hypot(ux, uy)
    if t < body.paid and (slip > STILL or math.hypot(body.vx, body.vy) > STILL):
        return Motion(body, SLIDING if slip > STILL else ROLLING, t, body.paid)
    fall = 2.5 * cloth.mu_spin * cloth.gravity / radius
    if slip > STILL:
        grip = cloth.mu_slide * cloth.gravity / slip
        ax, ay = -grip * ux, -grip * uy
        turn = 2.5 / radius
        return Motion(
            body, SLIDING, t, t + 2.0 * slip / (7.0 * cloth.mu_slide * cloth.gravity),
            0.5 * ax, 0.5 * ay, turn * ay, -turn * ax, fall,
        )  # fmt: skip
    roll(body, ux, uy)
    speed = math.hypot(body.vx, body.vy)
    if speed > STILL:
        drag = cloth.mu_roll * cloth.gravity / speed
        ax, ay = -drag * body.vx, -drag * body.vy
        return Motion(
            body, ROLLING, t, t + speed / (cloth.mu_roll * cloth.gravity),
            0.5 * ax, 0.5 * ay, -ay / radius, ax / radius, fall,
        )  # fmt: skip
    body.vx = body.vy = body.wx = body.wy = 0.0
    if radius * abs(body.wz) > STILL:
        return Motion(body, SPINNING, t, t + abs(body.wz) / fall, bz=fall)
    body.wz = 0.0
    return Motion(body, RESTING, t, INF)


def finish(motion: Motion, body: Body, cloth: ClothNumbers) -> Motion:
    """What follows `motion` when its phase has run out; `body` is brought to that moment."""
    motion.move(body, motion.t1)
    if motion.coasts():
        return start(body, motion.t1, cloth)
    if motion.phase == SLIDING:
        # Exactly at natural roll: the slip that rounding leaves must not start another slide.
        roll(body, body.vx - body.radius * body.wy, body.vy + body.radius * body.wx)
    else:
        body.vx = body.vy = body.wx = body.wy = 0.0
        if motion.phase == SPINNING:
            body.wz = 0.0
    return start(body, motion.t1, cloth)


def pocketed(body: Body, t: float) -> Motion:
    """A ball that has fallen into a pocket, from time `t` on."""
    body.z = 0.0
    return _gone(body, POCKETED, t)


def off(body: Body, t: float) -> Motion:
    """A ball that has left the table, from time `t` on; it stays where it was last seen."""
    return _gone(body, OFF, t)


def _gone(body: Body, phase: Phase, t: float) -> Motion:
    body.vx = body.vy = body.vz = body.wx = body.wy = body.wz = 0.0
    return Motion(body, phase, t, INF)


def roll(body: Body, ux: float, uy: float) -> None:
    """Give `body` the natural roll that ends its slip (ux, uy): v - 2u/7 (Coriolis; Alciatore TP A.4)."""
    body.vx -= 2.0 / 7.0 * ux
    body.vy -= 2.0 / 7.0 * uy
    body.wx = -body.vy / body.radius
    body.wy = body.vx / body.radius


def pieces(track: Sequence[Motion], start: float, end: float) -> Iterator[tuple[Motion, float, float]]:
    """The motions of a ball between two times, each with the part of that time in which it holds."""
    for i, motion in enumerate(track):
        until = track[i + 1].t0 if i + 1 < len(track) else INF
        if motion.t0 < end and until > start:
            yield motion, max(motion.t0, start), min(until, end)


def span(track: Sequence[Motion], end: float, u: float = 1.0, v: float = 0.0) -> tuple[float, float]:
    """The least and greatest ux + vy of a ball up to a time; of a track that begins later (0, 0)."""
    low, high = INF, -INF
    for motion, a, b in pieces(track, 0.0, end):
        place = u * motion.x + v * motion.y
        speed, bend = u * motion.vx + v * motion.vy, u * motion.hx + v * motion.hy
        turn = motion.t0 - 0.5 * speed / bend if bend else a
        for t in (a, min(max(turn, a), b), b):
            s = t - motion.t0
            there = place + (speed + bend * s) * s
            low, high = min(low, there), max(high, there)
    return (low, high) if low <= high else (0.0, 0.0)
