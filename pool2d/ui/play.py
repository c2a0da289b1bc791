"""The table being played on: aiming, the stroke, the balls running, the cue ball in hand."""

from __future__ import annotations

import random
from collections.abc import Callable
from pathlib import Path

import pygame

from ..errors import BudgetError, InputError
from ..game.rules import AIM
from ..game.session import Session, practice
from ..physics.rollout import Rollout
from ..physics.values import Shot
from ..preset import load_table
from ..settings import GUIDES
from ..table import Table
from . import guide, play_art, stroke, telling
from .effects import Effects
from .hands import Hands
from .help import Help
from .in_hand import InHand
from .keys import KEYS, action_of, fine_step
from .playback import Playback
from .referee import Referee
from .saving import ask_to_save
from .scene import Scene
from .sound import Sounds
from .stage import Stage
from .timeline import Timeline
from .tuning import Tuning
from .words import say

_ARROWS = {"turn_left": (-1.0, 0.0), "turn_right": (1.0, 0.0), "harder": (0.0, 1.0), "softer": (0.0, -1.0)}


class Play:
    """A session on screen.

    While `playback` is set, its shot is shown. `effects` is what the options allow to move for show; `warning`
    stays until what it warns of is mended. `told` says what is told until the next; it is asked anew for every
    picture, as the language may change.
    """

    def __init__(self, session: Session, sounds: Sounds | None = None) -> None:
        self.session = session
        self.sounds = sounds or Sounds()
        self.stage = Stage(session.table)
        self.hands = Hands()
        self.level = guide.GHOST
        self.playback: Playback | None = None
        self.timeline = Timeline()
        self.in_hand = InHand()
        self.referee = Referee()
        self.tuning: Tuning | None = None
        self.effects = Effects()
        self.geometry = False
        self.vectors = False
        self.told: Callable[[], str] = lambda: say("play.welcome", help=KEYS.shown("help"))
        self.warning = ""
        self._next: Scene | None = None
        self._keys: dict[str, Callable[[], None]] = {
            **self.hands.keys,
            **self.stage.camera.keys,
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

    @property
    def rollout(self) -> Rollout | None:
        """The shot that is shown, if one is."""
        return None if self.playback is None else self.playback.rollout

    @property
    def message(self) -> str:
        """What is told at present; empty where nothing is."""
        return self.told()

    @property
    def time(self) -> float:
        """The moment of that shot, s; below 0 the cue is still on its way."""
        return 0.0 if self.playback is None else self.playback.time

    @property
    def still(self) -> bool:
        """Whether it would look the same at the next frame, unless an event comes."""
        shown = self.playback is None or self.playback.still
        return shown and self.stage.still and self.tuning is None

    # Events.

    def handle(self, event: pygame.event.Event) -> Scene | None:
        if self.tuning is not None and not self.hands.busy and self.tuning.handle(event):
            scene, self._next = self._next or self, None
            return scene
        if event.type == pygame.MOUSEMOTION:
            self.hands.pointer = event.pos
        if self.playback is None and not self.hands.busy and self._referred(event):
            return self
        if self.stage.camera.handle(event, pygame.key.get_mods()):
            return self
        if self.playback is not None and self.playback.review and self.timeline.handle(event, self.playback):
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
            self._fast_forward(False)
            self.stage.camera.let_go()
            self.timeline.let_go()
            self._put_down()
        return self

    def _key(self, key: int, mod: int) -> Scene | None:
        action = action_of(key, mod) or ""
        if action == "quit":
            return None
        if action == "help":
            return Help(self)
        if self._holding and action in _ARROWS:
            # Steps of 1 cm; with Shift 2 mm, with Ctrl 20 cm.
            dx, dy = _ARROWS[action]
            self.in_hand.nudge(self.session, 0.2 * fine_step(mod) * dx, 0.2 * fine_step(mod) * dy)
        elif action in ("turn_left", "turn_right"):
            self.hands.turn(fine_step(mod) if action == "turn_left" else -fine_step(mod))
        elif action in self._keys:
            self._keys[action]()
        return self

    def _move(self, pos: tuple[int, int]) -> None:
        if self.hands.move(pos, self.stage.screen):
            return
        if self._holding:
            self.in_hand.at = self.stage.view.to_table(*pos)
        elif not self.session.in_hand:
            cue = self.session.cue
            self.hands.point(pos, self.stage.view, cue, self.session.table.body_of(cue)[0])

    def _press(self, pos: tuple[int, int]) -> None:
        screen = self.stage.screen
        if self.hands.grab(pos, screen):
            return
        if self.playback is None and self.referee.point_out(*self.stage.view.to_table(*pos), self.session):
            return
        self._move(pos)
        if self._holding:
            self._place()
        elif self.playback is None and self.session.ask.kind == AIM and screen.top.bottom <= pos[1] < screen.bottom.top:
            self.hands.begin_pull(pos)

    def _release(self, pos: tuple[int, int]) -> None:
        self._move(pos)
        speed = self.hands.let_go()
        if speed > 0.0:
            self._strike(speed, drawn=True)

    # What hands and keys lead to.

    @property
    def _holding(self) -> bool:
        """Whether the player holds the cue ball."""
        return self.session.in_hand and self.playback is None

    def aimed(self, shot: Shot) -> str:
        """The ball that a shot would meet first; empty where it meets none."""
        rollout = self.stage.foresee(self.level, self.session.layout, shot)
        pairs = [pair for event in rollout.events for pair in event.pairs if shot.ball in pair] if rollout else []
        return next((ball for ball in pairs[0] if ball != shot.ball), "") if pairs else ""

    def begin(self, session: Session) -> None:
        """Go over to another session, and leave the one that was played."""
        self._drop()
        self.tuning = None
        self.session.leave()
        self.session = session
        self.told = lambda: self.referee.verdict(session)

    def _referred(self, event: pygame.event.Event) -> bool:
        """Hand an event to the referee; whether it was meant for it, and what came of it is told."""
        moment = self.session.match.now
        try:
            taken = self.referee.handle(event, self.session)
        except InputError as error:
            wrong = str(error)
            self.told = lambda: wrong
            return True
        if self.session.match.now is not moment:
            self._drop()
            self.told = lambda: self.referee.verdict(self.session)
        return taken

    def _next_guide(self) -> None:
        self.level = (self.level + 1) % len(GUIDES)
        self.told = lambda: say("play.guide", level=say(f"choice.{GUIDES[self.level]}"))

    def _fast_forward(self, fast: bool) -> None:
        if self.playback is not None:
            self.playback.fast = fast

    def _put_down(self) -> None:
        if self.hands.pull is not None:
            self.told = lambda: say("play.put_down")
        self.hands.put_down()

    def _cancel(self) -> None:
        if not self.hands.busy:
            self.tuning = None
        self._put_down()

    def _enter(self) -> None:
        if self.playback is not None:
            self.playback.leave()
        elif self._holding:
            self._place()
        else:
            self._strike(self.hands.aim.speed)

    def _strike(self, speed: float, drawn: bool = False) -> None:
        """Play the shot that is aimed; `drawn` where a hand has drawn the cue back already."""
        self.hands.put_down()
        shot = self.hands.aim.shot(self.session.cue.id, speed)
        try:
            rollout = self.session.play(shot, self.referee.said(self.session, self.aimed(shot)))
        except (InputError, BudgetError) as error:
            wrong = str(error)
            self.told = lambda: wrong
            return
        self._show(Playback(rollout, shot, stroke.lead(drawn, self.effects)))
        self.told = lambda: say("play.miscue") if telling.missed(rollout) else ""

    def _replay(self) -> None:
        last = self.session.rollout
        if last is None:
            self.told = lambda: say("play.no_shot")
        elif self.playback is None:
            self.hands.put_down()
            self._show(Playback(last, self.session.shot, stroke.lead(False, self.effects), again=True))
            self.timeline.begin(self.hands.pointer)
            self.told = lambda: ""

    def _pause(self) -> None:
        """Hold the shot that runs, or the last one at its beginning."""
        if self.playback is None:
            self._replay()
        if self.playback is not None:
            self.timeline.begin(self.hands.pointer)
            self.playback.pause()

    def _show(self, playback: Playback) -> None:
        """Run a shot from its beginning; without a stroke before it, the tip is heard at once."""
        self.playback = playback
        if playback.time == 0.0:
            self.sounds.play_events(self.session.table, playback.rollout, -1.0, 0.0)

    def _tune(self) -> None:
        if not self.session.free:
            self.told = lambda: say("play.practice_only")
        elif self.tuning is None:
            aimed = self.hands.aim.shot(self.session.cue.id)
            self.tuning = Tuning(self.session, aimed, self._ask_name, self.open_table)
        else:
            self.tuning = None

    def open_table(self, name: str) -> None:
        """Go over to another preset, with a new rack; raises InputError."""
        self.begin(practice(load_table(name), random.randrange(1 << 30)))
        title = self.session.table.title
        self.told = lambda: say("play.new_table", table=title)

    def _ask_name(self) -> None:
        def saved(path: Path) -> None:
            self.told = lambda: say("play.saved", path=path)

        self._next = ask_to_save(self, self.session.table, saved)

    def _show_geometry(self) -> None:
        self.geometry = not self.geometry

    def _show_vectors(self) -> None:
        self.vectors = not self.vectors

    def _undo(self) -> None:
        self._drop()
        undone = self.session.undo()
        self.told = lambda: say("play.undone") if undone else say("play.nothing_to_undo")

    def _redo(self) -> None:
        self._drop()
        redone = self.session.redo()
        self.told = lambda: say("play.redone") if redone else say("play.nothing_to_redo")

    def _rack(self) -> None:
        if not self.session.free:
            self.told = lambda: say("play.practice_only")
            return
        self._drop()
        self.session.rack(random.randrange(1 << 30))
        self.told = lambda: say("play.new_rack")

    def _drop(self) -> None:
        """Let go of whatever is under way."""
        self.playback = None
        self.hands.put_down()
        self.in_hand.at = None

    def _place(self) -> None:
        if self.in_hand.place(self.session):
            self.hands.hold = self.hands.pointer
            self.told = lambda: ""
        else:
            self.told = lambda: say("play.no_room")

    def change_table(self, table: Table) -> None:
        """Play on with other parameters; raises InputError where the balls do not fit."""
        self.session.change_table(table)
        self.playback = None
        if self.tuning is not None:
            self.tuning.refresh()
        self.told = lambda: say("play.file_changed")

    # Time.

    def update(self, dt: float) -> Scene | None:
        self.referee.follow(self.session)
        self.referee.form.update(dt)
        if self.tuning is not None:
            self.tuning.follow(self.hands.aim.shot(self.session.cue.id))
            self.tuning.update(dt)
        self.stage.camera.update(dt, self.effects.eased)
        if self.playback is not None:
            before = self.playback.time
            self.playback.update(dt)
            self.sounds.play_events(self.session.table, self.playback.rollout, before, self.playback.time)
            if self.playback.over:
                self._come_to_rest(self.playback)
        return self

    def _come_to_rest(self, shown: Playback) -> None:
        self.playback = None
        if telling.missed(shown.rollout) and not shown.again:
            self.sounds.chalk()
        if shown.review:
            # The pointer has been elsewhere: the aim stays until it is moved again.
            self.hands.hold = self.hands.pointer
        else:
            self.hands.hold = None
            if self.hands.pointer is not None:
                self._move(self.hands.pointer)
        if shown.again:
            self.told = lambda: ""
        elif not self.session.free:
            self.told = lambda: self.referee.verdict(self.session)
        elif self.session.in_hand or not telling.missed(shown.rollout):
            cue = self.session.cue.id
            self.told = lambda: telling.outcome(shown.rollout, cue)

    def draw(self, surface: pygame.Surface) -> None:
        play_art.draw(surface, self)
