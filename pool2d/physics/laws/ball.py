"""How two balls exchange impulse: the laws a preset can name.

The unit normal n points from the first ball to the second. Between balls of unequal radius on one
cloth it is tilted, climbing toward the larger. The slate takes the vertical part of what a ball gets;
its moment stays. The slip of the first ball's surface against the second's is
s = (v1 - v2) + (R1 w1 + R2 w2) x n, less its part along n.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from .rebound import rebound

if TYPE_CHECKING:
    from ..body import Body
    from ..params import Physics

Friction = Callable[[float, "Physics"], float]
BallLaw = Callable[["Body", "Body", "Physics"], None]
Vector = tuple[float, float, float]

# Steps of the integration of `mathavan2014`, for each of compression and restitution.
STEPS = 40
# Many times the steps that a contact takes.
_ENOUGH = 4


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
    for ball in (a, b):
        turn = 2.5 / (ball.mass * ball.radius)
        ball.wx += turn * mx
        ball.wy += turn * my
        ball.wz += turn * mz


def _collide(a: Body, b: Body, physics: Physics, friction: Friction) -> None:
    """P = j (n - f v_s / |v_s|): j from restitution, friction no more than what stops the slip."""
    n = normal(a, b)
    nx, ny, nz = n
    approach = (a.vx - b.vx) * nx + (a.vy - b.vy) * ny
    if approach <= 0.0:
        return
    ease, flat = 1.0 / a.mass + 1.0 / b.mass, 1.0 - nz * nz
    along = (approach + rebound(approach, physics.ball.restitution)) / (flat * ease)
    sx, sy, sz = slip(a, b, n, approach)
    # A tilted push changes the slip; friction answers to what it leaves, or it might drive the balls.
    tilt = along * ease * nz
    sx, sy, sz = sx - tilt * nx * nz, sy - tilt * ny * nz, sz + tilt * flat
    size = math.sqrt(sx * sx + sy * sy + sz * sz)
    rub = 0.0 if size == 0.0 else -min(friction(size, physics) * along, size / (3.5 * ease)) / size
    push(a, b, n, along, rub * sx, rub * sy, rub * sz)


def impulse(a: Body, b: Body, physics: Physics) -> None:
    """Restitution, and friction with one coefficient. ("physic-based billiard simulation", 2002.)"""
    _collide(a, b, physics, constant)


def alciatore(a: Body, b: Body, physics: Physics) -> None:
    """As `impulse`, with friction that falls as the slip grows. (Alciatore TP A.14, eqs. 15-17.)"""
    _collide(a, b, physics, falling)


def frictionless(a: Body, b: Body, physics: Physics) -> None:
    """Restitution alone."""
    _collide(a, b, physics, none)


def constant(slip: float, physics: Physics) -> float:
    """The coefficient of friction that the preset gives."""
    return physics.ball.friction * physics.ball.cling


def falling(slip: float, physics: Physics) -> float:
    """mu(s) through Marlow's measurements, s in m/s. (Alciatore TP A.14, p. 4.)"""
    return (9.951e-3 + 0.108 * math.exp(-1.088 * slip)) * physics.ball.cling


def none(slip: float, physics: Physics) -> float:
    return 0.0


def mathavan2014(a: Body, b: Body, physics: Physics) -> None:
    """Impulse by impulse, with friction between the balls and of the one that is pressed on the cloth.

    Integrated over the normal impulse: until the balls no longer near, then until what they have given
    back is e^2 of the work it took. (Mathavan, Jackson and Parkin, Sports Engineering 17:227-237, 2014.)
    """
    n = normal(a, b)
    nx, ny, nz = n
    approach = (a.vx - b.vx) * nx + (a.vy - b.vy) * ny
    if approach <= 0.0:
        return
    restitution = rebound(approach, physics.ball.restitution) / approach
    ease = (1.0 - nz * nz) * (1.0 / a.mass + 1.0 / b.mass)
    step = approach / ease / STEPS
    closing, work = approach, 0.0
    for _ in range(_ENOUGH * STEPS):
        part = min(step, closing / ease)
        after = _nudge(a, b, n, closing, part, physics)
        work += 0.5 * (closing + after) * part
        closing = after
        if closing <= 1e-9 * approach:
            break
    left = restitution * restitution * work
    for _ in range(_ENOUGH * STEPS):
        if left <= 1e-12 * work:
            break
        # A step gives back (-closing + ease part / 2) part.
        part = min(step, 2.0 * left / (math.sqrt(closing * closing + 2.0 * ease * left) - closing))
        after = _nudge(a, b, n, closing, part, physics)
        left += 0.5 * (closing + after) * part
        closing = after
    # Without restitution they would stay together: they part gently.
    stay = closing + 0.1 * rebound(approach, 0.0)
    if stay > 0.0:
        push(a, b, n, stay / ease, 0.0, 0.0, 0.0)


def _nudge(a: Body, b: Body, n: Vector, closing: float, part: float, physics: Physics) -> float:
    """One step of the normal impulse, with the friction it brings; the speed of nearing after it."""
    sx, sy, sz = slip(a, b, n, closing)
    size = math.sqrt(sx * sx + sy * sy + sz * sz)
    most = size / (3.5 * (1.0 / a.mass + 1.0 / b.mass))
    rub = 0.0 if size == 0.0 else -min(constant(size, physics) * part, most) / size
    push(a, b, n, part, rub * sx, rub * sy, rub * sz)
    down = part * n[2] - rub * sz
    _scrub(a if down > 0.0 else b, physics.cloth.mu_slide * abs(down))
    return (a.vx - b.vx) * n[0] + (a.vy - b.vy) * n[1]


def _scrub(ball: Body, limit: float) -> None:
    """Friction with the cloth while a ball is pressed on it: an impulse of `limit` at most."""
    ux, uy = ball.vx - ball.radius * ball.wy, ball.vy + ball.radius * ball.wx
    size = math.hypot(ux, uy)
    if size > 0.0:
        part = -min(limit / ball.mass, 2.0 / 7.0 * size) / size
        ball.vx += part * ux
        ball.vy += part * uy
        ball.wx += 2.5 * part * uy / ball.radius
        ball.wy -= 2.5 * part * ux / ball.radius


BALL_LAWS: dict[str, BallLaw] = {
    "impulse": impulse,
    "alciatore": alciatore,
    "mathavan2014": mathavan2014,
    "frictionless": frictionless,
}
FRICTION: dict[str, Friction] = {
    "impulse": constant,
    "alciatore": falling,
    "mathavan2014": constant,
    "frictionless": none,
}
