"""What events mean to the table that is played on: each is offered to one taker after the other."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pygame

from ...config.settings import GUIDES
from ...errors import InputError
from ...game.rules import AIM
from ..dialogs.save_table import ask_to_save
from ..scene import Scene, Wish
from ..screen import Screen
from ..stage.stage import Stage
from ..stage.timeline import Timeline
from ..wording.clearance_text import TOLD
from ..wording.keys import fine_step
from .by_hand_page import ByHandPage
from .call_strip import CallStrip
from .editing import Editing
from .mouse import Mouse
from .positions import Positions
from .state import PlayState
from .tuning import Tuning
from .tuning_panel import TuningPanel

_BY_HAND = (pygame.MOUSEBUTTONDOWN, pygame.MOUSEMOTION, pygame.MOUSEWHEEL)
_MOUSE = (*_BY_HAND, pygame.MOUSEBUTTONUP)
_ARROWS = {"turn_left": (-1.0, 0.0), "turn_right": (1.0, 0.0), "harder": (0.0, 1.0), "softer": (0.0, -1.0)}


class Controller:
    """Changes a state as hands ask for it; `scene` is what pages open over, `stage` where the table is on the window.

    `call_strip`, `timeline` and `tuning_panel` are what hands can take hold of beside the table.
    """

    def __init__(self, state: PlayState, stage: Stage, scene: Scene) -> None:
        self.state = state
        self.stage = stage
        self.scene = scene
        self.timeline = Timeline(state.words)
        self.call_strip = CallStrip(state.calls, state.words)
        self.editing = Editing(state, stage)
        self.mouse = Mouse(state, stage, self.editing)
        self.positions = Positions(state, scene)
        self._panel: TuningPanel | None = None
        self._by_hand = ByHandPage(state.words)
        # Who is asked, in this order, what an event means; the first who takes it is the last.
        self._takers: tuple[Callable[[pygame.event.Event], bool], ...] = (
            self._to_panel,
            self._notice,
            self._strip,
            lambda event: stage.camera.handle(event, pygame.key.get_mods()),
            self._review,
            self._look_on,
            self.editing.handle,
            self._key,
            self.mouse.handle,
            self._focus_lost,
        )
        self._keys: dict[str, Callable[[], None]] = {
            **state.hands.keys,
            **state.show.keys,
            **stage.camera.keys,
            **self.editing.keys,
            **self.positions.keys,
            "raise": self._raise,
            "strike": self._enter,
            "jump_cue": self._change_cue,
            "guide": self._next_guide,
            "fast": lambda: self._fast_forward(True),
            "replay": self._replay,
            "pause": lambda: self._replay(hold=True),
            "why": self._tell_why,
            "undo": state.undo,
            "redo": state.redo,
            "rack": state.rack,
            "tune": self._tune,
            "cancel": self._cancel,
            "quit": lambda: state.go_to(Wish.QUIT),
        }

    @property
    def tuning_panel(self) -> TuningPanel | None:
        """The tuning panel, while it is open over the session that is played."""
        panel = self._panel
        return panel if panel is not None and panel.tuning.session is self.state.session else None

    @property
    def tuning(self) -> Tuning | None:
        """How the table is tuned, while the panel is open."""
        return None if self.tuning_panel is None else self.tuning_panel.tuning

    def handle(self, event: pygame.event.Event) -> None:
        """Do what an event means."""
        any(taker(event) for taker in self._takers)

    def update(self, dt: float) -> None:
        """Let `dt` seconds pass for what hands take hold of, and for the state."""
        state = self.state
        self.call_strip.offers = state.mode.persons_turn
        self.call_strip.follow(state.session)
        self.call_strip.form.update(dt)
        if self.tuning_panel is not None:
            self.tuning_panel.tuning.follow(state.aimed())
            self.tuning_panel.update(dt)
        rested = state.update(dt)
        if rested is not None and not rested.review and state.playback is None and state.mode.persons_turn:
            self.mouse.follow()
        state.hand_over_cue_ball()

    def lay_out(self, screen: Screen) -> None:
        """Put the table and all that hands take hold of in their places in a window."""
        session = self.state.session
        panel = self.tuning_panel.place(screen) if self.tuning_panel is not None else 0
        self.stage.lay_out(screen, session.table, panel)
        self.timeline.place(screen, panel)
        if self.state.playback is None:
            self.call_strip.place(screen, session)

    def leave(self) -> None:
        """The hands leave the table: nothing is held any more."""
        for form in (self.call_strip.form, *([self.tuning_panel.form] if self.tuning_panel is not None else [])):
            form.let_go()
        self._fast_forward(False)
        self.stage.camera.let_go()
        self.timeline.let_go()
        if self.state.mode.persons_turn:
            self.state.in_hand.put_back()
        self.mouse.put_down()

    # The takers.

    def _to_panel(self, event: pygame.event.Event) -> bool:
        """The tuning panel, unless a hand is at the cue."""
        panel = self.tuning_panel
        return panel is not None and not self.state.hands.busy and panel.handle(event)

    def _notice(self, event: pygame.event.Event) -> bool:
        """Only look where the hands are."""
        hands = self.state.hands
        if self.state.playback is None and event.type in _BY_HAND:
            hands.armed = True
        if event.type == pygame.MOUSEMOTION:
            hands.pointer = event.pos
        return False

    def _strip(self, event: pygame.event.Event) -> bool:
        """The strip of calls and choices; what came of it is said."""
        state = self.state
        if state.playback is not None or state.hands.busy:
            return False
        if state.hands.guarded and event.type == pygame.KEYDOWN:
            return False
        moment = state.session.match.now
        try:
            taken = self.call_strip.handle(event, state.session)
        except InputError as error:
            state.messages.say(str(error))
            return True
        if state.session.match.now is not moment:
            state.hands.armed = False
            state.drop()
            state.messages.clear()
            state.go_to(Wish.ENDED)
        return taken

    def _review(self, event: pygame.event.Event) -> bool:
        """The time line of a shot that is seen again."""
        shown = self.state.playback
        return shown is not None and shown.review and self.timeline.handle(event, shown)

    def _look_on(self, event: pygame.event.Event) -> bool:
        """What hands would do to the table while the turn is no person's, which is nothing."""
        if self.state.mode.persons_turn or self.state.playback is not None:
            return False
        if event.type != pygame.KEYDOWN:
            return event.type in _MOUSE
        action = self.state.words.keys.action_of(event.key, getattr(event, "mod", 0))
        return action in (*self.state.hands.keys, *self.editing.keys, "turn_left", "turn_right", "jump_cue")

    def _key(self, event: pygame.event.Event) -> bool:
        """The keys, by the names of their actions."""
        if event.type == pygame.KEYUP and self.state.words.keys.action_of(event.key, 0) == "fast":
            self._fast_forward(False)
        if event.type != pygame.KEYDOWN:
            return event.type == pygame.KEYUP
        state, mod = self.state, getattr(event, "mod", 0)
        action = self.state.words.keys.action_of(event.key, mod) or ""
        if state.playback is None and (action in _ARROWS or action in state.hands.keys):
            state.hands.armed = True
        if state.held is not None and action in _ARROWS:
            # Steps of 1 cm; with Shift 2 mm, with Ctrl 20 cm.
            dx, dy = _ARROWS[action]
            state.in_hand.nudge(state.session, 0.2 * fine_step(mod) * dx, 0.2 * fine_step(mod) * dy)
            state.hands.keep_aim()
        elif action in ("turn_left", "turn_right"):
            state.hands.turn(fine_step(mod) if action == "turn_left" else -fine_step(mod))
        else:
            (state.mode.keys.get(action) or self._keys.get(action, _nothing))()
        return True

    def _focus_lost(self, event: pygame.event.Event) -> bool:
        """Another window: the hands have left."""
        if event.type == pygame.WINDOWFOCUSLOST:
            self.leave()
        return True

    # What keys lead to.

    def _enter(self) -> None:
        """Skip a shot, or else go on: never both by the same press, nor by one that came a moment too late."""
        state = self.state
        if state.playback is not None:
            state.playback.leave()
        elif state.hands.guarded:
            state.hands.rested = 0.0
        else:
            self._go_on()

    def _go_on(self) -> None:
        """Do what a key of the stroke does while the balls rest."""
        state, hands = self.state, self.state.hands
        if state.mode.go_on():
            hands.armed = False
        elif state.held is not None:
            hands.armed = False
            self.mouse.place()
        elif hands.armed or state.session.ask.kind != AIM:
            state.strike(hands.aim.speed)
        else:
            hands.armed = True
            state.messages.show(lambda: self.state.words.say("play.armed", key=self.state.words.key("strike")))

    def _cancel(self) -> None:
        state, busy = self.state, self.state.hands.busy
        by_hand = state.mode.persons_turn
        if (by_hand and self.editing.cancel()) or (not busy and state.mode.cancel()):
            return
        if self.tuning is None and state.playback is None and not busy:
            state.go_to(Wish.PAUSED)
        if not busy:
            self._panel = None
        self.mouse.put_down()

    def _replay(self, hold: bool = False) -> None:
        """Show the last shot again; to `hold` is to do so at its beginning, or to stop the shot that runs."""
        state, before = self.state, self.state.playback
        if before is None or not hold:
            state.replay()
        if state.playback is not None and (hold or state.playback is not before):
            self.timeline.begin(state.hands.pointer)
            if hold:
                state.playback.pause()

    def _tell_why(self) -> None:
        """Show the last shot from its beginning, and why it was played; or tell that no more."""
        state, show = self.state, self.state.show
        if show.why is not None and show.why is state.playback:
            show.why = None
            return
        self._replay(hold=True)
        if state.playback is not None:
            state.playback.seek(0.0)
            show.why = state.playback

    def _fast_forward(self, fast: bool) -> None:
        if self.state.playback is not None:
            self.state.playback.fast = fast

    def _change_cue(self) -> None:
        """Take the jump cue, or put it away again."""
        state, words = self.state, self.state.words
        if state.playback is not None:
            return
        state.hands.aim = state.hands.aim.with_other_cue()
        if state.hands.aim.jump:
            state.messages.show(lambda: words.say("play.jump_cue", key=words.key("jump_cue")))
        else:
            state.messages.show(lambda: words.say("play.playing_cue"))

    def _raise(self) -> None:
        """Raise the butt, from where it has to be where that is told."""
        hands, needed = self.state.hands, self.state.clearance
        if needed.over and (needed.elevation or 0.0) >= TOLD:
            hands.aim = hands.aim.with_elevation(needed.elevation or 0.0)
        hands.raise_butt(1.0)

    def _next_guide(self) -> None:
        say = self.state.words.say
        show = self.state.show
        show.level = (show.level + 1) % len(GUIDES)
        self.state.messages.show(lambda: say("play.guide", level=say(f"choice.{GUIDES[show.level]}")))

    def _tune(self) -> None:
        state = self.state
        if not state.may_arrange():
            return
        if self.tuning is None:
            tuning = Tuning(state.session, state.aimed())
            self._panel = TuningPanel(tuning, state.words, self._by_hand, self._ask_name, state.open_table)
        else:
            self._panel = None

    def _ask_name(self) -> None:
        def saved(path: Path) -> None:
            self.state.messages.show(lambda: self.state.words.say("play.saved", path=path))

        self.state.go_to(ask_to_save(self.scene, self.state.session.table, saved))


def _nothing() -> None:
    """What a key does that means nothing here."""
