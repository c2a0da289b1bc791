"""Two balls that touch: normal, slip, the push between them, and the impact that most laws share.

The unit normal n points from the first ball to the second. Between balls of unequal radius on one
cloth it is tilted, climbing toward the larger. The slate takes the vertical part of what a ball gets;
its moment stays. The slip of the first ball's surface against the second's is
s = (v1 - v2) + (R1 w1 + R2 w2) x n, less its part along n.
"""

from __future__ import annotations

import math

from ..body import Body
from .law import BallNumbers, Friction
from .rebound import rebound

Vector = tuple[float, float, float]


def normal(a: Body, b: Body) -> Vector:
    """The unit vector from one ball to another that it touches."""
    dx, dy = b.x - a.x, b.y - a.y
    total = a.radius + b.radius
    flat = 2.0 * math.sqrt(a.radius * b.radius) / (total * math.hypot(dx, dy))
    return flat * dx, flat * dy, (b.radius - a.radius) / total


def slip(a: Body, b: Body, n: Vector, approach: float) -> Vector:
    """The slip of a's surface against b's, m/s; `approach` is the speed at which they near along n."""
    nx, ny, nz = n
    px, py = a.radius * a.wx + b.radius * b.wx, a.radius * a.wy + b.radius * b.wy
    pz = a.radius * a.wz + b.radius * b.wz
    return (
        a.vx - b.vx + py * nz - pz * ny - approach * nx,
        a.vy - b.vy + pz * nx - px * nz - approach * ny,
        px * ny - py * nx - approach * nz,
    )


def push(a: Body, b: Body, n: Vector, along: float, fx: float, fy: float, fz: float) -> None:
    """Give a the impulse -along n + f, and b its opposite."""
    nx, ny, nz = n
    # Both arms point at the contact and the impulses are opposite, so both balls turn the same way.
    mx, my, mz = ny * fz - nz * fy, nz * fx - nx * fz, nx * fy - ny * fx
    jx, jy = fx - along * nx, fy - along * ny
    a.vx += jx / a.mass
    a.vy += jy / a.mass
    b.vx -= jx / b.mass
    b.vy -= jy / b.mass
    turn = 2.5 / (a.mass * a.radius)
    a.wx += turn * mx
    a.wy += turn * my
    a.wz += turn * mz
    turn = 2.5 / (b.mass * b.radius)
    b.wx += turn * mx
    b.wy += turn * my
    b.wz += turn * mz


def collide(a: Body, b: Body, numbers: BallNumbers) -> None:
    """P = j (n - f v_s / |v_s|): j from restitution, friction f(|v_s|), no more of it than what stops the slip."""
    n = normal(a, b)
    nx, ny, nz = n
    approach = (a.vx - b.vx) * nx + (a.vy - b.vy) * ny
    if approach <= 0.0:
        return
    ease, flat = 1.0 / a.mass + 1.0 / b.mass, 1.0 - nz * nz
    along = (approach + rebound(approach, numbers.restitution)) / (flat * ease)
    sx, sy, sz = slip(a, b, n, approach)
    # A tilted push changes the slip; friction answers to what it leaves, or it might drive the balls.
    tilt = along * ease * nz
    sx, sy, sz = sx - tilt * nx * nz, sy - tilt * ny * nz, sz + tilt * flat
    size = math.sqrt(sx * sx + sy * sy + sz * sz)
    rub = 0.0 if size == 0.0 else -min(numbers.friction.at(size) * along, size / (3.5 * ease)) / size
    push(a, b, n, along, rub * sx, rub * sy, rub * sz)


def constant(level: Friction, falling: Friction) -> Friction:
    """The coefficient of friction that the preset gives for any slip."""
    return level
