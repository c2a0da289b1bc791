"""The table being played on: aiming, the stroke, the balls running, the cue ball in hand."""

from __future__ import annotations

import math
import random
from collections.abc import Callable

import pygame

from ..errors import BudgetError, InputError
from ..game.falls import ending
from ..game.session import Session
from ..physics.rollout import Rollout
from ..physics.strike import hop
from ..physics.values import POCKETED
from ..preset import differences, load_table, save_preset
from ..table import Table
from . import cue_art, guide, hud, theme
from .debug import ScreenPen, draw_geometry
from .dialog import Ask
from .hands import Hands
from .help import Help
from .keys import action_of, fine_step
from .scene import Scene
from .sound import Sounds
from .stage import Stage
from .tuning import Tuning

_FAST = 8.0
# How far the cue stands back from the ball at rest and at full pull, m.
_REST, _FULL = 0.02, 0.32
# From this height on, m, the player is told that a real ball would leave the cloth.
_HOP = 0.005

_ARROWS = {"turn_left": (-1.0, 0.0), "turn_right": (1.0, 0.0), "harder": (0.0, 1.0), "softer": (0.0, -1.0)}


class Play:
    """A session on screen.

    While `rollout` is set, its balls are shown at `time`. `hover` is where a cue ball in hand is held;
    `warning` stays until what it warns of is mended, `message` until the next.
    """

    def __init__(self, session: Session, sounds: Sounds | None = None) -> None:
        self.session = session
        self.sounds = sounds or Sounds()
        self.stage = Stage(session.table)
        self.hands = Hands()
        self.level = guide.GHOST
        self.rollout: Rollout | None = None
        self.time = 0.0
        self.fast = False
        self.hover: tuple[float, float] | None = None
        self.tuning: Tuning | None = None
        self.geometry = False
        self.message = "Aim with the mouse, press, pull back and release. F1 lists every key."
        self.warning = ""
        self._next: Scene | None = None
        hands = self.hands
        self._keys: dict[str, Callable[[], None]] = {
            "harder": lambda: hands.change_speed(0.25),
            "softer": lambda: hands.change_speed(-0.25),
            "raise": lambda: hands.raise_butt(1.0),
            "lower": lambda: hands.raise_butt(-1.0),
            "spin_up": lambda: hands.nudge_tip(0.0, 0.05),
            "spin_down": lambda: hands.nudge_tip(0.0, -0.05),
            "spin_left": lambda: hands.nudge_tip(-0.05, 0.0),
            "spin_right": lambda: hands.nudge_tip(0.05, 0.0),
            "no_spin": hands.center,
            "strike": self._enter,
            "guide": self._next_guide,
            "fast": self._fast_forward,
            "replay": self._replay,
            "undo": self._undo,
            "rack": self._rack,
            "tune": self._tune,
            "geometry": self._show_geometry,
            "cancel": self._cancel,
        }

    # Events.

    def handle(self, event: pygame.event.Event) -> Scene | None:
        if self.tuning is not None and not self.hands.busy and self.tuning.handle(event):
            scene, self._next = self._next or self, None
            return scene
        if event.type == pygame.KEYDOWN:
            return self._key(event.key, getattr(event, "mod", 0))
        if event.type == pygame.KEYUP and action_of(event.key, 0) == "fast":
            self.fast = False
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
            self.fast = False
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
            self._nudge(*_ARROWS[action], 0.2 * fine_step(mod))
        elif action in ("turn_left", "turn_right"):
            self.hands.turn(fine_step(mod) if action == "turn_left" else -fine_step(mod))
        elif action in self._keys:
            self._keys[action]()
        return self

    def _move(self, pos: tuple[int, int]) -> None:
        self.hands.pointer = pos
        if self.hands.move(pos, self.stage.screen):
            return
        if self._holding:
            self.hover = self.stage.view.to_table(*pos)
        elif not self.session.in_hand:
            cue = self.session.cue
            self.hands.point(pos, self.stage.view, cue, self.session.table.body_of(cue)[0])

    def _press(self, pos: tuple[int, int]) -> None:
        screen = self.stage.screen
        if self.hands.grab(pos, screen):
            return
        self._move(pos)
        if self._holding:
            self._place()
        elif not self.rollout and screen.top.bottom <= pos[1] < screen.bottom.top:
            self.hands.begin_pull(pos)

    def _release(self, pos: tuple[int, int]) -> None:
        self._move(pos)
        speed = self.hands.let_go()
        if speed > 0.0:
            self._strike(speed)

    # What hands and keys lead to.

    @property
    def _holding(self) -> bool:
        """Whether the player holds the cue ball."""
        return self.session.in_hand and self.rollout is None

    def _next_guide(self) -> None:
        self.level = (self.level + 1) % len(guide.LEVELS)
        self.message = f"Guide: {guide.LEVELS[self.level]}"

    def _fast_forward(self) -> None:
        self.fast = True

    def _put_down(self) -> None:
        if self.hands.pull is not None:
            self.message = "The cue is put down."
        self.hands.put_down()

    def _cancel(self) -> None:
        if not self.hands.busy:
            self.tuning = None
        self._put_down()

    def _enter(self) -> None:
        if self.rollout:
            self.time = ending(self.rollout)
        elif self._holding:
            self._place()
        else:
            self._strike(self.hands.aim.speed)

    def _strike(self, speed: float) -> None:
        self.hands.put_down()
        try:
            rollout = self.session.play(self.hands.aim.shot(self.session.cue.id, speed))
        except (InputError, BudgetError) as error:
            self.message = str(error)
            return
        self._show(rollout)
        self.message = "Miscue: the tip slipped off the ball." if _missed(rollout) else ""

    def _replay(self) -> None:
        if self.session.rollout is None:
            self.message = "There is no shot to see again."
        elif not self.rollout:
            self._show(self.session.rollout)
            self.message = "The last shot again."

    def _show(self, rollout: Rollout) -> None:
        """Run a shot from its beginning, which is heard at once."""
        self.rollout, self.time = rollout, 0.0
        self.sounds.play_events(self.session.table, rollout, -1.0, 0.0)

    def _tune(self) -> None:
        if self.tuning is None:
            aimed = self.hands.aim.shot(self.session.cue.id)
            self.tuning = Tuning(self.session, aimed, self._ask_name, self.open_table)
        else:
            self.tuning = None

    def open_table(self, name: str) -> None:
        """Go over to another preset, with a new rack; raises InputError."""
        self._drop()
        self.tuning = None
        self.session = Session(load_table(name), seed=random.randrange(1 << 30))
        self.message = f"{self.session.table.title}: a new rack."

    def _ask_name(self) -> None:
        table = self.session.table

        def save(name: str) -> str:
            try:
                path = save_preset(name, table.source, differences(table), name)
            except InputError as error:
                return error.allowed
            self.message = f"Saved as {path}"
            return ""

        self._next = Ask(self, "Save this table as a preset", "Name", f"my-{table.source}", save)

    def _show_geometry(self) -> None:
        self.geometry = not self.geometry

    def _undo(self) -> None:
        self._drop()
        self.message = "Taken back." if self.session.undo() else "There is nothing to take back."

    def _rack(self) -> None:
        self._drop()
        self.session.rack(random.randrange(1 << 30))
        self.message = "A new rack."

    def _drop(self) -> None:
        """Let go of whatever is under way."""
        self.rollout = None
        self.hands.put_down()
        self.hover = None

    def _nudge(self, dx: float, dy: float, step: float) -> None:
        x, y = self.hover or self._spot()
        self.hover = (x + dx * step, y + dy * step)

    def _place(self) -> None:
        if self.session.place(*(self.hover or self._spot())):
            self.hover = None
            self.hands.hold = self.hands.pointer
            self.message = ""
        else:
            self.message = "There is no room for the ball here."

    def _spot(self) -> tuple[float, float]:
        """Where a ball in hand is held before a hand has moved it."""
        start = self.session.table.rack(self.session.rack_name)[self.session.cue.id]
        return start.x, start.y

    def change_table(self, table: Table) -> None:
        """Play on with other parameters; raises InputError where the balls do not fit."""
        self.session.change_table(table)
        self.rollout = None
        if self.tuning is not None:
            self.tuning.refresh()
        self.message = "The table's file has changed, and so has the table."

    # Time.

    def update(self, dt: float) -> Scene | None:
        if self.tuning is not None:
            self.tuning.follow(self.hands.aim.shot(self.session.cue.id))
            self.tuning.update(dt)
        if self.rollout:
            before, self.time = self.time, self.time + dt * (_FAST if self.fast else 1.0)
            self.sounds.play_events(self.session.table, self.rollout, before, self.time)
            if self.time >= ending(self.rollout):
                self._come_to_rest(self.rollout)
        return self

    def _come_to_rest(self, rollout: Rollout) -> None:
        self.rollout = None
        if _missed(rollout):
            self.sounds.chalk()
        after = rollout.layout()
        fallen = [ball.id for ball in rollout.start.on_table() if after[ball.id].phase == POCKETED]
        if self.session.in_hand:
            self.message = "Scratch: the cue ball is in hand. Click where it shall stand."
        elif self.session.left == 0:
            self.message = "The table is cleared. N sets up a new rack."
        elif fallen:
            self.message = f"Down: {', '.join(sorted(fallen, key=lambda ball: (len(ball), ball)))}."
        elif not self.message.startswith("Miscue"):
            self.message = ""
        self.hands.hold = None
        if self.hands.pointer is not None:
            self._move(self.hands.pointer)

    # Drawing.

    def draw(self, surface: pygame.Surface) -> None:
        session, stage = self.session, self.stage
        screen = hud.Screen(*surface.get_size())
        stage.begin(surface, session.table, self.tuning.width(screen) if self.tuning is not None else 0)
        aim, speed = self.hands.aim, self.hands.speed
        shown = self.rollout.at(self.time) if self.rollout else session.layout
        aiming = not (self.rollout or session.in_hand)
        if self.tuning is not None and self.hands.pull is None and not self.rollout:
            stage.ways(surface, self.tuning)
        elif aiming and speed > 0.0:
            stage.guide(surface, self.level, session.layout, aim.shot(session.cue.id, speed))
        stage.balls(surface, shown, self.rollout or session.rollout, self.time if self.rollout else math.inf)
        if aiming:
            back = _REST + (_FULL - _REST) * self.hands.drawn
            cue_art.draw(surface, session.table, session.cue, aim, back, stage.view)
        elif not self.rollout:
            x, y = self.hover or self._spot()
            stage.in_hand(surface, session.cue._replace(x=x, y=y), session.may_place(x, y))
        if self.geometry:
            draw_geometry(ScreenPen(surface, stage.view), session.table)
        note = f"Shot {session.position.shots + 1}   \N{MIDDLE DOT}   {session.left} balls left"
        hud.draw_bars(surface, stage.screen, session.table.title, note)
        stage.tray(surface)
        hud.draw_controls(surface, stage.screen, aim, speed, session.table.knobs.cue.tip_friction)
        wrong = (self.tuning.error if self.tuning is not None else "") or self.warning
        message = wrong or f"{self.message} {self._hop(speed)}".strip()
        hud.draw_message(surface, stage.screen, message, theme.WARNING if wrong else theme.TEXT)
        if self.tuning is not None:
            self.tuning.draw(surface)

    def _hop(self, speed: float) -> str:
        """What to say of a stroke so steep and hard that a real ball would leave the cloth."""
        if self.hands.aim.elevation == 0.0 or self.rollout or self.session.in_hand:
            return ""
        knobs = self.session.table.knobs
        apex = hop(self.hands.aim.shot("", speed), self.session.table.body_of(self.session.cue)[1], knobs)[1]
        if apex < _HOP:
            return ""
        return f"So steep and hard, a real ball would hop {1000.0 * apex:.0f} mm. Here it stays on the cloth."


def _missed(rollout: Rollout) -> bool:
    """Whether the tip slipped off the ball."""
    return any(event.where == "miscue" for event in rollout.events)
