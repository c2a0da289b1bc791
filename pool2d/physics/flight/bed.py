"""What is under a ball off the cloth, the bed, the rails' tops, the pockets' holes; and what stands about it."""

from __future__ import annotations

import math
from typing import Final, final

from ..body import Body
from ..detect import SURFACE, Element, Jaw, Pocket, Rail
from ..materials import Materials
from ..motion import Motion
from ..roots import INF, falling_root
from ..standing import Point, inside
from ..values import AIRBORNE
from .holes import Back, Brink, Rim
from .impact import LEAST, Surface, land
from .solids import Boundary, RoundNose, Solid, StraightNose

Side = tuple[str, float, float, float, float]

# How often in a row a ball may be held up by something in the air before it rests there, off the cloth.
PATIENCE: Final = 1000


@final
class Ground:
    """Where the ground of a table lies, in plan.

    `cloth` is the outline of what is covered by the slate, pockets' throats and all; `sides` are the names and ends of
    the cushions' fronts, and `edge` their rails' outer edges; `high` the height of the rails' top, m, and `low` that of
    the noses.
    """

    __slots__ = ("cloth", "sides", "edge", "low", "high", "pockets")

    def __init__(
        self, cloth: list[Point], sides: list[Side], edge: list[Side], low: float, high: float, pockets: list[Pocket]
    ) -> None:
        self.cloth = cloth
        self.sides = sides
        self.edge = edge
        self.low = low
        self.high = high
        self.pockets = pockets

    def hole(self, x: float, y: float) -> Pocket | None:
        """The pocket whose hole is open under a place: the rails cover it beside the facings."""
        for pocket in self.pockets:
            distance = math.hypot(x - pocket.x, y - pocket.y)
            behind = (x - pocket.x) * pocket.ux + (y - pocket.y) * pocket.uy <= 0.0
            if distance < pocket.radius and (behind or inside(x, y, self.cloth)):
                return pocket
        return None

    def on_rail(self, x: float, y: float) -> bool:
        """Whether a place is over a rail's top."""
        return self.hole(x, y) is None and not inside(x, y, self.cloth)

    def is_beyond(self, x: float, y: float) -> bool:
        """Whether a place is beyond the rails' outer edge."""
        return not inside(x, y, [(ax, ay) for _, ax, ay, _, _ in self.edge])

    def beside(self, x: float, y: float) -> str:
        """The cushion whose front is the nearest to a place."""
        least, found = INF, ""
        for name, ax, ay, bx, by in self.sides:
            dx, dy = bx - ax, by - ay
            along = min(max(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0.0), 1.0)
            distance = math.hypot(x - ax - along * dx, y - ay - along * dy)
            if distance < least:
                least, found = distance, name
        return found

    def landing(self, body: Body, hz: float) -> tuple[float, float]:
        """After how many seconds a ball in the air is down, and at which height, m; minus its radius is in a pocket."""
        s = falling_root(body.z - self.high, body.vz, hz)
        if 0.0 <= s < INF and self.on_rail(body.x + body.vx * s, body.y + body.vy * s):
            return s, self.high
        s = falling_root(body.z, body.vz, hz)
        # A ball that rolls over a hole's edge, or does not come up out of it again, is in the air down to its bottom.
        if 0.0 <= s < INF:
            pocket = self.hole(body.x + body.vx * s, body.y + body.vy * s)
            if pocket is None:
                return s, 0.0
            if is_tight(pocket, body):
                return s, -body.radius
        return max(0.0, falling_root(body.z + body.radius, body.vz, hz)), -body.radius


def is_tight(pocket: Pocket, body: Body) -> bool:
    """Whether a hole has hardly room for a ball: then the ball is down once it is over it."""
    return pocket.radius < 1.25 * body.radius


@final
class Bed:
    """A table as balls off the cloth meet it: its ground and solids, and what they and the rest are of."""

    __slots__ = ("ground", "solids", "materials", "slate", "rail", "hz", "liner")

    def __init__(self, ground: Ground, elements: list[Element], materials: Materials) -> None:
        self.ground = ground
        self.materials = materials
        self.slate = materials.slate
        self.rail = materials.rail
        self.liner = materials.liner
        self.hz = -0.5 * materials.cloth.gravity
        self.solids = _solids(ground, elements, materials)

    def fall(self, body: Body, t: float) -> Motion:
        """The motion of a ball that is in the air, from time `t` on."""
        body.paid = 0.0
        seconds, floor = self.ground.landing(body, self.hz)
        motion = Motion(body, AIRBORNE, t, t + seconds)
        motion.hz = self.hz
        motion.floor = floor
        return motion

    def lies(self, body: Body) -> bool:
        """Whether a ball lies on something, the bed or a rail's top."""
        return body.vz == 0.0 and (
            body.z == 0.0 or (body.z == self.ground.high and self.ground.on_rail(body.x, body.y))
        )

    def land(self, body: Body, floor: float) -> None:
        """A ball comes down at a height: on the slate, or on a rail's top."""
        land(body, floor, self.slate if floor == 0.0 else self.rail)

    def answer(self, body: Body) -> None:
        """A ball that has lain on something has been pressed on it, or lifted off it."""
        if body.vz < 0.0:
            self.land(body, body.z)
        elif body.vz < LEAST:
            body.vz = 0.0

    def room(self, x: float, y: float, z: float, radius: float) -> tuple[float, str]:
        """How far a ball off the cloth is from the nearest thing about the bed, m, and what that is."""
        ground = self.ground
        if ground.is_beyond(x, y) and ground.hole(x, y) is None:
            return -INF, "nothing: it is off the table"
        least, found = INF, ""
        if z >= 0.0 and ground.on_rail(x, y):
            least, found = z - ground.high, f"the {ground.beside(x, y)} rail"
        elif z >= 0.0 and ground.hole(x, y) is None:
            least, found = z, "the bed"
        for solid in self.solids:
            gap = solid.gap(x, y, z + radius, radius)
            if gap < least:
                least, found = gap, solid.name
        return least, found

    def pocket(self, body: Body) -> Pocket:
        """The pocket that a ball has fallen into: the nearest."""
        least, found = INF, self.ground.pockets[0]
        for pocket in self.ground.pockets:
            distance = math.hypot(body.x - pocket.x, body.y - pocket.y)
            if distance < least:
                least, found = distance, pocket
        return found

    def keeps(self, body: Body, pocket: Pocket) -> bool:
        """Whether a ball that rolls or slides over a hole's edge is in the pocket for good.

        It is where it is so slow that it rolls off the edge, v^2 < g R; and where it comes back from the back so late
        that its centre has sunk below the bed. That is reckoned straight across and without friction; with friction,
        which may lift it, it has to be seen.
        """
        speed, gravity, e = math.hypot(body.vx, body.vy), -2.0 * self.hz, self.liner.restitution
        if speed * speed < gravity * body.radius or is_tight(pocket, body):
            return True
        if self.liner.friction > 0.0:
            return False
        if e == 0.0:
            return True
        seconds = max(0.0, 2.0 * pocket.radius - body.radius) / speed * (1.0 + 1.0 / e)
        return 0.5 * gravity * seconds * seconds >= body.radius


def _ledges(facing: Rail, x: float, y: float, ground: Ground, surface: Surface) -> list[Solid]:
    """What closes the pocket between a facing's end at (x, y), across from the hole's centre, and its back.

    Where the facings are as far apart as the hole is wide, nothing is open there.
    """
    for pocket in ground.pockets:
        px, py = x - pocket.x, y - pocket.y
        beside = px * pocket.uy - py * pocket.ux
        if abs(px * pocket.ux + py * pocket.uy) < SURFACE and 0.0 < abs(beside) < pocket.radius - SURFACE:
            far = math.copysign(pocket.radius, beside)
            ends = [(x, y), (pocket.x + far * pocket.uy, pocket.y - far * pocket.ux)]
            # The open side is on the left of a nose's way.
            (ax, ay), (bx, by) = ends if beside < 0.0 else ends[::-1]
            return [
                StraightNose(Rail(f"{pocket.name} back", ax, ay, bx, by), surface, ground.low, ground.high),
                Boundary(None, "", surface, bx, by, ax, ay, False),
            ]
    return []


def _solids(ground: Ground, elements: list[Element], materials: Materials) -> list[Solid]:
    """All that a ball off the cloth can come to, from a table's elements."""
    low, high, rail = ground.low, ground.high, materials.rail
    found: list[Solid] = []
    for element in elements:
        numbers = materials.facing if element.facing else materials.cushion
        surface = Surface(numbers.restitution, numbers.friction)
        if isinstance(element, Rail):
            found.append(StraightNose(element, surface, low, high))
            if element.facing:
                # The end of a facing within its pocket has no jaw.
                for x, y in ((element.ax, element.ay), (element.bx, element.by)):
                    found.append(RoundNose(element.name, x, y, 0.0, surface, low, high))
                    found += _ledges(element, x, y, ground, surface)
        elif isinstance(element, Jaw):
            found.append(RoundNose(element.name, element.x, element.y, element.radius, surface, low, high))
        elif isinstance(element, Pocket):
            found.append(Rim(element, materials.slate))
            found.append(Back(element, materials.liner, high))
            found.append(Brink(element, rail))
    for name, ax, ay, bx, by in ground.edge:
        found.append(Boundary("ball_off", name, rail, ax, ay, bx, by, True))
    front = ground.cloth
    for i, (ax, ay) in enumerate(front):
        bx, by = front[i - 1]
        if (ax, ay) != (bx, by):
            # Passed from behind: the cloth is on the right of the way back along its outline.
            found.append(Boundary(None, "", rail, ax, ay, bx, by, False))
    return found
