"""The tops of the rails as something that lies across them meets them: their edges, seen from a ball along an aim."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from ..physics.cue.cue_body import BUTT, CueBody, Way
from ..physics.detect import Jaw, Pocket, Rail
from ..physics.standing import inside
from .geometry import Geometry
from .outline import Point, widened

# A place this near a line, m, is on it.
_ON = 1e-9
_QUARTER = 0.5 * math.pi


class AimFrame(NamedTuple):
    """Where an aim is seen from: a ball's place, and the cosine and sine of the cue's direction."""

    x: float
    y: float
    cos: float
    sin: float

    def seen(self, x: float, y: float) -> Point:
        """A place of the table by how far it is behind the ball, and to the right of the aim."""
        return self.turned(x - self.x, y - self.y)

    def turned(self, dx: float, dy: float) -> Point:
        return -dx * self.cos - dy * self.sin, dx * self.sin - dy * self.cos

    def place(self, back: float, right: float) -> Point:
        """The place of the table that is seen there."""
        return self.x - back * self.cos + right * self.sin, self.y - back * self.sin - right * self.cos


class StraightEdge(NamedTuple):
    """A straight edge between two places; `name` is that of its cushion, jaw or pocket's back."""

    name: str
    a: Point
    b: Point

    def ways(self, frame: AimFrame, cue: CueBody) -> Iterator[Way]:
        """The part of it that is behind the ball, no further aside than a butt is thick, and within the cue's reach."""
        ax, ay = frame.seen(*self.a)
        bx, by = frame.seen(*self.b)
        dx, dy = bx - ax, by - ay
        low, high = 0.0, 1.0
        for start, change in ((ax, dx), (ay - cue.side + BUTT, dy), (cue.side + BUTT - ay, -dy)):
            if change == 0.0:
                high = high if start >= 0.0 else -1.0
            elif change > 0.0:
                low = max(low, -start / change)
            else:
                high = min(high, -start / change)
        if low < high:
            # The cue's reach is a circle about the ball.
            square, half = dx * dx + dy * dy, ax * dx + ay * dy
            part = half * half - square * (ax * ax + ay * ay - cue.reach * cue.reach)
            if part > 0.0:
                low, high = max(low, (-half - math.sqrt(part)) / square), min(high, (-half + math.sqrt(part)) / square)
                if low < high:
                    yield _straight(ax + low * dx, ay + low * dy, (high - low) * dx, (high - low) * dy)


class RoundEdge(NamedTuple):
    """An edge round (x, y), counter-clockwise from the direction `start` on, radians, through a positive `sweep`."""

    name: str
    x: float
    y: float
    radius: float
    start: float
    sweep: float

    def ways(self, frame: AimFrame, cue: CueBody) -> Iterator[Way]:
        """Its parts that do not turn back, as seen along the aim, where they may come to the cue."""
        x, y = frame.seen(self.x, self.y)
        if x + self.radius <= 0.0 or abs(y - cue.side) > self.radius + BUTT or x - self.radius > cue.reach:
            return
        # The frame's x points back along the aim, so it is turned by that and a half turn.
        start = self.start + math.pi - math.atan2(frame.sin, frame.cos)
        end = start + self.sweep
        quarters = range(math.floor(start / _QUARTER) + 1, math.ceil(end / _QUARTER))
        turns = [start, *(_QUARTER * turn for turn in quarters), end]
        for a, b in pairwise(turns):
            yield _round(x, y, self.radius, a, b - a)


Edge = StraightEdge | RoundEdge


class RailTops:
    """The level tops of a table's rails, at a `height`, m, from the noses to the outer edge.

    `inner` are their edges toward the table, noses, facings, jaws and the backs of the pockets, `outer` those away
    from it.
    """

    def __init__(self, geometry: Geometry, height: float, width: float) -> None:
        self.height = height
        self.inner = tuple(_inner(geometry))
        corners = widened(geometry.corners, width)
        names = [corner.cushion for corner in geometry.corners]
        self.outer = tuple(map(StraightEdge, names, corners, (*corners[1:], corners[0])))
        self._within = corners
        self._cloth = list(geometry.outline)
        self._holes = geometry.pockets

    def covers(self, x: float, y: float) -> bool:
        """Whether there is a rail's top at a place."""
        if inside(x, y, self._cloth) or not inside(x, y, self._within):
            return False
        return not any(
            math.hypot(x - hole.x, y - hole.y) < hole.radius and (x - hole.x) * hole.ux + (y - hole.y) * hole.uy <= 0.0
            for hole in self._holes
        )

    def beside(self, x: float, y: float) -> str:
        """The cushion or pocket whose edge is the nearest to a place on the rails."""
        return min(self.inner, key=lambda edge: _distance(edge, x, y)).name


def _inner(geometry: Geometry) -> Iterator[Edge]:
    facings: list[Point] = []
    for element in geometry.elements:
        if isinstance(element, Rail):
            yield StraightEdge(element.name, (element.ax, element.ay), (element.bx, element.by))
            facings += [(element.ax, element.ay), (element.bx, element.by)] if element.facing else []
        elif isinstance(element, Jaw) and element.radius > 0.0:
            yield RoundEdge(element.name, element.x, element.y, element.radius, 0.0, math.tau)
        elif isinstance(element, Pocket):
            yield from _back(element, facings)


def _back(hole: Pocket, facings: Sequence[Point]) -> Iterator[Edge]:
    """The back of a pocket: round the half of its hole away from the table, and from there to its facings' ends."""
    ux, uy = hole.ux, hole.uy
    name = f"{hole.name} back"
    yield RoundEdge(name, hole.x, hole.y, hole.radius, math.atan2(uy, ux) + 0.5 * math.pi, math.pi)
    for x, y in facings:
        beside = (x - hole.x) * -uy + (y - hole.y) * ux
        if abs((x - hole.x) * ux + (y - hole.y) * uy) < _ON and 0.0 < abs(beside) < hole.radius:
            far = math.copysign(hole.radius, beside)
            yield StraightEdge(name, (x, y), (hole.x - far * uy, hole.y + far * ux))


def _distance(edge: Edge, x: float, y: float) -> float:
    if isinstance(edge, RoundEdge):
        return abs(math.hypot(x - edge.x, y - edge.y) - edge.radius)
    (ax, ay), (bx, by) = edge.a, edge.b
    dx, dy = bx - ax, by - ay
    along = min(max(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0.0), 1.0)
    return math.hypot(x - ax - along * dx, y - ay - along * dy)


def _straight(x: float, y: float, dx: float, dy: float) -> Way:
    return lambda s: (x + s * dx, y + s * dy, dx, dy)


def _round(x: float, y: float, radius: float, start: float, sweep: float) -> Way:
    def way(s: float) -> tuple[float, float, float, float]:
        turn = start + s * sweep
        cos, sin = radius * math.cos(turn), radius * math.sin(turn)
        return x + cos, y + sin, -sweep * sin, sweep * cos

    return way
