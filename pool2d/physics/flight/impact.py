"""How a ball in the air parts from what it meets: impulses in three dimensions.

P = j (n - f s/|s|), as on the level: j from restitution along the normal n, friction f against the slip s of
the surfaces, no more of it than what stops the slip (2/7 of it for a ball on what does not move).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final, final

if TYPE_CHECKING:
    from ..body import Body
    from ..laws.law import BallNumbers

Vector = tuple[float, float, float]

# A ball that would come off the ground more slowly than this stays on it, m/s: its hop would be 20 micrometres high,
# less than the cloth is rough, and over within 4 ms.
LEAST: Final = 0.02
# Two that meet in the air more slowly than this part as fast as they met, m/s. What gravity holds together, as a ball
# that lies on others or rolls over an edge, then hops along for some milliseconds at a time and 20 micrometres high:
# else it would take endlessly many bounces in a finite time.
GENTLE: Final = 0.02
# A ball that has only slid along something leaves it at no more than this part of the speed at which it slid.
STEEPEST: Final = 0.3


@final
class Surface:
    """What a ball may come down on, or fly against: restitution and friction."""

    __slots__ = ("restitution", "friction")

    def __init__(self, restitution: float, friction: float) -> None:
        self.restitution = restitution
        self.friction = friction


def against(ball: Body, n: Vector, surface: Surface) -> None:
    """Part a ball from what does not move; n is the unit vector from the ball into it."""
    nx, ny, nz = n
    approach = ball.vx * nx + ball.vy * ny + ball.vz * nz
    if approach <= 0.0:
        return
    _push(ball, n, approach, _parting(approach, surface.restitution), surface.friction)


def _push(ball: Body, n: Vector, approach: float, parting: float, friction: float) -> None:
    """Let a ball that approaches along n part again, with the friction that this allows."""
    nx, ny, nz = n
    along, radius = approach + parting, ball.radius
    # The surface of the ball moves at v + w x R n where it touches.
    sx = ball.vx + radius * (ball.wy * nz - ball.wz * ny) - approach * nx
    sy = ball.vy + radius * (ball.wz * nx - ball.wx * nz) - approach * ny
    sz = ball.vz + radius * (ball.wx * ny - ball.wy * nx) - approach * nz
    size = math.sqrt(sx * sx + sy * sy + sz * sz)
    rub = 0.0 if size == 0.0 else -min(friction * along / size, 2.0 / 7.0)
    fx, fy, fz = rub * sx, rub * sy, rub * sz
    ball.vx += fx - along * nx
    ball.vy += fy - along * ny
    ball.vz += fz - along * nz
    turn = 2.5 / radius
    ball.wx += turn * (ny * fz - nz * fy)
    ball.wy += turn * (nz * fx - nx * fz)
    ball.wz += turn * (nx * fy - ny * fx)


def land(ball: Body, floor: float, surface: Surface) -> None:
    """A ball comes down at the height `floor`, m: it hops on, or stays there.

    Speed up after = e times that down; friction min(mu (1 + e) |vz|, 2/7 |u|) against the slip u; wz stays.
    """
    ball.z = floor
    ball.held = 0
    up = -surface.restitution * ball.vz
    _push(ball, (0.0, 0.0, -1.0), -ball.vz, up if up >= LEAST else 0.0, surface.friction)
    # What is left of a speed that has been taken away is rounding.
    ball.vz = up if up >= LEAST else 0.0


def between(a: Body, b: Body) -> Vector:
    """The unit vector from one ball's centre to another's."""
    dx, dy, dz = b.x - a.x, b.y - a.y, b.z + b.radius - a.z - a.radius
    size = math.sqrt(dx * dx + dy * dy + dz * dz)
    return dx / size, dy / size, dz / size


def nearing(a: Body, b: Body) -> float:
    """How fast two balls near each other, m/s."""
    nx, ny, nz = between(a, b)
    return (a.vx - b.vx) * nx + (a.vy - b.vy) * ny + (a.vz - b.vz) * nz


def collide(a: Body, b: Body, numbers: BallNumbers) -> None:
    """Two balls meet of which one at least is in the air: both are free, whatever lies under them answers later."""
    nx, ny, nz = between(a, b)
    dvx, dvy, dvz = a.vx - b.vx, a.vy - b.vy, a.vz - b.vz
    approach = dvx * nx + dvy * ny + dvz * nz
    if approach <= 0.0:
        return
    ease = 1.0 / a.mass + 1.0 / b.mass
    along = (approach + _parting(approach, numbers.restitution)) / ease
    px, py = a.radius * a.wx + b.radius * b.wx, a.radius * a.wy + b.radius * b.wy
    pz = a.radius * a.wz + b.radius * b.wz
    sx = dvx + py * nz - pz * ny - approach * nx
    sy = dvy + pz * nx - px * nz - approach * ny
    sz = dvz + px * ny - py * nx - approach * nz
    size = math.sqrt(sx * sx + sy * sy + sz * sz)
    rub = 0.0 if size == 0.0 else -min(numbers.friction.at(size) * along, size / (3.5 * ease)) / size
    fx, fy, fz = rub * sx, rub * sy, rub * sz
    jx, jy, jz = fx - along * nx, fy - along * ny, fz - along * nz
    a.vx, a.vy, a.vz = a.vx + jx / a.mass, a.vy + jy / a.mass, a.vz + jz / a.mass
    b.vx, b.vy, b.vz = b.vx - jx / b.mass, b.vy - jy / b.mass, b.vz - jz / b.mass
    # Both arms point at the contact and the impulses are opposite, so both balls turn the same way.
    mx, my, mz = ny * fz - nz * fy, nz * fx - nx * fz, nx * fy - ny * fx
    for ball in (a, b):
        turn = 2.5 / (ball.mass * ball.radius)
        ball.wx += turn * mx
        ball.wy += turn * my
        ball.wz += turn * mz


def glance(ball: Body, n: Vector, least: float) -> None:
    """See to it that a ball leaves what it has touched at `least`, m/s, or more, at the energy that it has."""
    nx, ny, nz = n
    out = -(ball.vx * nx + ball.vy * ny + ball.vz * nz)
    tx, ty, tz = ball.vx + out * nx, ball.vy + out * ny, ball.vz + out * nz
    slide = math.sqrt(tx * tx + ty * ty + tz * tz)
    least = min(least, STEEPEST * slide)
    if out >= least:
        return
    part = math.sqrt(1.0 - (least * least - out * out) / (slide * slide)) * (1.0 - 1e-15)
    ball.vx, ball.vy, ball.vz = part * tx - least * nx, part * ty - least * ny, part * tz - least * nz


def _parting(approach: float, restitution: float) -> float:
    """How fast two part in the air that met at `approach`, m/s.

    What gravity holds together hops along, gently, at the energy that it has.
    """
    return max(restitution * approach, min(approach, GENTLE))
