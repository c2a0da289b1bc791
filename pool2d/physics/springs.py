"""The contacts of a cluster, as the springs that they are: two balls, and a ball in a cushion.

A spring keeps its place and normal; `depth` is how far the two are pressed into each other, negative while
there is a gap, and `met` tells whether it has ever closed. `press` works out what a step gives the balls
and `act` gives it, so that all springs of a step see the same moment and their order is of no consequence.
"""

from __future__ import annotations

import math
from functools import cache
from typing import TYPE_CHECKING, Final, final

from .detect import TOUCH
from .laws.nose import State, along_nose, drag, dragged, rate, slip_along, springing_back
from .laws.pair import normal, push, slip
from .laws.rebound import rebound

if TYPE_CHECKING:
    from .body import Body
    from .detect import Element
    from .laws.law import Nose
    from .materials import Materials

# Stiffness of two pool balls, N/m^1.5, and the radius it was worked out for (Marlow; Alciatore TP B.29).
STIFFNESS: Final = 8.06e8
RADIUS: Final = 0.028575
# Stiffness of a cushion, N/m: a pool ball stays in it for 4 ms, twenty times as long as on another ball.
# What comes out depends on it only in that it is much softer than a ball.
RUBBER: Final = 1.05e5
# Steps in the duration of one impact at the speed of approach.
STEPS: Final = 60
# A spring that has relaxed to this part of its greatest force, and is being left, lets go.
_SPENT: Final = 1e-9


class Spring:
    """One contact of a cluster. `step` is how long a step may be while it is closed, s."""

    __slots__ = ("balls", "depth", "step", "met")

    def __init__(self, balls: tuple[Body, ...], gap: float, step: float) -> None:
        self.balls = balls
        self.depth = -gap
        self.step = step
        self.met = False

    def closing(self) -> float:
        """How fast the two near each other, in plan, m/s."""
        raise NotImplementedError

    def part(self, speed: float) -> None:
        """Take `speed` off that, without friction, m/s."""
        raise NotImplementedError

    def press(self, dt: float) -> bool:
        """Let the depth run for a step and work out the impulse that it brings; whether the contact is closed."""
        raise NotImplementedError

    def act(self) -> None:
        """Give the balls the impulse of a contact that is closed."""
        raise NotImplementedError


@final
class BallSpring(Spring):
    """Two balls: F = K d^1.5 with a loss, and friction.

    `slip` is the fastest so far: it sets the friction of the whole impact, as it does for two balls alone. A step's
    impulse is `along` the normal and (fx, fy, fz) across it.
    """

    __slots__ = ("a", "b", "n", "slip", "stiffness", "loss", "friction", "along", "fx", "fy", "fz")

    def __init__(self, a: Body, b: Body, gap: float, speed: float, loss: float, materials: Materials) -> None:
        super().__init__((a, b), gap, duration(a, b, speed) / STEPS)
        self.a = a
        self.b = b
        self.n = normal(a, b)
        self.slip = 0.0
        # Springs of Hertz: K goes with the root of the effective radius.
        self.stiffness = stiffness(a, b)
        self.loss = loss * math.sqrt(self.stiffness * a.mass * b.mass / (a.mass + b.mass))
        self.friction = materials.ball.friction
        self.along = self.fx = self.fy = self.fz = 0.0

    def press(self, dt: float) -> bool:
        a, b, n = self.a, self.b, self.n
        # As `closing` has it: most of an impact's time goes into this, and a call would double it.
        closing = (a.vx - b.vx) * n[0] + (a.vy - b.vy) * n[1]
        self.depth = d = self.depth + closing * dt
        if d <= 0.0:
            return False
        self.along = 0.0
        self.met = self.met or d > TOUCH
        root = math.sqrt(d)
        along = dt * (self.stiffness * d * root + self.loss * math.sqrt(root) * closing)
        if along > 0.0:
            self.along = along
            self._rub(closing)
        return True

    def act(self) -> None:
        if self.along > 0.0:
            push(self.a, self.b, self.n, self.along, self.fx, self.fy, self.fz)

    def closing(self) -> float:
        a, b, n = self.a, self.b, self.n
        return (a.vx - b.vx) * n[0] + (a.vy - b.vy) * n[1]

    def part(self, speed: float) -> None:
        a, b, n = self.a, self.b, self.n
        along = speed / ((n[0] * n[0] + n[1] * n[1]) * (1.0 / a.mass + 1.0 / b.mass))
        push(a, b, n, along, 0.0, 0.0, 0.0)

    def _rub(self, closing: float) -> None:
        """The friction of a step: Coulomb's, or what ends the slip."""
        a, b = self.a, self.b
        sx, sy, sz = slip(a, b, self.n, closing)
        size = math.sqrt(sx * sx + sy * sy + sz * sz)
        if size == 0.0:
            self.fx = self.fy = self.fz = 0.0
            return
        self.slip = max(self.slip, size)
        limit = self.friction.at(self.slip) * self.along
        rub = -min(limit / size, 1.0 / (3.5 * (1.0 / a.mass + 1.0 / b.mass)))
        self.fx, self.fy, self.fz = rub * sx, rub * sy, rub * sz


class SoftSpring(Spring):
    """A linear spring that gives back e^2 of the work it took: rubber, or leather.

    On the way out it follows k D (d/D)^q from its greatest depth D, with q = 2/e^2 - 1 for that part of
    the work, and whatever the speed. `stiffness` is per mass, 1/s^2.
    """

    __slots__ = ("stiffness", "restitution", "deepest", "power")

    def __init__(self, balls: tuple[Body, ...], gap: float, step: float, stiffness: float, restitution: float) -> None:
        super().__init__(balls, gap, step)
        self.stiffness = stiffness
        self.restitution = restitution
        self.deepest = 0.0
        self.power = 0.0

    def force(self, depth: float) -> float:
        """Per mass, m/s^2, at a depth that has been come to."""
        if depth >= self.deepest:
            self.deepest = depth
            self.power = 0.0
            return self.stiffness * depth
        if self.power == 0.0:
            speed = self.deepest * math.sqrt(self.stiffness)
            # What is too slow for a number comes back as it came.
            part = speed / rebound(speed, self.restitution) if speed > 0.0 else 1.0
            self.power = 2.0 * (part * part) - 1.0
        return self.stiffness * self.deepest * math.pow(depth / self.deepest, self.power)

    def spent(self, force: float) -> bool:
        """Whether a spring that is being left has relaxed, and lets go."""
        return force < _SPENT * self.stiffness * self.deepest


@final
class NoseSpring(SoftSpring):
    """A ball in a cushion: soft in plan, with friction. A ball alone comes off as `mathavan2010` has it.

    When it lets go it springs back along the rail, after its friction's impulse `along` the rail with a `push`; but it
    gives no more than the `work` that this friction has taken, for other contacts may have driven the ball against it.
    `share` is how many cushions the ball is in, which together must not hold it by more than one would.
    """

    __slots__ = ("ball", "nx", "ny", "name", "share", "nose", "change", "along", "push", "work")

    def __init__(self, ball: Body, element: Element, gap: float, share: int, materials: Materials) -> None:
        nose = materials.cushion_law.nose(ball.radius, materials.of(element))
        super().__init__((ball,), gap, stay(ball) / STEPS, RUBBER / ball.mass, nose.restitution)
        self.ball = ball
        self.nx, self.ny = element.normal(ball.x, ball.y)
        self.name = element.name
        self.share = share
        self.nose: Nose = nose
        self.change = (0.0, 0.0, 0.0, 0.0, 0.0)
        self.along = self.push = self.work = 0.0

    def closing(self) -> float:
        return self.ball.vx * self.nx + self.ball.vy * self.ny

    def part(self, speed: float) -> None:
        self.ball.vx -= speed * self.nx
        self.ball.vy -= speed * self.ny

    def press(self, dt: float) -> bool:
        ball = self.ball
        state = along_nose(ball, self.nx, self.ny)
        self.depth = d = self.depth + state[1] * dt
        if d <= 0.0:
            return self._let_go(state)
        self.met = self.met or d > TOUCH
        force = self.force(d)
        if state[1] < 0.0 and self.spent(force):
            self.depth = 0.0
            return self._let_go(state)
        # The nose stands above the centre: what it gives in plan is less than what it presses with.
        step = force * dt / self.nose.cos
        dvx, dvy, dqx, dqy, dqz = rate(state, self.nose, self.share * step)
        self.change = step * dvx, step * dvy, step * dqx, step * dqy, step * dqz
        if self.nose.tangential > 0.0:
            fx = drag(step * dqz, self.nose)
            self.along += fx
            self.push += step
            self.work -= fx * (slip_along(state, self.nose) + 1.75 * fx)
        return True

    def _let_go(self, state: State) -> bool:
        """Open again; whether the rubber gives the ball something yet, as `press` has it."""
        self.deepest = 0.0
        fx = springing_back(self.along, self.push, self.nose)
        onward = slip_along(state, self.nose) if fx > 0.0 else -slip_along(state, self.nose)
        most = (math.sqrt(onward * onward + 7.0 * max(0.0, self.work)) - onward) / 3.5
        self.along = self.push = self.work = 0.0
        self.change = dragged((0.0, 0.0, 0.0, 0.0, 0.0), math.copysign(min(abs(fx), most), fx), self.nose)
        return fx != 0.0

    def act(self) -> None:
        ball, nx, ny = self.ball, self.nx, self.ny
        vx, vy, qx, qy, qz = self.change
        ball.vx += vx * ny + vy * nx
        ball.vy += vy * ny - vx * nx
        ball.wx += (qx * ny + qy * nx) / ball.radius
        ball.wy += (qy * ny - qx * nx) / ball.radius
        ball.wz += qz / ball.radius


def pace(spring: Spring, longest: float) -> float:
    """How long the next step may be for the sake of a spring, s, up to `longest`."""
    if spring.depth > 0.0:
        return spring.step
    closing = spring.closing()
    # Into the contact, not to its very edge, where rounding would tell whether it is closed.
    return min(longest, 0.5 * spring.step - spring.depth / closing) if closing > 0.0 else longest


def stiffness(a: Body, b: Body) -> float:
    """K of the contact of two balls of the same stuff, N/m^1.5."""
    return STIFFNESS * math.sqrt(2.0 * a.radius * b.radius / ((a.radius + b.radius) * RADIUS))


def depth(a: Body, b: Body, speed: float) -> float:
    """How deep two balls press into each other that meet at `speed`: (5 m v^2 / (4 K))^0.4."""
    mass = a.mass * b.mass / (a.mass + b.mass)
    return math.pow(1.25 * mass * speed * speed / stiffness(a, b), 0.4)


def duration(a: Body, b: Body, speed: float) -> float:
    """How long an impact of two balls at `speed` lasts, s: 3.218 (m^2 / (K^2 v))^0.2."""
    mass = a.mass * b.mass / (a.mass + b.mass)
    k = stiffness(a, b)
    return 3.218 * math.pow(mass * mass / (k * k * speed), 0.2)


def yielding(ball: Body, speed: float) -> float:
    """How far a cushion gives way to a ball that meets it at `speed`, m."""
    return speed * math.sqrt(ball.mass / RUBBER)


def stay(ball: Body) -> float:
    """How long a ball is in a cushion, s."""
    return math.pi * math.sqrt(ball.mass / RUBBER)


@cache
def damping(restitution: float) -> float:
    """The loss, in units of sqrt(m K), that gives a lone pair this restitution, or 0.01 for less: by halving."""
    lo, hi = 0.0, 10.0
    for _ in range(40):
        middle = 0.5 * (lo + hi)
        lo, hi = (middle, hi) if _restitution(middle) > restitution else (lo, middle)
    return 0.5 * (lo + hi)


def _restitution(loss: float) -> float:
    """Of a lone pair with that loss, in units where mass, stiffness and speed are one."""
    depth, speed, dt = 0.0, 1.0, 3.218 / STEPS
    while True:
        depth += speed * dt
        if depth <= 0.0:
            return -speed
        speed -= dt * max(0.0, depth**1.5 + loss * depth**0.25 * speed)
