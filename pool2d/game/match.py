"""A match: players, frames, turns, and the way back. `Match` is the one object of the game that changes.

Each action leads to a new `Moment`, which never changes; undo and redo go back and forth among them.
"""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from typing import Any

from ..errors import InputError, suggest
from ..knobs import Knob
from ..physics.rollout import Rollout
from ..physics.simulate import simulate
from ..physics.values import Layout
from ..table import Table
from .actions import Action, Arrange, Concede, NextFrame, Stalemate, Stroke
from .report import Call, Report
from .rules import AIM, OVER, Ask, Choice, Ruling, State, game
from .rules.practice import Practice
from .tally import Tally, after_frame, after_stroke
from .witness import read

ALTERNATE, WINNER, LOSER = "alternate", "winner", "loser"
BREAKS = (ALTERNATE, WINNER, LOSER)
_RACE = Knob(1, 1, 100, "frames", "")
_SEED = Knob(0, -1e15, 1e15, "", "")
_NAME = 40


@dataclass(frozen=True, slots=True)
class Setup:
    """What is agreed before a match.

    `race` is how many frames win it; `breaks` who breaks after the first frame: "alternate", "winner" or
    "loser". `breaker` breaks first, as a lag or the players decided; -1 leaves it to a coin. `seed` gives
    the coin and the racks. Without `names` the players are Player 1 and so on.
    """

    game: str = "practice"
    options: Mapping[str, float | str] = field(default_factory=dict)
    names: tuple[str, ...] = ()
    race: int = 1
    breaks: str = ALTERNATE
    breaker: int = -1
    seed: int = 0

    def as_dict(self) -> dict[str, Any]:
        """The setup in JSON's types; `setup_of` reads it."""
        return {**asdict(self), "options": dict(self.options), "names": list(self.names)}


@dataclass(frozen=True, slots=True)
class Moment:
    """Where a match stands after an action, and that action; `rollout` and `report` are of a stroke.

    `shooter` played the last stroke of the frame, -1 where there was none; `breaker` broke or is to.
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
    """

    def __init__(self, table: Table, setup: Setup) -> None:
        """Raises InputError where the setup is not one, or the game cannot be played on the table."""
        self.table = table
        self.rules = game(setup.game, table, setup.options)
        self.setup = _checked(setup, self.rules.players)
        self.names = self.setup.names
        coin = random.Random(f"coin {setup.seed}").randrange(self.rules.players)
        breaker = coin if setup.breaker < 0 else setup.breaker
        ruling = self.rules.start(breaker, self._seed(0))
        self._past = [Moment(ruling, (Tally(),) * self.rules.players, breaker)]
        self._future: list[Moment] = []

    @property
    def now(self) -> Moment:
        return self._past[-1]

    @property
    def history(self) -> tuple[Moment, ...]:
        return tuple(self._past)

    @property
    def state(self) -> State:
        return self.now.state

    @property
    def layout(self) -> Layout:
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
        """Go back to before the last action; False where there is none."""
        if len(self._past) == 1:
            return False
        self._future.append(self._past.pop())
        return True

    def redo(self) -> bool:
        """Go on to what was last undone; False where nothing was, or something else was played since."""
        if not self._future:
            return False
        self._past.append(self._future.pop())
        return True

    def change_table(self, table: Table) -> None:
        """Go on with other parameters; raises InputError, changing nothing, where the balls do not fit.

        A record of the match would no longer replay: it is for practice.
        """
        layout = table.settle(self.layout)
        rules = game(self.setup.game, table, self.setup.options)
        self.table, self.rules = table, rules
        self._past[-1] = replace(self.now, ruling=self.now.ruling._replace(layout=layout))

    def _after(self, action: Action) -> Moment:
        now = self.now
        state, layout = now.state, now.layout
        if isinstance(action, NextFrame):
            return self._next_frame()
        if state.over:
            raise InputError("match", "action", action, "the frame is over")
        if isinstance(action, Stroke):
            return self._stroke(action)
        if isinstance(action, Choice):
            ruling = self.rules.choose(state, layout, action)
        elif isinstance(action, Concede):
            if type(action.player) is not int or not 0 <= action.player < self.rules.players:
                raise InputError("match", "player", action.player, f"allowed is 0 to {self.rules.players - 1}")
            ruling = self.rules.conceded(state, layout, action.player)
        elif isinstance(action, Stalemate):
            # The last stroke is nobody's in the new rack.
            now, ruling = replace(now, shooter=-1), self.rules.stalemate(state)
        else:
            ruling = self._arranged(action)
        return self._moment(replace(now, ruling=ruling, action=action, rollout=None, report=None))

    def _stroke(self, stroke: Stroke) -> Moment:
        now, ask = self.now, self.ask
        if ask.kind != AIM:
            raise InputError("match", "action", "a stroke", f"allowed is what is asked for: {ask.kind}")
        if stroke.shot.ball != ask.ball:
            raise InputError("match", "shot.ball", stroke.shot.ball, f"allowed is {ask.ball}")
        _check_call(stroke.call, ask, self.table)
        rollout = simulate(self.table, now.layout, stroke.shot)
        report = read(self.table, rollout, stroke.call, ask.ball)
        ruling = self.rules.judge(now.state, rollout.layout(), report)
        tallies = after_stroke(now.tallies, ask.who, now.shooter == ask.who, ruling, report)
        return self._moment(Moment(ruling, tallies, now.breaker, now.frame, ask.who, stroke, rollout, report))

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

    def _seed(self, frame: int) -> int:
        """The seed of a frame's racks."""
        return self.setup.seed + 1_000_000 * frame


def setup_of(data: Mapping[str, Any], source: str) -> Setup:
    """The setup that `as_dict` made it of; raises InputError for an unknown key. Match looks at the values."""
    known = {entry.name for entry in fields(Setup)}
    for key, value in data.items():
        if key not in known:
            raise InputError(source, key, value, suggest(key, known))
    for key, kind in (("options", dict), ("names", list), ("game", str), ("breaks", str)):
        if not isinstance(data.get(key, kind()), kind):
            raise InputError(source, key, data[key], f"allowed is a {kind.__name__}")
    return Setup(**{**data, "names": tuple(data.get("names", ()))})


def _checked(setup: Setup, players: int) -> Setup:
    """The setup with every player named; raises InputError where a value is out of range."""
    for name, knob, value in (("race", _RACE, setup.race), ("seed", _SEED, setup.seed)):
        if type(value) is not int:
            raise InputError("match", name, value, f"allowed is a whole number; {knob.allowed()}")
        knob.check(value, "match", name)
    if setup.breaks not in BREAKS:
        raise InputError("match", "breaks", setup.breaks, suggest(setup.breaks, BREAKS))
    if type(setup.breaker) is not int or not -1 <= setup.breaker < players:
        raise InputError("match", "breaker", setup.breaker, f"allowed is -1, for a coin, to {players - 1}")
    names = setup.names or tuple(f"Player {number}" for number in range(1, players + 1))
    if len(names) != players:
        raise InputError("match", "names", names, f"allowed are {players} names")
    for name in names:
        if not isinstance(name, str) or not name.strip() or not name.isprintable() or len(name) > _NAME:
            raise InputError("match", "names", name, f"allowed is a text of up to {_NAME} printable characters")
    return replace(setup, names=names)


def _check_call(call: Call, ask: Ask, table: Table) -> None:
    """Raises InputError where what is called may not be, or is nothing on the table."""
    for said, value in (("safety", call.safety), ("push", call.push)):
        if value and said not in ask.may:
            raise InputError("match", "call", said, f"allowed is {', '.join(ask.may) or 'neither safety nor push'}")
    pockets = [pocket.name for pocket in table.geometry.pockets]
    if call.pocket and call.pocket not in pockets:
        raise InputError("match", "call.pocket", call.pocket, suggest(call.pocket, pockets))
