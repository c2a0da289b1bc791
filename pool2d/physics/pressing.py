"""Lasting contacts: a ball that the cloth's friction keeps pressing against another ball or a cushion.

As impacts alone such a contact is a row of ever lower bounces, endlessly many in a finite time. So while it
lasts, the cloth gives its friction in portions: where friction would, within a moment, bring two bodies
together faster than they meet now, the ball gets that moment's friction at once, before the contact is
solved, and then moves without friction until the moment is over. The friction's impulse is exact, at most a
moment early. Between two portions the ball hops off what it leans on, by no more than eight times the way on
which a moment's friction takes a ball from rest: 0.03 mm, or, for a ball that would slide on for more than 64
moments, 0.2 % of the way on which it would slide. (Moreau's time stepping, for these contacts alone; a pair
driven by spin goes a way that is 4 to 8 % too long, see the tests.)
"""

from __future__ import annotations

import math
from typing import Final, final

from .body import Body, Velocity
from .motion import ClothNumbers, Motion, start

# How far a moment's friction moves a ball that lies still at the least, m.
HOP: Final = 4e-6
# A moment is at least this part of the time for which the ball would still slide.
SHARE: Final = 1.0 / 64.0


@final
class Side:
    """A ball in a contact, and the unit vector from it to what it touches."""

    __slots__ = ("ball", "nx", "ny")

    def __init__(self, ball: Body, nx: float, ny: float) -> None:
        self.ball = ball
        self.nx = nx
        self.ny = ny


def press(sides: list[Side], approach: float, now: float, cloth: ClothNumbers) -> list[Motion]:
    """Give the balls of a contact a moment's friction if that adds more than `approach` to how fast they meet, m/s.

    Returns the motions, each without friction, of the balls that have been given it: none where the contact
    is an impact, or the friction drives the balls apart.
    """
    gain = 0.0
    found = []
    for side in sides:
        ball = side.ball
        if now >= ball.paid:
            velocity, until = _portion(ball, now, cloth)
            more = (velocity[0] - ball.vx) * side.nx + (velocity[1] - ball.vy) * side.ny
            if more > 0.0:
                gain += more
                found.append((ball, velocity, until))
    if approach >= gain:
        return []
    for ball, velocity, until in found:
        ball.set_velocity(velocity)
        ball.paid = until
    return [start(ball, now, cloth) for ball, _, _ in found]


def _portion(ball: Body, now: float, cloth: ClothNumbers) -> tuple[Velocity, float]:
    """A ball's velocity and spin after a moment's friction, and when that is over; the ball stays as it is."""
    x, y, t, velocity = ball.x, ball.y, ball.t, ball.velocity()
    motion = start(ball, now, cloth)
    until = now + max(math.sqrt(2.0 * HOP / (cloth.mu_slide * cloth.gravity)), SHARE * (motion.t1 - now))
    motion.move(ball, min(until, motion.t1))
    after = ball.velocity()
    ball.x, ball.y, ball.t = x, y, t
    ball.set_velocity(velocity)
    return after, until
