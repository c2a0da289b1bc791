"""Blackball by the international rules of the World Pool Association, as they were played in the 2020s.

Their clauses were read in guides to them (the numbers are those of the WPA's text): a free shot and a visit after a
foul, the skill shot, and the break by points.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from ....config.knobs import choice
from ....physics.values import POCKETED, Layout
from ..base import YES_NO, Options
from ..notes import Note
from ..report import BALL, Report
from ..ruling import Ruling, State
from ..scores import changed
from ..sight import sees
from ..spotting import KITCHEN, Spotted, spot_balls
from .pool import PoolRules

BLACK = "black"
RED, YELLOW = "red", "yellow"
# 5.5: what a break has to score: a point for each ball potted, and for each that goes wholly over the middle.
POINTS = 3
# Without points, how many balls have to go over it where none is potted.
OVER = 2


@dataclass(frozen=True, slots=True)
class BlackballOptions(Options):
    """What may be set about blackball."""

    three_point: str = choice("yes", YES_NO, "a break needs three points; else a ball potted or two over the middle")


@dataclass(frozen=True, slots=True)
class BlackballState(State):
    """A frame: `groups` are the players' colours, "" while the table is open; `free`: the next shot is a free one."""

    groups: tuple[str, ...] = ("", "")
    free: bool = False

    @property
    def open(self) -> bool:
        return not self.groups[0]


class Blackball(PoolRules[BlackballState]):
    """Clear your colour, then pot the black. A foul gives the opponent a free shot, and a visit after it."""

    name = "blackball"
    title = "Blackball"
    rank = 7
    racks = ("eight-ball",)
    groups = (RED, YELLOW)
    options_type = BlackballOptions
    state_type = BlackballState

    def on(self, state: BlackballState, layout: Layout, player: int) -> tuple[str, ...]:
        """5.1: one's colour, and the black when it is gone; both colours on an open table; with a free shot any."""
        standing = self.on_table(layout)
        if state.free or not state.shots:
            return standing
        colors = (RED, YELLOW) if state.open else (state.groups[player],)
        mine = tuple(ball for color in colors for ball in self._balls(color) if ball in standing)
        return mine or tuple(ball for ball in standing if ball == BLACK)

    def judge(self, state: BlackballState, layout: Layout, report: Report) -> Ruling:
        shooter = state.ask.player
        if not state.shots:
            return self._break(replace(state, shots=1), layout, report)
        state = replace(state, shots=state.shots + 1)
        fouls = tuple(self.fouls(state, report))
        if BLACK in report.potted:
            return self._black(state, layout, fouls)
        layout, spotted = spot_balls(self.table, layout, report.off)
        if fouls:
            return self._fouled(state, layout, fouls, spotted)
        fallen = {color for color in (RED, YELLOW) if set(report.potted) & set(self._balls(color))}
        mine = bool(fallen) if state.open else state.groups[shooter] in fallen
        # 5.7: a free shot ends no visit.
        player = shooter if mine or state.free else self.other(shooter)
        notes: tuple[Note, ...] = ()
        if state.open and len(fallen) == 1 and not state.free:
            # 5.6: not by a free shot, and not by balls of both colours.
            color = fallen.pop()
            other = YELLOW if color == RED else RED
            state = replace(state, groups=changed((other, other), shooter, color))
            notes = (Note(f"group.{color}", shooter),)
        return self.ruled(self._aiming(state, layout, player), layout, *notes)

    def picked(self, state: BlackballState, layout: Layout, key: str) -> Ruling:
        player = state.ask.player
        if key == "re-rack":
            # 5.5: the free shot is kept, and is the break.
            ruling = self.broken_by(player, state)
            again: BlackballState = ruling.state  # type: ignore[assignment]
            return ruling._replace(state=replace(again, free=True))
        # 5.1: the cue ball may be taken to baulk for a free shot.
        layout = layout.put(layout[self.table.furniture.cue]._replace(phase=POCKETED))
        return self.ruled(self._aiming(state, layout, player, free=True), layout)

    def fouls(self, state: BlackballState, report: Report) -> Iterator[Note]:
        """5.10: the standard fouls, as far as they can be seen."""
        if report.scratch:
            yield Note("foul.scratch")
        if report.cue_off:
            yield Note("foul.cue-off")
        for ball in report.off:
            yield Note("foul.off", ball=ball)
        if not state.free:
            yield from self._theirs(state, report)
        yield from self._hit(state, report)
        if report.pressed or any(fault in ("push", "double-hit") for fault in report.stroke):
            yield Note("foul.push")

    def _theirs(self, state: BlackballState, report: Report) -> Iterator[Note]:
        """5.9: the opponent's balls may fall with one's own (a skill shot), but not alone."""
        if state.open or set(report.potted) & {*self._balls(state.groups[state.ask.player]), BLACK}:
            return
        for ball in report.potted:
            yield Note("foul.potted", ball=ball)

    def _hit(self, state: BlackballState, report: Report) -> Iterator[Note]:
        """5.8: a ball on first, then any ball potted or driven to a cushion; the latter not by who is snookered.

        To play away from a touching ball that is on is to have hit it.
        """
        on = self.on(state, report.start, state.ask.player)
        touched = bool(set(report.touching) & set(on))
        if not report.first and not touched:
            yield Note("foul.no-hit")
        elif not touched and not set(report.first) & set(on):
            yield Note("foul.wrong-ball", ball=report.first[0])
        elif all(contact.kind == BALL for contact in (report.contacts if touched else report.after)) and sees(
            self.table, report.start, report.start[report.cue], on
        ):
            yield Note("foul.no-rail")

    def _break(self, state: BlackballState, layout: Layout, report: Report) -> Ruling:
        """5.5: it never gives a colour. The black potted means another break by the same player."""
        shooter = state.ask.player
        if BLACK in report.potted:
            ruling = self.broken_by(shooter, state)
            again: BlackballState = ruling.state  # type: ignore[assignment]
            notes = (Note("re-racked"), *ruling.notes)
            return ruling._replace(state=replace(again, free=state.free), notes=notes)
        layout, spotted = spot_balls(self.table, layout, report.off)
        fouls = tuple(note for note in self.fouls(replace(state, free=True), report) if note.key != "foul.no-rail")
        if not self._broken(report):
            return self._fouled(state, layout, (Note("foul.break"), *fouls), spotted, "re-rack")
        if fouls:
            return self._fouled(state, layout, fouls, spotted)
        player = shooter if report.potted or state.free else self.other(shooter)
        return self.ruled(self._aiming(state, layout, player), layout)

    def _broken(self, report: Report) -> bool:
        """5.5: whether a break is legal."""
        if self.options.three_point == "yes":
            return len({*report.potted, *report.cleared}) >= POINTS
        return bool(report.potted) or len(report.cleared) >= OVER

    def _black(self, state: BlackballState, layout: Layout, fouls: tuple[Note, ...]) -> Ruling:
        """5.11: with the last of one's colour, or after it, and without foul, it wins; else it loses."""
        player = state.ask.player
        standing = self.on_table(layout)
        cleared = not state.open and not any(ball in standing for ball in self._balls(state.groups[player]))
        if cleared and not fouls:
            return self.ruled(self.ended(state, player), layout)
        reason = "loss.black-foul" if cleared else "loss.black-early"
        return self.ruled(self.ended(state, self.other(player)), layout, Note(reason, player), fouls=fouls)

    def _fouled(
        self,
        state: BlackballState,
        layout: Layout,
        fouls: tuple[Note, ...],
        spotted: Spotted,
        *options: str,
    ) -> Ruling:
        """5.1, 5.10: the opponent has a free shot, from where the cue ball lies or from baulk, and then a visit."""
        opponent = self.other(state.ask.player)
        state = self._aiming(state, layout, opponent, *options, free=True)
        return self.ruled(state, layout, Note("free-shot", opponent), fouls=fouls, spotted=spotted)

    def _aiming(
        self, state: BlackballState, layout: Layout, player: int, *options: str, free: bool = False
    ) -> BlackballState:  # fmt: skip
        """The state in which a player shoots; with a free shot from baulk where the cue ball is off the table."""
        gone = layout[self.table.furniture.cue].phase == POCKETED
        choices = (*(("baulk",) if free and not gone else ()), *options)
        return self.next(replace(state, free=free), layout, player, KITCHEN if gone else "", options=choices)

    def next_note(self, state: BlackballState) -> Note:
        note = super().next_note(state)
        return replace(note, key="in-hand.baulk") if note.key == "in-hand.kitchen" else note

    def _balls(self, color: str) -> tuple[str, ...]:
        return self.table.furniture.groups[color]
