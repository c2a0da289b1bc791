"""The aim: how the player means to strike, and the curve from a pull of the cue to its speed."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from ..physics.values import Shot

# The speed of a full pull, and how far that is as a part of the window's height (of 9/16 of the width,
# where that is less): the same movement across the screen gives the same speed in a window of any size.
# The first part is free, so that a click is not a shot, and slow speeds get room.
MAX_SPEED = 10.0
FULL_PULL = 0.36
FREE_PULL = 0.0085
_CURVE = 1.6
# Softer than this nobody strikes: a pull so short is a click of a hand that was not quite still.
MIN_SPEED = 0.1
# How far the tip may be set from the centre, in radii: past the miscue limit, but on the ball.
MAX_OFFSET = 0.7
MAX_ELEVATION = 80.0


@dataclass(frozen=True, slots=True)
class Aim:
    """The cue before the stroke: a `Shot` without a ball; `speed`, m/s, is that of a stroke by key.

    `jump` is whether it is the jump cue.
    """

    angle: float = 0.0
    speed: float = 3.0
    side: float = 0.0
    height: float = 0.0
    elevation: float = 0.0
    jump: bool = False

    def shot(self, ball: str, speed: float | None = None, easy: bool = False) -> Shot:
        """The shot that it makes of a ball, at another speed, m/s, where one is given; `easy` as `Shot` has it."""
        given = self.speed if speed is None else speed
        return Shot(self.angle, given, self.side, self.height, self.elevation, ball, easy=easy, jump=self.jump)

    @classmethod
    def of(cls, shot: Shot) -> Aim:
        """The aim that makes a shot."""
        return cls(shot.angle % 360.0, shot.speed, shot.side, shot.height, shot.elevation, shot.jump)

    def toward(self, dx: float, dy: float) -> Aim:
        """Aimed along (dx, dy), in the table's directions."""
        return replace(self, angle=math.degrees(math.atan2(dy, dx)) % 360.0)

    def turned(self, degrees: float) -> Aim:
        """Turned counter-clockwise by so many degrees."""
        return replace(self, angle=(self.angle + degrees) % 360.0)

    def with_spin(self, side: float, height: float) -> Aim:
        """With the tip at (side, height), in ball radii, or as far out that way as is allowed."""
        offset = math.hypot(side, height)
        shrink = MAX_OFFSET / offset if offset > MAX_OFFSET else 1.0
        return replace(self, side=round(side * shrink, 3), height=round(height * shrink, 3))

    def with_elevation(self, degrees: float) -> Aim:
        """With the butt raised so many degrees, within what is allowed."""
        return replace(self, elevation=min(max(round(degrees, 1), 0.0), MAX_ELEVATION))

    def with_other_cue(self) -> Aim:
        """With the jump cue in place of the playing cue, or that in place of it."""
        return replace(self, jump=not self.jump)

    def with_speed(self, speed: float) -> Aim:
        """With the speed of a stroke by key, m/s, within what is allowed."""
        return replace(self, speed=min(max(round(speed, 2), MIN_SPEED), MAX_SPEED))


def pulled_speed(pulled: float) -> float:
    """The cue's speed, m/s, after pulling back by a part of the window's height; 0 where it is no pull."""
    part = (pulled - FREE_PULL) / (FULL_PULL - FREE_PULL)
    speed = MAX_SPEED * math.pow(min(max(part, 0.0), 1.0), _CURVE)
    return speed if speed >= MIN_SPEED else 0.0


def drawn_back(speed: float) -> float:
    """The part of a full pull that gives this speed."""
    part = math.pow(min(max(speed / MAX_SPEED, 0.0), 1.0), 1.0 / _CURVE)
    return (FREE_PULL + part * (FULL_PULL - FREE_PULL)) / FULL_PULL
