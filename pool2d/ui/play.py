"""The table being played on: aiming, the stroke, the balls running, the cue ball in hand."""

from __future__ import annotations

import math
import random
from dataclasses import replace

import pygame

from ..errors import BudgetError, InputError
from ..game.session import Session
from ..physics.rollout import Rollout
from ..physics.simulate import simulate
from ..physics.values import POCKETED, Ball, Layout
from ..table import Table
from . import ball_art, cue_art, guide, hud, pen, table_art, theme
from .aim import FULL_PULL, Aim, pulled_speed
from .help import Help
from .keys import action_of, fine_step
from .scene import Scene
from .view import View, fit

_FAST = 8.0
# The aim, once set by wheel or keys, stays until the pointer has moved this far, in pixels.
_HOLD = 8.0
# How far the cue stands back from the ball at rest and at full pull, m.
_REST, _FULL = 0.02, 0.32


class Play:
    """A session on screen.

    What the hands hold: `pull` is where a pull began, `drag` the diagram being dragged, `hover` where
    a cue ball in hand is shown. While `rollout` is set its balls are shown at `time`.
    """

    def __init__(self, session: Session) -> None:
        self.session = session
        self.aim = Aim()
        self.level = guide.GHOST
        self.rollout: Rollout | None = None
        self.time = 0.0
        self.fast = False
        self.pull: tuple[int, int] | None = None
        self.pulled = 0.0
        self.drag = ""
        self.hover: tuple[float, float] | None = None
        self.hold: tuple[int, int] | None = None
        self.pointer = (0, 0)
        self.message = "Aim with the mouse, press, pull back and release. F1 lists every key."
        self.warning = ""
        self.screen = hud.Screen(1280, 720)
        self.view = self._fit()
        self._table_key: object = None
        self._table_picture = pygame.Surface((1, 1))
        self._guide_key: object = None
        self._guide: Rollout | None = None

    # Events.

    def handle(self, event: pygame.event.Event) -> Scene | None:
        if event.type == pygame.KEYDOWN:
            return self._key(event)
        if event.type == pygame.KEYUP and action_of(event.key, 0) == "fast":
            self.fast = False
        elif event.type == pygame.MOUSEMOTION:
            self._move(event.pos)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            self._press(event.pos)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 3:
            self._cancel()
        elif event.type == pygame.MOUSEBUTTONUP and event.button == 1:
            self._release(event.pos)
        elif event.type == pygame.MOUSEWHEEL:
            self._turn(event.y * fine_step(getattr(event, "mod", 0) or pygame.key.get_mods()))
        elif event.type == pygame.WINDOWFOCUSLOST:
            self.fast = False
            self._cancel()
        return self

    def _key(self, event: pygame.event.Event) -> Scene | None:
        mod = getattr(event, "mod", 0)
        action = action_of(event.key, mod)
        if action == "quit":
            return None
        if action == "help":
            return Help(self)
        step = fine_step(mod)
        spin, aim = 0.05, self.aim
        if self.session.in_hand and not self.rollout and action in _ARROWS:
            # Steps of 1 cm; Shift 2 mm, Ctrl 20 cm.
            self._nudge(*_ARROWS[action], 0.2 * step)
        elif action in ("turn_left", "turn_right"):
            self._turn(step if action == "turn_left" else -step)
        elif action in ("harder", "softer"):
            self.aim = aim.with_speed(aim.speed + (0.25 if action == "harder" else -0.25))
        elif action in _SPIN:
            side, height = _SPIN[action]
            self.aim = aim.with_spin(aim.side + spin * side, aim.height + spin * height)
        elif action == "no_spin":
            self.aim = replace(aim, side=0.0, height=0.0, elevation=0.0)
        elif action in ("lower", "raise"):
            self.aim = aim.with_elevation(aim.elevation + (1.0 if action == "raise" else -1.0))
        elif action == "strike":
            self._enter()
        elif action == "guide":
            self.level = (self.level + 1) % len(guide.LEVELS)
            self._say(f"Guide: {guide.LEVELS[self.level]}")
        elif action == "fast":
            self.fast = True
        elif action == "replay":
            self._replay()
        elif action == "undo":
            self._undo()
        elif action == "rack":
            self.rollout = None
            self.session.rack(random.randrange(1 << 30))
            self._say("A new rack.")
        elif action == "cancel":
            self._cancel()
        return self

    def _move(self, pos: tuple[int, int]) -> None:
        self.pointer = pos
        if self.drag:
            self._drag(pos)
        elif self.pull is not None:
            angle = math.radians(self.aim.angle)
            # Back along the cue; on the screen y points down.
            self.pulled = (self.pull[0] - pos[0]) * math.cos(angle) - (self.pull[1] - pos[1]) * math.sin(angle)
        elif self.session.in_hand:
            self.hover = self.view.to_table(*pos)
        else:
            self._point(pos)

    def _point(self, pos: tuple[int, int]) -> None:
        """Aim through the pointer, unless a fine aim is held or the pointer is on the ball itself."""
        if self.hold is not None and math.dist(pos, self.hold) < _HOLD:
            return
        x, y = self.view.to_table(*pos)
        cue = self.session.cue
        if math.hypot(x - cue.x, y - cue.y) > self.session.table.body_of(cue)[0]:
            self.hold = None
            self.aim = self.aim.toward(x - cue.x, y - cue.y)

    def _press(self, pos: tuple[int, int]) -> None:
        self.pointer = pos
        if self.screen.ball_diagram.collidepoint(pos):
            self.drag = "ball"
        elif self.screen.cue_diagram.collidepoint(pos):
            self.drag = "cue"
        if self.drag:
            self._drag(pos)
        elif self.rollout:
            return
        elif self.session.in_hand:
            self.hover = self.view.to_table(*pos)
            self._place()
        elif self.screen.top.bottom <= pos[1] < self.screen.bottom.top:
            self._point(pos)
            self.pull, self.pulled = pos, 0.0

    def _release(self, pos: tuple[int, int]) -> None:
        self._move(pos)
        self.drag = ""
        if self.pull is not None:
            speed = pulled_speed(self.pulled)
            self.pull = None
            if speed > 0.0:
                self._strike(speed)

    def _drag(self, pos: tuple[int, int]) -> None:
        if self.drag == "ball":
            self.aim = self.aim.with_spin(*self.screen.spin_at(pos))
        else:
            self.aim = self.aim.with_elevation(self.screen.elevation_at(pos))

    def _cancel(self) -> None:
        if self.pull is not None:
            self._say("The cue is put down.")
        self.pull = None
        self.drag = ""

    def _turn(self, degrees: float) -> None:
        if self.pull is None:
            self.aim = self.aim.turned(degrees)
            self.hold = self.pointer

    # What hands and keys lead to.

    def _enter(self) -> None:
        if self.rollout:
            self.time = self.rollout.duration
        elif self.session.in_hand:
            self._place()
        else:
            self._strike(self.aim.speed)

    def _strike(self, speed: float) -> None:
        try:
            self.rollout = self.session.play(self.aim.shot(self.session.cue.id, speed))
        except (InputError, BudgetError) as error:
            self.warning = str(error)
            return
        self.time = 0.0
        self.pull = None
        missed = any(event.where == "miscue" for event in self.rollout.events)
        self._say("Miscue: the tip slipped off the ball." if missed else "")

    def _replay(self) -> None:
        if self.session.rollout is None:
            self._say("There is no shot to see again.")
        elif not self.rollout:
            self.rollout, self.time = self.session.rollout, 0.0
            self._say("The last shot again.")

    def _undo(self) -> None:
        self.rollout = None
        self.pull = None
        self.hover = None
        self._say("Taken back." if self.session.undo() else "There is nothing to take back.")

    def _nudge(self, dx: float, dy: float, step: float) -> None:
        x, y = self.hover or self._spot()
        self.hover = (x + dx * step, y + dy * step)

    def _place(self) -> None:
        if self.session.place(*(self.hover or self._spot())):
            self.hover = None
            self.hold = None
            self._say("")
        else:
            self._say("There is no room for the ball here.")

    def _spot(self) -> tuple[float, float]:
        """Where a ball in hand is shown before a hand has moved it."""
        return self.session.table.furniture.spots["head"]

    def _say(self, message: str) -> None:
        self.message = message

    # Time.

    def update(self, dt: float) -> Scene | None:
        if self.rollout:
            self.time += dt * (_FAST if self.fast else 1.0)
            if self.time >= self.rollout.duration:
                self._come_to_rest(self.rollout)
        return self

    def _come_to_rest(self, rollout: Rollout) -> None:
        self.rollout = None
        before, after = rollout.start, self.session.layout
        fallen = [ball.id for ball in before.on_table() if after[ball.id].phase == POCKETED]
        cue = self.session.cue.id
        if self.session.in_hand:
            self.hover = None
            self._say("Scratch: the cue ball is in hand. Click where it shall stand.")
        elif self.session.left == 0:
            self._say("The table is cleared. N sets up a new rack.")
        elif fallen:
            balls = ", ".join(sorted(fallen, key=lambda ball: (len(ball), ball)))
            self._say(f"Down: {balls}.")
        elif not self.message.startswith("Miscue"):
            self._say("")
        if cue not in fallen:
            self._point(self.pointer)

    def change_table(self, table: Table) -> None:
        """Play on with other parameters; raises InputError where the balls do not fit."""
        self.session.change_table(table)
        self.rollout = None
        self._say("The table's file has changed, and so has the table.")

    # Drawing.

    def draw(self, surface: pygame.Surface) -> None:
        self.screen = hud.Screen(*surface.get_size())
        self.view = self._fit()
        surface.blit(self._background(), (0, 0))
        layout = self.rollout.at(self.time) if self.rollout else self.session.layout
        still = self.rollout is None and not self.session.in_hand
        speed = pulled_speed(self.pulled) if self.pull is not None else self.aim.speed
        if still and self.level != guide.OFF and speed > 0.0:
            self._draw_guide(surface, speed)
        self._draw_balls(surface, layout)
        if still:
            part = max(0.0, min(1.0, self.pulled / FULL_PULL)) if self.pull is not None else 0.0
            back = _REST + (_FULL - _REST) * part
            cue_art.draw(surface, self.session.table, self.session.cue, self.aim, back, self.view)
        elif self.session.in_hand and not self.rollout:
            self._draw_in_hand(surface)
        note = f"Shot {self.session.position.shots + 1}   \N{MIDDLE DOT}   {self.session.left} balls left"
        hud.draw_bars(surface, self.screen, self.session.table.title, note)
        hud.draw_controls(surface, self.screen, self.aim, speed, self.session.table.knobs.cue.tip_friction)
        color = theme.WARNING if self.warning else theme.TEXT
        hud.draw_message(surface, self.screen, self.warning or self.message, color)

    def _fit(self) -> View:
        size = self.session.table.knobs.table
        return fit(size.length, size.width, self.screen.table)

    def _background(self) -> pygame.Surface:
        key = (self.screen, self.session.table)
        if key != self._table_key:
            self._table_key = key
            self._table_picture = table_art.draw(self.session.table, (self.screen.width, self.screen.height), self.view)
        return self._table_picture

    def _draw_balls(self, surface: pygame.Surface, layout: Layout) -> None:
        for ball in layout.on_table():
            self._draw_ball(surface, ball)

    def _draw_ball(self, surface: pygame.Surface, ball: Ball, faint: bool = False) -> None:
        radius = self.session.table.body_of(ball)[0] * self.view.scale
        ball_art.draw(surface, ball.id, self.view.to_screen(ball.x, ball.y), radius, faint)

    def _draw_in_hand(self, surface: pygame.Surface) -> None:
        x, y = self.hover or self._spot()
        ball = self.session.cue._replace(x=x, y=y)
        self._draw_ball(surface, ball, faint=True)
        free = self.session.may_place(x, y)
        radius = self.session.table.body_of(ball)[0] * self.view.scale
        pen.ring(surface, theme.ACCENT if free else theme.WARNING, self.view.to_screen(x, y), radius + 2.0, 2.0)

    def _draw_guide(self, surface: pygame.Surface, speed: float) -> None:
        rollout = self._foreseen(speed)
        if rollout is None:
            return
        if self.level == guide.WHOLE:
            guide.draw_whole(surface, rollout, self.session.table, self.view)
        guide.draw(surface, guide.foresee(rollout, self.session.cue.id), self.level, self.session.table, self.view)

    def _foreseen(self, speed: float) -> Rollout | None:
        """The present aim's rollout, worked out again only when something has changed."""
        events = None if self.level == guide.WHOLE else guide.EVENTS
        key = (self.session.layout, self.session.table, self.aim, speed, events)
        if key != self._guide_key:
            self._guide_key = key
            try:
                shot = self.aim.shot(self.session.cue.id, speed)
                self._guide = simulate(self.session.table, self.session.layout, shot, events=events)
            except (InputError, BudgetError):
                self._guide = None
        return self._guide


_ARROWS = {"turn_left": (-1.0, 0.0), "turn_right": (1.0, 0.0), "harder": (0.0, 1.0), "softer": (0.0, -1.0)}
_SPIN = {"spin_up": (0.0, 1.0), "spin_down": (0.0, -1.0), "spin_left": (-1.0, 0.0), "spin_right": (1.0, 0.0)}
