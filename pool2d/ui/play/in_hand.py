"""A ball in the player's hand: the cue ball that the rules give, or any that was picked up; and putting it down."""

from __future__ import annotations

from dataclasses import dataclass

from ...game.match import Moment
from ...game.rules.spotting import KITCHEN, D, within
from ...game.session import Session
from ...physics.values import Ball
from ..wording.words import Words

Point = tuple[float, float]
Pos = tuple[int, int]


@dataclass
class Grip:
    """A button that went down at `pos` on a ball, or on the bare cloth where `ball` is ""."""

    button: int
    pos: Pos
    ball: str
    # From the pointer to the ball's middle, m.
    offset: Point = (0.0, 0.0)
    moved: bool = False


class InHand:
    """`ball` is one that was picked up, or ""; `at` is where the ball is held, m; None before a hand has moved it.

    `grip` is the button that holds it, if one does; `given_at` the moment whose cue ball has been put into the hand.
    """

    def __init__(self) -> None:
        self.ball = ""
        self.at: Point | None = None
        self.grip: Grip | None = None
        self.given_at: Moment | None = None

    def take(self, ball: str, at: Point | None = None) -> None:
        """Pick a ball up, from where it lies or straight to a place."""
        self.ball, self.at = ball, at

    def let_go(self) -> None:
        """Forget what was done: a ball that was picked up is where it was."""
        self.ball, self.at = "", None

    def put_back(self) -> None:
        """Put back what is held, as if nothing had been done: what the rules gave is given again."""
        self.grip = None
        if self.ball:
            self.given_at = None
        self.let_go()

    def held(self, session: Session) -> Ball | None:
        """The ball in hand, as it would stand where it is held; None where no ball is."""
        if not self.ball and not session.in_hand:
            return None
        x, y = self.where(session)
        ball = session.layout.get(self.ball or session.cue.id) or Ball(self.ball, x, y)
        return ball.still()._replace(x=x, y=y)

    def where(self, session: Session) -> Point:
        """Where the ball is held: at first where it lies, or on the table's head spot."""
        lies = session.layout.get(self.ball) if self.ball else None
        return self.at or ((lies.x, lies.y) if lies is not None else session.table.furniture.spots["head"])

    def nudge(self, session: Session, dx: float, dy: float) -> None:
        """Move it by so much."""
        x, y = self.where(session)
        self.at = (x + dx, y + dy)

    def may_stand(self, session: Session) -> bool:
        """Whether it may be put down where it is held."""
        ball = self.held(session)
        if ball is None:
            return False
        if self._by_rules(session):
            return session.may_place(ball.x, ball.y)
        radius = session.table.body_of(ball)[0]
        return session.table.has_room(ball.x, ball.y, radius, session.layout, ignore=ball.id)

    def refused(self, session: Session, words: Words) -> str:
        """Why it may not stand where it is held."""
        say = words.say
        ball, where = self.held(session), session.ask.where
        if ball is None or not self._by_rules(session) or within(session.table, where, ball.x, ball.y):
            return say("play.no_room")
        return {KITCHEN: say("play.only_kitchen"), D: say("play.only_d")}.get(where, say("play.no_room"))

    def place(self, session: Session) -> bool:
        """Put it down; False, and it is still held, where it may not stand. Unmoved it just stays where it lies."""
        if self.ball in session.layout and self.at is None:
            self.let_go()
            return True
        ball = self.held(session)
        if ball is None or not self.may_stand(session):
            return False
        if self._by_rules(session):
            session.place(ball.x, ball.y)
        else:
            session.arrange(session.layout.put(ball))
        self.let_go()
        return True

    def _by_rules(self, session: Session) -> bool:
        """Whether the rules have given the ball, and so say where it may stand."""
        return not self.ball or not session.is_practice
