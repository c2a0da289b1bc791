"""Impulse by impulse, with friction at the cloth as well."""

from __future__ import annotations

import math
from typing import Final

from ..body import Body
from .law import BallLaw, BallNumbers
from .pair import Vector, constant, normal, push, slip
from .rebound import rebound

# Steps of the integration, for each of compression and restitution.
STEPS: Final = 40
# Many times the steps that a contact takes.
_ENOUGH: Final = 4


def collide(a: Body, b: Body, numbers: BallNumbers) -> None:
    """Impulse by impulse, with friction between the balls and of the one that is pressed on the cloth.

    Integrated over the normal impulse: until the balls no longer near, then until what they have given
    back is e^2 of the work it took. (Mathavan, Jackson and Parkin, Sports Engineering 17:227-237, 2014.)
    """
    n = normal(a, b)
    nx, ny, nz = n
    approach = (a.vx - b.vx) * nx + (a.vy - b.vy) * ny
    if approach <= 0.0:
        return
    restitution = rebound(approach, numbers.restitution) / approach
    ease = (1.0 - nz * nz) * (1.0 / a.mass + 1.0 / b.mass)
    step = approach / ease / STEPS
    closing, work = approach, 0.0
    for _ in range(_ENOUGH * STEPS):
        part = min(step, closing / ease)
        after = _nudge(a, b, n, closing, part, numbers)
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
        after = _nudge(a, b, n, closing, part, numbers)
        left += 0.5 * (closing + after) * part
        closing = after
    # Without restitution they would stay together: they part gently.
    stay = closing + 0.1 * rebound(approach, 0.0)
    if stay > 0.0:
        push(a, b, n, stay / ease, 0.0, 0.0, 0.0)


def _nudge(a: Body, b: Body, n: Vector, closing: float, part: float, numbers: BallNumbers) -> float:
    """One step of the normal impulse, with the friction it brings; the speed of nearing after it."""
    sx, sy, sz = slip(a, b, n, closing)
    size = math.sqrt(sx * sx + sy * sy + sz * sz)
    most = size / (3.5 * (1.0 / a.mass + 1.0 / b.mass))
    rub = 0.0 if size == 0.0 else -min(numbers.friction.at(size) * part, most) / size
    push(a, b, n, part, rub * sx, rub * sy, rub * sz)
    down = part * n[2] - rub * sz
    _scrub(a if down > 0.0 else b, numbers.cloth * abs(down))
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


LAW = BallLaw("mathavan2014", collide, constant)
