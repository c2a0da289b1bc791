"""Arranging the table between shots: any ball by mouse and keyboard.

In practice every ball may be moved, added and taken off; in a match only the cue ball in hand, within what the
rules allow. The left button is for aiming, so with it only the cue ball is picked up, which one does not aim at.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import pygame

from ...errors import InputError
from ...game import arranging
from ...game.match import Moment
from ...physics.values import Ball
from ..wording.keys import KEYS
from ..wording.shot_text import ball_name, begun
from ..wording.words import say

if TYPE_CHECKING:
    from .play import Play

Pos = tuple[int, int]

_LEFT, _RIGHT = 1, 3
# A press becomes a drag when the pointer has moved so far, in pixels.
_DRAG = 4.0
# So near to its edge the cue ball is meant, in pixels and in units of the grid, whichever is more: a hand that misses
# it by a little does not mean to strike.
_NEAR, _NEAR_UNITS = 12.0, 1.5


@dataclass
class Grip:
    """A button that went down at `pos` on a ball, or on the bare cloth where `ball` is ""."""

    button: int
    pos: Pos
    ball: str
    # From the pointer to the ball's middle, m.
    offset: tuple[float, float] = (0.0, 0.0)
    moved: bool = False


class Editing:
    """What hands do to the balls of a scene between shots; `keys` is what keys do, by the names of their actions."""

    def __init__(self, play: Play) -> None:
        self.play = play
        self._grip: Grip | None = None
        # The moment whose cue ball has been put into the hand.
        self._given: Moment | None = None
        self.keys: dict[str, Callable[[], None]] = {
            "next_ball": self.next_ball,
            "add_ball": self.add,
            "remove_ball": self.remove,
        }

    # By mouse.

    def handle(self, event: pygame.event.Event) -> bool:
        """Take an event; whether it was meant for a ball."""
        if event.type == pygame.MOUSEBUTTONDOWN and event.button in (_LEFT, _RIGHT):
            return self._press(event.pos, event.button)
        grip = self._grip
        if grip is None:
            return False
        if event.type == pygame.MOUSEMOTION:
            self._drag(grip, event.pos)
        elif event.type == pygame.MOUSEBUTTONUP and event.button == grip.button:
            self._grip = None
            self._release(grip, event.pos)
        else:
            return False
        return True

    def give(self) -> None:
        """Put a cue ball that a foul has given into the hand, from where it lies: once, lest it come back by itself."""
        play, now = self.play, self.play.session.match.now
        if play.playback is None and not play.hands.busy and self._given is not now:
            self._given = now
            if play.session.given and not play.in_hand.ball:
                play.in_hand.take(play.session.cue.id)
                play.hands.hold = play.hands.pointer

    def let_go(self) -> None:
        """Put back what is held, as if nothing had been done: what the rules gave is given again."""
        self._grip = None
        if self.play.in_hand.ball:
            self._given = None
        self.play.in_hand.let_go()

    def cancel(self) -> bool:
        """Put back a ball that was picked up; whether one was."""
        if not self.play.in_hand.ball:
            return False
        self.let_go()
        self._given = self.play.session.match.now
        self._tell(lambda: say("edit.put_back"))
        return True

    def _press(self, pos: Pos, button: int) -> bool:
        play = self.play
        on_table = play.stage.screen.top.bottom <= pos[1] < play.stage.screen.bottom.top
        if play.playback is not None or play.hands.busy or play.in_hand.ball or not on_table:
            return False
        x, y = play.stage.view.to_table(*pos)
        ball = self._meant(pos, button)
        if button == _LEFT and (ball is None or ball.id != play.session.cue.id or play.session.in_hand):
            return False
        if (ball is None and not play.session.is_practice) or (ball is not None and not self._may_move(ball.id)):
            return False
        if ball is None:
            self._grip = Grip(button, pos, "")
        else:
            self._grip = Grip(button, pos, ball.id, (ball.x - x, ball.y - y))
        return True

    def carry(self, pos: Pos) -> None:
        """Keep hold of the ball that was put down here, or could not be, as long as the button is down."""
        session = self.play.session
        ball = self.play.in_hand.held(session) or self._meant(pos, _LEFT)
        if ball is not None and (session.in_hand or self._may_move(ball.id)):
            self._grip = Grip(_LEFT, pos, ball.id)

    def _meant(self, pos: Pos, button: int) -> Ball | None:
        """The ball under the pointer; for the left button also the cue ball that the pointer just misses."""
        session, view = self.play.session, self.play.stage.view
        x, y = view.to_table(*pos)
        under = session.layout.get(session.table.under(x, y, session.layout) or "")
        if under is not None or button != _LEFT or session.in_hand:
            return under
        cue = session.cue
        near = max(_NEAR, _NEAR_UNITS * self.play.stage.screen.unit) / view.scale
        beside = math.hypot(cue.x - x, cue.y - y) <= session.table.body_of(cue)[0] + near
        return cue if beside and self._may_move(cue.id) else None

    def _drag(self, grip: Grip, pos: Pos) -> None:
        play = self.play
        grip.moved = grip.moved or math.dist(pos, grip.pos) > _DRAG
        if grip.moved and grip.ball:
            x, y = play.stage.view.to_table(*pos)
            # A ball that the rules have given is in hand already.
            ball = play.in_hand.ball if play.session.in_hand else grip.ball
            play.in_hand.take(ball, (x + grip.offset[0], y + grip.offset[1]))

    def _release(self, grip: Grip, pos: Pos) -> None:
        play = self.play
        play.hands.hold = pos
        if grip.moved and play.in_hand.held(play.session) is not None:
            if play.session.is_practice and play.in_hand.ball and play.stage.screen.top.collidepoint(pos):
                self.remove()
            elif not self.place():
                self._refuse()
        elif grip.button == _LEFT and not grip.moved:
            play.call_strip.calls.point_out(*play.stage.view.to_table(*pos), play.session)
        elif grip.button == _RIGHT and not grip.moved:
            if grip.ball:
                self._take_off(grip.ball)
            else:
                self.add()

    def _refuse(self) -> None:
        """Tell why a ball may not stand where it was let go, and put it back where it came from a place."""
        play = self.play
        why = play.in_hand.refused(play.session)
        if play.session.in_hand:
            self._tell(lambda: why)
        else:
            self.let_go()
            self._tell(lambda: f"{why} {say('edit.put_back')}")

    # By keyboard.

    def next_ball(self) -> None:
        """Pick up the next ball that may be moved, putting back the one that is held."""
        play = self.play
        balls = [ball.id for ball in play.session.layout.on_table() if self._may_move(ball.id)]
        if play.playback is not None or not balls:
            self._tell(lambda: say("edit.none"))
            return
        at = balls.index(play.in_hand.ball) + 1 if play.in_hand.ball in balls else 0
        self._hold(balls[at % len(balls)])

    def add(self) -> None:
        """Take in hand the lowest ball that is missing; the one after it where such a one is held already."""
        play, session = self.play, self.play.session
        if not self.play.practising():
            return
        balls = arranging.missing(session.table, session.layout)
        if not balls:
            self._tell(lambda: say("edit.all_there"))
            return
        held = play.in_hand.ball
        ball = balls[(balls.index(held) + 1) % len(balls)] if held in balls else balls[0]
        at = (
            play.stage.view.to_table(*play.hands.pointer)
            if play.hands.pointer
            else session.table.furniture.spots["head"]
        )
        if held in balls:
            at = play.in_hand.where(session)
        self._hold(ball, arranging.room_near(session.table, session.layout, Ball(ball, *at)) or at)

    def remove(self) -> None:
        """Take the ball that is held off the table."""
        ball = self.play.in_hand.ball
        if not ball:
            self._tell(lambda: say("edit.hold_first", key=KEYS.shown("next_ball")))
        elif self.play.practising():
            self._take_off(ball)

    def place(self) -> bool:
        """Put down what is held; False where it may not stand."""
        play = self.play
        try:
            placed = play.in_hand.place(play.session)
        except InputError as error:
            self.let_go()
            play.tell(str(error))
            return True
        if placed:
            play.hands.hold = play.hands.pointer
            play.tell_standing_message()
        return placed

    # What all of them do.

    def _hold(self, ball: str, at: tuple[float, float] | None = None) -> None:
        play = self.play
        play.drop()
        play.in_hand.take(ball, at)
        play.hands.hold = play.hands.pointer
        name = ball_name(ball, play.session.table.furniture.cue)
        place, off = KEYS.shown("strike"), KEYS.shown("remove_ball")
        if play.session.is_practice:
            self._tell(lambda: say("edit.held", ball=name, place=place, off=off))
        else:
            self._tell(lambda: say("edit.cue_held", ball=name, place=place))

    def _take_off(self, ball: str) -> None:
        session = self.play.session
        name = ball_name(ball, session.table.furniture.cue)
        if ball in session.layout and self.play.arrange(session.layout.without(ball)):
            self._tell(lambda: say("edit.taken_off", ball=name, undo=KEYS.shown("undo")))
        self.let_go()

    def _may_move(self, ball: str) -> bool:
        session = self.play.session
        return session.is_practice or (session.movable and ball == session.cue.id)

    def _tell(self, told: Callable[[], str]) -> None:
        self.play.message = lambda: begun(told())
