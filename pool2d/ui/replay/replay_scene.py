"""A recorded match on the screen: shot after shot, each with its time line."""

from __future__ import annotations

from collections.abc import Callable

import pygame

from ...config.settings import Store
from ...draw.effects import style_of
from ...game.records.recorded_shots import RecordedShots
from ...sound.mixer import Sounds
from ...table.table import Table
from ..dialogs.help import Help
from ..dialogs.options import OptionsPage
from ..dialogs.pick import Pick
from ..frame import Frame
from ..scene import Scene
from ..screen import Screen
from ..stage.stage import Stage
from ..stage.timeline import Timeline
from ..wording.words import Words
from . import replay_view
from .replay_state import ReplayState

# What keys do besides those of the time line, and where one of them goes from the present shot.
REPLAY_KEYS = {
    pygame.K_PAGEUP: "earlier", pygame.K_UP: "earlier",
    pygame.K_PAGEDOWN: "later", pygame.K_DOWN: "later", pygame.K_n: "later",
    pygame.K_g: "list",
}  # fmt: skip


class Replay(Scene):
    """A recorded match on the window; Esc goes to the scene below, or closes the window without one.

    `state` is what is shown of the match, `stage` and `timeline` are how. `store` says how it looks, `sounds` makes it
    heard.
    """

    def __init__(
        self, shots: RecordedShots, words: Words, below: Scene | None = None, store: Store | None = None,
        sounds: Sounds | None = None,
    ) -> None:  # fmt: skip
        self.words = words
        store = store or Store()
        self.state = state = ReplayState(shots, store, sounds or Sounds())
        self.below = below
        self.stage = Stage(state.table)
        self.timeline = Timeline(words)
        self._next: Scene | None = None
        self._keys: dict[str, Callable[[], None]] = {
            **self.stage.camera.keys,
            **state.show.keys,
            "why": state.turn_why,
            "fast": lambda: self._fast_forward(True),
            "help": lambda: self._open(Help(self)),
            "options": lambda: self._open(OptionsPage(self, store)),
        }
        self._do: dict[str, Callable[[], None]] = {
            "earlier": lambda: state.go(state.at - 1),
            "later": lambda: state.go(state.at + 1),
            "list": self._list,
            "why": state.turn_why,
        }

    @property
    def still(self) -> bool:
        """Whether it would look the same at the next frame, unless an event comes."""
        return self.state.still and self.stage.still

    @property
    def table(self) -> Table:
        return self.state.table

    # Events.

    def leave(self) -> None:
        self._fast_forward(False)
        self.stage.camera.let_go()
        self.timeline.let_go()

    def handle(self, event: pygame.event.Event) -> Scene | None:
        if event.type == pygame.WINDOWFOCUSLOST:
            self.leave()
        elif event.type == pygame.KEYUP and self.words.keys.action_of(event.key, 0) == "fast":
            self._fast_forward(False)
        elif event.type == pygame.KEYDOWN and self.words.keys.action_of(event.key, getattr(event, "mod", 0)) == "quit":
            return None
        elif not self.stage.camera.handle(event, pygame.key.get_mods()):
            self._hand(event)
        if self.state.playback.over:
            return self.below
        scene, self._next = self._next or self, None
        return scene

    def _hand(self, event: pygame.event.Event) -> None:
        """What is meant for a button of the upper bar, the panel, a shot's time line or a key."""
        if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            pressed = replay_view.under(event.pos, self.stage.screen, self.state)
            if pressed:
                self._do[pressed]()
                return
        if self.state.why and event.type == pygame.KEYDOWN and event.key == pygame.K_ESCAPE:
            self.state.turn_why()
        elif self.timeline.handle(event, self.state.playback):
            # What a hand has brought to its end stays there.
            self.state.playback.paused |= self.state.playback.kept and self.state.playback.ended
        elif event.type == pygame.KEYDOWN:
            action = self.words.keys.action_of(event.key, getattr(event, "mod", 0)) or ""
            self._do.get(REPLAY_KEYS.get(event.key, ""), self._keys.get(action, _nothing))()

    def _open(self, scene: Scene) -> None:
        self.state.playback.paused = True
        self._next = scene

    def _list(self) -> None:
        """Offer every shot, to go to one."""
        say = self.words.say

        def take(at: int) -> Scene:
            self.state.go(at)
            return self

        self.state.play_all()
        shots = self.state.shots
        lines = [replay_view.line(self.words, shots, shot) for shot in shots.played]
        self._open(Pick(self, say("replay.shots"), lines, self.state.at, say("replay.show"), take))

    def _fast_forward(self, fast: bool) -> None:
        self.state.playback.fast = fast

    # Time.

    def update(self, dt: float) -> Scene | None:
        self.stage.camera.update(dt, self.state.effects.eased)
        self.state.update(dt)
        return self

    def lay_out(self, size: tuple[int, int]) -> None:
        screen = Screen(*size)
        self.stage.lay_out(screen, self.table)
        self.timeline.place(screen, 0)

    def draw(self, frame: Frame) -> None:
        self.stage.style = style_of(self.state.store.values)
        replay_view.draw(frame, self.words, self.state, self.stage, self.timeline)


def _nothing() -> None:
    """What a key does that means nothing here."""
