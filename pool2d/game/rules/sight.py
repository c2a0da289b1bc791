"""What a cue ball can be sent at in a straight line: what it sees of a ball, and whether it is snookered.

A line is that of the cue ball's middle. A ball stands in its way where the two would touch before the end.
Clauses are those of the WPBSA's rules of snooker; the World Rules of eight-ball pool (O) mean the same.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator
from typing import NamedTuple

from ...physics.detect import Jaw
from ...physics.values import Ball, Layout
from ...table.arrivals import FROZEN
from ...table.outline import Point, distance_to_edge, edges
from ...table.table import Table

# What a ball may reach into a line without standing in its way, m: more than rounding, less than can be seen.
_HAIR = 1e-7
# What the names of jaws end in, after the pocket's.
JAW = " jaw"


class Disc(NamedTuple):
    """A place that the cue ball's middle cannot come nearer to than `touch`: a ball."""

    x: float
    y: float
    touch: float


class Line(NamedTuple):
    """A way from a point along a unit vector, and how far it goes, m."""

    x: float
    y: float
    dx: float
    dy: float
    length: float

    def meets(self, disc: Disc) -> float:
        """How far along the line a ball is met; infinite where it is not."""
        dx, dy = disc.x - self.x, disc.y - self.y
        along, aside = dx * self.dx + dy * self.dy, dy * self.dx - dx * self.dy
        if along <= 0.0 or abs(aside) >= disc.touch - _HAIR:
            return math.inf
        return along - math.sqrt(disc.touch * disc.touch - aside * aside)


class SightLines(NamedTuple):
    """What a cue ball may meet on straight lines: the balls on, the balls in their way, the jaws of pockets by name.

    `edge` is how near to the outline its middle comes along a cushion; between the jaws of a pocket it comes nearer.
    `between`: a jaw snookers the ball that lies between it and its like (World Rules, Q). Without, it snookers nothing,
    nor does a ball behind it (2.17 e).
    """

    targets: tuple[Disc, ...]
    others: tuple[Disc, ...]
    jaws: tuple[tuple[str, Disc], ...]
    edge: float
    between: bool

    def open(self, table: Table, place: Point, target: Disc) -> bool:
        """Whether a ball on can be hit at both its edges from a place."""
        lines = []
        for line in _edges(place, target):
            if not _open(line, self.others) and (self.between or not self._jaw_first(line)):
                return False
            lines.append(line)
        if not self.between or not lines:
            return True
        jaws = self.beside(table, place)
        return all(_open(line, jaws) for line in lines)

    def partly_open(self, table: Table, place: Point, target: Disc) -> bool:
        """Whether any part of a ball on can be hit from a place."""
        if not _part_open(place, target, self.others):
            return False
        jaws = self.beside(table, place) if self.between else ()
        return not jaws or _part_open(place, target, (*self.others, *jaws))

    def beside(self, table: Table, place: Point) -> tuple[Disc, ...]:
        """The jaws of the pocket between whose jaws a ball lies; none where it lies between none."""
        pocket = mouth(table, place, self.edge) if self.jaws else ""
        return tuple(disc for name, disc in self.jaws if name == pocket)

    def alone(self, other: Disc) -> SightLines:
        """The view with only one ball in the way, and no jaws."""
        return self._replace(others=(other,), jaws=())

    def _jaw_first(self, line: Line) -> bool:
        """Whether a pocket's jaw is nearer on a line than the balls in its way."""
        stop = min(line.meets(other) for other in self.others)
        return any(line.meets(jaw) < stop for _, jaw in self.jaws)


def view(
    table: Table,
    layout: Layout,
    cue: Ball,
    on: Collection[str],
    by: Collection[str] | None = None,
    between: bool = False,
) -> SightLines:
    """What a cue ball may meet; `by` are the balls that may stand in the way, all that are not on where not given."""
    edge = table.reach(table.body_of(cue)[0])
    jaws = tuple(
        (element.name.removesuffix(JAW), Disc(element.x, element.y, element.radius + edge))
        for element in table.elements
        if isinstance(element, Jaw) and element.name.endswith(JAW)
    )
    return SightLines(*_discs(table, layout, cue, on, by), jaws, edge, between)


def mouth(table: Table, place: Point, edge: float) -> str:
    """The pocket between whose jaws a ball lies: it is nearer to the outline than it gets to a cushion; "" for none."""
    if table.on_surface(*place) and all(
        distance_to_edge(*place, side) >= edge - _HAIR for side in edges(table.geometry.corners)
    ):
        return ""
    pockets = table.geometry.pockets
    return min(pockets, key=lambda pocket: math.dist(place, (pocket.x, pocket.y))).name if pockets else ""


def snookered(
    table: Table,
    layout: Layout,
    cue: Ball,
    on: Collection[str],
    by: Collection[str] | None = None,
    between: bool = False,
) -> bool:
    """2.17: whether no ball on can be hit at both its edges, for balls that are not on.

    `by` are the balls that may stand in the way, all that are not on where not given. Of a cushion only the
    curved face matters (e): where it is nearer than the ball in the way, that ball snookers nothing. With `between` it
    snookers itself the ball between the jaws (World Rules, Q).
    """
    seen = view(table, layout, cue, on, by, between)
    return not any(seen.open(table, (cue.x, cue.y), target) for target in seen.targets)


def snookering(table: Table, layout: Layout, cue: Ball, on: Collection[str]) -> str:
    """2.17 (b), (c): the nearest ball that by itself snookers the cue ball on every ball on; "" for none."""
    others = [ball for ball in layout.on_table() if ball.id != cue.id and ball.id not in on]
    others.sort(key=lambda ball: math.hypot(ball.x - cue.x, ball.y - cue.y))
    return next((ball.id for ball in others if snookered(table, layout, cue, on, (ball.id,))), "")


def sees(table: Table, layout: Layout, cue: Ball, on: Collection[str], between: bool = False) -> bool:
    """Whether any part of a ball on can be hit in a straight line; `between` as for `snookered`."""
    seen = view(table, layout, cue, on, between=between)
    return any(seen.partly_open(table, (cue.x, cue.y), target) for target in seen.targets)


def sees_full(table: Table, layout: Layout, cue: Ball, on: Collection[str]) -> bool:
    """Whether the middle of a ball on can be hit in a straight line, but for other balls on."""
    targets, others = _discs(table, layout, cue, on)
    place = (cue.x, cue.y)
    return any(_open(_line_to(place, target, _angle(place, target)), others) for target in targets)


def _discs(
    table: Table, layout: Layout, cue: Ball, on: Collection[str], by: Collection[str] | None = None
) -> tuple[tuple[Disc, ...], tuple[Disc, ...]]:
    """The balls on, and the balls that may stand in the way."""
    targets, others = [], []
    for ball in layout.on_table():
        disc = Disc(ball.x, ball.y, table.touch(cue, ball))
        if ball.id in on:
            targets.append(disc)
        elif ball.id != cue.id and (by is None or ball.id in by):
            others.append(disc)
    return tuple(targets), tuple(others)


def _edges(place: Point, target: Disc) -> Iterator[Line]:
    """The two lines that graze a ball; none where the cue ball touches it."""
    far = _gap(place, target)
    if far <= target.touch + FROZEN:
        return
    middle, half = _angle(place, target), math.asin(target.touch / far)
    length = math.sqrt(far * far - target.touch * target.touch)
    for turn in (-half, half):
        yield _line(place, middle + turn, length)


def _part_open(place: Point, target: Disc, others: Iterable[Disc]) -> bool:
    far = _gap(place, target)
    if far <= target.touch + FROZEN:
        return True
    middle, half = _angle(place, target), math.asin(target.touch / far)
    return any(_open(_line_to(place, target, angle), others) for angle in _angles(place, middle, half, others))


def _angles(place: Point, middle: float, half: float, others: Iterable[Disc]) -> Iterator[float]:
    """The ways at which a ball comes into sight, if it does: at its own edges, or past those of another ball."""
    # A grazed ball counts as hit, so the edges are taken a hair within.
    yield from (middle, middle - half * (1.0 - 1e-9), middle + half * (1.0 - 1e-9))
    for other in others:
        width, at = math.asin(min(other.touch / _gap(place, other), 1.0)), _angle(place, other)
        for angle in (at - width, at + width):
            if abs((angle - middle + math.pi) % math.tau - math.pi) < half:
                yield angle


def _gap(place: Point, disc: Disc) -> float:
    return math.hypot(disc.x - place[0], disc.y - place[1])


def _angle(place: Point, disc: Disc) -> float:
    return math.atan2(disc.y - place[1], disc.x - place[0])


def _line(place: Point, angle: float, length: float) -> Line:
    return Line(*place, math.cos(angle), math.sin(angle), length)


def _line_to(place: Point, target: Disc, angle: float) -> Line:
    """The way at an angle as far as a ball."""
    way = _line(place, angle, math.inf)
    return way._replace(length=way.meets(target))


def _open(line: Line, others: Iterable[Disc]) -> bool:
    return all(line.meets(other) >= line.length for other in others)
