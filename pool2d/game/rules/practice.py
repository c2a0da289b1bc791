"""Free practice: no fouls, no turns, no end. The cue ball is always in hand."""

from __future__ import annotations

from dataclasses import replace

from ...physics.values import POCKETED, Ball, Layout
from .base import Rules
from .notes import Note
from .report import Report
from .ruling import Ruling, State
from .spotting import ANYWHERE, spot_balls


class Practice(Rules[State]):
    """One player, any table. A cue ball that fell is placed again."""

    name = "practice"
    title = "Practice"
    rank = 1000
    players = 1

    def start(self, breaker: int = 0, seed: int = 0) -> Ruling:
        layout = self.table.rack(next(iter(self.table.furniture.racks)), seed)
        state = State(seed=seed, racks=1, scores=(0,), fouls=(0,))
        return Ruling(self.to_play(state, layout, 0, ANYWHERE, on=self.on_table(layout)), layout, points=(0,))

    def judge(self, state: State, layout: Layout, report: Report) -> Ruling:
        layout, spotted = spot_balls(self.table, layout, report.off)
        scored = len(report.potted)
        state = State(
            seed=state.seed, racks=state.racks, shots=state.shots + 1, scores=(state.scores[0] + scored,), fouls=(0,)
        )
        notes = (Note("score", 0, points=scored),) if scored else ()
        state = self.to_play(state, layout, 0, ANYWHERE, on=self.on_table(layout))
        return Ruling(state, layout, notes, spotted=spotted, points=(scored,))

    def arranged(self, state: State, layout: Layout) -> Ruling:
        """What follows when balls are put somewhere by hand; a cue ball that is missing is in hand.

        Raises InputError where they cannot stand there.
        """
        cue = self.table.furniture.cue
        if cue not in layout:
            x, y = self.table.furniture.spots["head"]
            layout = layout.put(Ball(cue, x, y, phase=POCKETED))
        layout, state = self.table.settle(layout), replace(state, shots=0)
        return Ruling(self.to_play(state, layout, 0, ANYWHERE, on=self.on_table(layout)), layout, points=(0,))
