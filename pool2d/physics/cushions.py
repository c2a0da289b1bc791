"""How a cushion returns a ball: the laws a preset can name.

In the frame of the contact X runs along the cushion, Y into it, Z up. The nose stands above the ball's
centre: with th the angle at which the ball sees it, sin th = h/R - 1, the contact is at
R (0, cos th, sin th) from the centre, and the slip of the ball's surface there is
sX = vX + R wY sin th - R wZ cos th along the cushion, sY = -vY sin th + R wX up across it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from .gentle import rebound

if TYPE_CHECKING:
    from .motion import Body
    from .params import Physics

CushionLaw = Callable[["Body", float, float, "Physics"], None]

# Steps of the integration of `mathavan2010`, for each of compression and restitution. Of the speeds
# after a rebound the largest error is 3e-4 of the speed before it, against 20,000 steps.
STEPS = 16
# A slip below this part of the approach speed has ended: the surfaces grip.
GRIP = 0.001
# Many times the steps that a contact takes which does not jam.
_ENOUGH = 20


def impulse(ball: Body, nx: float, ny: float, physics: Physics) -> None:
    """P = j (n - f v_s / |v_s|) with the cushion as a level wall of infinite mass.

    (nx, ny) points into the cushion. ("physic-based billiard simulation", 2002.)
    """
    approach = ball.vx * nx + ball.vy * ny
    if approach <= 0.0:
        return
    push = ball.mass * (approach + rebound(approach, physics.cushion.restitution))
    _kick(ball, nx, ny, push, 0.0, 1.0, physics.cushion.friction)


def han2005(ball: Body, nx: float, ny: float, physics: Physics) -> None:
    """A free sphere struck at the nose; the velocity it gets upward or downward is dropped.

    (Han 2005, "Dynamics in carom and three cushion billiards", as physics engines quote it.)
    """
    approach = ball.vx * nx + ball.vy * ny
    if approach <= 0.0:
        return
    sin = physics.cushion.nose_height / ball.radius - 1.0
    cos = math.sqrt(1.0 - sin * sin)
    push = ball.mass * cos * (approach + rebound(approach, physics.cushion.restitution))
    _kick(ball, nx, ny, push, sin, cos, physics.cushion.friction)


def _kick(ball: Body, nx: float, ny: float, push: float, sin: float, cos: float, friction: float) -> None:
    """Apply a normal impulse at the nose and the friction it allows, at most what stops the slip."""
    vx, vy = ball.vx * ny - ball.vy * nx, ball.vx * nx + ball.vy * ny
    radius = ball.radius
    qx, qy, qz = radius * (ball.wx * ny - ball.wy * nx), radius * (ball.wx * nx + ball.wy * ny), radius * ball.wz
    sx, sy = vx + qy * sin - qz * cos, qx - vy * sin
    slip = math.hypot(sx, sy)
    rub = 0.0 if slip == 0.0 else -min(friction * push, 2.0 / 7.0 * ball.mass * slip) / (slip * ball.mass)
    fx, fy = rub * sx, rub * sy
    vx += fx
    vy -= push / ball.mass * cos + fy * sin
    _give(ball, nx, ny, vx, vy, qx + 2.5 * fy, qy + 2.5 * fx * sin, qz - 2.5 * fx * cos)


def _give(ball: Body, nx: float, ny: float, vx: float, vy: float, qx: float, qy: float, qz: float) -> None:
    """Set a ball's velocity and spin (times its radius) from the frame of the contact.

    A ball that a model leaves in the cushion, jammed by friction or without restitution, is let go gently.
    """
    vy = min(vy, -0.1 * rebound(ball.vx * nx + ball.vy * ny, 0.0))
    ball.vx, ball.vy = vx * ny + vy * nx, vy * ny - vx * nx
    ball.wx, ball.wy = (qx * ny + qy * nx) / ball.radius, (qy * ny - qx * nx) / ball.radius
    ball.wz = qz / ball.radius


def mathavan2010(ball: Body, nx: float, ny: float, physics: Physics) -> None:
    """Impulse by impulse, with friction at the nose and, as the nose presses the ball down, at the cloth.

    The state is integrated over the cushion's normal impulse: first until the ball has stopped going
    in, then until the cushion has given back e^2 of the work it took. (Mathavan, Jackson and Parkin,
    Proc. IMechE C 224:1863-1873, 2010, eqs. 12-17.)
    """
    approach = ball.vx * nx + ball.vy * ny
    if approach <= 0.0:
        return
    restitution = rebound(approach, physics.cushion.restitution) / approach
    sin = physics.cushion.nose_height / ball.radius - 1.0
    cos = math.sqrt(1.0 - sin * sin)
    contact = (sin, cos, physics.cushion.friction, physics.cloth.mu_slide, GRIP * approach)
    radius = ball.radius
    state = (
        ball.vx * ny - ball.vy * nx, approach,
        radius * (ball.wx * ny - ball.wy * nx), radius * (ball.wx * nx + ball.wy * ny), radius * ball.wz,
    )  # fmt: skip
    step = approach / (cos * STEPS)
    work = 0.0
    for _ in range(_ENOUGH * STEPS):
        rate, part = _middle(state, contact, step)
        last = state[1] + part * rate[1] <= 0.0
        part = -state[1] / rate[1] if last else part
        after = _moved(state, rate, part)
        work += 0.5 * (state[1] + after[1]) * cos * part
        state = after
        if last:
            break
    work *= restitution * restitution
    for _ in range(_ENOUGH * STEPS):
        rate, part = _middle(state, contact, step)
        # Within a step the cushion gives back (-vY + |vY'| part / 2) cos part.
        out, gain = -state[1], -rate[1]
        square = out * out + 2.0 * gain * work / cos
        reach = out + math.sqrt(square) if square > 0.0 else 0.0
        whole = 2.0 * work / cos / reach if reach > 0.0 else math.inf
        last = whole <= part
        part = whole if last else part
        work -= (out + 0.5 * gain * part) * cos * part
        state = _moved(state, rate, part)
        if last:
            break
    _give(ball, nx, ny, *state)


_State = tuple[float, float, float, float, float]


def _moved(state: _State, rate: _State, step: float) -> _State:
    return (
        state[0] + step * rate[0], state[1] + step * rate[1],
        state[2] + step * rate[2], state[3] + step * rate[3], state[4] + step * rate[4],
    )  # fmt: skip


def _middle(state: _State, contact: _State, step: float) -> tuple[_State, float]:
    """The rate in the middle of a step, and the step: it is cut short where a slip ends."""
    rate = _rate(state, contact, step)
    step = _until_grip(state, rate, contact, step)
    rate = _rate(_moved(state, rate, 0.5 * step), contact, step)
    return rate, _until_grip(state, rate, contact, step)


def _until_grip(state: _State, rate: _State, contact: _State, step: float) -> float:
    """How far `rate` holds: `step`, or to where the slip at the nose or at the cloth is at its least."""
    vx, vy, qx, qy, qz = state
    ax, ay, bx, by, bz = rate
    sin, cos, _, _, grip = contact
    nose = _until(vx + qy * sin - qz * cos, qx - vy * sin, ax + by * sin - bz * cos, bx - ay * sin, grip)
    return min(step, nose, _until(vx - qy, vy + qx, ax - by, ay + bx, grip))


def _until(x: float, y: float, rate_x: float, rate_y: float, grip: float) -> float:
    """How far it is until the slip (x, y), changing at that rate, is at its least."""
    square, toward = x * x + y * y, -(x * rate_x + y * rate_y)
    return square / toward if square > grip * grip and toward > 0.0 else math.inf


def _rate(state: _State, contact: _State, step: float) -> _State:
    """What a unit of the nose's impulse, per mass, does to (vX, vY, R wX, R wY, R wZ)."""
    vx, vy, qx, qy, qz = state
    sin, cos, nose, cloth, grip = contact
    sx, sy = vx + qy * sin - qz * cos, qx - vy * sin
    ux, uy = vx - qy, vy + qx
    across, along = 2.5 - sin, 1.0 - 2.5 * sin
    gx = gy = 0.0
    # Where a surface grips, what holds it depends on the other's friction: one more round.
    for _ in range(2):
        fx, fy = _friction(sx, sy, along * gx, sin * cos + across * gy, 2.5 + sin * sin, nose, grip, step)
        # The nose and its friction press the ball on the cloth, or lift it and leave the cloth nothing.
        weight = max(0.0, sin - fy * cos)
        gx, gy = _friction(ux, uy, along * fx, across * fy - cos, 3.5, cloth * weight, grip, step)
        if sx * sx + sy * sy > grip * grip:
            break
    return fx + gx, gy - cos - fy * sin, 2.5 * (fy + gy), 2.5 * (fx * sin - gx), -2.5 * fx * cos


def _friction(
    x: float, y: float, drive_x: float, drive_y: float, ease_y: float, limit: float, grip: float, step: float
) -> tuple[float, float]:
    """Coulomb friction, `limit` at most, of a surface with the slip (x, y).

    Below a slip of `grip` the surface holds: the friction is what ends the slip in a step, against what
    else (drive_x, drive_y) does to it. A unit of friction takes 7/2 off a slip along x, `ease_y` along y.
    """
    slip = math.sqrt(x * x + y * y)
    if slip <= grip:
        x, y = (x / step + drive_x) / 3.5, (y / step + drive_y) / ease_y
        slip = math.sqrt(x * x + y * y)
        if slip <= limit:
            return -x, -y
    return -limit * x / slip, -limit * y / slip


CUSHION_LAWS: dict[str, CushionLaw] = {"impulse": impulse, "han2005": han2005, "mathavan2010": mathavan2010}
