"""What a player says before a shot: the ball and the pocket meant, a safety, a push out.

A click on a ball or a pocket means it, and the same click takes that back; where the rules let the player choose the
ball that is struck, a click on a ball takes that one.
"""

from __future__ import annotations

import math

from ...game.rules import AIM
from ...game.rules.report import Call
from ...game.session import Session

# How far round a ball, in its radii, a click still means it where nothing else is nearer.
_NEAR = 1.25


class Calls:
    """`ball` and `pocket` are what has been called for the next shot, "" where that is left to be obvious."""

    def __init__(self) -> None:
        self.ball = self.pocket = ""
        self.safety = self.push = False

    def forget(self) -> None:
        """A new shot: nothing has been said of it."""
        self.ball = self.pocket = ""
        self.safety = self.push = False

    # What may be meant.

    def balls(self, session: Session) -> tuple[str, ...]:
        """The balls that may be meant at present, those that are on first."""
        ask = session.ask
        if ask.kind != AIM:
            return ()
        if ask.call != "pocket":
            return ask.cues or (ask.on if ask.call == "ball" else ())
        others = (ball.id for ball in session.layout.on_table() if ball.id not in (*ask.on, session.cue.id))
        return (*ask.on, *others)

    def pockets(self, session: Session) -> tuple[str, ...]:
        """The pockets that may be meant at present."""
        if session.ask.kind != AIM or session.ask.call != "pocket":
            return ()
        return tuple(pocket.name for pocket in session.table.geometry.pockets)

    def under(self, x: float, y: float, session: Session) -> tuple[str, str]:
        """The ball or the pocket at a point of the table that a click there means, the other being ""."""
        table, layout = session.table, session.layout
        reached = {
            ball: math.hypot(layout[ball].x - x, layout[ball].y - y) / table.body_of(layout[ball])[0]
            for ball in self.balls(session)
        }
        ball = min(reached, key=lambda ball: reached[ball], default="")
        if ball and reached[ball] <= _NEAR:
            return ball, ""
        named = self.pockets(session)
        for pocket in table.geometry.pockets:
            if pocket.name in named and math.hypot(pocket.x - x, pocket.y - y) <= pocket.radius:
                return "", pocket.name
        return "", ""

    # Saying it, and taking it back.

    def point_out(self, x: float, y: float, session: Session) -> bool:
        """Mean what is at a point of the table, or take that back; whether there is anything to be meant."""
        ball, pocket = self.under(x, y, session)
        if ball:
            self._mean(ball if ball != self.meant(session) else "", session)
        elif pocket:
            self._say_pocket("" if self.pocket == pocket else pocket)
        return bool(ball or pocket)

    def next_ball(self, session: Session, step: int = 1) -> None:
        """Go on to the next ball that may be meant, or back; where none has to be, after the last to none."""
        struck = bool(session.ask.cues)
        balls = self.balls(session) if struck else ("", *self.balls(session))
        now = session.cue.id if struck else self.ball
        self._mean(balls[(balls.index(now) + step) % len(balls)], session)

    def next_pocket(self, session: Session, step: int = 1) -> None:
        """Go on to the next pocket that may be meant, or back; after the last, to none."""
        pockets = ("", *self.pockets(session))
        self._say_pocket(pockets[(pockets.index(self.pocket) + step) % len(pockets)])

    def declare(self, *, safety: bool = False, push: bool = False) -> None:
        """Say a safety or a push out, in place of all else, or take it back."""
        self.forget()
        self.safety, self.push = safety, push

    def meant(self, session: Session) -> str:
        """The ball that has been pointed out, as the one called or the one to be struck; "" where none was."""
        if session.ask.cues:
            return session.cue.id if session.cue.id != session.ask.ball else ""
        return self.ball

    def said(self, session: Session, aimed: str) -> Call:
        """The call that goes with a shot aimed at a ball."""
        ask = session.ask
        if self.safety or self.push:
            return Call(safety=self.safety, push=self.push)
        if ask.call == "pocket" and (self.ball or self.pocket):
            return Call(self.ball or aimed, self.pocket)
        if ask.call == "ball":
            return Call(self.ball or (aimed if aimed in ask.on else ""))
        return Call()

    def _mean(self, ball: str, session: Session) -> None:
        if session.ask.cues:
            session.take_cue(ball or session.ask.ball)
        else:
            self.ball = ball
            self.safety = self.push = False

    def _say_pocket(self, pocket: str) -> None:
        self.pocket = pocket
        self.safety = self.push = False
