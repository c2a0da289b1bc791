"""The balls of a shot, found by where they are: the broad phase of balls."""

from __future__ import annotations

import math
from typing import Final, final

from .body import Body
from .motion import Motion
from .roots import INF

# Up to so many balls are gone through one by one: quicker than looking into cells.
FEW: Final = 64
# Rows of cells are counted so far apart that no two cells have one number.
_ROW: Final = 1 << 20


@final
class Crowd:
    """Every ball's body and present motion, and which of them may be in a box.

    Each motion has a box in which its ball stays for now (see `Motion.bound`). Where the balls are many, the boxes are
    kept small, as none is followed further than its horizon, and entered into square cells, about one to each.
    """

    __slots__ = ("bodies", "motion", "largest", "placed", "cells", "size")

    def __init__(self, bodies: list[Body], motion: list[Motion]) -> None:
        self.bodies = bodies
        self.motion = motion
        self.largest = max([body.radius for body in bodies], default=0.0)
        self.placed: dict[int, Motion] = {}
        self.cells: dict[int, list[Motion]] = {}
        # The side of a cell, m; infinite where there are none.
        self.size = INF
        if len(bodies) > FEW:
            area = _spread([body.x for body in bodies]) * _spread([body.y for body in bodies])
            self.size = max(4.0 * self.largest, math.sqrt(area / len(bodies)))

    def horizon(self, motion: Motion, now: float) -> float:
        """For how long a motion is followed from now on: for about the way through one cell, s."""
        if self.size == INF:
            return INF
        s = now - motion.t0
        speed = math.hypot(motion.vx + 2.0 * motion.hx * s, motion.vy + 2.0 * motion.hy * s)
        pull = math.hypot(motion.hx, motion.hy)
        # v t + h t^2 is no more than the cell.
        return 2.0 * self.size / (speed + math.sqrt(speed * speed + 4.0 * pull * self.size))

    def lift(self, motion: Motion) -> None:
        """Give a ball its motion; it is in no box until `put`."""
        old = self.placed.pop(motion.index, None)
        if old is not None:
            for cell in self._cells(old.left, old.bottom, old.right, old.top):
                self.cells[cell].remove(old)
        self.motion[motion.index] = motion

    def put(self, motion: Motion) -> None:
        """Count on the ball of a motion wherever that takes it within its box."""
        self.placed[motion.index] = motion
        for cell in self._cells(motion.left, motion.bottom, motion.right, motion.top):
            self.cells.setdefault(cell, []).append(motion)

    def near(self, left: float, bottom: float, right: float, top: float) -> list[Motion]:
        """The motions of the balls whose centres may be in a box."""
        if self.size == INF:
            return _within(list(self.placed.values()), left, bottom, right, top)
        found: dict[int, Motion] = {}
        for cell in self._cells(left, bottom, right, top):
            for motion in _within(self.cells.get(cell, []), left, bottom, right, top):
                found[motion.index] = motion
        return list(found.values())

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

    def _cells(self, left: float, bottom: float, right: float, top: float) -> list[int]:
        """The numbers of the cells that a box reaches into."""
        if self.size == INF:
            return []
        first, last = math.floor(left / self.size), math.floor(right / self.size)
        low, high = math.floor(bottom / self.size), math.floor(top / self.size)
        return [column * _ROW + row for column in range(first, last + 1) for row in range(low, high + 1)]


def _within(motions: list[Motion], left: float, bottom: float, right: float, top: float) -> list[Motion]:
    """Those of the motions whose boxes touch a box."""
    return [
        motion
        for motion in motions
        if motion.left <= right and left <= motion.right and motion.bottom <= top and bottom <= motion.top
    ]


def _spread(values: list[float]) -> float:
    return max(values) - min(values)
