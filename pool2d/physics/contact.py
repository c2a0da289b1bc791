"""Solving a contact: which law, and whether a ball that is struck passes it on at once."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple, Protocol

from .body import Body
from .cluster import Group, facing, linked, solve
from .detect import NOISE, Element
from .materials import materials
from .motion import Motion
from .params import Physics
from .pressing import Side, press
from .springs import depth, yielding


class Surroundings(Protocol):
    """What contacts need of a table."""

    @property
    def physics(self) -> Physics: ...

    @property
    def elements(self) -> Sequence[Element]: ...

    def near(self, left: float, bottom: float, right: float, top: float) -> list[int]:
        """The indices of the elements that a box, in m, may touch: the broad phase."""
        ...


class Met(NamedTuple):
    """Which balls touched each other, and which touched which cushions, by name; what set it off first.

    `pressed` has the motions, just before, of balls that the cloth pressed into it (see `pressing`).
    """

    pairs: tuple[tuple[Body, Body], ...]
    rails: tuple[tuple[Body, str], ...]
    pressed: list[Motion]


class Contacts:
    """How things that meet on one table part again.

    `reach` gives each ball's distance, in plan, from a nose that it touches.
    """

    def __init__(self, table: Surroundings, reach: Sequence[float]) -> None:
        self.table = table
        self.physics = table.physics
        self.reach = reach
        self.materials = materials(self.physics)

    def cushion(self, ball: Body, element: Element, present: list[Body], now: float) -> Met:
        """A ball meets a cushion among the balls `present`."""
        nx, ny = element.normal(ball.x, ball.y)
        pressed = self._press([Side(ball, nx, ny)], ball.vx * nx + ball.vy * ny, now)
        speed = ball.vx * nx + ball.vy * ny
        if speed > NOISE:
            # A cushion gives way by far more than a ball: others of its kind are reached from further off.
            group = self._group([ball], present, depth(ball, ball, speed), yielding(ball, speed))
            met = self._together(group, speed, present)
            if met is not None:
                rails = sorted(met.rails, key=lambda rail: rail != (ball, element.name))
                return Met(met.pairs, tuple(rails), pressed)
            self.materials.cushion_law.collide(ball, nx, ny, self.materials.cushion)
        return Met((), ((ball, element.name),), pressed)

    def balls(self, a: Body, b: Body, present: list[Body], now: float) -> Met:
        """Two balls meet among those `present`."""
        nx, ny = _toward(a, b)
        pressed = self._press([Side(a, nx, ny), Side(b, -nx, -ny)], _approach(a, b), now)
        speed = _approach(a, b)
        if speed > NOISE:
            room = depth(a, b, speed)
            met = self._together(self._group([a, b], present, room, room), speed, present)
            if met is not None:
                pairs = sorted(met.pairs, key=lambda pair: pair != (a, b))
                return Met(tuple(pairs), met.rails, pressed)
            self.materials.ball_law.collide(a, b, self.materials.ball)
        return Met(((a, b),), (), pressed)

    def _group(self, first: list[Body], present: list[Body], room: float, yielding: float) -> Group:
        """What the first balls touch, or reach while the impact lasts: `room` away, or a cushion `yielding` away."""
        pairs = linked(first, present, room)
        balls = sorted({ball.index: ball for ball in (*first, *(ball for pair in pairs for ball in pair[:2]))}.items())
        spans = [(ball, self.reach[index], yielding if ball in first else room) for index, ball in balls]
        near = self.table.near(
            min(ball.x - reach - far for ball, reach, far in spans),
            min(ball.y - reach - far for ball, reach, far in spans),
            max(ball.x + reach + far for ball, reach, far in spans),
            max(ball.y + reach + far for ball, reach, far in spans),
        )
        cushions = [self.table.elements[i] for i in near if self.table.elements[i].kind == "ball_cushion"]
        if not cushions:
            return Group(pairs, [])
        noses = [
            (ball, element, gap) for ball, reach, far in spans for element, gap in facing(ball, cushions, reach, far)
        ]
        return Group(pairs, noses)

    def _together(self, group: Group, speed: float, present: list[Body]) -> Met | None:
        """Solve a group as one; None, and nothing changed, where only one contact is in it after all."""
        if len(group.pairs) + len(group.noses) < 2:
            return None
        before = [(ball, ball.velocity()) for ball in present]
        pairs, noses = solve(group, speed, self.materials)
        if len(pairs) + len(noses) < 2:
            for ball, velocity in before:
                ball.set_velocity(velocity)
            return None
        return Met(tuple((pair.a, pair.b) for pair in pairs), tuple((nose.ball, nose.name) for nose in noses), [])

    def _press(self, sides: list[Side], approach: float, now: float) -> list[Motion]:
        return press(sides, approach, now, self.physics.cloth, self.physics.gravity)


def _approach(a: Body, b: Body) -> float:
    """How fast two balls near each other in plan, m/s."""
    nx, ny = _toward(a, b)
    return (a.vx - b.vx) * nx + (a.vy - b.vy) * ny


def _toward(a: Body, b: Body) -> tuple[float, float]:
    """The unit vector, in plan, from one ball to another."""
    dx, dy = b.x - a.x, b.y - a.y
    distance = math.hypot(dx, dy)
    return dx / distance, dy / distance
