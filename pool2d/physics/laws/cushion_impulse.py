"""A cushion as a level wall of infinite mass. ("physic-based billiard simulation", 2002.)"""

from __future__ import annotations

from ..body import Body
from .law import CushionLaw, CushionNumbers, Nose
from .nose import kick
from .rebound import rebound


def collide(ball: Body, nx: float, ny: float, numbers: CushionNumbers) -> None:
    """P = j (n - f v_s / |v_s|) with the cushion as a level wall of infinite mass.

    (nx, ny) points into the cushion. ("physic-based billiard simulation", 2002.)
    """
    approach = ball.vx * nx + ball.vy * ny
    if approach <= 0.0:
        return
    push = ball.mass * (approach + rebound(approach, numbers.restitution))
    kick(ball, nx, ny, push, level(ball.radius, numbers))


def level(radius: float, numbers: CushionNumbers) -> Nose:
    """A level wall, which does not spring back along itself."""
    return Nose(0.0, 1.0, numbers.friction, 0.0, numbers.restitution, 0.0)


LAW = CushionLaw("impulse", collide, level)
