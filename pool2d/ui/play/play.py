"""The scene that is played on: a state, the controller that changes it, and the view that shows it."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import pygame

from ...config.settings import GUIDES, Settings
from ...draw.effects import effects_of, style_of
from ...errors import InputError
from ...game.drills.drill import Drill
from ...game.drills.drill_file import drills, load
from ...game.drills.drill_session import DrillSession
from ...game.session import Session
from ...sound.mixer import Sounds
from ...table.table import Table
from ..frame import Frame
from ..scene import Scene, Wish
from ..screen import Screen
from ..stage.stage import Stage
from ..wording.words import Words
from . import play_view
from .controller import Controller
from .modes.drill_mode import DrillMode
from .modes.mode_choice import mode_of
from .state import PlayState


class Game(NamedTuple):
    """A state with its controller and the stage that it is shown on."""

    state: PlayState
    controller: Controller
    stage: Stage


class Play(Scene):
    """A table for as long as the window is open: practice, a match, or a drill over the one of them.

    `paused` gives what opens where Esc finds nothing to put away, `ended` what opens once the frame is over.
    """

    def __init__(self, session: Session, words: Words, sounds: Sounds | None = None) -> None:
        self.words = words
        self.sounds = sounds or Sounds()
        self.paused: Callable[[], Scene | None] = lambda: None
        self.ended: Callable[[], Scene | None] = lambda: None
        self._game = self._set_out(session)
        # What is played on after a drill, and where the drill was chosen.
        self._below: tuple[Game, Scene] | None = None

    @property
    def state(self) -> PlayState:
        return self._game.state

    @property
    def controller(self) -> Controller:
        return self._game.controller

    @property
    def stage(self) -> Stage:
        return self._game.stage

    @property
    def still(self) -> bool:
        """Whether it would look the same at the next frame, unless an event comes."""
        state = self.state
        if not self.stage.still or self.controller.tuning is not None:
            return False
        if state.playback is not None:
            return state.playback.still
        return state.messages.settled and not state.hands.guarded and state.mode.still

    @property
    def opens_pages(self) -> bool:
        return True

    @property
    def takes_text(self) -> bool:
        panel = self.controller.tuning_panel
        return panel is not None and panel.takes_text

    @property
    def table(self) -> Table:
        return self.state.session.table

    def enter(self, by_key: bool) -> None:
        """A key that leads back to the table does not also strike, pressed twice."""
        if by_key:
            self.state.hands.armed = False

    def leave(self) -> None:
        self.controller.leave()

    def handle(self, event: pygame.event.Event) -> Scene | None:
        self.controller.handle(event)
        return self._wished()

    def update(self, dt: float) -> Scene | None:
        self.controller.update(dt)
        self.stage.camera.update(dt, self.state.show.effects.eased)
        return self._wished()

    def lay_out(self, size: tuple[int, int]) -> None:
        self.controller.lay_out(Screen(*size))

    def draw(self, frame: Frame) -> None:
        play_view.draw(frame, self.state, self.controller)

    def take_options(self, values: Settings) -> None:
        """Show the table as the options say."""
        show = self.state.show
        show.level = GUIDES.index(values.aiming.guide)
        show.effects, show.style = effects_of(values), style_of(values)
        self.state.easy_stroke = values.aiming.easy_stroke
        if self.controller.tuning_panel is not None:
            self.controller.tuning_panel.fill()

    def drill(self, drill: Drill, home: Scene) -> Scene:
        """Play a drill; Esc goes back to `home`, or where one is played already to where that was chosen."""
        below, home = self._below or (self._game, home)
        session = DrillSession(drill)
        game = self._set_out(session)
        game.state.hands.pointer = self.state.hands.pointer
        game.state.take_up(DrillMode(game.state, session, self._leave_drill, lambda: self._go_on_from(drill)))
        self._go_over(game, (below, home))
        return self

    def close(self) -> None:
        """Let go of what is played; a match goes on under a drill, which has no record."""
        (self._below[0] if self._below is not None else self._game).state.leave()

    def _set_out(self, session: Session) -> Game:
        stage, state = Stage(session.table), PlayState(session, self.words, self.sounds, mode_of)
        return Game(state, Controller(state, stage, self), stage)

    def _leave_drill(self) -> None:
        assert self._below is not None
        below, home = self._below
        self._go_over(below, None)
        if home is self:
            # The key that leads back does not also strike.
            self.state.hands.armed = False
        self.state.go_to(home)

    def _go_over(self, game: Game, below: tuple[Game, Scene] | None) -> None:
        """Have another game on the window, played under the same options, in its place before anything is drawn."""
        screen = self.stage.screen
        game.state.show.take_options(self.state.show)
        game.state.easy_stroke = self.state.easy_stroke
        self._game, self._below = game, below
        game.controller.lay_out(screen)

    def _go_on_from(self, drill: Drill) -> None:
        """Play the drill after this one."""
        names = drills()
        name = names[(names.index(drill.id) + 1) % len(names)] if drill.id in names else names[0]
        try:
            self.drill(load(name), self)
        except InputError as error:
            self.state.messages.say(str(error))
            return
        self.state.hands.armed = False

    def _wished(self) -> Scene | None:
        """The scene that comes next."""
        wish, self.state.wish = self.state.wish, None
        if wish is Wish.QUIT:
            return None
        if wish is Wish.PAUSED:
            return self.paused() or self
        if wish is Wish.ENDED:
            return self.ended() or self
        return wish or self
