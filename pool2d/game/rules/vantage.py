"""From where in its area a cue ball in hand is not snookered, worked out exactly.

The line that grazes a ball on is open up to the nearest ball in its way. So what is shut off from the cue ball lies
behind that ball, between lines that touch both balls; and where the cue ball may be put ends at lines (of the area, of
cushions) and at circles round the balls. If any place is left, then so is one where two of these lines and circles
cross, and it is enough to look at the crossings. For take the place that is left nearest to the foot, of several the
one with the greatest y: on a line one can go on along it, outside a circle on round it, and on the bow of the D on to
one of its ends, until another line or circle is met.

Places are right to a nanometre, and a ball may reach 0.1 um into a line without standing in its way.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from functools import cache
from itertools import chain, combinations
from typing import NamedTuple, TypeAlias

from ...physics.detect import Jaw, Pocket, Rail
from ...physics.values import Ball, Layout
from ...table.outline import Point, edges
from ...table.table import Table
from .sight import JAW, Disc, SightLines, view
from .spotting import HAIR, KITCHEN, D, Where, within


class StraightLine(NamedTuple):
    """The line of all points whose nx x + ny y is `far`; (nx, ny) is a unit vector."""

    nx: float
    ny: float
    far: float


Curve: TypeAlias = StraightLine | Disc


class Area:
    """Where a cue ball in hand may be put: on the table, in the kitchen or the D, with room beside the other balls."""

    def __init__(self, table: Table, layout: Layout, cue: Ball, where: Where) -> None:
        self.table, self.where = table, where
        self.radius = table.body_of(cue)[0]
        self.balls = [Disc(b.x, b.y, table.touch(cue, b)) for b in layout.on_table() if b.id != cue.id]
        self.box = self._box()
        self.curves = [curve for curve in self._curves() if self.crossed(curve)]

    def allows(self, place: Point) -> bool:
        """Whether the cue ball may be put at a place, which may be a nanometre beside the area."""
        x, y = place
        if not self.boxes(place) or not within(self.table, D if self.where == D else "", x, y):
            return False
        if any(math.hypot(ball.x - x, ball.y - y) < ball.touch - HAIR for ball in self.balls):
            return False
        return self.table.element_gap(x, y, self.radius)[0] >= -HAIR

    @property
    def middle(self) -> Point:
        """The middle of the box round the area."""
        left, low, right, high = self.box
        return 0.5 * (left + right), 0.5 * (low + high)

    def boxes(self, place: Point) -> bool:
        """Whether a place is in the box round the area."""
        left, low, right, high = self.box
        return left - HAIR <= place[0] <= right + HAIR and low - HAIR <= place[1] <= high + HAIR

    def crossed(self, curve: Curve) -> bool:
        """Whether a curve may cross the area: by the box round it."""
        left, low, right, high = self.box
        if isinstance(curve, Disc):
            return (
                left - curve.touch <= curve.x <= right + curve.touch
                and low - curve.touch <= curve.y <= high + curve.touch
            )
        sides = [curve.nx * x + curve.ny * y - curve.far for x in (left, right) for y in (low, high)]
        return min(sides) <= HAIR and max(sides) >= -HAIR

    def _box(self) -> tuple[float, float, float, float]:
        """The box round the area: left, low, right, high."""
        box = [f(values) for f in (min, max) for values in zip(*self.table.geometry.outline, strict=True)]
        line = self.table.furniture.head_string
        if line is not None and self.where == KITCHEN:
            # The line itself is not in the kitchen.
            box[2] = line - HAIR
        if line is not None and self.where == D:
            radius, y = self.table.furniture.d_radius, self.table.furniture.spots["head"][1]
            box = [line - radius, y - radius, line, y + radius]
        left, low, right, high = box
        return left, low, right, high

    def _curves(self) -> Iterator[Curve]:
        """What bounds the area: its line or bow, the balls, cushions, the jaws, and the drops that lie behind them."""
        yield StraightLine(1.0, 0.0, self.box[2])
        if self.where == D:
            yield Disc(self.box[2], self.table.furniture.spots["head"][1], self.table.furniture.d_radius)
        yield from self.balls
        reach = self.table.reach(self.radius)
        for a, b in edges(self.table.geometry.corners):
            yield from self._along((a.x, a.y), (b.x, b.y), reach)
        for element in self.table.elements:
            if isinstance(element, Rail) and element.name.endswith(JAW):
                yield from self._along((element.ax, element.ay), (element.bx, element.by), reach)
            elif isinstance(element, Jaw):
                yield Disc(element.x, element.y, element.radius + reach)
            elif isinstance(element, Pocket):
                yield Disc(element.x, element.y, element.radius)

    def _along(self, a: Point, b: Point, gap: float) -> Iterator[StraightLine]:
        """The line to the left of a segment, where that may cross the area."""
        size = math.dist(a, b)
        nx, ny = (a[1] - b[1]) / size, (b[0] - a[0]) / size
        line = StraightLine(nx, ny, nx * a[0] + ny * a[1] + gap)
        if self.crossed(line):
            yield line


def vantage(
    table: Table, layout: Layout, cue: Ball, on: Collection[str], where: Where, between: bool = False
) -> Point | None:
    """A place in an area from which a cue ball in hand is not snookered (2.17 a); None where there is none."""
    area, seen = Area(table, layout, cue, where), view(table, layout, cue, on, between=between)
    own = [place for a, b in combinations(area.curves, 2) for place in _meet(a, b) if area.boxes(place)]
    # Asked for one by one: the first that will do ends the search.
    allowed = cache(area.allows)
    for target in seen.targets:
        found = next((place for place in own if allowed(place) and seen.open(table, place, target)), None)
        if found is not None:
            return found
    for target in seen.targets:
        lines = _grazing(area, seen, target)
        for place in chain(_crossings(area, lines), _touching(area, lines)):
            if seen.open(table, place, target) and area.allows(place):
                return place
    return None


def _grazing(area: Area, seen: SightLines, target: Disc) -> list[StraightLine]:
    """The lines across an area that graze a ball on, and at which something comes into their way or leaves it.

    None where a ball hides the whole of the area: its shadow has no end there.
    """
    jaws = [jaw for _, jaw in seen.jaws if _crossing(area, target, jaw)]
    lines: list[StraightLine] = []
    for other in seen.others:
        found = _crossing(area, target, other)
        if (
            not found
            and not jaws
            and not area.crossed(other)
            and not seen.alone(other).open(area.table, area.middle, target)
        ):
            return []
        lines += found
    for jaw in jaws:
        lines += _crossing(area, target, jaw)
        # Here a jaw comes to be nearer than a ball.
        for other in seen.others:
            for x, y in _meet(jaw, other):
                lines += _crossing(area, target, Disc(x, y, 0.0))
    return lines


def _crossing(area: Area, target: Disc, other: Disc) -> list[StraightLine]:
    """The lines across an area that graze a ball on and another disc, which lies on the way."""
    return [line for line in _common(target, other) if area.crossed(line) and _on_the_way(area, target, other, line)]


def _on_the_way(area: Area, target: Disc, other: Disc, line: StraightLine) -> bool:
    """Whether a disc lies on a line between where that grazes a ball on and a part of the area."""
    x, y, far = -line.ny, line.nx, line.nx * target.y - line.ny * target.x
    left, low, right, high = area.box
    ends = [x * a + y * b - far for a in (left, right) for b in (low, high)]
    at = x * other.x + y * other.y - far
    ahead = at >= -other.touch and max(ends) >= at - other.touch
    return ahead or (at <= other.touch and min(ends) <= at + other.touch)


def _common(ball: Disc, other: Disc) -> Iterator[StraightLine]:
    """The lines that graze a ball and another disc, or graze the ball where the disc reaches it."""
    wx, wy = other.x - ball.x, other.y - ball.y
    size = math.hypot(wx, wy)
    if not size:
        return
    parts = {ball.touch + other.touch, ball.touch - other.touch}
    if size < ball.touch + other.touch:
        parts.add((size * size + ball.touch * ball.touch - other.touch * other.touch) / (2.0 * ball.touch))
    way = math.atan2(wy, wx)
    for part in sorted(parts):
        if abs(part) <= size:
            turn = math.acos(part / size)
            for angle in (way - turn, way + turn):
                nx, ny = math.cos(angle), math.sin(angle)
                yield StraightLine(nx, ny, nx * ball.x + ny * ball.y + ball.touch)


def _crossings(area: Area, lines: list[StraightLine]) -> Iterator[Point]:
    """The points in the box round the area where these lines cross each other and the straight ends of the area.

    Where balls crowd there are thousands of pairs, of which few cross there: most are rejected by x alone.
    """
    every = [*lines, *(curve for curve in area.curves if isinstance(curve, StraightLine))]
    left, low, right, high = area.box
    left, low, right, high = left - HAIR, low - HAIR, right + HAIR, high + HAIR
    for at, (ax, ay, far) in enumerate(lines):
        for bx, by, other in every[at + 1 :]:
            turn = ax * by - ay * bx
            if turn and left <= (x := (far * by - other * ay) / turn) <= right:
                y = (ax * other - bx * far) / turn
                if low <= y <= high:
                    yield x, y


def _touching(area: Area, lines: list[StraightLine]) -> Iterator[Point]:
    """The points in the box round the area where these lines meet the round ends of the area."""
    discs = [curve for curve in area.curves if isinstance(curve, Disc)]
    for line in lines:
        nx, ny, far = line
        for disc in discs:
            if abs(far - nx * disc.x - ny * disc.y) <= disc.touch + HAIR:
                yield from (place for place in _on_circle(disc, line) if area.boxes(place))


def _meet(a: Curve, b: Curve) -> Iterator[Point]:
    """The points where two curves meet."""
    if isinstance(a, StraightLine) and isinstance(b, StraightLine):
        turn = a.nx * b.ny - a.ny * b.nx
        if turn:
            yield (a.far * b.ny - b.far * a.ny) / turn, (a.nx * b.far - b.nx * a.far) / turn
    elif isinstance(a, StraightLine) and isinstance(b, Disc):
        yield from _on_circle(b, a)
    elif isinstance(a, Disc) and isinstance(b, StraightLine):
        yield from _on_circle(a, b)
    elif isinstance(a, Disc) and isinstance(b, Disc):
        wx, wy = b.x - a.x, b.y - a.y
        size = math.hypot(wx, wy)
        if size:
            nx, ny = wx / size, wy / size
            along = 0.5 * (size + (a.touch - b.touch) * (a.touch + b.touch) / size)
            yield from _on_circle(a, StraightLine(nx, ny, nx * a.x + ny * a.y + along))


def _on_circle(disc: Disc, line: StraightLine) -> Iterator[Point]:
    """Where a line crosses a circle; where it misses by less than a hair, it touches."""
    gap = line.far - line.nx * disc.x - line.ny * disc.y
    if abs(gap) > disc.touch + HAIR:
        return
    half = math.sqrt(max(0.0, disc.touch * disc.touch - gap * gap))
    x, y = disc.x + gap * line.nx, disc.y + gap * line.ny
    yield x - half * line.ny, y + half * line.nx
    if half:
        yield x + half * line.ny, y - half * line.nx
