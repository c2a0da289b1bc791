"""The outline of a playing surface: a polygon of corners, some of which hold pockets."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from ..errors import InputError

Point = tuple[float, float]
Edge = tuple["Corner", "Corner"]

# How near each other corners, and edges that do not meet, may be, m: two radii of the largest ball.
NEAR = 0.12
# What an interior angle may be, degrees. A nose that turned further outward would have no room behind it.
SHARPEST, WIDEST = 30.0, 270.0
# Angles that differ by less, radians, are the same.
_SAME = 1e-6


@dataclass(frozen=True, slots=True)
class Corner:
    """A corner of the outline: where, the name of the cushion that leaves it, and its pocket if any."""

    x: float
    y: float
    cushion: str
    pocket: str = ""
    kind: str = "corner"


# The usual table, in parts of its length and width: pockets in the corners and the long sides' middles.
RECTANGLE = (
    Corner(0.0, 0.0, "bottom-left", "bottom-left"),
    Corner(0.5, 0.0, "bottom-right", "bottom-side", "side"),
    Corner(1.0, 0.0, "right", "bottom-right"),
    Corner(1.0, 1.0, "top-right", "top-right"),
    Corner(0.5, 1.0, "top-left", "top-side", "side"),
    Corner(0.0, 1.0, "left", "top-left"),
)


def scaled(corners: Sequence[Corner], length: float, width: float, source: str) -> tuple[Corner, ...]:
    """An outline given in parts of length and width, in m and counter-clockwise.

    Raises InputError where no table can have that outline.
    """
    placed = [replace(corner, x=corner.x * length, y=corner.y * width) for corner in corners]
    if len(placed) < 3:
        raise InputError(source, "outline", len(placed), "allowed are three corners or more")
    if _area(placed) < 0.0:
        # A cushion leaves its corner; the other way round that is the one before it.
        names = [corner.cushion for corner in placed]
        placed = [replace(corner, cushion=names[i - 1]) for i, corner in enumerate(placed)][::-1]
    _check_names(placed, source)
    _check_edges(placed, source)
    _check_angles(placed, source)
    return tuple(placed)


def turn_at(corners: Sequence[Corner], i: int) -> float:
    """The interior angle of a counter-clockwise outline at corner i, in radians."""
    before, here, after = corners[i - 1], corners[i], corners[(i + 1) % len(corners)]
    ahead = math.atan2(after.y - here.y, after.x - here.x)
    back = math.atan2(before.y - here.y, before.x - here.x)
    return (back - ahead) % math.tau


def edges(corners: Sequence[Corner]) -> list[Edge]:
    """From each corner to the next, and back to the first."""
    return list(zip(corners, (*corners[1:], corners[0]), strict=True))


def sides(corners: Sequence[Corner]) -> list[Edge]:
    """The straight sides of an outline: its edges, joined where they go straight on."""
    return edges([corner for i, corner in enumerate(corners) if abs(turn_at(corners, i) - math.pi) > _SAME])


def widened(corners: Sequence[Corner], by: float) -> list[Point]:
    """The corners of an outline whose edges all lie further out by so much, m: a rail's outer edge."""
    found = []
    for i, here in enumerate(corners):
        before, after = corners[i - 1], corners[(i + 1) % len(corners)]
        (ax, ay), (bx, by_) = _outward(before, here), _outward(here, after)
        part = by / (1.0 + ax * bx + ay * by_)
        found.append((here.x + part * (ax + bx), here.y + part * (ay + by_)))
    return found


def _outward(a: Corner, b: Corner) -> Point:
    """The unit vector across an edge, away from the playing surface on its left."""
    length = math.hypot(b.x - a.x, b.y - a.y)
    return (b.y - a.y) / length, (a.x - b.x) / length


def distance_to_edge(x: float, y: float, edge: Edge) -> float:
    """How far a point is from an edge."""
    a, b = edge
    dx, dy = b.x - a.x, b.y - a.y
    along = ((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy)
    along = min(max(along, 0.0), 1.0)
    return math.hypot(x - a.x - along * dx, y - a.y - along * dy)


def _check_names(corners: Sequence[Corner], source: str) -> None:
    """Raises InputError for a name that is used twice: events tell cushions and pockets by name."""
    for names in ([corner.cushion for corner in corners], [corner.pocket for corner in corners if corner.pocket]):
        for name in names:
            if names.count(name) > 1:
                raise InputError(source, "outline", name, "this name is used twice")


def _check_edges(corners: Sequence[Corner], source: str) -> None:
    """Raises InputError for edges that are too short, cross, or come too near each other."""
    every = edges(corners)
    for a, b in every:
        length = math.hypot(b.x - a.x, b.y - a.y)
        if length < NEAR:
            allowed = f"the edge from here is {length:.3g} m long; allowed is {NEAR:g} m or more"
            raise InputError(source, f"outline, cushion {a.cushion}", (a.x, a.y), allowed)
    for i, one in enumerate(every):
        # The next edge meets this one, and so does the last the first.
        for other in every[i + 2 : len(every) - (i == 0)]:
            both = (one[0].cushion, other[0].cushion)
            if _cross(one, other):
                raise InputError(source, "outline", both, "the outline crosses itself at these edges")
            gap = _gap(one, other)
            if gap < NEAR:
                allowed = f"these edges come within {gap:.3g} m of each other; allowed is {NEAR:g} m or more"
                raise InputError(source, "outline", both, allowed)


def _check_angles(corners: Sequence[Corner], source: str) -> None:
    """Raises InputError for a corner that is too sharp, and for a pocket where the outline turns outward."""
    for i, corner in enumerate(corners):
        turn = turn_at(corners, i)
        key, place = "outline, corner before " + corner.cushion, (round(corner.x, 4), round(corner.y, 4))
        if not math.radians(SHARPEST) - _SAME <= turn <= math.radians(WIDEST) + _SAME:
            allowed = f"the angle is too sharp, {math.degrees(turn):.1f}; allowed is {SHARPEST:g} to {WIDEST:g} degrees"
            raise InputError(source, key, place, allowed)
        if corner.pocket and turn > math.pi + _SAME:
            raise InputError(source, key, place, "allowed is no pocket where the outline turns outward")


def _cross(one: Edge, other: Edge) -> bool:
    return all(_side(*a, b[0]) * _side(*a, b[1]) < 0.0 for a, b in ((one, other), (other, one)))


def _gap(one: Edge, other: Edge) -> float:
    """The distance of two edges that do not cross."""
    return min(distance_to_edge(end.x, end.y, a) for a, b in ((one, other), (other, one)) for end in b)


def _side(a: Corner, b: Corner, c: Corner) -> float:
    """Positive where c is left of the line from a to b, negative where right."""
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)


def _area(corners: Sequence[Corner]) -> float:
    """Twice the area, negative where the corners go round clockwise."""
    return math.fsum(corners[i - 1].x * here.y - here.x * corners[i - 1].y for i, here in enumerate(corners))
