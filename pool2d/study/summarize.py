"""Shots played one after another, and what is kept of each."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from ..errors import BudgetError, InputError
from ..physics.rollout import Rollout
from ..physics.simulate import simulate
from ..physics.values import MISCUE, Layout, Shot
from ..printable import printable
from ..table.arrivals import Arrivals
from ..table.table import Table
from .summaries import NONE, Summaries, gathered

_Row = tuple[Any, ...]


def summarize(table: Table, layout: Layout, shots: Sequence[Shot]) -> Summaries:
    """Play each shot from the layout. One that fails, however it does, is a row with its error."""
    clerk = _Clerk(table, layout)
    rows, failed = [], {}
    for number, shot in enumerate(shots):
        try:
            outcome = clerk.outcome(simulate(table, layout, shot), shot)
        except BudgetError as error:
            outcome, failed[number] = clerk.failure(str(error)), error.scenario
        except InputError as error:
            outcome, failed[number] = clerk.failure(str(error)), table.scenario(layout, shot)
        except Exception as error:
            # A fault of the engine in one shot is no reason to lose all the others.
            text = clerk.failure(printable(f"{type(error).__name__}: {error}"))
            outcome, failed[number] = text, table.scenario(layout, shot)
        rows.append((*clerk.cue(shot), *outcome))
    return gathered(clerk.balls, clerk.pockets, rows, failed)


class _Clerk:
    """Writes a shot down as a row, in the order of `COLUMNS`."""

    def __init__(self, table: Table, layout: Layout) -> None:
        self.table = table
        self.balls = tuple(layout)
        self.pockets = tuple(pocket.name for pocket in table.geometry.pockets)
        self.ball = {ball: number for number, ball in enumerate(self.balls)}
        self.pocket = {name: number for number, name in enumerate(self.pockets)}

    def cue(self, shot: Shot) -> _Row:
        """What is known before the shot."""
        return shot.angle, shot.speed, shot.side, shot.height, shot.elevation, self.ball.get(shot.ball, NONE)

    def outcome(self, rollout: Rollout, shot: Shot) -> _Row:
        """What came of the shot."""
        first, miscue = NONE, False
        pocket, cushions = [NONE] * len(self.balls), [0] * len(self.balls)
        off = [False] * len(self.balls)
        arrivals = Arrivals(self.table, rollout)
        for event in rollout.events:
            if first == NONE:
                first = next((self._other(pair, shot.ball) for pair in event.pairs if shot.ball in pair), NONE)
            for ball, cushion in event.rails:
                # The back of a pocket is none.
                if cushion in self.table.rails:
                    cushions[self.ball[ball]] += arrivals.arrives(ball, cushion, event.t)
            if event.kind == "ball_pocket":
                pocket[self.ball[event.balls[0]]] = self.pocket[event.where or ""]
            if event.kind == "ball_off":
                off[self.ball[event.balls[0]]] = True
            miscue = miscue or (event.kind == "cue_ball" and event.where == MISCUE)
        rests = {ball.id: (ball.x, ball.y) for ball in rollout.layout().on_table()}
        x, y = zip(*(rests.get(ball, (math.nan, math.nan)) for ball in self.balls), strict=True)
        return first, pocket, off, x, y, cushions, rollout.duration, len(rollout.events), miscue, ""

    def _other(self, pair: tuple[str, str], ball: str) -> int:
        return self.ball[pair[1] if pair[0] == ball else pair[0]]

    def failure(self, why: str) -> _Row:
        """What is told of a shot that failed."""
        size = len(self.balls)
        lost = (math.nan,) * size
        return NONE, (NONE,) * size, (False,) * size, lost, lost, (0,) * size, math.nan, 0, False, why
