"""Solving a contact: which law, and whether a ball that is struck passes it on at once."""

from __future__ import annotations

import math

from .balls import BALL_LAWS
from .cluster import depth, gather, solve
from .cushions import CUSHION_LAWS
from .motion import Body, start
from .params import Physics

# Bodies that meet more slowly than this, m/s, are being pressed together by the cloth's friction.
# They then feel the friction of the next moment, s, at once, so that they part with a speed and the
# pressing becomes a few small bounces; it is the same impulse, that much earlier.
PRESSED, MOMENT = 1e-4, 2e-3


class Contacts:
    """How things that meet on one table part again."""

    def __init__(self, physics: Physics) -> None:
        self.physics = physics
        self.ball_law = BALL_LAWS[physics.ball.law]
        self.cushion_law = CUSHION_LAWS[physics.cushion.law]

    def cushion(self, ball: Body, nx: float, ny: float) -> None:
        """A ball meets a cushion that lies along (nx, ny) from it.

        A cushion gives way for some ms, ten times as long as two balls touch. So a ball that lies on
        a cushion first takes a blow from another ball as if it were free, and then meets the cushion.
        """
        if ball.vx * nx + ball.vy * ny < PRESSED:
            self._hasten(ball)
        self.cushion_law(ball, nx, ny, self.physics)

    def balls(self, a: Body, b: Body, present: list[Body]) -> list[tuple[Body, Body]]:
        """Two balls meet among those `present`; the pairs that took part, this one first.

        Where others are so near that they are reached while the impact lasts, it is a cluster.
        """
        if _approach(a, b) < PRESSED:
            self._hasten(a)
            self._hasten(b)
        speed = _approach(a, b)
        if speed > 0.0:
            pairs = gather(a, b, present, depth(a, b, speed))
            if len(pairs) > 1:
                before = [(ball, ball.velocity()) for ball in present]
                met = [(contact.a, contact.b) for contact in solve(pairs, speed, self.physics)]
                if len(met) > 1:
                    return [(a, b), *(pair for pair in met if pair != (a, b))]
                for ball, velocity in before:
                    ball.set_velocity(velocity)
        self.ball_law(a, b, self.physics)
        return [(a, b)]

    def _hasten(self, ball: Body) -> None:
        """Give a ball the cloth's friction of the next moment at once."""
        x, y = ball.x, ball.y
        motion = start(ball, 0.0, self.physics.cloth, self.physics.gravity)
        motion.move(ball, min(MOMENT, motion.t1))
        ball.x, ball.y = x, y


def _approach(a: Body, b: Body) -> float:
    """How fast two balls near each other in plan, m/s."""
    dx, dy = b.x - a.x, b.y - a.y
    return ((a.vx - b.vx) * dx + (a.vy - b.vy) * dy) / math.hypot(dx, dy)
