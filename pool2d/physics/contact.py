"""Solving a contact: which law, and whether a ball that is struck passes it on at once."""

from __future__ import annotations

import math
from typing import final

from .body import Body
from .cluster import Group, facing, linked, solve
from .crowd import Crowd
from .detect import NOISE, Element
from .flight.bed import Bed
from .flight.impact import GENTLE, against, collide, glance, nearing
from .flight.solids import Solid
from .motion import STILL, Motion
from .pressing import Side, press
from .roots import INF
from .springs import depth, yielding
from .strike import TipImpulse, TipSpring

Pair = tuple[Body, Body]
Touch = tuple[Body, str]


@final
class Met:
    """Which balls touched each other, and which touched which cushions, by name; what set it off first.

    `pressed` has the motions, just before, of balls that the cloth pressed into it (see `pressing`); `aloft` is whether
    it was off the cloth.
    """

    __slots__ = ("pairs", "rails", "pressed", "aloft")

    def __init__(self, pairs: list[Pair], rails: list[Touch], pressed: list[Motion]) -> None:
        self.pairs = pairs
        self.rails = rails
        self.pressed = pressed
        self.aloft = False

    def bodies(self) -> list[Body]:
        """The balls that touched something, in order."""
        if len(self.rails) == 1 and not self.pairs:
            return [self.rails[0][0]]
        found = {body.index: body for pair in self.pairs for body in pair}
        for body, _ in self.rails:
            found[body.index] = body
        return [found[index] for index in sorted(found)]


@final
class Contacts:
    """How things that meet on one table part again."""

    __slots__ = ("crowd", "cushions", "materials", "bed")

    def __init__(self, crowd: Crowd, elements: list[Element], bed: Bed) -> None:
        self.crowd = crowd
        self.bed = bed
        self.cushions = [element for element in elements if element.kind == "ball_cushion"]
        self.materials = bed.materials

    def cushion(self, ball: Body, element: Element, now: float) -> Met:
        """A ball meets a cushion."""
        nx, ny = element.normal(ball.x, ball.y)
        pressed = press([Side(ball, nx, ny)], ball.vx * nx + ball.vy * ny, now, self.materials.cloth)
        speed = ball.vx * nx + ball.vy * ny
        if speed <= STILL:
            _stop(ball, nx, ny)
        else:
            # A cushion gives way by far more than a ball: others of its kind are reached from further off.
            group = self._group([ball], depth(ball, ball, speed), yielding(ball, speed), now)
            met = self._together(group, speed, pressed)
            if met is not None:
                met.rails.sort(key=lambda rail: rail != (ball, element.name))
                return met
            self.materials.cushion_law.collide(ball, nx, ny, self.materials.of(element))
        return Met([], [(ball, element.name)], pressed)

    def balls(self, a: Body, b: Body, now: float) -> Met:
        """Two balls meet."""
        if a.aloft() or b.aloft():
            return self._in_the_air(a, b)
        nx, ny = _toward(a, b)
        pressed = press([Side(a, nx, ny), Side(b, -nx, -ny)], _approach(a, b), now, self.materials.cloth)
        speed = _approach(a, b)
        if speed <= STILL and (_creeps(a) or _creeps(b)):
            _stop(a, nx, ny)
            _stop(b, -nx, -ny)
        elif speed > NOISE:
            room = depth(a, b, speed)
            met = self._together(self._group([a, b], room, room, now), speed, pressed)
            if met is not None:
                met.pairs.sort(key=lambda pair: pair != (a, b))
                return met
            self.materials.ball_law.collide(a, b, self.materials.ball)
        return Met([(a, b)], [], pressed)

    def _in_the_air(self, a: Body, b: Body) -> Met:
        """Two balls meet of which one is off the cloth; one that lies and is pressed down has its answer at once."""
        lying = [ball for ball in (a, b) if self.bed.lies(ball)]
        speed = nearing(a, b)
        collide(a, b, self.materials.ball)
        for ball in lying:
            self.bed.answer(ball)
        for ball in (a, b):
            if speed < 2.0 * GENTLE and not self.bed.lies(ball):
                ball.held += 1
        met = Met([(a, b)], [], [])
        met.aloft = True
        return met

    def solid(self, ball: Body, solid: Solid) -> None:
        """A ball in the air meets something about the bed."""
        n = solid.normal(ball.x, ball.y, ball.z + ball.radius)
        speed = ball.vx * n[0] + ball.vy * n[1] + ball.vz * n[2]
        if speed < 2.0 * GENTLE:
            ball.held += 1
        against(ball, n, solid.surface)
        glance(ball, n, solid.least(math.hypot(ball.vx, ball.vy)))

    def struck(self, ball: Body, stroke: TipImpulse) -> Met:
        """A stroke has sent a ball that lies on its way: where another is in it, with the tip they are one contact.

        Else nothing is met, and nothing changes: what the ball meets later it meets without the tip.
        """
        speed, up = math.hypot(ball.vx, ball.vy), ball.vz
        if speed <= NOISE:
            return Met([], [], [])
        tip = TipSpring(ball, stroke)
        # Until the slate has answered, a ball that is driven into it is beside the others, not off the cloth.
        ball.vz = 0.0
        met = self._driven(ball, speed, tip)
        if met.pairs:
            stroke.onward = tip.speed
        else:
            ball.vz = up
        return met

    def _driven(self, ball: Body, speed: float, tip: TipSpring) -> Met:
        room = depth(ball, ball, speed)
        if not linked([ball], self.crowd, room, 0.0):
            return Met([], [], [])
        group = self._group([ball], room, yielding(ball, speed), 0.0)
        before = [(body, body.velocity()) for body in [ball, *group.balls()]]
        ball.set_velocity((0.0, 0.0, 0.0, 0.0, 0.0))
        # One that comes to meet it may be faster.
        fastest = max([speed, *[math.hypot(body.vx, body.vy) for body in group.balls()]])
        pairs, noses = solve(group, fastest, self.materials, tip)
        if not any(ball in pair.balls for pair in pairs):
            for body, velocity in before:
                body.set_velocity(velocity)
            return Met([], [], [])
        met = [(pair.a, pair.b) for pair in pairs]
        met.sort(key=lambda pair: ball not in pair)
        return Met(met, [(nose.ball, nose.name) for nose in noses], [])

    def _group(self, first: list[Body], room: float, yielding: float, now: float) -> Group:
        """What the first balls touch, or reach while the impact lasts: `room` away, or a cushion `yielding` away."""
        pairs = linked(first, self.crowd, room, now)
        balls = first
        if len(pairs) > len(first) - 1:
            found = {ball.index: ball for ball in first}
            for a, b, _ in pairs:
                found[a.index] = a
                found[b.index] = b
            balls = [found[index] for index in sorted(found)]
        spans = [(ball, yielding if ball in first else room) for ball in balls]
        cushions = self._cushions_near(spans)
        if not cushions:
            return Group(pairs, [])
        noses = [
            (ball, element, gap) for ball, far in spans for element, gap in facing(ball, cushions, ball.reach, far)
        ]
        return Group(pairs, noses)

    def _cushions_near(self, spans: list[tuple[Body, float]]) -> list[Element]:
        """The cushions about balls, each with how far from touching it they count."""
        left = bottom = INF
        right = top = -INF
        for ball, far in spans:
            reach = ball.reach + far
            left, bottom = min(left, ball.x - reach), min(bottom, ball.y - reach)
            right, top = max(right, ball.x + reach), max(top, ball.y + reach)
        return [element for element in self.cushions if element.near(left, bottom, right, top)]

    def _together(self, group: Group, speed: float, pressed: list[Motion]) -> Met | None:
        """Solve a group as one; None, and nothing changed, where only one contact is in it after all."""
        if len(group.pairs) + len(group.noses) < 2:
            return None
        before = [(ball, ball.velocity()) for ball in group.balls()]
        pairs, noses = solve(group, speed, self.materials)
        if len(pairs) + len(noses) < 2:
            for ball, velocity in before:
                ball.set_velocity(velocity)
            return None
        return Met([(pair.a, pair.b) for pair in pairs], [(nose.ball, nose.name) for nose in noses], pressed)


def _creeps(ball: Body) -> bool:
    """Whether a ball is so slow that what it has of speed is rounding."""
    return math.hypot(ball.vx, ball.vy) <= STILL


def _stop(ball: Body, nx: float, ny: float) -> None:
    """Take from a ball the speed at which it goes toward something.

    Two that creep would else have endless contacts: what one gets of the other is rounded away before the next.
    """
    speed = ball.vx * nx + ball.vy * ny
    if speed > 0.0:
        ball.vx -= speed * nx
        ball.vy -= speed * ny


def _approach(a: Body, b: Body) -> float:
    """How fast two balls near each other in plan, m/s."""
    nx, ny = _toward(a, b)
    return (a.vx - b.vx) * nx + (a.vy - b.vy) * ny


def _toward(a: Body, b: Body) -> tuple[float, float]:
    """The unit vector, in plan, from one ball to another."""
    dx, dy = b.x - a.x, b.y - a.y
    distance = math.hypot(dx, dy)
    return dx / distance, dy / distance
