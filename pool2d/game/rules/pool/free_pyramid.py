"""Free pyramid, on a Russian table, by the rules of the International Pyramid Confederation.

Clauses are those of the free pyramid's own rules (1 to 7); what comes from the general rules of pyramid is named so.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from ....physics.values import GONE, Layout
from ..base import Rules
from ..lost import ball_off
from ..notes import Note
from ..report import Report
from ..ruling import AIM, Ask, Ruling, State
from ..scores import added, points, score_notes
from ..spotting import KITCHEN, Spotted, spot_balls

# 1: the points that win.
TARGET = 8
# How many object balls a break has to drive to a cushion or over the middle where none is pocketed (general rules).
BROKEN = 3
# What the ball without a number is called.
COLORED = "colored"


class FreePyramid(Rules[State]):
    """Any ball strikes, any ball that falls is a point, the struck ball too once it has met another: first to eight."""

    name = "free-pyramid"
    title = "Free pyramid"
    rank = 13
    scored = cue_counts = True
    racks = ("pyramid",)
    groups = ("white",)

    def start(self, breaker: int = 0, seed: int = 0) -> Ruling:
        return self._broken_by(breaker, State(seed=seed))

    def spoken(self, ball: str) -> str:
        return COLORED if ball == self.table.furniture.cue else super().spoken(ball)

    def judge(self, state: State, layout: Layout, report: Report) -> Ruling:
        shooter, breaks = state.ask.player, not state.shots
        state = replace(state, shots=state.shots + 1)
        fouls = tuple(self.fouls(report, breaks))
        if fouls:
            return self._foul(state, layout, report, breaks, fouls)
        # 5.4, 5.5, 6: every ball counts, whatever it was struck or hit by.
        change = points(shooter, len(report.fallen))
        notes = (Note("own-ball", shooter),) if report.scratch else ()
        state = added(state, change)
        if state.scores[shooter] >= TARGET:
            return self.ruled(self.ended(state, shooter), layout, *notes, *score_notes(change), points=change)
        # 5.2, 5.3
        player = shooter if report.fallen else self.other(shooter)
        state = self._aiming(state, layout, player, report.cue)
        return self.ruled(state, layout, *notes, *score_notes(change), points=change)

    def picked(self, state: State, layout: Layout, key: str) -> Ruling:
        """General rules: after a foul at the break the other player plays on, breaks anew, or has it broken anew."""
        player = state.ask.player
        if key == "accept":
            return self.ruled(self._aiming(state, layout, player), layout)
        return self._broken_by(player if key == "re-rack" else self.other(player), state)

    def fouls(self, report: Report, breaks: bool) -> Iterator[Note]:
        """7, and the general rules: what ends a turn and gives the other player a point, as far as it can be seen."""
        for ball in report.left:
            yield ball_off(report, ball, self.spoken(ball))
        if not report.first:
            yield Note("foul.no-hit")
        elif breaks and not report.fallen and len({*report.passed, *report.driven} - {report.cue}) < BROKEN:
            yield Note("foul.break")
        elif not breaks and not report.fallen and not report.driven:
            # 5.6
            yield Note("foul.no-rail")
        for fault in report.stroke:
            if fault in ("double-hit", "second-hit", "push"):
                yield Note(f"foul.{fault}", ball=self.spoken(report.first[0]) if report.first else "")

    def _foul(
        self, state: State, layout: Layout, report: Report, breaks: bool, fouls: tuple[Note, ...]
    ) -> Ruling:  # fmt: skip
        """6: a point for the other player; what fell or left the table is spotted."""
        opponent = self.other(state.ask.player)
        change = points(opponent, 1)
        state = added(state, change)
        layout, spotted = self._spot(layout, (*report.fallen, *report.left))
        if state.scores[opponent] >= TARGET:
            state = self.ended(state, opponent)
        elif breaks:
            state = self.to_choose(state, opponent, "accept", "re-rack", "opponent-breaks")
        else:
            state = self._aiming(state, layout, opponent, report.cue)
        return self.ruled(state, layout, *score_notes(change), fouls=fouls, spotted=spotted, points=change)

    def _broken_by(self, player: int, state: State) -> Ruling:
        """4: the break, with the ball without a number, from behind the head string; the score is kept."""
        state = State(seed=state.seed, racks=state.racks, scores=state.scores, breaker=player)
        state, layout = self.racked(state)
        return self.ruled(self.to_play(state, layout, player, KITCHEN, on=self.on_table(layout)), layout)

    def _aiming(self, state: State, layout: Layout, player: int, struck: str = "") -> State:
        """2, 5.1: any ball may be struck; the one that was last, unless another is taken."""
        balls = tuple(ball.id for ball in layout.on_table())
        ball = next((ball for ball in (struck, self.table.furniture.cue) if ball in balls), balls[0])
        return replace(state, turn=player, ask=Ask(AIM, player, ball, on=balls, cues=balls))

    def _spot(self, layout: Layout, balls: tuple[str, ...]) -> tuple[Layout, Spotted]:
        """General rules: on the foot spot or behind it on the long string, touching nothing; else before it."""
        lost = [ball for ball in balls if layout[ball].phase in GONE]
        return spot_balls(self.table, layout, lost, self.table.furniture.spots["foot"], clear=frozenset(layout))
