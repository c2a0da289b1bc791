"""Where colours are spotted in snooker. Clauses are those of the WPBSA's rules, section 3."""

from __future__ import annotations

import math
from collections.abc import Iterable

from ....physics.values import Layout
from ....table.arrivals import FROZEN
from ....table.outline import Point
from ....table.table import Table
from ..spotting import Spotted, near_spot, put

# By value, from 2 to 7.
COLORS = ("yellow", "green", "brown", "blue", "pink", "black")


def value(ball: str) -> int:
    """What a ball is worth: a red 1, the colours 2 to 7 (3.1)."""
    return COLORS.index(ball) + 2 if ball in COLORS else 1


def spot_colors(table: Table, layout: Layout, balls: Iterable[str]) -> tuple[Layout, Spotted]:
    """The layout with colours spotted, and where each went.

    3.7: each on its own spot. Those whose spots are occupied go, the highest value first (e), on the spot of
    the highest value that is free (d); where all are occupied, as near to their own as may be towards the top
    cushion (f), and where there is no room either, away from it (g).
    """
    spotted: list[tuple[str, Point]] = []
    waiting = sorted(balls, key=value, reverse=True)
    for ball in waiting:
        if _free(table, layout, ball, spot_of(table, ball)):
            layout = put(layout, ball, spot_of(table, ball))
            spotted.append((ball, spot_of(table, ball)))
    for ball in waiting:
        place = None if ball in dict(spotted) else _elsewhere(table, layout, ball)
        if place is not None:
            layout = put(layout, ball, place)
            spotted.append((ball, place))
    return layout, tuple(spotted)


def spot_of(table: Table, ball: str) -> Point:
    """A colour's own spot; the brown's is the middle of the baulk line."""
    return table.furniture.spots["head" if ball == "brown" else ball]


def _elsewhere(table: Table, layout: Layout, ball: str) -> Point | None:
    for other in reversed(COLORS):
        if _free(table, layout, ball, spot_of(table, other)):
            return spot_of(table, other)
    return near_spot(table, layout, ball, spot_of(table, ball), clear=frozenset(layout))


def _free(table: Table, layout: Layout, ball: str, spot: Point) -> bool:
    """2.18: a spot is occupied where a ball cannot be put on it without touching another."""
    return all(
        math.hypot(other.x - spot[0], other.y - spot[1]) > table.touch(layout[ball], other) + FROZEN
        for other in layout.on_table()
        if other.id != ball
    )
