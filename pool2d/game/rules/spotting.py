"""Where the cue ball may be put and where balls are spotted: geometry on a table with balls in the way."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Final, Literal, TypeAlias

from ...physics.values import Layout
from ...table.outline import Point
from ...table.table import Table

# Areas of a cue ball in hand; "" where it is not in hand.
Where: TypeAlias = Literal["", "anywhere", "kitchen", "d"]
ANYWHERE: Final = "anywhere"
KITCHEN: Final = "kitchen"
D: Final = "d"
AREAS: Mapping[Where, str] = {ANYWHERE: "anywhere on the table", KITCHEN: "behind the head string", D: "in the D"}
# What is left between a spotted ball and one it must not overlap, m: more than rounding, less than can be seen.
HAIR = 1e-9
# What is left to a ball that must not be touched, m.
CLEAR = 1e-4


def within(table: Table, where: Where, x: float, y: float) -> bool:
    """Whether a point is in an area of the bed; the kitchen is without its line, the D with it.

    The shelves of pockets are of the bed: a ball that stopped there is on the table.
    """
    line = table.furniture.head_string
    if not table.on_cloth(x, y):
        return False
    if where == KITCHEN and line is not None:
        return x < line
    if where == D and line is not None:
        head = table.furniture.spots["head"]
        return x <= line + HAIR and math.hypot(x - line, y - head[1]) <= table.furniture.d_radius + HAIR
    return True


def may_place(table: Table, layout: Layout, ball: str, where: Where, x: float, y: float) -> bool:
    """Whether a ball in hand may be put here: within the area, and with room."""
    radius = table.body_of(layout[ball])[0]
    return within(table, where, x, y) and table.has_room(x, y, radius, layout, ignore=ball)


def put(layout: Layout, ball: str, place: Point) -> Layout:
    """The layout with a ball at rest at a place."""
    return layout.put(layout[ball].still()._replace(x=place[0], y=place[1]))


def has_room(table: Table, layout: Layout, ball: str, place: Point) -> bool:
    """Whether a ball can stand at a place, touching others at most."""
    return table.on_surface(*place) and table.has_room(*place, table.body_of(layout[ball])[0], layout, ignore=ball)


def nearest(
    table: Table, layout: Layout, ball: str, spot: Point, way: int, clear: frozenset[str] = frozenset()
) -> Point | None:
    """The place nearest to a spot, along the length toward `way` (+1 the foot, -1 the head), with room for a ball.

    Balls in the way are touched, those in `clear` nearly. None where there is no room.
    """
    x, y = spot
    blocked = []
    for other in layout.on_table():
        reach = table.touch(layout[ball], other) + (CLEAR if other.id in clear else HAIR)
        if other.id != ball and abs(other.y - y) < reach:
            half = math.sqrt(reach * reach - (other.y - y) ** 2)
            blocked.append((other.x - half, other.x + half))
    places = [x, *(high if way > 0 else low for low, high in blocked)]
    ahead = sorted((place for place in places if (place - x) * way >= 0.0), key=lambda place: abs(place - x))
    for place in ahead:
        if not any(low < place < high for low, high in blocked) and has_room(table, layout, ball, (place, y)):
            return place, y
    return None


def on_long_string(table: Table, layout: Layout, ball: str, spot: str = "foot") -> Point | None:
    """Where a ball is spotted on the long string: the spot, or below it, or above it, as near as may be.

    WPA 1.5: in contact with object balls in the way where possible, but not with the cue ball.
    """
    place = table.furniture.spots.get(spot) or _mirrored(table)
    clear = frozenset({table.furniture.cue})
    return nearest(table, layout, ball, place, 1, clear) or nearest(table, layout, ball, place, -1, clear)


def spot_balls(table: Table, layout: Layout, balls: tuple[str, ...]) -> tuple[Layout, tuple[tuple[str, Point], ...]]:
    """The layout with balls spotted on the long string in the given order, and where each went."""
    spotted: list[tuple[str, Point]] = []
    for ball in balls:
        place = on_long_string(table, layout, ball)
        if place is not None:
            layout = put(layout, ball, place)
            spotted.append((ball, place))
    return layout, tuple(spotted)


def _mirrored(table: Table) -> Point:
    """A foot spot for a table that names none: as far from the foot as the head spot from the head."""
    x, y = table.furniture.spots["head"]
    return table.knobs.table.length - x, y
