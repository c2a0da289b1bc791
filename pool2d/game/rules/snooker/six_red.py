"""Snooker with six reds, by the rules of the Six-red World Championship: the WPBSA's, but for three exceptions.

1: no more than five fouls and a miss are called in a row. 2: after four the player is warned; after the fifth the
opponent may place the cue ball anywhere instead of having the balls put back, unless snookers are required.
3: no player may snooker behind a nominated colour.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from ....physics.values import Layout
from ..notes import Note
from ..report import Report
from ..ruling import Ruling
from ..sight import snookering
from ..spotting import ANYWHERE
from .snooker import Snooker, SnookerState
from .snooker_fouls import COLOR, ORDER, RED, Foul, Target, balls_on, scored

# How many misses in a row are called.
MISSES = 5


@dataclass(frozen=True, slots=True)
class SixRedState(SnookerState):
    """A frame; `called` are the fouls and a miss called in a row."""

    called: int = 0


class SixRed(Snooker):
    """Six reds, and otherwise as in snooker."""

    name = "six-red"
    title = "Six-red snooker"
    rank = 9
    racks = ("six-red",)
    state_type = SixRedState

    def judge(self, state: SnookerState, layout: Layout, report: Report) -> Ruling:
        """1, 2: misses are counted; after the fifth the balls are not put back."""
        assert isinstance(state, SixRedState)
        ruling = super().judge(state, layout, report)
        called = state.called + 1 if any(note.key == "miss" for note in ruling.notes) else 0
        now: SixRedState = ruling.state  # type: ignore[assignment]
        now = replace(now, called=called)
        if called == MISSES and not now.over:
            options = tuple(key for key in now.ask.options if key != "put-back")
            placed = () if any(now.snookers) else ("anywhere",)
            now = replace(now, before=(), ask=replace(now.ask, options=(*options, *placed)))
        return ruling._replace(state=now)

    def picked(self, state: SnookerState, layout: Layout, key: str) -> Ruling:
        assert isinstance(state, SixRedState)
        if key == "put-back":
            ruling = super().picked(state, layout, key)
            warned = state.called == MISSES - 1
            notes = (Note("last-miss", ruling.ask.player), *ruling.notes) if warned else ruling.notes
            return ruling._replace(notes=notes)
        state = replace(state, called=0)
        if key == "anywhere":
            state = replace(state, misses=0, before=())
            return self.ruled(self.aiming(state, layout, state.ask.player, ANYWHERE), layout)
        return super().picked(state, layout, key)

    def fouls(self, state: SnookerState, layout: Layout, report: Report, aim: Target) -> tuple[Foul, ...]:
        """3: the colour that was nominated after a red, and not potted, may not hide the balls that are on next."""
        fouls = super().fouls(state, layout, report, aim)
        if fouls or state.phase != COLOR or scored(report, aim) or set(report.touching) & set(aim.on):
            return fouls
        on = balls_on(RED, layout) or balls_on(ORDER, layout)
        if snookering(self.table, layout, layout[report.cue], on) not in aim.on:
            return ()
        return (Foul(Note("foul.color-snooker", ball=aim.on[0]), aim.worth),)
