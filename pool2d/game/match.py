"""A match: players, frames, turns, and the way back. `Match` is the one object of the game that changes.

Each action leads to a new `Moment`, which never changes; undo and redo go back and forth among them.
"""

from __future__ import annotations

import random
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from ..errors import InputError, suggest
from ..physics.rollout import Rollout
from ..physics.values import Layout
from ..table.table import Table
from .actions import Action, Arrange, Concede, NextFrame, Stalemate, Stroke
from .judging import judged
from .rules import AIM, OVER, Ask, Choice, Rules, Ruling, State, game
from .rules.lag import Lag, LagState
from .rules.pool.pool import PoolRules
from .rules.practice import Practice
from .rules.report import Call, Report
from .setup import ALTERNATE, LAG, WINNER, Setup, can_lag, checked
from .tally import Tally, after_frame, after_stroke


@dataclass(frozen=True, slots=True)
class Moment:
    """Where a match stands after an action, and that action; `rollout` and `report` are of a stroke.

    A lag has no report: it counts for nothing but the break. `shooter` played the last stroke of the frame, -1
    where there was none; `breaker` broke or is to.
    """

    ruling: Ruling
    tallies: tuple[Tally, ...]
    breaker: int
    frame: int = 0
    shooter: int = -1
    action: Action | None = None
    rollout: Rollout | None = None
    report: Report | None = None

    @property
    def layout(self) -> Layout:
        return self.ruling.layout

    @property
    def state(self) -> State:
        return self.ruling.state


class Match:
    """A match on one table. `play` goes on, `undo` and `redo` go back and forth by an action.

    `now` is the present moment, `history` all that led to it.

    Examples:
        >>> from pool2d import Shot, load_table
        >>> from pool2d.game import Match, Setup, Stroke
        >>> match = Match(load_table("pool-9ft"), Setup("nine-ball", names=("Ann", "Bo"), race=3, breaker=0, seed=7))
        >>> moment = match.play(Stroke(Shot(angle=0.2, speed=8.0)))
        >>> moment.report.potted, moment.ruling.foul, match.names[match.state.turn]
        ((), False, 'Bo')
        >>> match.undo(), len(match.history)
        (True, 1)
    """

    def __init__(self, table: Table, setup: Setup) -> None:
        """Raises InputError where the setup is not one, or the game cannot be played on the table."""
        self.table = table
        self.rules = game(setup.game, table, setup.options)
        self.setup = checked(setup, self.rules, table)
        self.names = self.setup.names
        coin = random.Random(f"coin {setup.seed}").randrange(self.rules.players)
        breaker = coin if setup.breaker < 0 else setup.breaker
        ruling = self._lag.start(breaker, setup.seed) if setup.breaker == LAG else self._begin(breaker)
        self._past = [Moment(ruling, (Tally(),) * self.rules.players, breaker)]
        self._future: list[Moment] = []
        # How many of the past moments were played before the table was changed last.
        self._older = 0

    @property
    def now(self) -> Moment:
        """The present moment."""
        return self._past[-1]

    @property
    def history(self) -> tuple[Moment, ...]:
        """The moments so far, the first before anything was played, the last being now."""
        return tuple(self._past)

    @property
    def state(self) -> State:
        """The state of the game now."""
        return self.now.state

    @property
    def layout(self) -> Layout:
        """Where the balls are now."""
        return self.now.layout

    @property
    def ask(self) -> Ask:
        """What is to happen next, and who is to do it."""
        return self.now.ruling.ask

    @property
    def frames(self) -> tuple[int, ...]:
        """How many frames each player has won."""
        return tuple(tally.frames for tally in self.now.tallies)

    @property
    def winner(self) -> int | None:
        """Who has won the match; None while nobody has."""
        return next((player for player, won in enumerate(self.frames) if won >= self.setup.race), None)

    @property
    def over(self) -> bool:
        """Whether somebody has won the match."""
        return self.winner is not None

    def play(self, action: Action) -> Moment:
        """Carry out an action; returns the moment it leads to.

        Raises InputError for one that is not asked for or out of range, BudgetError for a shot that does
        not end; nothing has changed then.
        """
        moment = self._after(action)
        self._past.append(moment)
        self._future.clear()
        return moment

    def undo(self) -> bool:
        """Go back to before the last action; False where there is none.

        So it is where the table has changed since and the balls of then do not fit.
        """
        if len(self._past) == 1:
            return False
        if len(self._past) - 1 <= self._older:
            try:
                self._past[-2] = self._settled(self._past[-2], self.table)
            except InputError:
                return False
        self._future.append(self._past.pop())
        return True

    def redo(self) -> bool:
        """Go on to what was last undone; False where nothing was, or something else was played since."""
        if not self._future:
            return False
        self._past.append(self._future.pop())
        return True

    def accept(self, moment: Moment, instead: bool = False) -> None:
        """Go on to a moment that is known from elsewhere, as from a record; with `instead` in place of the present."""
        if instead:
            self._past[-1] = moment
        else:
            self._past.append(moment)
            self._future.clear()

    def change_table(self, table: Table) -> None:
        """Go on with other parameters; raises InputError, changing nothing, where the balls do not fit.

        What was undone cannot be done again: it came of the table as it was. The way back is kept, as far as the
        balls of then fit. A record of the match would no longer replay: it is for practice.
        """
        now = self._settled(self.now, table)
        self.rules = game(self.setup.game, table, self.setup.options)
        self.table = table
        self._past[-1] = now
        self._older = len(self._past) - 1
        self._future.clear()

    @staticmethod
    def _settled(moment: Moment, table: Table) -> Moment:
        """The moment with its balls as they stand on a table; raises InputError where they do not fit."""
        layout = table.settle(moment.layout)
        return moment if layout is moment.layout else replace(moment, ruling=moment.ruling._replace(layout=layout))

    def _after(self, action: Action) -> Moment:
        now = self.now
        state, layout, rules = now.state, now.layout, self.judge
        if isinstance(action, NextFrame):
            return self._next_frame()
        if state.over:
            raise InputError("match", "action", action, "the frame is over")
        if isinstance(action, Stroke):
            return self._stroke(action)
        if isinstance(action, Choice):
            ruling = rules.choose(state, layout, action)
            if lagged(state) and not lagged(ruling.state):
                now = replace(now, shooter=-1, breaker=ruling.state.breaker)
        elif isinstance(action, Concede):
            if type(action.player) is not int or not 0 <= action.player < self.rules.players:
                raise InputError("match", "player", action.player, f"allowed is 0 to {self.rules.players - 1}")
            ruling = rules.conceded(state, layout, action.player)
        elif isinstance(action, Stalemate):
            # The last stroke is nobody's in the new rack.
            now = replace(now, shooter=-1)
            again = rules.lags_again and can_lag(self.rules, self.table)
            ruling = self._lag.again(state) if again else rules.stalemate(state)
        else:
            ruling = self._arranged(action)
        return self._moment(replace(now, ruling=ruling, action=action, rollout=None, report=None))

    def _stroke(self, stroke: Stroke) -> Moment:
        now, ask = self.now, self.ask
        if ask.kind != AIM:
            raise InputError("match", "action", "a stroke", f"allowed is what is asked for: {ask.kind}")
        if stroke.shot.ball not in (ask.cues or (ask.ball,)):
            allowed = f"allowed is {', '.join(ask.cues) or ask.ball}"
            raise InputError("match", "shot.ball", stroke.shot.ball, allowed)
        _check_call(stroke.call, ask, self.table)
        rollout, report, ruling = judged(self.judge, now.state, now.layout, stroke)
        if lagged(now.state):
            return Moment(ruling, now.tallies, now.breaker, now.frame, ask.player, stroke, rollout)
        tallies = after_stroke(now.tallies, ask.player, now.shooter == ask.player, self.rules, ruling, report)
        return self._moment(Moment(ruling, tallies, now.breaker, now.frame, ask.player, stroke, rollout, report))

    def _moment(self, moment: Moment) -> Moment:
        """The moment with a frame counted that has just ended."""
        if not moment.state.over:
            return moment
        return replace(moment, tallies=after_frame(moment.tallies, moment.state.winner))

    def _arranged(self, action: Arrange) -> Ruling:
        if not isinstance(self.rules, Practice):
            raise InputError("match", "action", "arrange", "allowed in practice only")
        return self.rules.arranged(self.state, action.layout)

    def _next_frame(self) -> Moment:
        now = self.now
        if self.ask.kind != OVER or self.over:
            raise InputError("match", "action", "next frame", "allowed between frames only")
        breaker, winner, players = now.breaker, now.state.winner, self.rules.players
        if self.setup.breaks == ALTERNATE:
            breaker = (breaker + 1) % players
        elif winner is not None:
            breaker = winner if self.setup.breaks == WINNER else (winner + 1) % players
        ruling = self.rules.start(breaker, self._seed(now.frame + 1))
        return Moment(ruling, now.tallies, breaker, now.frame + 1, action=NextFrame())

    def rules_of(self, lag: bool) -> Rules[Any]:
        """The rules of the game, or of the lag before it."""
        return self._lag if lag else self.rules

    @property
    def judge(self) -> Rules[Any]:
        """The rules that hold at the moment."""
        return self.rules_of(lagged(self.state))

    @cached_property
    def _lag(self) -> Lag:
        return Lag(self.table, self._begin)

    def _begin(self, breaker: int, lag: LagState | None = None) -> Ruling:
        """The first break of the match, or one after a stalemate that was lagged for: the scores are kept."""
        if lag is None or lag.racks < 0 or not isinstance(self.rules, PoolRules):
            return self.rules.start(breaker, self._seed(0))
        kept = {name: getattr(lag, name) for name in ("seed", "scores", "fouls", "racks")}
        return self.rules.broken_by(breaker, self.rules.state_type(**kept))

    def _seed(self, frame: int) -> int:
        """The seed of a frame's racks."""
        return self.setup.seed + 1_000_000 * frame


def lagged(state: State) -> bool:
    """Whether players lag, or have to choose what follows from it."""
    return isinstance(state, LagState)


def _check_call(call: Call, ask: Ask, table: Table) -> None:
    """Raises InputError where what is called may not be, or is nothing on the table."""
    for said, value in (("safety", call.safety), ("push", call.push)):
        if value and said not in ask.may:
            raise InputError("match", "call", said, f"allowed is {', '.join(ask.may) or 'neither safety nor push'}")
    pockets = [pocket.name for pocket in table.geometry.pockets]
    if call.pocket and call.pocket not in pockets:
        raise InputError("match", "call.pocket", call.pocket, suggest(call.pocket, pockets))
