"""A recorded match on the screen: shot after shot, each with its time line."""

from __future__ import annotations

from collections.abc import Callable

import pygame

from ...config.settings import Store
from ...draw import cue_motion
from ...draw.effects import effects_of, style_of
from ...game.actions import Stroke
from ...game.records.recorded_shots import RecordedShots
from ...sound.mixer import Sounds
from ...table.table import Table
from ..dialogs.help import Help
from ..dialogs.options import OptionsPage
from ..dialogs.pick import Pick
from ..frame import Frame
from ..scene import Scene
from ..screen import Screen
from ..stage.playback import Playback
from ..stage.stage import Stage
from ..stage.timeline import Timeline
from ..wording.keys import action_of
from ..wording.words import say
from . import replay_view

# What keys do besides those of the time line, and where one of them goes from the present shot.
KEYS = {
    pygame.K_PAGEUP: "earlier", pygame.K_UP: "earlier",
    pygame.K_PAGEDOWN: "later", pygame.K_DOWN: "later", pygame.K_n: "later",
    pygame.K_g: "list",
}  # fmt: skip
# How long a shot's last moment is shown before the next begins, s.
PAUSE = 2.0


class Replay(Scene):
    """The strokes of a record, one after the other; Esc goes to the scene below, or closes the window without one.

    `at` is the stroke shown, counted from 0. One that runs to its end leads on to the next; one that a hand
    holds or brings to its end stays. `store` says how it looks, `sounds` makes it heard.
    """

    def __init__(
        self, shots: RecordedShots, below: Scene | None = None, store: Store | None = None, sounds: Sounds | None = None
    ) -> None:
        self.shots = shots
        self.below = below
        self.store = store or Store()
        self.sounds = sounds or Sounds()
        self.stage = Stage(shots[0].match.table)
        self.stage.cue_counts = shots[0].match.rules.cue_counts
        self.timeline = Timeline()
        self.vectors = self.geometry = False
        self.at = 0
        self._laid = 0
        self._rested = 0.0
        self._next: Scene | None = None
        self._keys: dict[str, Callable[[], None]] = {
            **self.stage.camera.keys,
            "vectors": self._show_vectors,
            "geometry": self._show_geometry,
            "fast": lambda: self._fast_forward(True),
            "help": lambda: self._open(Help(self)),
            "options": lambda: self._open(OptionsPage(self, self.store)),
        }
        self._do: dict[str, Callable[[], None]] = {
            "earlier": lambda: self.go(self.at - 1),
            "later": lambda: self.go(self.at + 1),
            "list": self._list,
        }
        self.playback = self._shown()

    @property
    def still(self) -> bool:
        """Whether it would look the same at the next frame, unless an event comes."""
        waits = self.playback.ended and not self.playback.paused and self.at + 1 < len(self.shots)
        return self.playback.still and self.stage.still and self.shots.complete and not waits

    @property
    def table(self) -> Table:
        return self.shots[self.at].match.table

    def go(self, at: int, paused: bool = False) -> None:
        """Show a stroke, from its beginning; the nearest there is."""
        self.at = min(max(at, 0), len(self.shots) - 1)
        # It may be that the record cannot be played so far.
        self.at = min(self.at, self.shots[self.at].number - 1)
        rate = self.playback.rate
        self.playback = self._shown()
        self.playback.rate = rate
        self.playback.paused = paused
        self._rested = 0.0
        if not paused and self.playback.time == 0.0:
            self.sounds.play_events(self.stage.table, self.playback.rollout, -1.0, 0.0)

    def _shown(self) -> Playback:
        take = self.shots[self.at]
        self._lay()
        action = take.moment.action
        lead = cue_motion.lead(False, effects_of(self.store.values))
        shown = Playback(take.rollout, action.shot if isinstance(action, Stroke) else None, lead, again=True)
        shown.kept = True
        return shown

    def _lay(self) -> None:
        """Let the balls of every stroke that is worked out lie as those before it left them."""
        takes = self.shots.played
        for at in range(self._laid, len(takes)):
            last = takes[at - 1].moment if at else None
            self.stage.tracker.follow(takes[at].before, takes[at].rollout, last)
        self._laid = len(takes)

    # Events.

    def leave(self) -> None:
        self._fast_forward(False)
        self.stage.camera.let_go()
        self.timeline.let_go()

    def handle(self, event: pygame.event.Event) -> Scene | None:
        if event.type == pygame.WINDOWFOCUSLOST:
            self.leave()
        elif event.type == pygame.KEYUP and action_of(event.key, 0) == "fast":
            self._fast_forward(False)
        elif event.type == pygame.KEYDOWN and action_of(event.key, getattr(event, "mod", 0)) == "quit":
            return None
        elif not self.stage.camera.handle(event, pygame.key.get_mods()):
            self._hand(event)
        if self.playback.over:
            return self.below
        scene, self._next = self._next or self, None
        return scene

    def _hand(self, event: pygame.event.Event) -> None:
        """What is meant for a button of the upper bar, a shot's time line or a key."""
        if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            pressed = replay_view.under(event.pos, self.stage.screen)
            if pressed:
                self._do[pressed]()
                return
        if self.timeline.handle(event, self.playback):
            # What a hand has brought to its end stays there.
            self.playback.paused |= self.playback.kept and self.playback.ended
        elif event.type == pygame.KEYDOWN:
            action = action_of(event.key, getattr(event, "mod", 0)) or ""
            self._do.get(KEYS.get(event.key, ""), self._keys.get(action, _nothing))()

    def _open(self, scene: Scene) -> None:
        self.playback.paused = True
        self._next = scene

    def _list(self) -> None:
        """Offer every shot, to go to one."""

        def take(at: int) -> Scene:
            self.go(at)
            return self

        # Asked for the last, they play them all.
        self.shots[len(self.shots) - 1]
        self._lay()
        lines = [replay_view.line(self.shots, shot) for shot in self.shots.played]
        self._open(Pick(self, say("replay.shots"), lines, self.at, say("replay.show"), take))

    def _fast_forward(self, fast: bool) -> None:
        self.playback.fast = fast

    def _show_vectors(self) -> None:
        self.vectors = not self.vectors

    def _show_geometry(self) -> None:
        self.geometry = not self.geometry

    # Time.

    def update(self, dt: float) -> Scene | None:
        if not self.shots.complete:
            self.shots.play_next()
            self._lay()
        self.stage.camera.update(dt, effects_of(self.store.values).eased)
        shown = self.playback
        before = shown.time
        shown.update(dt)
        self.sounds.play_events(self.stage.table, shown.rollout, before, shown.time)
        if shown.ended and not shown.paused:
            self._rested += dt
            if self._rested >= PAUSE and self.at + 1 < len(self.shots):
                fast = shown.fast
                self.go(self.at + 1)
                self.playback.fast = fast
        return self

    def lay_out(self, size: tuple[int, int]) -> None:
        screen = Screen(*size)
        self.stage.lay_out(screen, self.table)
        self.timeline.place(screen, 0)

    def draw(self, frame: Frame) -> None:
        self.stage.style = style_of(self.store.values)
        replay_view.draw(frame, self)


def _nothing() -> None:
    """What a key does that means nothing here."""
