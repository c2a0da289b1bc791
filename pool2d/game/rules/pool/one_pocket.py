"""One-pocket by the rules of OnePocket.org, adopted 9 October 2021, by the section numbers of those of 2005.

Where these are silent, the WPA's general rules hold. Balls moved by hand, and handicaps beyond the
number of balls to make, are left out.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from ....config.knobs import choice, knob
from ....physics.values import Layout
from ....table.table import Table
from ..base import YES_NO, Options
from ..notes import Note
from ..report import Report
from ..ruling import Ruling, State
from ..scores import changed
from ..spotting import KITCHEN, Spotted, Where, spot_balls
from .fouls import shared_fouls
from .pool import PoolRules, gone


@dataclass(frozen=True, slots=True)
class OnePocketOptions(Options):
    target: float = knob(8.0, 1.0, 8.0, "balls", "how many balls win")
    three_foul: str = choice("yes", YES_NO, "three fouls in a row lose the game")


@dataclass(frozen=True, slots=True)
class OnePocketState(State):
    """`pockets` are the players', `held` the balls they made, `owed` how many balls they owe.

    `waiting` are balls made in other pockets, to be spotted when the inning is over.
    """

    pockets: tuple[str, ...] = ("", "")
    held: tuple[tuple[str, ...], ...] = ((), ())
    owed: tuple[int, ...] = (0, 0)
    waiting: tuple[str, ...] = ()


class OnePocket(PoolRules[OnePocketState]):
    """Each player scores in one of the two pockets at the foot; eight balls win. Nothing is called (section 1)."""

    name = "one-pocket"
    title = "One-pocket"
    rank = 5
    scored = True
    racks = ("straight-pool",)
    options_type = OnePocketOptions
    state_type = OnePocketState

    def broken_by(self, player: int, state: OnePocketState) -> Ruling:
        """2.1: the breaker chooses a pocket before the break."""
        new = OnePocketState(seed=state.seed, racks=state.racks, breaker=player)
        new, layout = self.racked(new)
        new = replace(new, turn=player)
        return self.ruled(self.to_choose(new, player, *(f"pocket:{name}" for name in foot(self.table))), layout)

    def picked(self, state: OnePocketState, layout: Layout, key: str) -> Ruling:
        name, _, mine = key.partition(":")
        if name != "pocket":
            return super().picked(state, layout, key)
        player = state.ask.player
        other = next(pocket for pocket in foot(self.table) if pocket != mine)
        state = replace(state, pockets=(mine, other) if player == 0 else (other, mine))
        return self.ruled(self.to_play(state, layout, player, KITCHEN, on=self.on_table(layout)), layout)

    def judge(self, state: OnePocketState, layout: Layout, report: Report) -> Ruling:
        shooter, opponent, ask = state.ask.player, self.other(state.ask.player), state.ask
        fouls = shared_fouls(report, ask.on, kitchen=ask.where == KITCHEN)
        before, state = state, self.counted(replace(state, shots=state.shots + 1), shooter, bool(fouls))
        mine, theirs, neutral = self._sorted(state, report)
        notes: tuple[Note, ...] = ()
        if fouls:
            # 6.2: nothing counts for the shooter; for the opponent it does, unless the cue ball is gone.
            neutral, mine = (*mine, *neutral), ()
            if gone(layout, report.cue):
                neutral, theirs = (*theirs, *neutral), ()
            state = replace(state, owed=changed(state.owed, shooter, state.owed[shooter] + 1))
            notes = (*self.second(state, shooter), Note("owes", shooter))
            if self.options.three_foul == "yes" and state.fouls[shooter] >= 3:
                return self._told(before, self.ended(state, opponent), layout, Note("foul.three", shooter), fouls=fouls)
        held = changed(state.held, shooter, (*state.held[shooter], *mine))
        held = changed(held, opponent, (*held[opponent], *theirs))
        state = replace(state, held=held, waiting=(*state.waiting, *neutral))
        for player in (shooter, opponent):
            if len(state.held[player]) - state.owed[player] >= self.options.target:
                return self._told(before, self.ended(state, player), layout, *notes, fouls=fouls)
        spotted: Spotted = ()
        if not mine or not self.on_table(layout):
            # Spotting comes at the end of an inning, or when the table is empty.
            state, back = _due(state)
            layout, spotted = spot_balls(self.table, layout, back)
        # 6.3: after any other foul than a scratch the balls lie as they are.
        where: Where = KITCHEN if gone(layout, report.cue) else ""
        state = self.next(state, layout, shooter if mine else opponent, where)
        return self._told(before, state, layout, *notes, fouls=fouls, spotted=spotted)

    def pots(self, player: int, report: Report, ruling: Ruling) -> tuple[str, ...]:
        """Those in one's own pocket."""
        state: OnePocketState = ruling.state  # type: ignore[assignment]
        return () if ruling.foul else tuple(pot.ball for pot in report.pots if pot.pocket == state.pockets[player])

    def goals(self, state: OnePocketState, player: int) -> tuple[str, ...]:
        return (state.pockets[player],)

    def _told(self, before: OnePocketState, state: OnePocketState, layout: Layout, *notes: Note, **more: Any) -> Ruling:
        """A ruling with the scores worked out: the balls made, less those owed."""
        scores = tuple(len(held) - owed for held, owed in zip(state.held, state.owed, strict=True))
        change = tuple(new - old for new, old in zip(scores, before.scores, strict=True))
        return self.ruled(replace(state, scores=scores), layout, *notes, points=change, **more)

    def _sorted(
        self, state: OnePocketState, report: Report
    ) -> tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]:
        """The balls that fell into the shooter's pocket, into the opponent's, and elsewhere or off the table."""
        player = state.ask.player
        mine = tuple(pot.ball for pot in report.pots if pot.pocket == state.pockets[player])
        theirs = tuple(pot.ball for pot in report.pots if pot.pocket == state.pockets[self.other(player)])
        rest = tuple(ball for ball in (*report.potted, *report.off) if ball not in (*mine, *theirs))
        return mine, theirs, rest


def foot(table: Table) -> tuple[str, str]:
    """The names of the two pockets furthest from the head, from low y to high."""
    far = sorted(table.geometry.pockets, key=lambda pocket: pocket.x)[-2:]
    low, high = sorted(far, key=lambda pocket: pocket.y)
    return low.name, high.name


def _due(state: OnePocketState) -> tuple[OnePocketState, tuple[str, ...]]:
    """What is spotted when an inning is over: the waiting balls, and of what each player owes as many as he holds.

    Balls that the opponent has made for a debtor pay at the end of that inning, not of his own next one (6.4).
    """
    back, held, owed = state.waiting, state.held, state.owed
    for player, balls in enumerate(state.held):
        pay = min(owed[player], len(balls))
        back = (*back, *balls[len(balls) - pay :])
        held = changed(held, player, balls[: len(balls) - pay])
        owed = changed(owed, player, owed[player] - pay)
    return replace(state, waiting=(), held=held, owed=owed), back
