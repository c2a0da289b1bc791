"""Arranging the table between shots: any ball by mouse and keyboard.

In practice every ball may be moved, added and taken off; in a match only the cue ball in hand, within what the
rules allow. The left button is for aiming, so with it only the cue ball is picked up, which one does not aim at.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import pygame

from ...errors import InputError
from ...game import arranging
from ...physics.values import Ball
from ..stage.stage import Stage
from ..wording.shot_text import ball_name, begun
from .in_hand import Grip, Pos
from .messages import Message
from .state import PlayState

_LEFT, _RIGHT = 1, 3
# A press becomes a drag when the pointer has moved so far, in pixels.
_DRAG = 4.0
# So near to its edge the cue ball is meant, in pixels and in units of the grid, whichever is more: a hand that misses
# it by a little does not mean to strike.
_NEAR, _NEAR_UNITS = 12.0, 1.5


class Editing:
    """What hands do to the balls of a scene between shots; `keys` is what keys do, by the names of their actions."""

    def __init__(self, state: PlayState, stage: Stage) -> None:
        self.state = state
        self.words = state.words
        self.stage = stage
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
        grip = self.state.in_hand.grip
        if grip is None:
            return False
        if event.type == pygame.MOUSEMOTION:
            self._drag(grip, event.pos)
        elif event.type == pygame.MOUSEBUTTONUP and event.button == grip.button:
            self.state.in_hand.grip = None
            self._release(grip, event.pos)
        else:
            return False
        return True

    def cancel(self) -> bool:
        """Put back a ball that was picked up; whether one was."""
        in_hand = self.state.in_hand
        if not in_hand.ball:
            return False
        in_hand.put_back()
        # What the rules gave is not given again.
        in_hand.given_at = self.state.session.match.now
        self._say(lambda: self.words.say("edit.put_back"))
        return True

    def _press(self, pos: Pos, button: int) -> bool:
        state = self.state
        on_table = self.stage.screen.top.bottom <= pos[1] < self.stage.screen.bottom.top
        if state.playback is not None or state.hands.busy or state.in_hand.ball or not on_table:
            return False
        x, y = self.stage.view.to_table(*pos)
        ball = self._meant(pos, button)
        if button == _LEFT and (ball is None or ball.id != state.session.cue.id or state.session.in_hand):
            return False
        if (ball is None and not state.mode.may_arrange) or (ball is not None and not self._may_move(ball.id)):
            return False
        if ball is None:
            self.state.in_hand.grip = Grip(button, pos, "")
        else:
            self.state.in_hand.grip = Grip(button, pos, ball.id, (ball.x - x, ball.y - y))
        return True

    def carry(self, pos: Pos) -> None:
        """Keep hold of the ball that was put down here, or could not be, as long as the button is down."""
        session = self.state.session
        ball = self.state.in_hand.held(session) or self._meant(pos, _LEFT)
        if ball is not None and (session.in_hand or self._may_move(ball.id)):
            self.state.in_hand.grip = Grip(_LEFT, pos, ball.id)

    def _meant(self, pos: Pos, button: int) -> Ball | None:
        """The ball under the pointer; for the left button also the cue ball that the pointer just misses."""
        session, view = self.state.session, self.stage.view
        x, y = view.to_table(*pos)
        under = session.layout.get(session.table.under(x, y, session.layout) or "")
        if under is not None or button != _LEFT or session.in_hand:
            return under
        cue = session.cue
        near = max(_NEAR, _NEAR_UNITS * self.stage.screen.unit) / view.scale
        beside = math.hypot(cue.x - x, cue.y - y) <= session.table.body_of(cue)[0] + near
        return cue if beside and self._may_move(cue.id) else None

    def _drag(self, grip: Grip, pos: Pos) -> None:
        state = self.state
        grip.moved = grip.moved or math.dist(pos, grip.pos) > _DRAG
        if grip.moved and grip.ball:
            x, y = self.stage.view.to_table(*pos)
            # A ball that the rules have given is in hand already.
            ball = state.in_hand.ball if state.session.in_hand else grip.ball
            state.in_hand.take(ball, (x + grip.offset[0], y + grip.offset[1]))

    def _release(self, grip: Grip, pos: Pos) -> None:
        state = self.state
        state.hands.hold = pos
        if grip.moved and state.in_hand.held(state.session) is not None:
            if state.mode.may_arrange and state.in_hand.ball and self.stage.screen.top.collidepoint(pos):
                self.remove()
            elif not self.place():
                self._refuse()
        elif grip.button == _LEFT and not grip.moved:
            state.calls.point_out(*self.stage.view.to_table(*pos), state.session)
        elif grip.button == _RIGHT and not grip.moved:
            if grip.ball:
                self._take_off(grip.ball)
            else:
                self.add()

    def _refuse(self) -> None:
        """Tell why a ball may not stand where it was let go, and put it back where it came from a place."""
        state = self.state
        why = state.in_hand.refused(state.session, self.words)
        if state.session.in_hand:
            self._say(lambda: why)
        else:
            self.state.in_hand.put_back()
            self._say(lambda: f"{why} {self.words.say('edit.put_back')}")

    # By keyboard.

    def next_ball(self) -> None:
        """Pick up the next ball that may be moved, putting back the one that is held."""
        state = self.state
        balls = [ball.id for ball in state.session.layout.on_table() if self._may_move(ball.id)]
        if state.playback is not None or not balls:
            self._say(lambda: self.words.say("edit.none"))
            return
        at = balls.index(state.in_hand.ball) + 1 if state.in_hand.ball in balls else 0
        self._hold(balls[at % len(balls)])

    def add(self) -> None:
        """Take in hand the lowest ball that is missing; the one after it where such a one is held already."""
        state, session = self.state, self.state.session
        if not self.state.may_arrange():
            return
        balls = arranging.missing(session.table, session.layout)
        if not balls:
            self._say(lambda: self.words.say("edit.all_there"))
            return
        held = state.in_hand.ball
        ball = balls[(balls.index(held) + 1) % len(balls)] if held in balls else balls[0]
        at = (
            self.stage.view.to_table(*state.hands.pointer)
            if state.hands.pointer
            else session.table.furniture.spots["head"]
        )
        if held in balls:
            at = state.in_hand.where(session)
        self._hold(ball, arranging.room_near(session.table, session.layout, Ball(ball, *at)) or at)

    def remove(self) -> None:
        """Take the ball that is held off the table."""
        ball = self.state.in_hand.ball
        if not ball:
            self._say(lambda: self.words.say("edit.hold_first", key=self.words.key("next_ball")))
        elif self.state.may_arrange():
            self._take_off(ball)

    def place(self) -> bool:
        """Put down what is held; False where it may not stand."""
        state = self.state
        try:
            placed = state.in_hand.place(state.session)
        except InputError as error:
            self.state.in_hand.put_back()
            state.messages.say(str(error))
            return True
        if placed:
            state.hands.keep_aim()
            state.messages.clear()
        return placed

    # What all of them do.

    def _hold(self, ball: str, at: tuple[float, float] | None = None) -> None:
        say = self.words.say
        state = self.state
        state.drop()
        state.in_hand.take(ball, at)
        state.hands.keep_aim()
        name = ball_name(self.words, ball, state.session.table.furniture.cue)
        place, off = self.words.key("strike"), self.words.key("remove_ball")
        if state.mode.may_arrange:
            self._say(lambda: say("edit.held", ball=name, place=place, off=off))
        else:
            self._say(lambda: say("edit.cue_held", ball=name, place=place))

    def _take_off(self, ball: str) -> None:
        session = self.state.session
        name = ball_name(self.words, ball, session.table.furniture.cue)
        if ball in session.layout and self.state.arrange(session.layout.without(ball)):
            self._say(lambda: self.words.say("edit.taken_off", ball=name, undo=self.words.key("undo")))
        self.state.in_hand.put_back()

    def _may_move(self, ball: str) -> bool:
        session = self.state.session
        return self.state.mode.may_arrange or (session.movable and ball == session.cue.id)

    def _say(self, message: Message) -> None:
        self.state.messages.show(lambda: begun(message()))
