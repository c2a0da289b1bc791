"""A match in which somebody plays who is no person: they take their turns by themselves."""

from __future__ import annotations

from ....errors import BudgetError, InputError
from ....game.match import Moment, lagged
from ....opponent.deciding import agrees
from ....opponent.player import Player
from ....opponent.player_file import load_player
from ....opponent.thinker import Thinker, ThinkerError
from ...scene import Wish
from ...stage.playback import Playback
from ..call_words import ruled
from ..messages import Message
from ..opponents import aloud
from ..opponents.visit import Thinks, Visit
from ..state import PlayState
from .match_mode import MatchMode

# How often a turn is thought anew where that fails; then a person plays it.
_TRIES = 3


class OpponentMode(MatchMode):
    """A match against a player, or between two: the hands of people look on while it is not their turn.

    A player whose file cannot be read is a person's, which is told. `thinker` is who is asked what a player does.
    """

    def __init__(self, state: PlayState, thinker: Thinks | None = None) -> None:
        super().__init__(state.session, state.words, state.calls, state.in_hand)
        self._state = state
        self._missing = ""
        self._seats = tuple(map(self._seated, self.session.match.setup.players))
        self._thinker: Thinks = thinker or Thinker(self.session.table, self.session.match.setup)
        # The visit that is on, the moment that it has led to, and how often it has failed.
        self._visit: Visit | None = None
        self._at: Moment | None = None
        self._failed = 0

    # Whose turn it is.

    @property
    def persons_turn(self) -> bool:
        return self._player is None or self._failed >= _TRIES

    @property
    def still(self) -> bool:
        return self.persons_turn

    @property
    def _player(self) -> Player | None:
        """Who is at the table and is no person."""
        return None if self.session.match.state.over else self._seats[self.session.ask.player]

    @property
    def no_stalemate(self) -> Message | None:
        match = self.session.match
        against = (
            side
            for side, player in enumerate(self._seats)
            if player is not None and not agrees(match.rules, match.now.ruling, player, side)
        )
        side = None if lagged(match.state) else next(against, None)
        return None if side is None else aloud.playing_on(self.words, self._name(side))

    def _seated(self, name: str) -> Player | None:
        try:
            return load_player(name) if name else None
        except InputError as error:
            self._missing = str(error)
            return None

    # What is said.

    @property
    def welcome(self) -> Message:
        return (lambda: self._missing) if self._missing else self.standing

    def _verdict(self) -> str:
        if self.persons_turn:
            return super()._verdict()
        said = ruled(self.words, self.session)
        return f"{said} {self._visit.says()}" if self._visit is not None else said

    # What happens.

    def update(self, dt: float) -> None:
        """Go on with the visit of whoever is at the table."""
        if self.session.match.now is not self._at:
            self._begin()
        if self._visit is not None:
            self._go_on_with(self._visit, dt)

    def go_on(self) -> bool:
        if self._visit is None or self.persons_turn:
            return False
        self._visit.movements.hurried = True
        return True

    def at_rest(self, shown: Playback) -> Message | None:
        if shown.again or not self._missed:
            return self.standing
        self._state.sounds.chalk()
        return aloud.chalking(self.words, self._name(self.session.match.now.shooter), self._verdict)

    def drop(self) -> None:
        if self._visit is not None:
            self._state.hands.put_down()
            self._state.in_hand.put_back()
        self._visit = self._at = None
        self._failed = 0

    def leave(self) -> None:
        self.drop()
        self._thinker.close()

    def _begin(self) -> None:
        """Begin a visit where a player is to decide, and end the one that was on."""
        self.drop()
        self._at = self.session.match.now
        self._start()

    def _start(self) -> None:
        player = self._player
        self._visit = None
        if player is not None and not self.persons_turn:
            self._visit = Visit(self._state, self._thinker, player, self._name(self.session.ask.player))

    def _go_on_with(self, visit: Visit, dt: float) -> None:
        try:
            visit.movement.send(dt)
        except StopIteration:
            self._visit = None
        except (ThinkerError, InputError, BudgetError) as error:
            self._fail(visit, str(error))
            return
        # What was done within the visit belongs to it.
        if self._visit is not None:
            self._at = self.session.match.now
        if self.session.match.state.over and self._state.playback is None:
            self._state.go_to(Wish.ENDED)

    def _fail(self, visit: Visit, why: str) -> None:
        """Think anew, or leave the turn to a person; nothing of the match has changed."""
        self._failed += 1
        self._state.in_hand.put_back()
        self._start()
        self._state.messages.show(aloud.stopped(self.words, visit.name, why, self.persons_turn))

    @property
    def _missed(self) -> bool:
        """Whether a player's stroke has just lost the turn, who did not mean that."""
        now = self.session.match.now
        if now.report is None or self._seats[now.shooter] is None or now.state.over:
            return False
        return now.ruling.ask.player != now.shooter and not (now.report.call.safety or now.report.call.push)

    def _name(self, player: int) -> str:
        return self.session.match.names[player]
