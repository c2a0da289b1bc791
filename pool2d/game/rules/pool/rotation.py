"""What nine-ball and ten-ball share: the lowest ball first, the push out, three fouls, a ball that decides the rack.

Clauses are those of the WPA's Rules of Play of 15 September 2025, nine-ball's first.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from ....config.knobs import choice
from ....physics.values import Layout
from ..base import YES_NO, Options
from ..notes import Note
from ..report import Report
from ..ruling import Ruling, State
from ..spotting import ANYWHERE, KITCHEN, spot_balls
from .fouls import shared_fouls
from .pool import DRIVEN, PoolRules, driven


@dataclass(frozen=True, slots=True)
class RotationOptions(Options):
    three_foul: str = choice("yes", YES_NO, "three fouls in a row lose the rack")
    push_out: str = choice("yes", YES_NO, "the shot after the break may be a push out")


class Rotation(PoolRules[State]):
    """`last` is the ball that decides."""

    last = ""
    options_type = RotationOptions
    state_type = State

    def on(self, state: State, layout: Layout, player: int) -> tuple[str, ...]:
        """The lowest ball on the table."""
        return (min(self.on_table(layout), key=int),)

    def judge(self, state: State, layout: Layout, report: Report) -> Ruling:
        player, opponent, ask = state.ask.player, self.other(state.ask.player), state.ask
        breaks = state.shots == 0
        push = report.call.push and "push" in ask.may
        fouls = shared_fouls(report, ask.on, kitchen=ask.where == KITCHEN and not breaks, push=push)
        if breaks and not report.potted and driven(report) < DRIVEN:
            fouls = (*fouls, Note("foul.break"))
        state = self.counted(replace(state, shots=state.shots + 1), player, bool(fouls))
        if not fouls and not push and self.won(state, report, breaks):
            return self.ruled(self.ended(state, player), layout)
        if self.options.three_foul == "yes" and state.fouls[player] >= 3:
            # 5.8, 6.10
            return self.ruled(self.ended(state, opponent), layout, Note("foul.three", player), fouls=fouls)
        # 5.6, 6.8: of the balls that fell or left the table only the last is spotted.
        back = tuple(ball for ball in (*report.potted, *report.off) if ball == self.last)
        layout, spotted = spot_balls(self.table, layout, back)
        if fouls:
            # 5.7, 6.9
            state = self.next(state, layout, opponent, ANYWHERE)
        elif push:
            # 5.4, 6.4: the opponent says who goes on.
            state = self.to_choose(state, opponent, "play", "pass")
        else:
            state = self.after(state, layout, report, breaks)
        notes = self.second(state, player) if fouls else ()
        return self.ruled(state, layout, *notes, fouls=fouls, spotted=spotted)

    def won(self, state: State, report: Report, breaks: bool) -> bool:
        """Whether a legal shot wins the rack."""
        raise NotImplementedError

    def after(self, state: State, layout: Layout, report: Report, breaks: bool) -> State:
        """What comes after a legal shot that does not win."""
        raise NotImplementedError

    def goes_on(self, state: State, layout: Layout, player: int, breaks: bool) -> State:
        """Who shoots next; straight after the break it may be a push out (5.4, 6.4)."""
        may = ("push",) if breaks and self.options.push_out == "yes" else ()
        return self.next(state, layout, player, may=(*self.may, *may))
