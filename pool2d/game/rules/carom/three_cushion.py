"""Three-cushion by the UMB's World Rules of Carom Billiard."""

from __future__ import annotations

import math
from collections.abc import Collection

from ....physics.values import Layout
from ....table.outline import Point
from ..notes import Note
from ..report import Report
from ..spotting import Spotted, has_room, put
from .carom import RED, Carom, CaromState, cushions_before_last

# How many cushions a point needs before the second ball.
CUSHIONS = 3


class ThreeCushion(Carom):
    """A cannon counts where the cue ball met three cushions or more before the second ball (art. 83)."""

    name = "three-cushion"
    title = "Three-cushion"
    rank = 10
    scored = True

    def counts(self, report: Report) -> bool:
        return cushions_before_last(report) >= CUSHIONS

    def missed(self, report: Report) -> Note:
        """How many cushions there were, where both balls were met."""
        return Note(f"cushions.{cushions_before_last(report)}") if self.cannon(report) else super().missed(report)

    def spot(self, state: CaromState, layout: Layout, player: int, balls: Collection[str]) -> tuple[Layout, Spotted]:
        """Art. 27 (4) (b): the red on the foot spot, the player's ball on the head, the opponent's on the centre.

        Only the balls that touch are moved, or those that left the table (28). Where a spot is occupied, a ball goes
        on that of the ball which occupies it.
        """
        spots = self.table.furniture.spots
        home = {RED: "foot", self.ball_of(state, player): "head", self.ball_of(state, self.other(player)): "center"}
        moved = layout.without(*balls)
        spotted: list[tuple[str, Point]] = []
        for ball in sorted(balls, key=list(home).index):
            taker = _nearest(moved, spots[home[ball]])
            moved = moved.put(layout[ball])
            names = (home[ball], *((home[taker],) if taker else ()), *home.values())
            place = next(spots[name] for name in names if has_room(self.table, moved, ball, spots[name]))
            moved = put(moved, ball, place)
            spotted.append((ball, place))
        return layout.put(*moved.values()), tuple(spotted)


def _nearest(layout: Layout, spot: Point) -> str:
    """The ball nearest to a spot, "" where there is none."""
    gaps = {ball.id: math.hypot(ball.x - spot[0], ball.y - spot[1]) for ball in layout.values()}
    return min(gaps, key=lambda ball: gaps[ball], default="")
