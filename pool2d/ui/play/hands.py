"""What the player's hands do with the cue: aim, pull back, let go, and set the diagrams."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from ...draw.view import View
from ...game.aim import FULL_PULL, Aim, pulled_speed
from ...physics.values import Ball, Layout
from ..scene import GUARD
from ..screen import Screen

Pos = tuple[int, int]

# The aim, once set by wheel or keys, stays until the pointer has moved this far, in pixels.
_HOLD = 8.0
# A press that is let go within so many pixels is a click: it strikes nothing, and means what it is on.
_CLICK = 4.0
# Nearer to the cue ball than this, in its radii, the aim is calmed.
_CALM = 6.0


class Hands:
    """The aim, and what is being done to it.

    `pull` is where a pull began and `pulled` how far back it has come, as a part of the window's height; `clicked`
    tells whether the pointer has stayed where it began; `drag` names the diagram being dragged; `hold` is where the
    pointer was when the aim was set by wheel or keys. `armed` is whether a key may strike: not until a hand has shown
    that it means this stroke, and not what was there before it. `player` is whose hands they are, `rested` how long
    the balls have been at rest, s. `swing` is how far back a cue is, as a part of a full pull, that no button holds.
    `keys` is what keys do, by the names of their actions. They have more attributes than most classes, as whatever a
    hand may be doing is told apart.
    """

    def __init__(self) -> None:
        self.aim = Aim()
        self.pointer: Pos | None = None
        self.pull: Pos | None = None
        self.pulled = self.swing = 0.0
        self.clicked = False
        self.drag = ""
        self.hold: Pos | None = None
        self.armed = True
        self.player = 0
        self.rested = math.inf
        self._pointed: tuple[float, float] | None = None
        self.keys: dict[str, Callable[[], None]] = {
            "harder": lambda: self.change_speed(0.25),
            "softer": lambda: self.change_speed(-0.25),
            "raise": lambda: self.raise_butt(1.0),
            "lower": lambda: self.raise_butt(-1.0),
            "spin_up": lambda: self.nudge_tip(0.0, 0.05),
            "spin_down": lambda: self.nudge_tip(0.0, -0.05),
            "spin_left": lambda: self.nudge_tip(-0.05, 0.0),
            "spin_right": lambda: self.nudge_tip(0.05, 0.0),
            "no_spin": self.center,
        }

    @property
    def busy(self) -> bool:
        """Whether a button is held on the cue or on a diagram."""
        return self.pull is not None or bool(self.drag)

    @property
    def guarded(self) -> bool:
        """Whether the balls have come to rest just now, so that a key may still be meant for the shot."""
        return self.rested <= GUARD

    @property
    def speed(self) -> float:
        """The cue's speed if it were let go now, or struck by key; 0 for a pull too short."""
        return self.aim.speed if self.pull is None else pulled_speed(self.pulled)

    @property
    def drawn(self) -> float:
        """How far back the cue is, as a part of a full pull."""
        return self.swing if self.pull is None else min(max(self.pulled / FULL_PULL, 0.0), 1.0)

    def point(self, pos: Pos, view: View, cue: Ball, radius: float) -> None:
        """Aim through the pointer, unless a fine aim is held or the pointer is on the ball itself.

        Close to the ball a small movement means a large angle, so there the aim only goes toward the pointer: right
        beside the ball by no more than the same movement would turn it from a few radii off, and the freer the
        farther out.
        """
        if self.holds(pos):
            return
        x, y = view.to_table(*pos)
        dx, dy = x - cue.x, y - cue.y
        moved = math.dist((dx, dy), self._pointed) if self._pointed is not None else math.inf
        self._pointed = dx, dy
        if math.hypot(dx, dy) > radius:
            # How far out of the calm the pointer is; from 1 on it is free.
            out = math.hypot(dx, dy) / (_CALM * radius)
            limit = math.degrees(moved / (_CALM * radius)) / (1.0 - out) if out < 1.0 else math.inf
            turn = math.remainder(math.degrees(math.atan2(dy, dx)) - self.aim.angle, 360.0)
            self.aim = self.aim.toward(dx, dy) if abs(turn) <= limit else self.aim.turned(math.copysign(limit, turn))

    def holds(self, pos: Pos) -> bool:
        """Whether what was set by wheel or keys stays, with the pointer here; once it has moved off it does not."""
        if self.hold is not None and math.dist(pos, self.hold) >= _HOLD:
            self.hold = None
        return self.hold is not None

    def grab(self, pos: Pos, screen: Screen) -> bool:
        """Take hold of a diagram, if one is there."""
        if screen.ball_diagram.collidepoint(pos):
            self.drag = "ball"
        elif screen.cue_diagram.collidepoint(pos):
            self.drag = "cue"
        return self.move(pos, screen)

    def begin_pull(self, pos: Pos) -> None:
        """Take hold of the cue: the aim is frozen."""
        self.pull, self.pulled, self.clicked = pos, 0.0, True

    def move(self, pos: Pos, screen: Screen) -> bool:
        """Move what is held; False where nothing is."""
        if self.drag == "ball":
            self.aim = self.aim.with_spin(*screen.spin_at(pos))
        elif self.drag == "cue":
            self.aim = self.aim.with_elevation(screen.elevation_at(pos))
        elif self.pull is not None:
            angle = math.radians(self.aim.angle)
            # Back along the cue; on the screen y points down.
            back = (self.pull[0] - pos[0]) * math.cos(angle) - (self.pull[1] - pos[1]) * math.sin(angle)
            self.pulled = back / screen.measure
            self.clicked = self.clicked and math.dist(self.pull, pos) <= _CLICK
        return self.busy

    def let_go(self) -> float:
        """Release the button; the speed of the stroke, or 0 where it is none."""
        speed = self.speed if self.pull is not None else 0.0
        self.put_down()
        return speed

    def put_down(self) -> None:
        """Let go of everything without a stroke."""
        self.pull = None
        self.drag = ""
        self.swing = 0.0

    def turn(self, degrees: float) -> None:
        """Turn the aim finely; it holds against small movements of the pointer."""
        if self.pull is None:
            self.aim = self.aim.turned(degrees)
            self.keep_aim()

    def keep_aim(self) -> None:
        """Let the aim stay, or a ball that is held, until the pointer is moved."""
        self.hold = self.pointer

    def rest(self, keep: bool) -> None:
        """The balls have come to rest; where the pointer has been elsewhere meanwhile the aim is to be kept."""
        self.rested = 0.0
        self.armed = False
        self.hold = self.pointer if keep else None

    def nudge_tip(self, side: float, height: float) -> None:
        self.aim = self.aim.with_spin(self.aim.side + side, self.aim.height + height)

    def change_speed(self, by: float) -> None:
        self.aim = self.aim.with_speed(self.aim.speed + by)

    def raise_butt(self, degrees: float) -> None:
        self.aim = self.aim.with_elevation(self.aim.elevation + degrees)

    def take_over(self) -> None:
        """Another player's hands: the cue as at first, still pointing the same way."""
        self.put_down()
        self.aim = replace(Aim(), angle=self.aim.angle)

    def face(self, cue: Ball, layout: Layout) -> None:
        """Before a new rack: aim at the middle of the balls until the pointer is moved."""
        balls = [ball for ball in layout.on_table() if ball.id != cue.id]
        if balls:
            x, y = (math.fsum(getattr(ball, axis) for ball in balls) / len(balls) for axis in "xy")
            angle = math.degrees(math.atan2(y - cue.y, x - cue.x))
            self.aim, self.hold = replace(self.aim, angle=round(angle, 2) % 360.0), self.pointer

    def center(self) -> None:
        """No spin, level cue."""
        self.aim = replace(self.aim, side=0.0, height=0.0, elevation=0.0)
