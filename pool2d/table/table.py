"""A table: knobs, geometry and a pymunk Space that holds it.

The Space is the broad phase of the engine and the way to ask what is where. It is the only place that
knows pymunk. Balls are not in it: they move along closed forms, not steps. One Space must never be
queried from two threads: it aborts the process.
"""

from __future__ import annotations

import math
import random
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

import pymunk

from ..config.knobs import apply
from ..errors import InputError, suggest
from ..physics.body import Body
from ..physics.detect import Element, Jaw, Pocket, Rail, nearest, time_ball_ball
from ..physics.flight.bed import Bed, Ground
from ..physics.materials import materials
from ..physics.motion import Motion
from ..physics.params import Physics
from ..physics.standing import inside
from ..physics.values import GONE, MOTION_FIELDS, RESTING, ROLLING, Ball, Layout, Shot
from .furniture import Furniture, Rack, arrange
from .geometry import build
from .outline import edges, scaled, widened
from .placing import settle
from .rail_tops import RailTops
from .table_knobs import Knobs


class Table:
    """A table to play on. Immutable; `with_knobs` makes a changed copy.

    `source` says where it came from, for messages and scenarios; `conditions` names those that `base`
    holds on top of the preset; `set` is what was overridden since. It has more attributes than most classes, as it
    keeps ready what the engine asks it for at every contact.
    """

    def __init__(
        self,
        source: str,
        title: str,
        knobs: Knobs,
        furniture: Furniture,
        overrides: Mapping[str, Any] | None = None,
        conditions: Sequence[str] = (),
    ) -> None:
        self.source = source
        self.title = title
        self.base = knobs
        self.conditions = tuple(conditions)
        self.set = dict(overrides or {})
        self.knobs = apply(knobs, self.set, source)
        self.furniture = furniture
        lowest = min([self.knobs.ball.radius, *(radius for radius, _ in furniture.sizes.values())])
        if self.knobs.cushion.nose_height >= 2.0 * lowest:
            raise InputError(
                source, "cushion.nose_height", self.knobs.cushion.nose_height,
                f"the nose must be lower than a ball is high, {2.0 * lowest:g} m",
            )  # fmt: skip
        size = self.knobs.table
        corners = scaled(furniture.outline, size.length, size.width, source)
        self.surface = [(corner.x, corner.y) for corner in corners]
        self.geometry = build(corners, size, self.knobs.corner, self.knobs.side, source)
        self._elements = list(self.geometry.elements)
        self._throats = list(self.geometry.outline)
        # A layout that has been settled last need not be again: it is played, drawn and judged in turn.
        self._settled: Layout | None = None
        self._space = pymunk.Space()
        self._index: dict[pymunk.Shape, int] = {}
        for index, element in enumerate(self.geometry.elements):
            shape = _shape(element, self._space.static_body)
            self._space.add(shape)
            self._index[shape] = index
            box = shape.bb
            element.left, element.bottom, element.right, element.top = box.left, box.bottom, box.right, box.top

    def __reduce__(self) -> tuple[type[Table], tuple[object, ...]]:
        # What it was made of is small, and no Space is shared.
        return type(self), (self.source, self.title, self.base, self.furniture, self.set, self.conditions)

    @property
    def physics(self) -> Physics:
        """What the engine reads: the knobs."""
        return self.knobs

    @property
    def elements(self) -> tuple[Element, ...]:
        """Noses, jaws and pockets, in the order that `near` counts them."""
        return self.geometry.elements

    @cached_property
    def bed(self) -> Bed:
        """What balls meet that leave the cloth, and what everything is made of."""
        nose, corners = self.knobs.cushion.nose_height, self.geometry.corners
        sides = [(a.cushion, a.x, a.y, b.x, b.y) for a, b in edges(corners)]
        outer = widened(corners, self.knobs.rail.width)
        ends = zip(corners, outer, (*outer[1:], outer[0]), strict=True)
        edge = [(corner.cushion, *here, *there) for corner, here, there in ends]
        ground = Ground(self._throats, sides, edge, nose, nose + self.knobs.rail.height, self.geometry.pockets)
        return Bed(ground, self._elements, materials(self.knobs))

    @cached_property
    def rails(self) -> dict[str, list[Element]]:
        """The noses, facings and jaws that a ball can come to, by the cushion or jaw that they are of."""
        named: dict[str, list[Element]] = {}
        for element in self.elements:
            if element.kind == "ball_cushion":
                named.setdefault(element.name, []).append(element)
        return named

    @cached_property
    def rail_tops(self) -> RailTops:
        """The rails' tops, as a cue meets them that lies across them."""
        rail = self.knobs.rail
        return RailTops(self.geometry, self.knobs.cushion.nose_height + rail.height, rail.width)

    def with_knobs(self, overrides: Mapping[str, Any]) -> Table:
        """A copy with dotted knobs set on top of what was set before; raises InputError."""
        return self._having({**self.set, **overrides})

    def _having(self, overrides: Mapping[str, Any]) -> Table:
        """A copy with just these knobs set."""
        return Table(self.source, self.title, self.base, self.furniture, overrides, self.conditions)

    def reset(self, *names: str) -> Table:
        """A copy with these knobs as the preset has them; all of them where none is named."""
        kept = {name: value for name, value in self.set.items() if names and name not in names}
        return self._having(kept)

    def boxes(self) -> list[tuple[float, float, float, float]]:
        """The broad phase's box round each element: left, bottom, right, top, m."""
        return [(element.left, element.bottom, element.right, element.top) for element in self.elements]

    def rack(self, name: str, seed: int = 0, other: Rack | None = None) -> Layout:
        """The balls of a rack and the cue ball; `seed` draws what the rules leave open.

        `other` is a rack that goes by that name and is not the table's own. Raises InputError for one that it lacks.
        """
        rack = other or self.furniture.racks.get(name)
        if rack is None:
            raise InputError(self.source, "racks", name, suggest(name, self.furniture.racks))
        rng = random.Random(f"{name} {seed}")
        return self.settle(arrange(self.furniture, rack, self.knobs.ball.radius, rng))

    # What the engine asks.

    def near(self, left: float, bottom: float, right: float, top: float) -> list[int]:
        """The indices of the elements that a box may touch, in order."""
        index = self._index
        hits = self._space.bb_query(pymunk.BB(left, bottom, right, top), _ALL)
        return sorted([index[shape] for shape in hits])

    def body_of(self, ball: Ball) -> tuple[float, float]:
        """Radius and mass of a ball: its own, those the set has for it, or the table's."""
        radius, mass = self.furniture.sizes.get(ball.id) or (self.knobs.ball.radius, self.knobs.ball.mass)
        return radius if ball.radius is None else ball.radius, mass if ball.mass is None else ball.mass

    def bodies(self, balls: Sequence[Ball]) -> list[Body]:
        """The balls as the engine moves them, in this order."""
        usual, named = self.knobs.ball, self.furniture.sizes
        radius, mass, reach = usual.radius, usual.mass, self.reach(usual.radius)
        made = [Body(ball, i, radius, mass, reach) for i, ball in enumerate(balls)]
        for body, ball in zip(made, balls, strict=True):
            if ball.radius is not None or ball.mass is not None or ball.id in named:
                body.radius, body.mass = self.body_of(ball)
                body.reach = self.reach(body.radius)
        return made

    def touch(self, a: Ball, b: Ball) -> float:
        """How far apart, in plan, the centres of two balls are that touch: 2 sqrt(R1 R2) on one cloth."""
        return 2.0 * math.sqrt(self.body_of(a)[0] * self.body_of(b)[0])

    def settle(self, layout: Layout) -> Layout:
        """The layout as the engine takes it; see `placing.settle`."""
        if layout is not self._settled:
            self._settled = settle(self, layout)
        return self._settled

    def scenario(self, layout: Layout, shot: Shot | None) -> dict[str, Any]:
        """Table, balls and shot in the form of a scenario file."""
        entry: dict[str, Any] = {"table": self.source, "conditions": list(self.conditions), "set": dict(self.set)}
        entry["balls"] = []
        for ball in layout.values():
            given = {"id": ball.id, **{name: getattr(ball, name) for name in MOTION_FIELDS if name not in ("z", "vz")}}
            given.update({name: value for name in ("z", "vz") if (value := getattr(ball, name)) != 0.0})
            given.update({name: value for name in ("radius", "mass") if (value := getattr(ball, name)) is not None})
            if ball.phase not in GONE:
                entry["balls"].append(given)
        if shot is not None:
            told = {name: getattr(shot, name) for name in Shot.__dataclass_fields__}
            entry["shot"] = {name: value for name, value in told.items() if value is not False}
        return entry

    # What a person asks.

    def reach(self, radius: float) -> float:
        """How far from a nose, in plan, a ball's centre is when it touches: R cos th, sin th = h/R - 1."""
        nose = self.knobs.cushion.nose_height
        return math.sqrt(max(0.0, nose * (2.0 * radius - nose)))

    def on_surface(self, x: float, y: float) -> bool:
        """Whether a point is on the playing surface, within the noses."""
        return inside(x, y, self.surface)

    def on_cloth(self, x: float, y: float) -> bool:
        """Whether a point is on the playing surface or in a pocket's throat."""
        return self.on_surface(x, y) or inside(x, y, self._throats)

    def ground(self, x: float, y: float) -> float:
        """How high what lies below a point is above the cloth, m: off the cloth it is the top of the rails."""
        return self.bed.ground.high if self.bed.ground.on_rail(x, y) else 0.0

    def element_gap(self, x: float, y: float, radius: float) -> tuple[float, Element | None]:
        """How far a ball here is from the nearest element, and which; infinite where none is near."""
        return nearest(self._elements, x, y, radius, self.reach(radius))

    def has_room(self, x: float, y: float, radius: float, layout: Layout, ignore: str = "") -> bool:
        """Whether a ball fits here, touching nothing but by contact. `ignore` is a ball not to count."""
        if not self.on_cloth(x, y) or self.element_gap(x, y, radius)[0] < 0.0:
            return False
        here = Ball("", x, y, radius=radius)
        return all(
            math.hypot(ball.x - x, ball.y - y) >= self.touch(here, ball)
            for ball in layout.on_table()
            if ball.id != ignore
        )

    def under(self, x: float, y: float, layout: Layout) -> str | None:
        """The id of the ball at a point, or else the name of the pocket or cushion there."""
        for ball in layout.on_table():
            if math.hypot(ball.x - x, ball.y - y) <= self.body_of(ball)[0]:
                return ball.id
        near = [self.elements[i] for i in self.near(x - _DEPTH, y - _DEPTH, x + _DEPTH, y + _DEPTH)]
        hits = [(gap, element.name) for element in near if (gap := element.gap(x, y, 0.0)) <= 0.0]
        return max(hits)[1] if hits else None

    def cast(
        self, x: float, y: float, dx: float, dy: float, layout: Layout, radius: float | None = None, ignore: str = ""
    ) -> tuple[float, str | None]:
        """What a ball sent straight from (x, y) along (dx, dy) meets first: the distance and its id or name.

        Infinite and None where it meets nothing, as a ball that starts outside may.
        """
        size = math.hypot(dx, dy)
        # Further than any two points of an outline are from each other.
        end = 2.0 * (self.knobs.table.length + self.knobs.table.width)
        ball = Ball("", x, y, dx / size, dy / size, radius=radius)
        body = Body(ball, 0, *self.body_of(ball))
        way = Motion(body, ROLLING, 0.0, end)
        reach = self.reach(body.radius)
        far_x, far_y = x + body.vx * end, y + body.vy * end
        near = self.near(min(x, far_x) - reach, min(y, far_y) - reach, max(x, far_x) + reach, max(y, far_y) + reach)
        hits: list[tuple[float, str | None]] = [
            (self.elements[i].time(way, reach, end), self.elements[i].name) for i in near
        ]
        for other in layout.on_table():
            if other.id != ignore:
                still = Motion(Body(other.still(), 0, *self.body_of(other)), RESTING, 0.0, end)
                hits.append((time_ball_ball(way, still, 0.0, end, self.touch(ball, other)), other.id))
        met = [hit for hit in hits if hit[0] < math.inf]
        return min(met, key=lambda hit: hit[0], default=(math.inf, None))


_ALL = pymunk.ShapeFilter()
# How far behind its nose a cushion goes, m, as far as pointing at it is concerned.
_DEPTH = 0.05


def _shape(element: Element, body: pymunk.Body) -> pymunk.Shape:
    """A static shape that covers an element: a segment for a nose, a circle for a jaw or a drop."""
    if isinstance(element, Rail):
        return pymunk.Segment(body, (element.ax, element.ay), (element.bx, element.by), 0.0)
    if isinstance(element, Jaw):
        return pymunk.Circle(body, element.radius, (element.x, element.y))
    if isinstance(element, Pocket):
        shape = pymunk.Circle(body, element.radius, (element.x, element.y))
        shape.sensor = True
        return shape
    raise TypeError(f"no shape for a {type(element).__name__}")
