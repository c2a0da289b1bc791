"""A match: the referee's verdict stands over every stroke."""

from __future__ import annotations

from ....game.session import Session
from ...wording.words import Words
from ..call_words import verdict
from ..calls import Calls
from ..in_hand import InHand
from ..messages import Message
from ..mode import Mode


class MatchMode(Mode):
    """A match by the rules of its game, with what has been called and the ball in hand."""

    def __init__(self, session: Session, words: Words, calls: Calls, in_hand: InHand) -> None:
        super().__init__(session, words)
        self._calls = calls
        self._in_hand = in_hand

    @property
    def standing(self) -> Message:
        return self._verdict

    @property
    def welcome(self) -> Message:
        return self._verdict

    def _verdict(self) -> str:
        return verdict(self.words, self._calls, self.session, self._in_hand.held(self.session) is not None)
