"""The table being played on: aiming, the stroke, the balls running, the cue ball in hand."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pygame

from ...config.settings import GUIDES
from ...errors import InputError
from ...game.rules import AIM, OVER
from ...game.session import Session
from ...sound.mixer import Sounds
from ..dialogs.save_table import ask_to_save
from ..frame import Frame
from ..scene import GUARD, Scene
from ..screen import Screen
from ..stage.playback import Playback
from ..wording.keys import KEYS, action_of, fine_step
from ..wording.words import say
from . import play_view
from .editing import Editing
from .positions import Positions
from .session_scene import SessionScene
from .tuning import Tuning

_BY_HAND = (pygame.MOUSEBUTTONDOWN, pygame.MOUSEMOTION, pygame.MOUSEWHEEL)
_ARROWS = {"turn_left": (-1.0, 0.0), "turn_right": (1.0, 0.0), "harder": (0.0, 1.0), "softer": (0.0, -1.0)}


class Play(SessionScene):
    """A session and the hands that play it: what each event means to it."""

    def __init__(self, session: Session, sounds: Sounds | None = None) -> None:
        super().__init__(session, sounds)
        self.editing = Editing(self)
        self.positions = Positions(self)
        self.geometry = False
        self.vectors = False
        # What opens where Esc finds nothing to put away.
        self.paused: Callable[[], Scene | None] = lambda: None
        # Told where this is on the window from now on.
        self.entered: Callable[[Play], None] = lambda play: None
        self._keys: dict[str, Callable[[], None]] = {
            **self.hands.keys,
            **self.stage.camera.keys,
            **self.editing.keys,
            **self.positions.keys,
            "strike": self._enter,
            "guide": self._next_guide,
            "fast": lambda: self._fast_forward(True),
            "replay": self._replay,
            "pause": self._pause,
            "undo": self._undo,
            "redo": self._redo,
            "rack": self._rack,
            "tune": self._tune,
            "geometry": self._show_geometry,
            "vectors": self._show_vectors,
            "cancel": self._cancel,
        }

    # Events.

    @property
    def still(self) -> bool:
        """Whether it would look the same at the next frame, unless an event comes."""
        if self.playback is not None:
            return self.playback.still and self.stage.still and self.tuning is None
        read = self.standing_message is None or self.message == self.standing_message
        return read and not self._guarded and self.stage.still and self.tuning is None

    @property
    def opens_pages(self) -> bool:
        return True

    def enter(self, by_key: bool) -> None:
        """A key that leads back to the table does not also strike, pressed twice."""
        if by_key:
            self.hands.armed = False
        self.entered(self)

    def leave(self) -> None:
        for form in (self.call_strip.form, *([self.tuning.form] if self.tuning is not None else [])):
            form.let_go()
        self._fast_forward(False)
        self.stage.camera.let_go()
        self.timeline.let_go()
        self.editing.let_go()
        self._put_down()

    def handle(self, event: pygame.event.Event) -> Scene | None:
        if self.tuning is not None and not self.hands.busy and self.tuning.handle(event):
            scene, self._next = self._next or self, None
            return scene
        if self.playback is None and event.type in _BY_HAND:
            self.hands.armed = True
        if event.type == pygame.MOUSEMOTION:
            self.hands.pointer = event.pos
        if self.playback is None and not self.hands.busy and self._referred(event):
            return self
        if self.stage.camera.handle(event, pygame.key.get_mods()):
            return self
        if self.playback is not None and self.playback.review and self.timeline.handle(event, self.playback):
            return self
        if self.editing.handle(event):
            return self
        if event.type == pygame.KEYDOWN:
            return self._key(event.key, getattr(event, "mod", 0))
        if event.type == pygame.KEYUP and action_of(event.key, 0) == "fast":
            self._fast_forward(False)
        elif event.type == pygame.MOUSEMOTION:
            self._move(event.pos)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            self._press(event.pos)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 3:
            self._put_down()
        elif event.type == pygame.MOUSEBUTTONUP and event.button == 1:
            self._release(event.pos)
        elif event.type == pygame.MOUSEWHEEL:
            self.hands.turn(event.y * fine_step(pygame.key.get_mods()))
        elif event.type == pygame.WINDOWFOCUSLOST:
            self.leave()
        return self

    def _key(self, key: int, mod: int) -> Scene | None:
        action = action_of(key, mod) or ""
        if action == "quit":
            return None
        if self.playback is None and (action in _ARROWS or action in self.hands.keys):
            self.hands.armed = True
        if self._holding and action in _ARROWS:
            # Steps of 1 cm; with Shift 2 mm, with Ctrl 20 cm.
            dx, dy = _ARROWS[action]
            self.in_hand.nudge(self.session, 0.2 * fine_step(mod) * dx, 0.2 * fine_step(mod) * dy)
            self.hands.hold = self.hands.pointer
        elif action in ("turn_left", "turn_right"):
            self.hands.turn(fine_step(mod) if action == "turn_left" else -fine_step(mod))
        elif action in self._keys:
            self._keys[action]()
        scene, self._next = self._next or self, None
        return scene

    def _move(self, pos: tuple[int, int]) -> None:
        if self.hands.move(pos, self.stage.screen):
            return
        if self._holding:
            if not self.hands.holds(pos):
                self.in_hand.at = self.stage.view.to_table(*pos)
        elif not self.session.in_hand:
            cue = self.session.cue
            self.hands.point(pos, self.stage.view, cue, self.session.table.body_of(cue)[0])

    def _press(self, pos: tuple[int, int]) -> None:
        screen = self.stage.screen
        if self.hands.grab(pos, screen):
            return
        self._move(pos)
        if self.playback is None and self.session.ask.kind == OVER:
            self._next = self.ended()
        elif self._holding:
            self._place()
            # A drag carries it on from here, whether it could be put down or not.
            self.editing.carry(pos)
        elif self.playback is None and self.session.ask.kind == AIM and screen.top.bottom <= pos[1] < screen.bottom.top:
            self.hands.begin_pull(pos)

    def _release(self, pos: tuple[int, int]) -> None:
        self._move(pos)
        clicked = self.hands.pull is not None and self.hands.clicked
        speed = self.hands.let_go()
        if speed > 0.0:
            self._strike(speed, drawn=True)
        elif clicked:
            # What is a pull with a drag means the ball or the pocket without.
            self.call_strip.calls.point_out(*self.stage.view.to_table(*pos), self.session)
            self.hands.hold = pos

    # What hands and keys lead to.

    @property
    def _holding(self) -> bool:
        """Whether the player holds a ball."""
        return self.in_hand.held(self.session) is not None and self.playback is None

    def _referred(self, event: pygame.event.Event) -> bool:
        """Hand an event to the referee; whether it was meant for it, and what came of it is told."""
        if self._guarded and event.type == pygame.KEYDOWN:
            return False
        moment = self.session.match.now
        try:
            taken = self.call_strip.handle(event, self.session)
        except InputError as error:
            self.tell(str(error))
            return True
        if self.session.match.now is not moment:
            self.hands.armed = False
            self.drop()
            self.tell_standing_message()
            self._next = self.ended()
        return taken

    def _next_guide(self) -> None:
        self.level = (self.level + 1) % len(GUIDES)
        self.message = lambda: say("play.guide", level=say(f"choice.{GUIDES[self.level]}"))

    def _put_down(self) -> None:
        if self.hands.pull is not None:
            self.message = lambda: say("play.put_down")
        self.hands.put_down()

    def _cancel(self) -> None:
        if self.editing.cancel():
            return
        if self.tuning is None and self.playback is None and not self.hands.busy:
            self._next = self.paused()
        if not self.hands.busy:
            self.tuning = None
        self._put_down()

    def _enter(self) -> None:
        """Skip a shot, or else go on: never both by the same press, nor by one that came a moment too late."""
        if self.playback is not None:
            self.playback.leave()
        elif self._guarded:
            self._rested = 0.0
        else:
            self._go_on()

    def _go_on(self) -> None:
        """Do what a key of the stroke does while the balls rest."""
        if self._holding:
            self.hands.armed = False
            self._place()
        elif self.hands.armed or self.session.ask.kind != AIM:
            self._strike(self.hands.aim.speed)
        else:
            self.hands.armed = True
            self.message = lambda: say("play.armed", key=KEYS.shown("strike"))

    @property
    def _guarded(self) -> bool:
        """Whether the balls have come to rest just now, so that a key may still be meant for the shot."""
        return self._rested <= GUARD

    def _show_geometry(self) -> None:
        self.geometry = not self.geometry

    def _show_vectors(self) -> None:
        self.vectors = not self.vectors

    def _place(self) -> None:
        if not self.editing.place():
            told = self.in_hand.refused(self.session)
            self.message = lambda: told

    def update(self, dt: float) -> Scene | None:
        self.pass_time(dt)
        self.editing.give()
        scene, self._next = self._next or self, None
        return scene

    def draw_marks(self, surface: pygame.Surface) -> bool:
        """Draw what is marked on the cloth, under the balls: nothing in practice. Whether there was anything."""
        return False

    def lay_out(self, size: tuple[int, int]) -> None:
        screen = Screen(*size)
        panel = self.tuning.place(screen) if self.tuning is not None else 0
        self.stage.lay_out(screen, self.session.table, panel)
        self.timeline.place(screen, panel)
        if self.playback is None:
            self.call_strip.place(screen, self.session)

    def draw(self, frame: Frame) -> None:
        play_view.draw(frame, self)

    def _tune(self) -> None:
        if not self.practising():
            return
        if self.tuning is None:
            aimed = self.hands.aim.shot(self.session.cue.id)
            self.tuning = Tuning(self.session, aimed, self._ask_name, self.open_table)
        else:
            self.tuning = None

    def _ask_name(self) -> None:
        def saved(path: Path) -> None:
            self.message = lambda: say("play.saved", path=path)

        self._next = ask_to_save(self, self.session.table, saved)

    def drop(self) -> None:
        super().drop()
        self.editing.let_go()

    def _come_to_rest(self, shown: Playback) -> None:
        super()._come_to_rest(shown)
        self.hands.armed = False
        if shown.review:
            # The pointer has been elsewhere: the aim stays until it is moved again.
            self.hands.hold = self.hands.pointer
        else:
            self.hands.hold = None
            if self.hands.pointer is not None:
                self._move(self.hands.pointer)
