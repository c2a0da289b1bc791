"""What a cue ball can be sent at in a straight line: what it sees of a ball, and whether it is snookered.

A line is that of the cue ball's middle. A ball stands in its way where the two would touch before the end.
Clauses are those of the WPBSA's rules of snooker; the World Rules of eight-ball pool (O) mean the same.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator
from typing import NamedTuple

from ...outline import Point
from ...physics.values import Ball, Layout
from ...table import Table
from ..report import FROZEN

# What a ball may reach into a line without standing in its way, m: more than rounding, less than can be seen.
_HAIR = 1e-7


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


def snookered(table: Table, layout: Layout, cue: Ball, on: Collection[str], by: Collection[str] | None = None) -> bool:
    """2.17: whether no ball on can be hit at both its edges, for balls that are not on.

    `by` are the balls that may stand in the way, all that are not on where not given. Of a cushion only the
    curved face matters (e): where it is nearer than the ball in the way, that ball snookers nothing.
    """
    return _snookered(table, (cue.x, cue.y), *_discs(table, layout, cue, on, by))


def snookering(table: Table, layout: Layout, cue: Ball, on: Collection[str]) -> str:
    """2.17 (b), (c): the nearest ball that by itself snookers the cue ball on every ball on; "" for none."""
    others = [ball for ball in layout.on_table() if ball.id != cue.id and ball.id not in on]
    others.sort(key=lambda ball: math.hypot(ball.x - cue.x, ball.y - cue.y))
    return next((ball.id for ball in others if snookered(table, layout, cue, on, (ball.id,))), "")


def snookered_from(table: Table, layout: Layout, cue: Ball, on: Collection[str], places: Iterable[Point]) -> bool:
    """2.17 (a): whether a cue ball in hand is snookered from all the places at which it has room."""
    targets, others = _discs(table, layout, cue, on)
    radius = table.body_of(cue)[0]
    return all(
        _snookered(table, place, targets, others) or not table.has_room(*place, radius, layout, ignore=cue.id)
        for place in places
    )


def sees(table: Table, layout: Layout, cue: Ball, on: Collection[str]) -> bool:
    """Whether any part of a ball on can be hit in a straight line."""
    targets, others = _discs(table, layout, cue, on)
    return any(_part_open((cue.x, cue.y), target, others) for target in targets)


def sees_full(table: Table, layout: Layout, cue: Ball, on: Collection[str]) -> bool:
    """Whether the middle of a ball on can be hit in a straight line, but for other balls on."""
    targets, others = _discs(table, layout, cue, on)
    place = (cue.x, cue.y)
    return any(_open(_line_to(place, target, _angle(place, target)), others) for target in targets)


def _discs(
    table: Table, layout: Layout, cue: Ball, on: Collection[str], by: Collection[str] | None = None
) -> tuple[list[Disc], list[Disc]]:
    """The balls on, and the balls that may stand in the way."""
    targets, others = [], []
    for ball in layout.on_table():
        disc = Disc(ball.x, ball.y, table.touch(cue, ball))
        if ball.id in on:
            targets.append(disc)
        elif ball.id != cue.id and (by is None or ball.id in by):
            others.append(disc)
    return targets, others


def _snookered(table: Table, place: Point, targets: list[Disc], others: list[Disc]) -> bool:
    return not any(_edges_open(table, place, target, others) for target in targets)


def _edges_open(table: Table, place: Point, target: Disc, others: list[Disc]) -> bool:
    lines = _edges(place, target)
    return all(_open(line, others) or _jaw_first(table, line, others) for line in lines)


def _edges(place: Point, target: Disc) -> tuple[Line, ...]:
    """The two lines that graze a ball; none where the cue ball touches it."""
    far = _gap(place, target)
    if far <= target.touch + FROZEN:
        return ()
    middle, half = _angle(place, target), math.asin(target.touch / far)
    length = math.sqrt(far * far - target.touch * target.touch)
    return tuple(_line(place, middle + turn, length) for turn in (-half, half))


def _part_open(place: Point, target: Disc, others: list[Disc]) -> bool:
    far = _gap(place, target)
    if far <= target.touch + FROZEN:
        return True
    middle, half = _angle(place, target), math.asin(target.touch / far)
    return any(_open(_line_to(place, target, angle), others) for angle in _angles(place, middle, half, others))


def _angles(place: Point, middle: float, half: float, others: list[Disc]) -> Iterator[float]:
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


def _open(line: Line, others: list[Disc]) -> bool:
    return all(line.meets(other) >= line.length for other in others)


def _jaw_first(table: Table, line: Line, others: list[Disc]) -> bool:
    """Whether a pocket's jaw is nearer on a line than the balls in its way."""
    stop = min(line.meets(other) for other in others)
    x, y, room = line.x + stop * line.dx, line.y + stop * line.dy, table.knobs.ball.radius
    near = table.near(min(x, line.x) - room, min(y, line.y) - room, max(x, line.x) + room, max(y, line.y) + room)
    if not any(table.elements[index].name.endswith(" jaw") for index in near):
        return False
    far, name = table.cast(line.x, line.y, line.dx, line.dy, Layout())
    return far < stop and (name or "").endswith(" jaw")
