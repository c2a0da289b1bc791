"""Blackball by the international rules of the World Pool Association, as they were played in the 2020s.

Their clauses were read in guides to them (the numbers are those of the WPA's text): a free shot and a visit after a
foul, the skill shot, and the break by points.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace

from ....config.knobs import choice
from ....physics.values import GONE, Layout
from ..base import YES_NO, Options
from ..notes import Note
from ..report import Report
from ..ruling import Ruling
from ..sight import sees
from ..spotting import KITCHEN, Spotted, spot_balls
from .english_pool import BLACK, COLORS, EnglishPool
from .pool import GroupsState

# 5.5: what a break has to score: a point for each ball potted, and for each that goes wholly over the middle.
POINTS = 3
# Without points, how many balls have to go over it where none is potted.
OVER = 2


@dataclass(frozen=True, slots=True)
class BlackballOptions(Options):
    """What may be set about blackball."""

    three_point: str = choice("yes", YES_NO, "a break needs three points; else a ball potted or two over the middle")


@dataclass(frozen=True, slots=True)
class BlackballState(GroupsState):
    """A frame; `free`: the next shot is a free one."""

    free: bool = False


class Blackball(EnglishPool[BlackballState]):
    """Clear your colour, then pot the black. A foul gives the opponent a free shot, and a visit after it."""

    name = "blackball"
    title = "Blackball"
    rank = 7
    options_type = BlackballOptions
    state_type = BlackballState

    def on(self, state: BlackballState, layout: Layout, player: int) -> tuple[str, ...]:
        """5.1: one's colour, and the black when it is gone; both colours on an open table; with a free shot any."""
        if state.free or not state.shots:
            return self.on_table(layout)
        return self.to_clear(layout, COLORS if state.open else (state.groups[player],))

    def judge(self, state: BlackballState, layout: Layout, report: Report) -> Ruling:
        shooter = state.ask.player
        if not state.shots:
            return self._break(replace(state, shots=1), layout, report)
        state = replace(state, shots=state.shots + 1)
        fouls = tuple(self.fouls(state, report))
        if BLACK in report.potted:
            return self.black_potted(state, layout, fouls, due=self._cleared(state, layout))
        layout, spotted = spot_balls(self.table, layout, report.off)
        if fouls:
            return self._fouled(state, layout, fouls, spotted)
        fallen = self.colors_potted(report)
        mine = bool(fallen) if state.open else state.groups[shooter] in fallen
        # 5.7: a free shot ends no visit.
        player = shooter if mine or state.free else self.other(shooter)
        notes: tuple[Note, ...] = ()
        if state.open and len(fallen) == 1 and not state.free:
            # 5.6: not by a free shot, and not by balls of both colours.
            state, note = self.decided(state, shooter, fallen.pop())
            notes = (note,)
        return self.ruled(self._aiming(state, layout, player), layout, *notes)

    def picked(self, state: BlackballState, layout: Layout, key: str) -> Ruling:
        player = state.ask.player
        if key == "re-rack":
            # 5.5: the free shot is kept, and is the break.
            ruling = self.broken_by(player, state)
            again: BlackballState = ruling.state  # type: ignore[assignment]
            return ruling._replace(state=replace(again, free=True))
        # 5.1: the cue ball may be taken to baulk for a free shot.
        layout = self.to_baulk(layout)
        return self.ruled(self._aiming(state, layout, player, free=True), layout)

    def fouls(self, state: BlackballState, report: Report) -> Iterator[Note]:
        """5.10: the standard fouls, as far as they can be seen."""
        yield from self.fouls_lost(report)
        if not state.free:
            yield from self._theirs(state, report)
        # 5.8
        yield from self.fouls_hit(report, self.on(state, report.start, state.ask.player))
        yield from self.fouls_jumped(report)
        yield from self.fouls_pushed(report)

    def _theirs(self, state: BlackballState, report: Report) -> Iterator[Note]:
        """5.9: the opponent's balls may fall with one's own (a skill shot), but not alone."""
        if state.open or set(report.potted) & {*self.balls_of(state.groups[state.ask.player]), BLACK}:
            return
        for ball in report.potted:
            yield Note("foul.potted", ball=ball)

    def snookered(self, report: Report, on: Collection[str]) -> bool:
        """5.8: not by a jaw."""
        return not sees(self.table, report.start, report.start[report.cue], on)

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

    def _cleared(self, state: BlackballState, layout: Layout) -> bool:
        """5.11: whether the shooter has a colour and none of it is left, so that the black may fall."""
        standing = self.on_table(layout)
        mine = () if state.open else self.balls_of(state.groups[state.ask.player])
        return not state.open and not any(ball in standing for ball in mine)

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
        gone = layout[self.table.furniture.cue].phase in GONE
        choices = (*(("baulk",) if free and not gone else ()), *options)
        return self.next(replace(state, free=free), layout, player, KITCHEN if gone else "", options=choices)
