"""What the mouse means on the table and on the diagrams: aiming, pulling, placing, pointing out."""

from __future__ import annotations

import pygame

from ...game.rules import AIM, OVER
from ..scene import Wish
from ..stage.stage import Stage
from ..wording.keys import fine_step
from .editing import Editing
from .state import PlayState

Pos = tuple[int, int]


class Mouse:
    """The mouse over a state that is shown on a stage; `editing` has what it does to balls between shots."""

    def __init__(self, state: PlayState, stage: Stage, editing: Editing) -> None:
        self.state = state
        self.stage = stage
        self.editing = editing

    def handle(self, event: pygame.event.Event) -> bool:
        """Take an event; whether it was one of the mouse."""
        if event.type == pygame.MOUSEMOTION:
            self.move(event.pos)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            self._press(event.pos)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 3:
            self.put_down()
        elif event.type == pygame.MOUSEBUTTONUP and event.button == 1:
            self._release(event.pos)
        elif event.type == pygame.MOUSEWHEEL:
            self.state.hands.turn(event.y * fine_step(pygame.key.get_mods()))
        else:
            return False
        return True

    def move(self, pos: Pos) -> None:
        """Aim through the pointer, or carry what is held to it."""
        state, hands = self.state, self.state.hands
        if hands.move(pos, self.stage.screen):
            return
        if state.held is not None:
            if not hands.holds(pos):
                state.in_hand.at = self.stage.view.to_table(*pos)
        elif not state.session.in_hand:
            cue = state.session.cue
            hands.point(pos, self.stage.view, cue, state.session.table.body_of(cue)[0])

    def follow(self) -> None:
        """Aim through the pointer where it is, if it is known."""
        if self.state.hands.pointer is not None:
            self.move(self.state.hands.pointer)

    def _press(self, pos: Pos) -> None:
        state, screen = self.state, self.stage.screen
        on_table = screen.top.bottom <= pos[1] < screen.bottom.top
        if (on_table and state.mode.go_on()) or state.hands.grab(pos, screen):
            return
        self.move(pos)
        if state.playback is None and state.session.ask.kind == OVER:
            state.go_to(Wish.ENDED)
        elif state.held is not None:
            self.place()
            # A drag carries it on from here, whether it could be put down or not.
            self.editing.carry(pos)
        elif state.playback is None and state.session.ask.kind == AIM and on_table:
            state.hands.begin_pull(pos)

    def _release(self, pos: Pos) -> None:
        self.move(pos)
        state, hands = self.state, self.state.hands
        clicked = hands.pull is not None and hands.clicked
        speed = hands.let_go()
        if speed > 0.0:
            state.strike(speed, drawn=True)
        elif clicked:
            # What is a pull with a drag means the ball or the pocket without.
            state.calls.point_out(*self.stage.view.to_table(*pos), state.session)
            hands.hold = pos

    def put_down(self) -> None:
        """Let go of the cue without a stroke."""
        if self.state.hands.pull is not None:
            self.state.messages.show(lambda: self.state.words.say("play.put_down"))
        self.state.hands.put_down()

    def place(self) -> None:
        """Put down the ball that is held, or say why it may not stand there."""
        if not self.editing.place():
            self.state.messages.say(self.state.in_hand.refused(self.state.session, self.state.words))
