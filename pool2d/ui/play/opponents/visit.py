"""A player's visit to the table: thinks, looks along some of what was weighed, settles, says what is meant, strikes."""

from __future__ import annotations

import itertools
import math
from collections.abc import Generator, Iterator
from typing import Final, Protocol

from ....game.actions import Action, Stroke
from ....game.aim import Aim
from ....game.rules import PLACE, Choice, Ruling
from ....game.rules.report import Call
from ....opponent.deciding import Decision
from ....opponent.player import Player
from ....opponent.playing import by_hand
from ....physics.values import Shot
from ..messages import Message
from ..state import PlayState
from . import aloud
from .movements import Movement, Movements

# How long a look at a ball or along a shot takes, and how long it rests there, s.
_LOOK: Final = 0.7
_REST: Final = 0.45
# How long it takes to settle on the shot that is chosen, and to carry the cue ball to its place, s.
_SETTLE: Final = 0.8
_CARRY: Final = 1.0
# How long what is said is left to be read before it is done, s.
_READ: Final = 1.3
# How many other shots are looked at, and how far they have to be from each other to be others, degrees.
_OTHERS: Final = 2
_APART: Final = 2.0
_PRACTICE_STROKES: Final = 2


class Thinks(Protocol):
    """Whoever is asked what a player does: a `Thinker`."""

    def ask(self, ruling: Ruling, player: Player, seed: str) -> None:
        """Ask; what was asked before is forgotten."""

    def answer(self) -> Decision | None:
        """What was decided; None as long as nothing is."""

    def close(self) -> None:
        """Think no more."""


class Visit:
    """What `player`, called `name`, does at the table of a state, from where the match stands.

    `movement` is what is seen of it, frame by frame, which also plays what was decided; `says` is what is said of it at
    the moment. Where nothing comes of it, ThinkerError, InputError or BudgetError is raised.
    """

    def __init__(self, state: PlayState, thinker: Thinks, player: Player, name: str) -> None:
        self.state = state
        self.thinker = thinker
        self.player = player
        self.name = name
        self.movements = Movements(state.hands, state.in_hand, lambda: state.show.effects.stroke)
        self.movements.hurried = state.show.effects.instant
        self.says: Message = aloud.thinking(state.words, name)
        self.movement = self._visit()
        next(self.movement)

    @property
    def seed(self) -> str:
        """What decides all of the visit: the same in the same match at the same point."""
        match = self.state.session.match
        return f"{match.setup.seed} {len(match.history)}"

    def _visit(self) -> Movement:
        yield
        seed = self.seed
        decision = yield from self._thought(seed)
        for action in decision.actions:
            yield from self._act(action, decision, seed)

    def _thought(self, seed: str) -> Generator[None, float, Decision]:
        """Think, and look about meanwhile."""
        self.thinker.ask(self.state.session.ruling, self.player, seed)
        looks = self._looks()
        next(looks)
        while (decision := self.thinker.answer()) is None:
            looks.send((yield))
        return decision

    def _act(self, action: Action, decision: Decision, seed: str) -> Movement:
        if isinstance(action, Stroke):
            return self._stroke(action, decision, seed)
        assert isinstance(action, Choice)
        return self._place(action) if action.key == "place" else self._choose(action)

    # While thinking.

    def _looks(self) -> Movement:
        """Look from ball to ball, for as long as it is sent time; once hurried, no more."""
        for angle in itertools.cycle(self._ways()):
            yield from self.movements.turn(Aim(angle), _LOOK)
            yield from self.movements.wait(_REST)
            if self.movements.hurried:
                yield

    def _ways(self) -> list[float]:
        """The directions of the balls that may be hit, the nearest first; the present one where there are none."""
        layout, cue, ask = self.state.session.layout, self.state.session.cue, self.state.session.ask
        balls = [ball for ball in layout.on_table() if ball.id != cue.id and ball.id in (ask.on or layout)]
        balls.sort(key=lambda ball: math.dist((ball.x, ball.y), (cue.x, cue.y)))
        ways = [math.degrees(math.atan2(ball.y - cue.y, ball.x - cue.x)) for ball in balls[: _OTHERS + 1]]
        return ways or [self.state.hands.aim.angle]

    # What was decided.

    def _choose(self, choice: Choice) -> Movement:
        self.says = aloud.chosen(self.state.words, self.name, choice.key)
        yield from self.movements.wait(_READ)
        self._done(choice)

    def _place(self, choice: Choice) -> Movement:
        """Carry the cue ball to its place; one that a foul has given is taken from where it lies."""
        session, in_hand = self.state.session, self.state.in_hand
        self.says = aloud.placing(self.state.words, self.name)
        if session.ask.kind != PLACE:
            in_hand.take(session.cue.id)
        yield from self.movements.carry(in_hand.where(session), (choice.x, choice.y), _CARRY)
        in_hand.let_go()
        self._done(choice)

    def _stroke(self, stroke: Stroke, decision: Decision, seed: str) -> Movement:
        """Look along others, settle, say what is meant, swing, and strike as the hand does it."""
        move, session = self.movements, self.state.session
        if session.ask.cues:
            session.take_cue(stroke.shot.ball)
        for other in _others(stroke, decision):
            yield from move.turn(Aim.of(other), _LOOK)
            yield from move.wait(_REST)
        self._call(stroke)
        yield from move.turn(Aim.of(stroke.shot), _SETTLE)
        yield from move.practise(_PRACTICE_STROKES)
        struck = by_hand(session.match, stroke, self.player, seed)
        assert isinstance(struck, Stroke)
        yield from move.draw_back(Aim.of(struck.shot))
        self.state.play(struck, drawn=True)
        if struck.call != Call() and not self.state.messages.text:
            self.state.messages.show(self.says)

    def _call(self, stroke: Stroke) -> None:
        """Say what is meant, and mark it on the table."""
        calls, call = self.state.calls, stroke.call
        self.says = aloud.called(self.state.words, self.name, call)
        calls.declare(safety=call.safety, push=call.push)
        calls.ball, calls.pocket = call.ball, call.pocket

    def _done(self, choice: Choice) -> None:
        self.state.session.do(choice)
        self.state.messages.clear()


def _others(stroke: Stroke, decision: Decision) -> list[Shot]:
    """Shots that were weighed beside the one that is played, from the same place, the best last."""
    here = decision.weighed[0].candidate.place if decision.weighed else None
    found: list[Shot] = []
    for shot in _weighed(decision, here, stroke.shot.ball):
        if len(found) < _OTHERS and all(_apart(shot, other) for other in (stroke.shot, *found)):
            found.append(shot)
    return found[::-1]


def _weighed(decision: Decision, place: Choice | None, ball: str) -> Iterator[Shot]:
    for weighed in decision.weighed[1:]:
        shot = weighed.candidate.stroke.shot
        if weighed.candidate.place == place and shot.ball == ball:
            yield shot


def _apart(one: Shot, other: Shot) -> bool:
    return abs(math.remainder(one.angle - other.angle, 360.0)) > _APART
