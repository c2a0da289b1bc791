"""What a ball in the air, or on a rail's top, can come to: noses, jaws, the backs of pockets, the rail's outer edge.

In the air x and y run straight and the height is a parabola. So the distance from a straight nose is a quartic in
time, squared and less its value at contact. About a rounded jaw, or a hole, the distance from a ring goes by a root,
and its time is found by halving: how near a ball may come within a span of time is bounded from below, exactly, so
that a span in which it cannot touch is left out whole, and the first one that it cannot be left out of is halved on.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final, final

from ..detect import AIR_SKIN, SKIN, TOUCH, Rail, entering
from ..motion import Motion
from ..roots import INF, falling_root, first_root
from ..values import AIRBORNE, EventKind
from .impact import GENTLE, Surface, Vector

# A span of time that is not halved further, as a part of what it began as.
_FINEST: Final = 1e-16


class Solid:
    """Something off the cloth. `kind` is the event of meeting it, None where that is not told; `name` its `where`.

    (left, bottom, right, top) is a box that holds it.
    """

    __slots__ = ("kind", "name", "surface", "left", "bottom", "right", "top")

    def __init__(self, kind: EventKind | None, name: str, surface: Surface, x: list[float], y: list[float]) -> None:
        self.kind: EventKind | None = kind
        self.name = name
        self.surface = surface
        self.left, self.right = min(x), max(x)
        self.bottom, self.top = min(y), max(y)

    def time(self, motion: Motion, radius: float, end: float) -> float:
        """When, counted from the motion's start and up to `end`, a ball of this radius meets it; else infinite."""
        raise NotImplementedError

    def normal(self, x: float, y: float, centre: float) -> Vector:
        """The unit vector into it from a ball at (x, y) with its centre at a height."""
        raise NotImplementedError

    def gap(self, x: float, y: float, centre: float, radius: float) -> float:
        """How far a ball is from it, m; negative where they overlap, infinite for what is only passed."""
        return INF

    def least(self, slide: float) -> float:
        """How fast a ball leaves it at the least that has slid along it, m/s."""
        return GENTLE


@final
class StraightNose(Solid):
    """A straight nose or facing from (ax, ay) on, on the left of its way the table.

    It is an edge at the height `low`, and an upright face from there to the rail's top at `high`.
    """

    __slots__ = ("ax", "ay", "dx", "dy", "length", "low", "high")

    def __init__(self, rail: Rail, surface: Surface, low: float, high: float) -> None:
        super().__init__("ball_cushion", rail.name, surface, [rail.ax, rail.bx], [rail.ay, rail.by])
        self.ax, self.ay, self.dx, self.dy, self.length = rail.ax, rail.ay, rail.dx, rail.dy, rail.length
        self.low = low
        self.high = high

    def time(self, motion: Motion, radius: float, end: float) -> float:
        if motion.phase != AIRBORNE:
            return INF
        px, py = motion.x - self.ax, motion.y - self.ay
        c0, c1 = self.dx * py - self.dy * px, self.dx * motion.vy - self.dy * motion.vx
        first = self._edge(motion, c0, c1, radius, self.low, end)
        if self.high > self.low:
            first = min(first, self._edge(motion, c0, c1, radius, self.high, end))
            t = falling_root(c0 - radius + AIR_SKIN, c1, 0.0)
            if 0.0 <= t < min(end, first) and self._is_beside(motion, t):
                first = t if self.low < _centre(motion, radius, t) < self.high else first
        return first

    def _edge(self, motion: Motion, c0: float, c1: float, radius: float, height: float, end: float) -> float:
        """When a ball meets the level line at a height, on the side away from the face."""
        w0, w1, w2 = motion.z + radius - height, motion.vz, motion.hz
        # On the cloth the depth of a contact is counted in plan: at the same height it is this much less.
        reach = math.sqrt(max(0.0, height * (2.0 * radius - height))) / radius
        touch = radius - AIR_SKIN * max(reach, 0.01)
        t = 0.0
        # It may come into the line beyond its ends, out of it again as it rises, and then into the nose itself: twice
        # at the most, as a quartic falls through zero.
        for _ in range(2):
            t += _entering_line(c0 + c1 * t, c1, w0 + (w1 + w2 * t) * t, w1 + 2.0 * w2 * t, w2, touch, end - t, t > 0.0)
            if t == INF or (self._is_beside(motion, t) and self._is_met(_centre(motion, radius, t), height)):
                return t
        return INF

    def _is_beside(self, motion: Motion, t: float) -> bool:
        """Whether a ball is between the ends, some time after the start of its motion."""
        x, y = motion.x + motion.vx * t - self.ax, motion.y + motion.vy * t - self.ay
        return -SKIN <= x * self.dx + y * self.dy <= self.length + SKIN

    def _is_met(self, centre: float, height: float) -> bool:
        """Whether a ball with its centre so high meets the edge at a height, and not the face between the two."""
        return self.low == self.high or (centre <= self.low if height == self.low else centre >= self.high)

    def normal(self, x: float, y: float, centre: float) -> Vector:
        c = self.dx * (y - self.ay) - self.dy * (x - self.ax)
        w = _outside(centre, self.low, self.high)
        size = math.sqrt(c * c + w * w)
        if size == 0.0:
            c = size = 1.0
        return self.dy * c / size, -self.dx * c / size, -w / size

    def gap(self, x: float, y: float, centre: float, radius: float) -> float:
        px, py = x - self.ax, y - self.ay
        along = min(max(px * self.dx + py * self.dy, 0.0), self.length)
        beside = math.hypot(px - along * self.dx, py - along * self.dy)
        return math.hypot(beside, _outside(centre, self.low, self.high)) - radius


@final
class RoundNose(Solid):
    """A rounded jaw, a disc up to the rail's top; of radius 0, the end of a facing."""

    __slots__ = ("x", "y", "radius", "low", "high")

    def __init__(self, name: str, x: float, y: float, radius: float, surface: Surface, low: float, high: float) -> None:
        super().__init__("ball_cushion", name, surface, [x - radius, x + radius], [y - radius, y + radius])
        self.x, self.y, self.radius, self.low, self.high = x, y, radius, low, high

    def time(self, motion: Motion, radius: float, end: float) -> float:
        if motion.phase != AIRBORNE:
            return INF
        px, py = motion.x - self.x, motion.y - self.y

        def beside(first: float, last: float) -> float:
            return max(0.0, _nearest(px, py, motion.vx, motion.vy, first, last) - self.radius)

        return first_touch(motion, radius, end, self.low, self.high, beside)

    def normal(self, x: float, y: float, centre: float) -> Vector:
        px, py = self.x - x, self.y - y
        distance = math.hypot(px, py)
        u, w = max(0.0, distance - self.radius), _outside(centre, self.low, self.high)
        size = math.hypot(u, w)
        if size == 0.0:
            u = size = 1.0
        flat = u / (distance * size) if u > 0.0 and distance > 0.0 else 0.0
        return flat * px, flat * py, -w / size

    def gap(self, x: float, y: float, centre: float, radius: float) -> float:
        u = max(0.0, math.hypot(self.x - x, self.y - y) - self.radius)
        return math.hypot(u, _outside(centre, self.low, self.high)) - radius


@final
class Boundary(Solid):
    """A line in plan that a ball's centre passes, from the left of its way (ax, ay) to (bx, by) to the right.

    The outer edge of a rail, which is passed in the air too, or where the rail's top ends toward the table.
    """

    __slots__ = ("ax", "ay", "dx", "dy", "length", "airborne")

    def __init__(
        self, kind: EventKind | None, name: str, surface: Surface,
        ax: float, ay: float, bx: float, by: float, airborne: bool,
    ) -> None:  # fmt: skip
        super().__init__(kind, name, surface, [ax, bx], [ay, by])
        self.ax, self.ay = ax, ay
        self.length = math.hypot(bx - ax, by - ay)
        self.dx, self.dy = (bx - ax) / self.length, (by - ay) / self.length
        self.airborne = airborne

    def time(self, motion: Motion, radius: float, end: float) -> float:
        if motion.phase == AIRBORNE and not self.airborne:
            return INF
        px, py = motion.x - self.ax, motion.y - self.ay
        t = falling_root(
            self.dx * py - self.dy * px, self.dx * motion.vy - self.dy * motion.vx,
            self.dx * motion.hy - self.dy * motion.hx,
        )  # fmt: skip
        if not 0.0 <= t <= end:
            return INF
        along = (px + (motion.vx + motion.hx * t) * t) * self.dx + (py + (motion.vy + motion.hy * t) * t) * self.dy
        return t if -SKIN <= along <= self.length + SKIN else INF


def _entering_line(
    c0: float, c1: float, w0: float, w1: float, w2: float, touch: float, end: float, again: bool
) -> float:
    """When a ball that is c0 + c1 t beside a level line and w0 + w1 t + w2 t^2 above it comes as near as `touch`.

    Beyond its ends a ball may be far within the line of a nose already, or has just come there (`again`): then only
    from without.
    """
    q0, q1 = c0 * c0 + w0 * w0 - touch * touch, 2.0 * (c0 * c1 + w0 * w1)
    q2, q3, q4 = c1 * c1 + w1 * w1 + 2.0 * w0 * w2, 2.0 * w1 * w2, w2 * w2
    if again or q0 < -2.0 * touch * SKIN:
        return first_root(min(q0, 0.0), q1, q2, q3, q4, end)
    return entering(q0, q1, q2, q3, q4, 2.0 * touch, end)


def _centre(motion: Motion, radius: float, t: float) -> float:
    """The height of a ball's centre, some time after the start of its motion."""
    return motion.z + radius + (motion.vz + motion.hz * t) * t


def _outside(height: float, low: float, high: float) -> float:
    """How far a height is above `high`, or, negative, below `low`."""
    return height - high if height > high else min(0.0, height - low)


def _nearest(px: float, py: float, vx: float, vy: float, first: float, last: float) -> float:
    """How near (px, py) + (vx, vy) t comes to the origin during a span of time."""
    square = vx * vx + vy * vy
    t = min(max(-(px * vx + py * vy) / square, first), last) if square > 0.0 else first
    return math.hypot(px + vx * t, py + vy * t)


def _level(motion: Motion, radius: float, first: float, last: float, low: float, high: float) -> float:
    """How far from [low, high] the height of a ball's centre stays at the least during a span of time."""
    a, b = _centre(motion, radius, first), _centre(motion, radius, last)
    least, most = min(a, b), max(a, b)
    if motion.hz < 0.0:
        apex = -0.5 * motion.vz / motion.hz
        if first < apex < last:
            most = _centre(motion, radius, apex)
    return max(0.0, least - high, low - most)


def first_touch(
    motion: Motion, radius: float, end: float, low: float, high: float, beside: Callable[[float, float], float]
) -> float:
    """When a ball comes within its radius of a ring or disc between two heights.

    `beside` is the least distance in plan. That is exact for every span, as is the one in height; so nothing is missed
    in a span that is left out. A ball that touches already has to go deeper.
    """

    def room(first: float, last: float) -> float:
        u, w = beside(first, last), _level(motion, radius, first, last, low, high)
        return u * u + w * w

    touch = radius - AIR_SKIN
    level = touch * touch
    now = room(0.0, 0.0)
    if now <= level + 2.0 * radius * TOUCH:
        level = min(now, level) - 2.0 * radius * TOUCH
    spans = [(0.0, end)]
    while spans:
        first, last = spans.pop()
        if room(first, last) > level:
            continue
        middle = 0.5 * (first + last)
        if last - first <= _FINEST * (1.0 + last) or not first < middle < last:
            if room(last, last) <= level:
                return last
            continue
        spans.append((middle, last))
        spans.append((first, middle))
    return INF
