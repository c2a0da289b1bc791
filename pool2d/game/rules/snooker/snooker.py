"""Snooker by the official rules of the WPBSA (sections 2 and 3), as the IBSF has them too."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass, replace
from typing import Literal

from ....config.knobs import choice
from ....errors import InputError
from ....physics.values import GONE, POCKETED, Layout
from ..base import Options, Rules
from ..notes import Note
from ..report import Report
from ..ruling import CallKind, Ruling, State
from ..scores import added, points, score_notes
from ..sight import sees, sees_full, snookered
from ..spotting import D, Spotted, Where, put
from ..vantage import vantage
from .snooker_fouls import (
    COLOR,
    LEAST,
    ORDER,
    RED,
    Foul,
    SnookerPhase,
    Target,
    aimed,
    all_fouls,
    balls_on,
    missed,
    nominable,
    penalty,
    scored,
)
from .snooker_spots import COLORS, spot_colors, value


@dataclass(frozen=True, slots=True)
class SnookerOptions(Options):
    """What may be set about a frame of snooker."""

    miss: str = choice("clear", ("clear", "always", "never"), "a miss: where a ball on was in sight, always, never")


@dataclass(frozen=True, slots=True)
class SnookerState(State):
    """A frame.

    `phase`: "red", a red is on; "color", after a red any colour; "order", the colour of the lowest value. `free`:
    the striker may nominate a free ball. `run` is the break so far, `left` what can still be scored, and
    `snookers` how many fouls of the opponent each player needs to draw level. `tied`: the black is on its spot
    again. After a foul and a miss `before` is where the balls were, `was` the phase, and `freed` whether there
    was a free ball; `misses` counts those in a row with a full ball in sight.
    """

    phase: SnookerPhase = RED
    free: bool = False
    run: int = 0
    left: int = 147
    snookers: tuple[int, ...] = (0, 0)
    tied: bool = False
    before: tuple[tuple[str, float, float], ...] = ()
    was: SnookerPhase | Literal[""] = ""
    freed: bool = False
    misses: int = 0


class Snooker(Rules[SnookerState]):
    """A red, a colour, a red, ...; then the colours in their order. After a red the colour is nominated (3.3 g)."""

    name = "snooker"
    title = "Snooker"
    rank = 8
    scored = True
    series = "break"
    racks = ("snooker",)
    groups = (RED, COLOR)
    options_type = SnookerOptions
    state_type = SnookerState

    def start(self, breaker: int = 0, seed: int = 0) -> Ruling:
        """3.2, 3.3 (c): the balls on their spots, the cue ball in hand."""
        new: SnookerState = self.state_type(seed=seed, breaker=breaker)
        state, layout = self.racked(new)
        return self.ruled(self.aiming(state, layout, breaker, D), layout)

    def aiming(
        self, state: SnookerState, layout: Layout, player: int, where: Where = "", free: bool = False
    ) -> SnookerState:
        """The state in which a player is to strike: with a colour or a free ball to nominate, or without."""
        on = balls_on(state.phase, layout)
        balls = self.on_table(layout)
        left = points_left(state.phase, layout, free)
        state = replace(state, free=free, left=left, snookers=needed(state.scores, left, state.phase, on))
        claims = balls == ("black",) and state.scores[player] - state.scores[self.other(player)] > value("black")
        call: CallKind = "ball" if free or state.phase == COLOR else ""
        # 2.1 (b): with only the black left, who leads by more than seven may claim the frame.
        return self.to_play(
            state, layout, player, where, on=balls if free else on, call=call, options=("claim",) if claims else ()
        )

    def judge(self, state: SnookerState, layout: Layout, report: Report) -> Ruling:
        aim = aimed(state.phase, state.free, report)
        state = replace(state, shots=state.shots + 1)
        last = self.on_table(report.start) == ("black",)
        found = self.fouls(state, layout, report, aim)
        kept = aim.on if state.phase == ORDER and not found else ()
        gone = dict.fromkeys(ball for ball in (*report.potted, *report.off) if ball in COLORS and ball not in kept)
        layout, spotted = spot_colors(self.table, layout, gone)
        if found:
            return self._foul(state, layout, report, aim, found, spotted, last)
        shooter, won = state.ask.player, scored(report, aim)
        change = points(shooter, won)
        state = added(state, change)
        state = replace(state, run=state.run + won if won else 0, misses=0, before=())
        if won and last:
            return self._end(state, layout, change, score_notes(change))
        state = replace(state, phase=COLOR if won and state.phase == RED else _phase(layout))
        player = shooter if won else self.other(shooter)
        state = self.aiming(state, layout, player)
        return self.ruled(state, layout, *score_notes(change), spotted=spotted, points=change)

    def picked(self, state: SnookerState, layout: Layout, key: str) -> Ruling:
        chooser = state.ask.player
        if key == "claim":
            return self.ruled(self.ended(state, chooser), layout, Note("claims", chooser))
        if state.tied:
            player = chooser if key == "play" else self.other(chooser)
            return self.ruled(self.aiming(state, layout, player, D), layout)
        if key == "put-back":
            return self._put_back(state, layout)
        where: Where = D if layout[self.table.furniture.cue].phase in GONE else ""
        state = replace(state, misses=0, before=())
        if key == "play-again":
            # 3.11 (h), 3.12 (f): the offender plays, and there is no free ball.
            return self.ruled(self.aiming(state, layout, self.other(chooser), where), layout)
        return self.ruled(self.aiming(state, layout, chooser, where, self.free_ball(state, layout)), layout)

    def fouls(self, state: SnookerState, layout: Layout, report: Report, aim: Target) -> tuple[Foul, ...]:
        """Every foul of a stroke, the dearest first (3.10)."""
        return all_fouls(self.table, layout, report, aim)

    def pots(self, player: int, report: Report, ruling: Ruling) -> tuple[str, ...]:
        """Every ball that falls without a foul, for all that colours are spotted again."""
        return () if ruling.foul else report.potted

    def worth(self, ball: str) -> float:
        return float(value(ball))

    def conceded(self, state: SnookerState, layout: Layout, player: int) -> Ruling:
        """2.1 (a): only the striker may concede; raises InputError for the other player."""
        if player != state.ask.player:
            raise InputError(self.name, "concede", player, f"allowed is {state.ask.player}, whose turn it is")
        return super().conceded(state, layout, player)

    def free_ball(self, state: SnookerState, layout: Layout) -> bool:
        """3.12: whether the cue ball is snookered after a foul."""
        on, cue = balls_on(state.phase, layout), layout[self.table.furniture.cue]
        if cue.phase in GONE:
            return vantage(self.table, layout, cue, on, D) is None
        return snookered(self.table, layout, cue, on)

    def _foul(
        self,
        state: SnookerState,
        layout: Layout,
        report: Report,
        aim: Target,
        found: tuple[Foul, ...],
        spotted: Spotted,
        last: bool,
    ) -> Ruling:
        """3.11: the opponent scores, and says who plays; 3.14: from where."""
        player = state.ask.player
        opponent = self.other(player)
        change = points(opponent, penalty(found))
        notes_of_fouls = tuple(foul.note for foul in found)
        was = state
        state = replace(added(state, change), run=0, phase=_phase(layout), misses=0, before=())
        notes = score_notes(change)
        if last:
            return self._end(state, layout, change, notes, notes_of_fouls, spotted)
        if missed(found) and self._is_miss(was, state, layout, report):
            missed_again = self._after_miss(was, state, report)
            notes += (Note("miss"),)
            if missed_again.misses == 3:
                # 3.14 (d): the third miss in a row with a full ball in sight.
                return self.ruled(
                    self.ended(state, opponent), layout, *notes, fouls=notes_of_fouls, spotted=spotted, points=change
                )
            state = missed_again
        if self.free_ball(state, layout):
            notes += (Note("free-ball"),)
        options = ("play", "play-again", *(("put-back",) if state.before else ()))
        left = points_left(state.phase, layout)
        on = balls_on(state.phase, layout)
        state = replace(state, left=left, snookers=needed(state.scores, left, state.phase, on))
        state = self.to_choose(state, opponent, *options)
        return self.ruled(state, layout, *notes, fouls=notes_of_fouls, spotted=spotted, points=change)

    def _is_miss(self, before: SnookerState, after: SnookerState, layout: Layout, report: Report) -> bool:
        """3.14: whether a failure to hit a ball on is a miss.

        (c): it is where a part of a ball was in sight that was on or could have been, had it been nominated; whether it
        is without, as the option says, since a referee's opinion is asked for. (a): it is none where a player needed
        penalty points before or after it, or what is left equals the difference; but (d) it is when a full ball is
        missed again from the same place.
        """
        start, cue = report.start, report.start[report.cue]
        on = could_be_on(before, start)
        if self.options.miss == "never":
            return False
        if before.misses and sees_full(self.table, start, cue, on):
            return True
        left = points_left(after.phase, layout)
        if any(_decided(scores, points) for scores, points in ((before.scores, before.left), (after.scores, left))):
            return False
        return self.options.miss == "always" or sees(self.table, start, cue, on)

    def _after_miss(self, before: SnookerState, after: SnookerState, report: Report) -> SnookerState:
        """The state after a foul and a miss, from which the balls may be put back (3.14 b)."""
        full = sees_full(self.table, report.start, report.start[report.cue], could_be_on(before, report.start))
        places = tuple((ball.id, ball.x, ball.y) for ball in report.start.on_table())
        misses = before.misses + 1 if full else 0
        return replace(after, before=places, was=before.phase, freed=before.free, misses=misses)

    def _put_back(self, state: SnookerState, layout: Layout) -> Ruling:
        """3.14 (b): every ball goes back, and the same balls are on for the offender."""
        for ball, x, y in state.before:
            layout = put(layout, ball, (x, y))
        offender = self.other(state.ask.player)
        notes = (Note("warned", offender),) if state.misses == 2 else ()
        again = replace(state, phase=state.was or RED, before=(), was="", freed=False)
        return self.ruled(self.aiming(again, layout, offender, free=state.freed), layout, *notes)

    def _end(
        self,
        state: SnookerState,
        layout: Layout,
        change: tuple[int, ...],
        notes: tuple[Note, ...],
        notes_of_fouls: tuple[Note, ...] = (),
        spotted: Spotted = (),
    ) -> Ruling:
        """3.4 (a): a score or a foul at the last black ends the frame. (b): but not a tie."""
        first, second = state.scores
        if first != second:
            state = self.ended(state, 0 if first > second else 1)
            return self.ruled(state, layout, *notes, fouls=notes_of_fouls, spotted=spotted, points=change)
        cue = layout[self.table.furniture.cue].still()._replace(phase=POCKETED)
        layout, spotted = spot_colors(self.table, layout.put(cue), ("black",))
        # The lots are drawn from the seed.
        drawn = random.Random(f"lots {state.seed}").randrange(2)
        state = self.to_choose(replace(state, tied=True, phase=ORDER, run=0), drawn, "play", "pass")
        return self.ruled(state, layout, *notes, Note("tie"), fouls=notes_of_fouls, spotted=spotted, points=change)


def could_be_on(state: SnookerState, layout: Layout) -> tuple[str, ...]:
    """3.14 (c): the balls on, and those that a nomination could have made so."""
    return (*balls_on(state.phase, layout), *nominable(state.phase, state.free, layout))


def points_left(phase: SnookerPhase, layout: Layout, free: bool = False) -> int:
    """What can still be scored in one break: a black with every red, then the colours; a free ball adds its own."""
    on = balls_on(phase, layout)
    standing = {ball.id for ball in layout.on_table()}
    colors = sum(value(ball) for ball in COLORS if ball in standing)
    reds = len(balls_on(RED, layout))
    extra = value("black") if phase == COLOR else 0
    if free and on:
        extra += 1 + value("black") if phase == RED else value(on[0])
    return reds * (1 + value("black")) + extra + colors


def needed(scores: tuple[int, ...], left: int, phase: SnookerPhase, on: tuple[str, ...]) -> tuple[int, ...]:
    """How many fouls of the opponent each player needs to draw level with what is left: the snookers needed."""
    worth = max(LEAST, value(on[0])) if phase == ORDER and on else LEAST
    return tuple(
        max(0, math.ceil((theirs - mine - left) / worth)) for mine, theirs in (scores, tuple(reversed(scores)))
    )


def _decided(scores: tuple[int, ...], left: int) -> bool:
    """3.14 (a): whether a player needs penalty points, or all that is left to draw level."""
    return abs(scores[0] - scores[1]) >= left


def _phase(layout: Layout) -> SnookerPhase:
    """What is on at the start of a turn, and after a colour."""
    return RED if balls_on(RED, layout) else ORDER
