"""Straight pool, 14.1 continuous, by the WPA's Rules of Play of 15 September 2025, section 7."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ....config.knobs import choice, knob
from ....physics.values import Layout
from ..base import YES_NO, Options
from ..notes import Note
from ..report import Report
from ..ruling import Ruling, State
from ..scores import added, points, score_notes
from ..spotting import KITCHEN, Where, spot_balls
from .fouls import shared_fouls
from .pool import PoolRules, driven, gone
from .rerack import rerack

# What a breaking foul, a foul, and the third in a row cost (7.9 to 7.11).
BREAKING, FOUL, THIRD = -2, -1, -15


@dataclass(frozen=True, slots=True)
class StraightOptions(Options):
    target: float = knob(100.0, 1.0, 1000.0, "points", "the score that wins")
    three_foul: str = choice("yes", YES_NO, "three fouls in a row cost 15 points more")


@dataclass(frozen=True, slots=True)
class StraightState(State):
    """`opening`: the next shot is an opening break."""

    opening: bool = True


class Straight(PoolRules[StraightState]):
    """Any ball, called; a point for it and for each that falls with it. A safety may be called (7.4, 7.5)."""

    name = "straight"
    title = "Straight pool"
    rank = 4
    scored = True
    racks = ("straight-pool",)
    options_type = StraightOptions
    state_type = StraightState
    call = "pocket"
    may = ("safety",)
    lags_again = True

    def broken_by(self, player: int, state: StraightState) -> Ruling:
        """An opening break: the score is kept; it may be called, too (7.3)."""
        new, layout = self.racked(replace(state, breaker=player, opening=True))
        return self.ruled(self.next(new, layout, player, KITCHEN, options=()), layout)

    def judge(self, state: StraightState, layout: Layout, report: Report) -> Ruling:
        player, ask = state.ask.player, state.ask
        fouls = shared_fouls(report, ask.on, kitchen=ask.where == KITCHEN)
        opening = state.opening
        state = replace(state, shots=state.shots + 1, opening=False)
        if opening and not _opened(report):
            return self._breaking_foul(state, layout, report, fouls)
        state = self.counted(state, player, bool(fouls))
        if fouls:
            return self._foul(state, layout, report, fouls)
        if report.called():
            return self._scored(state, layout, report)
        # 7.5, 7.7: after a safety or a miss what fell is spotted.
        layout, spotted = spot_balls(self.table, layout, report.potted)
        lost = () if report.call.safety else tuple(Note("not-called", ball=ball) for ball in report.potted)
        return self.ruled(self.next(state, layout, self.other(player)), layout, *lost, spotted=spotted)

    def picked(self, state: StraightState, layout: Layout, key: str) -> Ruling:
        if key == "opponent-breaks":
            return self.broken_by(self.other(state.ask.player), state)
        return super().picked(state, layout, key)

    def pots(self, player: int, report: Report, ruling: Ruling) -> tuple[str, ...]:
        """7.4: with the ball called all count that fall with it."""
        return report.potted if ruling.points[player] > 0 else ()

    def _scored(self, state: StraightState, layout: Layout, report: Report) -> Ruling:
        """7.4: the shooter goes on, at the target has won, and with one ball left has the others racked."""
        player = state.ask.player
        change = points(player, len(report.potted))
        state = added(state, change)
        if state.scores[player] >= self.options.target:
            return self.ruled(self.ended(state, player), layout, *score_notes(change), points=change)
        where: Where = ""
        notes = score_notes(change)
        if len(self.on_table(layout)) <= 1:
            layout, where = rerack(self.table, layout, self.racks[0], state.seed + 1000 * state.racks)
            state, notes = replace(state, racks=state.racks + 1), (*notes, Note("re-racked"))
        return self.ruled(self.next(state, layout, player, where), layout, *notes, points=change)

    def _foul(self, state: StraightState, layout: Layout, report: Report, fouls: tuple[Note, ...]) -> Ruling:
        """7.9: a point off; all that fell is spotted; in hand only after a scratch or a cue ball that stayed (3.11)."""
        player = state.ask.player
        if self.options.three_foul == "yes" and state.fouls[player] >= 3:
            # 7.11: the offender breaks a new rack, his count at nought.
            change = points(player, FOUL + THIRD)
            state = self.counted(added(state, change), player, False)
            ruling = self.broken_by(player, state)
            notes = (*fouls, Note("foul.three", player), *score_notes(change), *ruling.notes)
            return ruling._replace(notes=notes, fouls=fouls, points=change)
        change = points(player, FOUL)
        layout, spotted = spot_balls(self.table, layout, (*report.potted, *report.off))
        in_hand = gone(layout, report.cue) or any(foul.key == "foul.stayed" for foul in fouls)
        state = self.next(added(state, change), layout, self.other(player), KITCHEN if in_hand else "")
        notes = (*self.second(state, player), *score_notes(change))
        return self.ruled(state, layout, *notes, fouls=fouls, spotted=spotted, points=change)

    def _breaking_foul(self, state: StraightState, layout: Layout, report: Report, fouls: tuple[Note, ...]) -> Ruling:
        """7.10: two points off, no other foul counts; the opponent accepts or has the offender break again."""
        player = state.ask.player
        change = points(player, BREAKING)
        layout, spotted = spot_balls(self.table, layout, (*report.potted, *report.off))
        accept = "kitchen" if gone(layout, report.cue) else "accept"
        state = self.to_choose(added(state, change), self.other(player), accept, "opponent-breaks")
        every = (Note("foul.break"), *fouls)
        return self.ruled(state, layout, *score_notes(change), fouls=every, spotted=spotted, points=change)


def _opened(report: Report) -> bool:
    """7.3: the ball called fell, or the cue ball and two object balls were driven to a rail."""
    return bool(report.called()) or (report.cue in report.driven and driven(report) >= 2)
