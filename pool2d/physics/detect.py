"""When a moving ball meets something: the exact times, and the table elements that ask for them.

Every contact is looked for at SKIN inside the true distance, so that balls that touch exactly, in a
rack or on a rail, are an ordinary case of balls a little apart.
"""

from __future__ import annotations

import math
from typing import Final, final

from .motion import Motion
from .roots import INF, falling_root, first_root
from .values import EventKind

# How far two surfaces may enter each other before they count as met, m.
SKIN: Final = 5e-10
# In the air, where nothing lies frozen, less will do, m.
AIR_SKIN: Final = 1e-11
# A gap that is no more than rounding after a contact was solved, m, and such a speed, m/s.
TOUCH: Final = 1e-12
NOISE: Final = 1e-12
# A point this near a surface, m, is on it.
SURFACE: Final = 1e-9


class Element:
    """A part of the table that a ball can meet. New kinds of element need only this.

    `kind` is the kind of event, `name` what its `where` says; (left, bottom, right, top) is a box that holds it.
    `facing` is whether it is the end of a cushion in a pocket, which is of other stuff than the cushion.
    """

    __slots__ = ("kind", "name", "facing", "left", "bottom", "right", "top")

    def __init__(self, kind: EventKind, name: str, facing: bool = False) -> None:
        self.kind: EventKind = kind
        self.name = name
        self.facing = facing
        # Until a table says how far it reaches, it is everywhere.
        self.left = self.bottom = -INF
        self.right = self.top = INF

    def near(self, left: float, bottom: float, right: float, top: float) -> bool:
        """Whether a box may touch this."""
        return self.left <= right and left <= self.right and self.bottom <= top and bottom <= self.top

    def time(self, motion: Motion, reach: float, end: float) -> float:
        """When, counted from the motion's start and up to `end`, a ball meets this; else infinite.

        `reach` is the distance in plan at which the ball touches a cushion's nose.
        """
        raise NotImplementedError

    def normal(self, x: float, y: float) -> tuple[float, float]:
        """The unit vector from a ball at (x, y) into the element."""
        raise NotImplementedError

    def gap(self, x: float, y: float, reach: float) -> float:
        """How far a ball at (x, y) is from this, m; negative where they overlap."""
        raise NotImplementedError

    def point(self, x: float, y: float) -> tuple[float, float] | None:
        """Where a ball at (x, y) touches this, or would; None where it has nothing across from the ball."""
        raise NotImplementedError

    def covers(self, x: float, y: float) -> bool:
        """Whether a point lies within or behind this, so that no ball can touch anything there."""
        raise NotImplementedError


@final
class Rail(Element):
    """A straight nose from (ax, ay) to (bx, by), with the table on its left."""

    __slots__ = ("ax", "ay", "bx", "by", "dx", "dy", "length")

    def __init__(self, name: str, ax: float, ay: float, bx: float, by: float, facing: bool = False) -> None:
        super().__init__("ball_cushion", name, facing)
        self.ax, self.ay, self.bx, self.by = ax, ay, bx, by
        self.length = math.hypot(bx - ax, by - ay)
        self.dx, self.dy = (bx - ax) / self.length, (by - ay) / self.length

    def time(self, motion: Motion, reach: float, end: float) -> float:
        return time_ball_rail(motion, self, reach, end)

    def normal(self, x: float, y: float) -> tuple[float, float]:
        return self.dy, -self.dx

    def gap(self, x: float, y: float, reach: float) -> float:
        px, py = x - self.ax, y - self.ay
        along = min(max(px * self.dx + py * self.dy, 0.0), self.length)
        beyond = math.hypot(px - along * self.dx, py - along * self.dy)
        behind = 0.0 < along < self.length and self.dx * py - self.dy * px < 0.0
        return (-beyond if behind else beyond) - reach

    def point(self, x: float, y: float) -> tuple[float, float] | None:
        along = (x - self.ax) * self.dx + (y - self.ay) * self.dy
        return (self.ax + along * self.dx, self.ay + along * self.dy) if 0.0 <= along <= self.length else None

    def covers(self, x: float, y: float) -> bool:
        px, py = x - self.ax, y - self.ay
        along = px * self.dx + py * self.dy
        return -SURFACE < along < self.length + SURFACE and self.dx * py - self.dy * px < SURFACE


@final
class Jaw(Element):
    """A rounded end of a cushion: a circle of `radius` in plan."""

    __slots__ = ("x", "y", "radius")

    def __init__(self, name: str, x: float, y: float, radius: float, facing: bool = False) -> None:
        super().__init__("ball_cushion", name, facing)
        self.x, self.y, self.radius = x, y, radius

    def time(self, motion: Motion, reach: float, end: float) -> float:
        return time_ball_jaw(motion, self, reach, end)

    def normal(self, x: float, y: float) -> tuple[float, float]:
        distance = math.hypot(self.x - x, self.y - y)
        return (self.x - x) / distance, (self.y - y) / distance

    def gap(self, x: float, y: float, reach: float) -> float:
        return math.hypot(self.x - x, self.y - y) - self.radius - reach

    def point(self, x: float, y: float) -> tuple[float, float] | None:
        nx, ny = self.normal(x, y)
        return self.x - nx * self.radius, self.y - ny * self.radius

    def covers(self, x: float, y: float) -> bool:
        return math.hypot(self.x - x, self.y - y) < self.radius - SURFACE


@final
class Pocket(Element):
    """The rim over which a ball falls: it drops when its centre is above the rim.

    (ux, uy) points from the hole's centre to the table.
    """

    __slots__ = ("x", "y", "radius", "ux", "uy")

    def __init__(self, name: str, x: float, y: float, radius: float, ux: float = 1.0, uy: float = 0.0) -> None:
        super().__init__("ball_pocket", name)
        self.x, self.y, self.radius = x, y, radius
        self.ux, self.uy = ux, uy

    def time(self, motion: Motion, reach: float, end: float) -> float:
        return time_ball_pocket(motion, self, end)

    def normal(self, x: float, y: float) -> tuple[float, float]:
        distance = math.hypot(self.x - x, self.y - y)
        return ((self.x - x) / distance, (self.y - y) / distance) if distance > 0.0 else (1.0, 0.0)

    def gap(self, x: float, y: float, reach: float) -> float:
        return math.hypot(self.x - x, self.y - y) - self.radius

    def point(self, x: float, y: float) -> tuple[float, float] | None:
        return None

    def covers(self, x: float, y: float) -> bool:
        return False


def nearest(elements: list[Element], x: float, y: float, radius: float, reach: float) -> tuple[float, Element | None]:
    """How far a ball at (x, y) is from the nearest element, m, and which; infinite where none is near."""
    least, found = INF, None
    left, bottom, right, top = x - radius, y - radius, x + radius, y + radius
    for element in elements:
        if element.left <= right and left <= element.right and element.bottom <= top and bottom <= element.top:
            gap = element.gap(x, y, reach)
            if gap < least:
                least, found = gap, element
    return least, found


def time_ball_ball(a: Motion, b: Motion, now: float, end: float, touch: float) -> float:
    """When two balls, both moving as given from `now` to `end`, come within `touch` of each other."""
    s, t = now - a.t0, now - b.t0
    return now + time_to_circle(
        b.x + (b.vx + b.hx * t) * t - a.x - (a.vx + a.hx * s) * s,
        b.y + (b.vy + b.hy * t) * t - a.y - (a.vy + a.hy * s) * s,
        b.vx + 2.0 * b.hx * t - a.vx - 2.0 * a.hx * s,
        b.vy + 2.0 * b.hy * t - a.vy - 2.0 * a.hy * s,
        b.hx - a.hx,
        b.hy - a.hy,
        touch - SKIN,
        end - now,
    )


def time_in_the_air(a: Motion, b: Motion, now: float, end: float, a_radius: float, b_radius: float) -> float:
    """When two balls touch of which one at least is off the cloth: a quartic in three dimensions."""
    s, t = now - a.t0, now - b.t0
    x = b.x + (b.vx + b.hx * t) * t - a.x - (a.vx + a.hx * s) * s
    y = b.y + (b.vy + b.hy * t) * t - a.y - (a.vy + a.hy * s) * s
    z = b.z + (b.vz + b.hz * t) * t + b_radius - a.z - (a.vz + a.hz * s) * s - a_radius
    vx = b.vx + 2.0 * b.hx * t - a.vx - 2.0 * a.hx * s
    vy = b.vy + 2.0 * b.hy * t - a.vy - 2.0 * a.hy * s
    vz = b.vz + 2.0 * b.hz * t - a.vz - 2.0 * a.hz * s
    hx, hy, hz = b.hx - a.hx, b.hy - a.hy, b.hz - a.hz
    touch = a_radius + b_radius - AIR_SKIN
    return now + entering(
        x * x + y * y + z * z - touch * touch,
        2.0 * (x * vx + y * vy + z * vz),
        vx * vx + vy * vy + vz * vz + 2.0 * (x * hx + y * hy + z * hz),
        2.0 * (vx * hx + vy * hy + vz * hz),
        hx * hx + hy * hy + hz * hz,
        2.0 * touch,
        end - now,
    )


def time_ball_rail(motion: Motion, rail: Rail, reach: float, end: float) -> float:
    """When, after the motion's start, a ball meets a straight nose between its ends."""
    nx, ny = -rail.dy, rail.dx
    px, py = motion.x - rail.ax, motion.y - rail.ay
    c0 = nx * px + ny * py - reach + SKIN
    c1 = nx * motion.vx + ny * motion.vy
    c2 = nx * motion.hx + ny * motion.hy
    # Beyond the ends a ball may be far behind the line of a nose; what touches it lies no deeper than SKIN.
    if -SKIN <= c0 <= TOUCH:
        t = 0.0 if c1 < -NOISE else falling_root(0.0, max(c1, NOISE), c2)
    else:
        t = falling_root(c0, c1, c2)
    if not 0.0 <= t <= end:
        return INF
    along = (px + (motion.vx + motion.hx * t) * t) * rail.dx + (py + (motion.vy + motion.hy * t) * t) * rail.dy
    return t if -SKIN <= along <= rail.length + SKIN else INF


def time_ball_jaw(motion: Motion, jaw: Jaw, reach: float, end: float) -> float:
    """When, after the motion's start, a ball meets a rounded jaw."""
    return time_to_circle(
        jaw.x - motion.x, jaw.y - motion.y, -motion.vx, -motion.vy, -motion.hx, -motion.hy,
        jaw.radius + reach - SKIN, end,
    )  # fmt: skip


def time_ball_pocket(motion: Motion, pocket: Pocket, end: float) -> float:
    """When, after the motion's start, the centre of a ball passes a pocket's rim."""
    return time_to_circle(
        pocket.x - motion.x, pocket.y - motion.y, -motion.vx, -motion.vy, -motion.hx, -motion.hy,
        pocket.radius, end,
    )  # fmt: skip


def time_to_circle(x: float, y: float, vx: float, vy: float, hx: float, hy: float, radius: float, end: float) -> float:
    """When the point (x, y) + (vx, vy) t + (hx, hy) t^2 first enters a circle about the origin."""
    # The path is a Bezier curve, within the triangle of its three control points. Where the triangle
    # lies clear of the circle, on one side of its base or wholly before or behind, nothing is met.
    bx, by = (vx + hx * end) * end, (vy + hy * end) * end
    far = radius * radius * (bx * bx + by * by)
    side0 = x * by - y * bx
    side1 = side0 + 0.5 * end * (vx * by - vy * bx)
    if side0 * side1 > 0.0 and side0 * side0 > far and side1 * side1 > far:
        return INF
    along0 = x * bx + y * by
    along1 = along0 + 0.5 * end * (vx * bx + vy * by)
    along2 = along0 + bx * bx + by * by
    nearest = min(min(along0, along1), along2)
    furthest = max(max(along0, along1), along2)
    if (nearest > 0.0 and nearest * nearest > far) or (furthest < 0.0 and furthest * furthest > far):
        return INF
    c0 = x * x + y * y - radius * radius
    c1 = 2.0 * (x * vx + y * vy)
    c2 = vx * vx + vy * vy + 2.0 * (x * hx + y * hy)
    c3 = 2.0 * (vx * hx + vy * hy)
    c4 = hx * hx + hy * hy
    return entering(c0, c1, c2, c3, c4, 2.0 * radius, end)


def entering(c0: float, c1: float, c2: float, c3: float, c4: float, unit: float, end: float) -> float:
    """When a squared distance, less its square at contact, falls through zero; `unit` is twice the latter's root."""
    if c0 > unit * TOUCH:
        return first_root(c0, c1, c2, c3, c4, end)
    # In contact: approaching is a hit now; else the contact at t = 0 is divided out.
    if c1 < -unit * NOISE:
        return 0.0
    return first_root(max(c1, unit * NOISE), c2, c3, c4, 0.0, end)
