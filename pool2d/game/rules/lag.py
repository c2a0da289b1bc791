"""The lag, by which the players find who breaks (WPA 1.2; UMB art. 22 has the same for carom).

Each sends a ball of their own up the table, off the foot cushion and back: who ends nearer to the head cushion
chooses who breaks. The rules have both play at once; here, with one cue at the table, one follows the other.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

from ...physics.values import POCKETED, Ball, Layout
from ...table.table import Table
from .base import Rules
from .notes import Note
from .report import BALL, OFF, POCKET, RAIL, TOP, Report
from .ruling import Ruling, State

HEAD, FOOT = "left", "right"
# Balls this much nearer than others, m, are so beyond a referee's doubt.
_DOUBT = 5e-4


@dataclass(frozen=True, slots=True)
class LagState(State):
    """A lag. `breaker` lags first; `rests` are how far the balls are from the head cushion, m, -1 for a bad lag.

    The first comes before any rack; one after a stalemate keeps the scores, the fouls and the count of racks.
    """

    rests: tuple[float, ...] = ()
    racks: int = -1


class Lag(Rules[LagState]):
    """The rules of a lag on a table; `begin` gives the ruling with which a player's break begins after a lag."""

    name = "lag"
    title = "Lag"
    lags = True
    lags_again = True
    state_type = LagState

    def __init__(self, table: Table, begin: Callable[[int, LagState], Ruling]) -> None:
        """Raises InputError for a table that lacks a head or a foot cushion."""
        super().__init__(table)
        self.begin = begin

    @classmethod
    def fits(cls, table: Table) -> bool:
        """Whether a table has the cushions and the spot for it."""
        names = {element.name for element in table.elements}
        return {HEAD, FOOT} <= names and "head" in table.furniture.spots

    def cue_of(self, player: int) -> str:
        """The cue ball; for the second player the yellow of carom, or a ball that is as easily told, as the 8."""
        furniture = self.table.furniture
        if player == 0:
            return furniture.cue
        others = furniture.groups.get("other") or self.on_table(self.table.rack(next(iter(furniture.racks))))
        return others[-1]

    def start(self, breaker: int = 0, seed: int = 0) -> Ruling:
        return self._set_up(LagState(seed=seed, breaker=breaker))

    def again(self, state: State) -> Ruling:
        """A lag after a stalemate, or after a lag that nobody has won: the scores stay (WPA 7, 1.13)."""
        kept = {name: getattr(state, name) for name in ("seed", "breaker", "scores", "fouls", "racks")}
        return self._set_up(LagState(**kept))

    def _set_up(self, state: LagState) -> Ruling:
        layout = self.table.settle(Layout(self._ball(player) for player in range(self.players)))
        return self.ruled(self.to_play(state, layout, state.breaker), layout)

    def judge(self, state: LagState, layout: Layout, report: Report) -> Ruling:
        """What follows from one lag: the other player's, or, after both, the winner's choice or another lag."""
        player = state.ask.player
        ball = layout[report.cue]
        gap = ball.x - self._reach(ball)
        fault = next(self.faults(layout, report), None)
        rests = (*state.rests, gap if fault is None else -1.0)
        state = replace(state, rests=rests, shots=state.shots + 1)
        good = Note("lag.rest", player, points=round(1000.0 * gap))
        notes: tuple[Note, ...] = (good,) if fault is None else (Note("lag.bad", player), fault)
        if fault is not None:
            # The cue ball stays in the layout; the other is no ball of the game.
            layout = layout.put(ball.still()._replace(phase=POCKETED)) if player == 0 else layout.without(ball.id)
        if len(rests) < self.players:
            other = self.other(player)
            # Back where it belongs, should it have been hit.
            layout = layout.put(self._ball(other))
            return self.ruled(self.to_play(state, layout, other), layout, *notes)
        winner = self._winner(state)
        if winner is None:
            again = self.again(state)
            return again._replace(notes=(*notes, Note("lag.again"), *again.notes))
        notes = (*notes, Note("lag.won", winner))
        return self.ruled(self.to_choose(state, winner, "break", "give-break"), layout, *notes)

    def faults(self, layout: Layout, report: Report) -> Iterator[Note]:
        """1.2: what makes a lag bad, the plainest first."""
        kinds = [contact.kind for contact in report.of(report.cue)]
        rails = [contact.other for contact in report.of(report.cue) if contact.kind == RAIL]
        if POCKET in kinds or OFF in kinds:
            yield Note("lag.lost")
        tops = [contact.other for contact in report.of(report.cue) if contact.kind == TOP]
        if {*rails, *tops} - {HEAD, FOOT}:
            yield Note("lag.side")
        if report.astray or BALL in kinds:
            yield Note("lag.astray")
        if rails.count(FOOT) != 1:
            yield Note("lag.foot")
        ball = layout[report.cue]
        # Nearer than a ball can be that touches the nose, it has come into the corner.
        if ball.x < self._reach(ball) - _DOUBT:
            yield Note("lag.jaws")

    def picked(self, state: LagState, layout: Layout, key: str) -> Ruling:
        player = state.ask.player
        return self.begin(player if key == "break" else self.other(player), state)

    def next_note(self, state: LagState) -> Note:
        return super().next_note(state) if state.over or state.ask.options else Note("lag.turn", state.ask.player)

    def _winner(self, state: LagState) -> int | None:
        """Who has won the lag; None where both were bad or too close to call."""
        first, second = (math.inf if rest < 0.0 else rest for rest in state.rests)
        if first == second or abs(first - second) < _DOUBT:
            return None
        return state.breaker if first < second else self.other(state.breaker)

    def _ball(self, player: int) -> Ball:
        """A player's ball where it is lagged from: beside the head spot, in the middle of the player's half."""
        table = self.table
        x, y = table.furniture.spots["head"][0], table.knobs.table.width * (0.75 if player else 0.25)
        radius, mass = table.body_of(Ball(table.furniture.cue, x, y))
        return Ball(self.cue_of(player), x - 2.0 * radius, y, radius=radius, mass=mass)

    def _reach(self, ball: Ball) -> float:
        """How far from the head cushion's nose the middle of a ball is that touches it, m."""
        return self.table.reach(self.table.body_of(ball)[0])
