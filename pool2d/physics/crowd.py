"""The balls of a shot, found by where they are: the broad phase of balls."""

from __future__ import annotations

import math
from typing import Final, final

from .body import Body
from .motion import Motion
from .roots import INF
from .values import POCKETED

# Rows of cells are counted so far apart that no two cells have one number.
_ROW: Final = 1 << 20


@final
class Crowd:
    """Every ball's body and present motion, and which of them may be in a box.

    Balls at rest stand in square cells, about one to each. Those that move are few, or all: each has a box that it
    stays in (see `Motion.bound`), and they are gone through one by one.
    """

    __slots__ = ("bodies", "motion", "largest", "moving", "resting", "cells", "size")

    def __init__(self, bodies: list[Body], motion: list[Motion]) -> None:
        self.bodies = bodies
        self.motion = motion
        self.largest = max([body.radius for body in bodies], default=0.0)
        self.moving: dict[int, Motion] = {}
        self.resting: dict[int, Motion] = {}
        self.cells: dict[int, list[Motion]] = {}
        across = _spread([body.x for body in bodies]) * _spread([body.y for body in bodies])
        self.size = max(2.0 * self.largest, math.sqrt(across / max(1, len(bodies))), 1e-3)

    def lift(self, motion: Motion) -> None:
        """Give a ball its new motion; it is in no box until `put`."""
        i = motion.index
        self.motion[i] = motion
        if i in self.moving:
            del self.moving[i]
        elif i in self.resting:
            old = self.resting.pop(i)
            self.cells[self._cell(old.x, old.y)].remove(old)

    def put(self, motion: Motion) -> None:
        """Count on the ball of a motion wherever that takes it within its box."""
        if motion.phase == POCKETED:
            return
        if motion.stays():
            self.resting[motion.index] = motion
            self.cells.setdefault(self._cell(motion.x, motion.y), []).append(motion)
        else:
            self.moving[motion.index] = motion

    def near(self, left: float, bottom: float, right: float, top: float) -> list[Motion]:
        """The motions of the balls whose centres may be in a box."""
        found: list[Motion] = []
        for motion in self.moving.values():
            if motion.left <= right and left <= motion.right and motion.bottom <= top and bottom <= motion.top:
                found.append(motion)  # noqa: PERF401 - a loop compiles to one
        first, last = math.floor(left / self.size), math.floor(right / self.size)
        low, high = math.floor(bottom / self.size), math.floor(top / self.size)
        if (last - first + 1) * (high - low + 1) >= len(self.resting):
            _within(list(self.resting.values()), left, bottom, right, top, found)
            return found
        for column in range(first, last + 1):
            for row in range(low, high + 1):
                cell = self.cells.get(column * _ROW + row)
                if cell:
                    _within(cell, left, bottom, right, top, found)
        return found

    def around(self, ball: Body, far: float, now: float) -> list[Body]:
        """The other balls whose centres may be within `far` of a ball's, brought to the present moment."""
        near = self.near(ball.x - far, ball.y - far, ball.x + far, ball.y + far)
        return [self.bring(motion.index, now) for motion in near if motion.index != ball.index]

    def bring(self, i: int, now: float) -> Body:
        """Ball i as it is now."""
        body, motion = self.bodies[i], self.motion[i]
        if body.t != now and motion.t1 < INF:
            motion.move(body, now)
        return body

    def _cell(self, x: float, y: float) -> int:
        return math.floor(x / self.size) * _ROW + math.floor(y / self.size)


def _within(resting: list[Motion], left: float, bottom: float, right: float, top: float, found: list[Motion]) -> None:
    """Add the motions whose balls lie in a box."""
    for motion in resting:
        if left <= motion.x <= right and bottom <= motion.y <= top:
            found.append(motion)  # noqa: PERF401 - a loop compiles to one


def _spread(values: list[float]) -> float:
    return max(values) - min(values) if values else 0.0
