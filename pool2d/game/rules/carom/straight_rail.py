"""Straight rail (partie libre) by the UMB's World Rules of Carom Billiard."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace

from ....config.knobs import choice, knob
from ....physics.values import Layout
from ..base import YES_NO
from ..corners import corner_of
from ..notes import Note
from ..report import Report
from ..ruling import Ruling
from ..spotting import Spotted
from .carom import Carom, CaromOptions, CaromState

# How often a player may score on balls that are, and stay, in one corner.
STROKES = 2


@dataclass(frozen=True, slots=True)
class StraightRailOptions(CaromOptions):
    """What may be set about straight rail."""

    points: float = knob(100.0, 1.0, 1000.0, "", "points that end the match")
    corners: str = choice("yes", YES_NO, "whether scoring in the corners is limited")


class StraightRail(Carom):
    """Every cannon counts (art. 61), but in the corners only so many (52)."""

    name = "straight-rail"
    title = "Straight rail"
    rank = 11
    scored = True
    options_type = StraightRailOptions

    def counts(self, report: Report) -> bool:
        return True

    def judge(self, state: CaromState, layout: Layout, report: Report) -> Ruling:
        """Art. 53: while both other balls are in a corner, `zone` counts down; once one has left, they enter anew."""
        ruling = super().judge(state, layout, report)
        if ruling.state.over:
            return ruling
        stayed = state.zone > 0 and not self._driven_out(state, report) and ruling.ask.player == state.ask.player
        now: CaromState = ruling.state  # type: ignore[assignment]
        corner = self.corner(now, ruling.layout, ruling.ask.player)
        zone = (state.zone - 1 if stayed else STROKES) if corner else -1
        return ruling._replace(state=replace(now, zone=zone))

    def fouls(self, state: CaromState, report: Report) -> Iterator[Note]:
        """Art. 54: the last cannon allowed in a corner has to drive a ball out of it."""
        yield from super().fouls(state, report)
        if state.zone == 1 and self.cannon(report) and not self._driven_out(state, report):
            yield Note("foul.inside")

    def _driven_out(self, state: CaromState, report: Report) -> bool:
        return bool(set(state.ask.on) & set(report.strayed))

    def corner(self, state: CaromState, layout: Layout, player: int) -> str:
        """The corner both other balls are in, "" for none."""
        if self.options.corners == "no":
            return ""
        mine = self.ball_of(state, player)
        found = {corner_of(self.table, ball.x, ball.y) for ball in layout.on_table() if ball.id != mine}
        return found.pop() if len(found) == 1 else ""

    def picked(self, state: CaromState, layout: Layout, key: str) -> Ruling:
        """Art. 27 (1): the player of a ball that touches had all balls spotted, and so out of any corner."""
        ruling = super().picked(state, layout, key)
        now: CaromState = ruling.state  # type: ignore[assignment]
        return ruling._replace(state=replace(now, zone=-1))

    def spot(self, state: CaromState, layout: Layout, player: int, balls: Collection[str]) -> tuple[Layout, Spotted]:
        """Art. 27 (4) (a), 28: all three balls to the starting position."""
        layout = self.set_up(state, layout, player)
        return layout, tuple((ball.id, (ball.x, ball.y)) for ball in layout.values())
