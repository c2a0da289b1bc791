"""The hole of a pocket as a ball in it, or on the rail behind it, meets it: rim, back and brink."""

from __future__ import annotations

import math
from typing import final

from ..detect import Pocket, time_to_circle
from ..motion import Motion
from ..roots import INF
from ..values import AIRBORNE, EventKind
from .impact import GENTLE, Surface, Vector
from .solids import Solid, first_touch


class Hole(Solid):
    """Something round the hole of a pocket, seen from within it: on the side of the table, or behind its centre."""

    __slots__ = ("x", "y", "radius", "ux", "uy")

    def __init__(self, kind: EventKind | None, name: str, pocket: Pocket, surface: Surface, radius: float) -> None:
        x, y = pocket.x, pocket.y
        super().__init__(kind, name, surface, [x - radius, x + radius], [y - radius, y + radius])
        self.x, self.y, self.radius, self.ux, self.uy = x, y, radius, pocket.ux, pocket.uy

    def inward(self, x: float, y: float) -> float:
        """How far a place is on the table's side of the hole's centre, m."""
        return (x - self.x) * self.ux + (y - self.y) * self.uy

    def least(self, slide: float) -> float:
        # A ball that glances along the round of the hole would else touch it endlessly often on its way.
        return max(GENTLE, 0.05 * slide)

    def _touch(self, motion: Motion, radius: float, end: float, high: float, side: float) -> float:
        """When a ball comes to the hole's edge, which is upright up to `high`.

        With a `side` of -1 only behind the hole's centre, with 0 all round.
        """
        px, py, vx, vy = motion.x - self.x, motion.y - self.y, motion.vx, motion.vy
        start, speed = side * self.inward(motion.x, motion.y), side * (vx * self.ux + vy * self.uy)

        def beside(first: float, last: float) -> float:
            # The way is straight: what it is not past at both ends it is not past between.
            if start + speed * first < 0.0 and start + speed * last < 0.0:
                return INF
            ax, ay, bx, by = px + vx * first, py + vy * first, px + vx * last, py + vy * last
            return max(0.0, self.radius - math.sqrt(max(ax * ax + ay * ay, bx * bx + by * by)))

        return first_touch(motion, radius, end, -INF, high, beside)

    def _toward(self, x: float, y: float, w: float) -> Vector:
        """The unit vector to the hole's edge from a ball whose centre is w above that."""
        px, py = x - self.x, y - self.y
        distance = math.hypot(px, py)
        u = max(0.0, self.radius - distance)
        size = math.hypot(u, w)
        if size == 0.0:
            u = size = 1.0
        flat = u / (distance * size) if distance > 0.0 else 0.0
        return flat * px, flat * py, -w / size


@final
class Rim(Hole):
    """The slate's edge round a hole, which a ball meets that is over the hole, and still reaches above it."""

    __slots__ = ()

    def __init__(self, pocket: Pocket, surface: Surface) -> None:
        super().__init__("ball_slate", pocket.name, pocket, surface, pocket.radius)

    def time(self, motion: Motion, radius: float, end: float) -> float:
        return self._touch(motion, radius, end, 0.0, 0.0) if motion.phase == AIRBORNE else INF

    def normal(self, x: float, y: float, centre: float) -> Vector:
        return self._toward(x, y, max(0.0, centre))

    def gap(self, x: float, y: float, centre: float, radius: float) -> float:
        distance = math.hypot(x - self.x, y - self.y)
        if distance >= self.radius:
            return INF
        return math.hypot(self.radius - distance, max(0.0, centre)) - radius


@final
class Back(Hole):
    """The back of a pocket: upright behind the hole, as high as the rail's top at `high`."""

    __slots__ = ("high",)

    def __init__(self, pocket: Pocket, surface: Surface, high: float) -> None:
        super().__init__("ball_cushion", f"{pocket.name} back", pocket, surface, pocket.radius)
        self.high = high

    def time(self, motion: Motion, radius: float, end: float) -> float:
        return self._touch(motion, radius, end, self.high, -1.0) if motion.phase == AIRBORNE else INF

    def normal(self, x: float, y: float, centre: float) -> Vector:
        return self._toward(x, y, max(0.0, centre - self.high))

    def gap(self, x: float, y: float, centre: float, radius: float) -> float:
        distance = math.hypot(x - self.x, y - self.y)
        # Beside its upright face a facing, which stands over the slate, lets a ball come past a little nearer than it
        # may touch: there it is leather, and gives way.
        if distance >= self.radius or self.inward(x, y) > 0.0 or centre < self.high:
            return INF
        return math.hypot(self.radius - distance, centre - self.high) - radius


@final
class Brink(Hole):
    """Where a ball on a rail's top rolls into a hole behind it: its centre passes the hole's edge."""

    __slots__ = ()

    def __init__(self, pocket: Pocket, surface: Surface) -> None:
        super().__init__(None, pocket.name, pocket, surface, pocket.radius)

    def time(self, motion: Motion, radius: float, end: float) -> float:
        if motion.phase == AIRBORNE:
            return INF
        t = time_to_circle(
            self.x - motion.x, self.y - motion.y, -motion.vx, -motion.vy, -motion.hx, -motion.hy, self.radius, end
        )
        if t == INF:
            return INF
        x, y = motion.place(motion.t0 + t)
        # Beside the facings the rail covers the hole.
        return t if self.inward(x, y) <= 0.0 else INF
