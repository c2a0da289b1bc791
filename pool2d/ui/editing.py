"""Arranging the table between shots: any ball by mouse and keyboard, and whole positions by keys.

In practice every ball may be moved, added and taken off; in a match only the cue ball in hand, within what the
rules allow. The left button is for aiming, so with it only the cue ball is picked up, which one does not aim at.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import pygame

from ..errors import InputError
from ..game import arranging, shelf
from ..physics.values import Ball, Layout, Shot
from ..placing import mirrored
from ..position import Position, read, write
from ..scenario import Scenario, scenario_of
from . import clipboard, shelf_dialog
from .aim import Aim
from .keys import KEYS
from .telling import ball_name
from .words import say

if TYPE_CHECKING:
    from .play import Play

Pos = tuple[int, int]

_LEFT, _RIGHT = 1, 3
# A press becomes a drag when the pointer has moved so far, in pixels.
_DRAG = 4.0


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
        self.keys: dict[str, Callable[[], None]] = {
            "next_ball": self.next_ball,
            "add_ball": self.add,
            "remove_ball": self.remove,
            "same_shot": self.same_shot,
            "mirror": self.mirror,
            "mirror_ends": lambda: self.mirror(ends=True),
            "copy": self.copy,
            "paste": self.paste,
            "save_position": self.save,
            "open_position": self.open,
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

    def let_go(self) -> None:
        """Put back what is held, as if nothing had been done."""
        self._grip = None
        self.play.in_hand.let_go()

    def cancel(self) -> bool:
        """Put back a ball that was picked up; whether one was."""
        if not self.play.in_hand.ball:
            return False
        self.let_go()
        self._tell(lambda: say("edit.put_back"))
        return True

    def _press(self, pos: Pos, button: int) -> bool:
        play = self.play
        on_table = play.stage.screen.top.bottom <= pos[1] < play.stage.screen.bottom.top
        if play.playback is not None or play.hands.busy or play.in_hand.ball or not on_table:
            return False
        x, y = play.stage.view.to_table(*pos)
        ball = play.session.layout.get(play.session.table.under(x, y, play.session.layout) or "")
        if button == _LEFT and (ball is None or ball.id != play.session.cue.id or play.session.in_hand):
            return False
        if (ball is None and not play.session.free) or (ball is not None and not self._may_move(ball.id)):
            return False
        if ball is None:
            self._grip = Grip(button, pos, "")
        else:
            self._grip = Grip(button, pos, ball.id, (ball.x - x, ball.y - y))
        return True

    def _drag(self, grip: Grip, pos: Pos) -> None:
        grip.moved = grip.moved or math.dist(pos, grip.pos) > _DRAG
        if grip.moved and grip.ball:
            x, y = self.play.stage.view.to_table(*pos)
            self.play.in_hand.take(grip.ball, (x + grip.offset[0], y + grip.offset[1]))

    def _release(self, grip: Grip, pos: Pos) -> None:
        play = self.play
        play.hands.hold = pos
        if grip.moved and play.in_hand.ball:
            if play.session.free and play.stage.screen.top.collidepoint(pos):
                self.remove()
            elif not self.place():
                self.let_go()
                self._tell(lambda: say("edit.no_room"))
        elif grip.button == _RIGHT and not grip.moved:
            if grip.ball:
                self._take_off(grip.ball)
            else:
                self.add()

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
        if not self._allowed():
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
        elif self._allowed():
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
            play.tell("")
        return placed

    # Positions.

    def same_shot(self) -> None:
        """Put the balls back as they were before the last stroke, and aim it again."""
        last = arranging.latest(self.play.session)
        if last is None:
            self._tell(lambda: say("play.no_shot"))
        elif self._allowed() and self._arrange(*last):
            self._tell(lambda: say("edit.same_shot", key=KEYS.shown("strike")))

    def mirror(self, ends: bool = False) -> None:
        """Change over the sides of the table, or its ends, and the aim with them."""
        session = self.play.session
        if not self._allowed():
            return
        aimed = arranging.mirrored_shot(self.play.hands.aim.shot(session.cue.id), ends)
        try:
            layout = mirrored(session.table, session.layout, ends)
        except InputError as error:
            self.play.tell(str(error))
            return
        if self._arrange(layout, aimed):
            self._tell(lambda: say("edit.mirrored_ends") if ends else say("edit.mirrored"))

    def copy(self) -> None:
        """Copy the position, with what is aimed, as a line of text."""
        session = self.play.session
        text = write(session.layout, self.play.hands.aim.shot(session.cue.id), session.table)
        copied = clipboard.put(text)
        self._tell(lambda: say("edit.copied") if copied else say("edit.no_clipboard"))

    def paste(self) -> None:
        """Set up the position that has been copied."""
        text = clipboard.get()
        if text is None:
            self._tell(lambda: say("edit.no_clipboard"))
        elif not text.strip():
            self._tell(lambda: say("edit.nothing_copied"))
        elif self._allowed():
            try:
                scenario = scenario_of(self._here(read(text, say("edit.clipboard"))))
            except InputError as error:
                self.play.tell(str(error))
                return
            if self.load(scenario):
                self._tell(lambda: say("edit.pasted"))

    def save(self) -> None:
        """Ask for a name to keep the position by."""
        session = self.play.session
        shot = self.play.hands.aim.shot(session.cue.id)

        def keep(name: str) -> None:
            path = shelf.save(name, session.table, session.layout, shot)
            self._tell(lambda: say("play.saved", path=path))

        self.play.go_to(shelf_dialog.ask_for_name(self.play, keep))

    def open(self) -> None:
        """Choose one of the positions that are kept."""
        if self._allowed():
            self.play.go_to(shelf_dialog.Positions(self.play, self._open))

    def load(self, scenario: Scenario) -> bool:
        """Set up a scenario, on its own table; False, and nothing is changed, where it is no position to play."""
        play, table = self.play, scenario.table
        here = play.session.table
        if (table.source, table.conditions, table.set) != (here.source, here.conditions, here.set):
            try:
                play.take_table(table, scenario.layout)
            except InputError as error:
                play.tell(str(error))
                return False
            return self._aim(scenario.shot)
        return self._arrange(scenario.layout, scenario.shot)

    def _open(self, name: str) -> str:
        """Set up a position by name; returns what is wrong with it, or nothing."""
        try:
            scenario = shelf.load(name)
        except InputError as error:
            return str(error)
        if not self.load(scenario):
            return self.play.message
        self._tell(lambda: say("edit.opened", name=name))
        return ""

    def _here(self, position: Position) -> Position:
        """A position that names no table, on the one that is played on; one of a shot alone, with its balls."""
        session = self.play.session
        if position.table:
            return position
        return Position(
            position.layout or session.layout,
            position.shot,
            session.table.source,
            (*session.table.conditions, *position.conditions),
            {**session.table.set, **position.set},
        )

    # What all of them do.

    def _arrange(self, layout: Layout, shot: Shot | None) -> bool:
        """Put the balls so and aim so; False, and nothing is changed, where they cannot stand."""
        try:
            self.play.session.arrange(layout)
        except InputError as error:
            self.play.tell(str(error))
            return False
        self.play.drop()
        return self._aim(shot)

    def _aim(self, shot: Shot | None) -> bool:
        hands = self.play.hands
        if shot is not None:
            hands.aim = Aim.of(shot)
        hands.hold = hands.pointer
        return True

    def _hold(self, ball: str, at: tuple[float, float] | None = None) -> None:
        play = self.play
        play.drop()
        play.in_hand.take(ball, at)
        play.hands.hold = play.hands.pointer
        name = ball_name(ball, play.session.table.furniture.cue)
        place, off = KEYS.shown("strike"), KEYS.shown("remove_ball")
        if play.session.free:
            self._tell(lambda: say("edit.held", ball=name, place=place, off=off))
        else:
            self._tell(lambda: say("edit.cue_held", ball=name, place=place))

    def _take_off(self, ball: str) -> None:
        session = self.play.session
        name = ball_name(ball, session.table.furniture.cue)
        if ball in session.layout and self._arrange(session.layout.without(ball), None):
            self._tell(lambda: say("edit.taken_off", ball=name, undo=KEYS.shown("undo")))
        self.let_go()

    def _may_move(self, ball: str) -> bool:
        session = self.play.session
        return session.free or (session.movable and ball == session.cue.id)

    def _allowed(self) -> bool:
        """Whether this is practice; where it is not, that is told."""
        if not self.play.session.free:
            self._tell(lambda: say("play.practice_only"))
        return self.play.session.free

    def _tell(self, told: Callable[[], str]) -> None:
        self.play.told = told
