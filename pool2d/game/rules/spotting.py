"""Where the cue ball may be put and where balls are spotted: geometry on a table with balls in the way."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
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
# Balls that were put back on the table, and where each went, m.
Spotted: TypeAlias = tuple[tuple[str, Point], ...]
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


def near_spot(
    table: Table, layout: Layout, ball: str, spot: Point, clear: frozenset[str] = frozenset()
) -> Point | None:  # fmt: skip
    """Where a ball is put that belongs on a spot: there, or below it, or, where there is no room, above it.

    It is as near as may be on the line through the spot along the table. Balls in the way are touched, those in `clear`
    nearly. None where there is no room at all.
    """
    return nearest(table, layout, ball, spot, 1, clear) or nearest(table, layout, ball, spot, -1, clear)


def foot_spot(table: Table) -> Point:
    """The foot spot; of a table that names none, as far from the foot as the head spot from the head."""
    x, y = table.furniture.spots["head"]
    return table.furniture.spots.get("foot") or (table.knobs.table.length - x, y)


def spot_balls(
    table: Table,
    layout: Layout,
    balls: Iterable[str],
    spot: Point | None = None,
    clear: frozenset[str] | None = None,
) -> tuple[Layout, Spotted]:
    """The layout with balls put near a spot in the given order, and where each went; those without room stay off.

    Without a `spot` that is the foot spot. Without `clear` only the cue ball must not be touched: WPA 1.5, in contact
    with object balls in the way where possible, but not with the cue ball.
    """
    place = foot_spot(table) if spot is None else spot
    apart = frozenset({table.furniture.cue}) if clear is None else clear
    spotted: list[tuple[str, Point]] = []
    for ball in balls:
        found = near_spot(table, layout, ball, place, apart)
        if found is not None:
            layout = put(layout, ball, found)
            spotted.append((ball, found))
    return layout, tuple(spotted)
