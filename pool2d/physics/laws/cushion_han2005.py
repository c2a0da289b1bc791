"""A free sphere struck at the nose. (Han 2005.)"""

from __future__ import annotations

from ..body import Body
from .law import CushionLaw, CushionNumbers, Nose
from .nose import kick, seen
from .rebound import rebound


def collide(ball: Body, nx: float, ny: float, numbers: CushionNumbers) -> None:
    """A free sphere struck at the nose; the velocity it gets upward or downward is dropped.

    (Han 2005, "Dynamics in carom and three cushion billiards", as physics engines quote it.)
    """
    approach = ball.vx * nx + ball.vy * ny
    if approach <= 0.0:
        return
    nose = lifting(ball.radius, numbers)
    push = ball.mass * nose.cos * (approach + rebound(approach, numbers.restitution))
    kick(ball, nx, ny, push, nose)


def lifting(radius: float, numbers: CushionNumbers) -> Nose:
    """As the slate holds the ball down, what `han2005` loses upward or downward is a loss at the nose."""
    sin, cos = seen(radius, numbers)
    restitution = cos * cos * (1.0 + numbers.restitution) - 1.0
    return Nose(sin, cos, numbers.friction, 0.0, max(0.0, restitution), numbers.tangential)


LAW = CushionLaw("han2005", collide, lifting)
