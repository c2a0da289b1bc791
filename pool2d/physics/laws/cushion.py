"""How a cushion returns a ball: the laws a preset can name.

In the frame of the contact X runs along the cushion, Y into it, Z up. The nose stands above the ball's
centre: with th the angle at which the ball sees it, sin th = h/R - 1, the contact is at
R (0, cos th, sin th) from the centre, and the slip of the ball's surface there is
sX = vX + R wY sin th - R wZ cos th along the cushion, sY = -vY sin th + R wX up across it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from ..energy import take_back
from .rebound import rebound

if TYPE_CHECKING:
    from ..body import Body
    from ..params import Physics

CushionLaw = Callable[["Body", float, float, "Physics"], None]
State = tuple[float, float, float, float, float]


class Nose(NamedTuple):
    """What a ball feels at a nose: th, the friction of the rubber and that of the cloth under the ball, and e."""

    sin: float
    cos: float
    rubber: float
    cloth: float
    restitution: float


# Steps of the integration of `mathavan2010`, for each of compression and restitution. Against 2,000
# steps the speeds after a rebound are off by 0.11 % of the speed before it at the most, 0.02 % on
# average, and the spins times the radius by 1 %; with a snooker cushion by twice that. The largest are
# where a slip turns about within a step. (`python -m pytest tests/physics/laws/test_steps.py`)
STEPS = 16
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
    sin, cos = _seen(ball.radius, physics)
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
    nose = _pressing(ball.radius, physics)
    restitution = rebound(approach, nose.restitution) / approach
    cos = nose.cos
    state = along_nose(ball, nx, ny)
    step = approach / (cos * STEPS)
    work = 0.0
    for _ in range(_ENOUGH * STEPS):
        change = rate(state, nose, step)
        last = state[1] + step * change[1] <= 0.0
        part = -state[1] / change[1] if last else step
        after = _moved(state, change, part)
        work += 0.5 * (state[1] + after[1]) * cos * part
        state = after
        if last:
            break
    work *= restitution * restitution
    for _ in range(_ENOUGH * STEPS):
        change = rate(state, nose, step)
        # Within a step the cushion gives back (-vY + |vY'| part / 2) cos part.
        out, gain = -state[1], -change[1]
        square = out * out + 2.0 * gain * work / cos
        reach = out + math.sqrt(square) if square > 0.0 else 0.0
        whole = 2.0 * work / cos / reach if reach > 0.0 else math.inf
        last = whole <= step
        part = whole if last else step
        work -= (out + 0.5 * gain * part) * cos * part
        state = _moved(state, change, part)
        if last:
            break
    before = ball.energy()
    _give(ball, nx, ny, *state)
    take_back((ball,), before, True)


def along_nose(ball: Body, nx: float, ny: float) -> State:
    """(vX, vY, R wX, R wY, R wZ) of a ball, in the frame of a contact with (nx, ny) into the cushion."""
    radius = ball.radius
    return (
        ball.vx * ny - ball.vy * nx, ball.vx * nx + ball.vy * ny,
        radius * (ball.wx * ny - ball.wy * nx), radius * (ball.wx * nx + ball.wy * ny), radius * ball.wz,
    )  # fmt: skip


def _moved(state: State, change: State, step: float) -> State:
    return (
        state[0] + step * change[0], state[1] + step * change[1],
        state[2] + step * change[2], state[3] + step * change[3], state[4] + step * change[4],
    )  # fmt: skip


def rate(state: State, nose: Nose, step: float) -> State:
    """What a unit of the nose's impulse, per mass, does to (vX, vY, R wX, R wY, R wZ) in a step."""
    vx, vy, qx, qy, qz = state
    sin, cos, rubber, cloth, _ = nose
    sx, sy = vx + qy * sin - qz * cos, qx - vy * sin
    ux, uy = vx - qy, vy + qx
    across, along = 2.5 - sin, 1.0 - 2.5 * sin
    gx = gy = 0.0
    # The friction of each surface depends on the other's: one more round.
    for _ in range(2):
        fx, fy = _friction(sx, sy, along * gx, sin * cos + across * gy, 2.5 + sin * sin, rubber, step)
        # The nose and its friction press the ball on the cloth, or lift it and leave the cloth nothing.
        weight = max(0.0, sin - fy * cos)
        gx, gy = _friction(ux, uy, along * fx, across * fy - cos, 3.5, cloth * weight, step)
    return fx + gx, gy - cos - fy * sin, 2.5 * (fy + gy), 2.5 * (fx * sin - gx), -2.5 * fx * cos


def _friction(
    x: float, y: float, drive_x: float, drive_y: float, ease_y: float, limit: float, step: float
) -> tuple[float, float]:
    """Coulomb friction, `limit` at most, of a surface with the slip (x, y), for a step.

    Something else drives the slip at (drive_x, drive_y); a unit of friction takes 7/2 off it along x,
    `ease_y` along y. What would end the slip within the step is enough; else the friction is against the
    slip in the middle of the step, or at its end where the slip is so small that it turns on the way.
    """
    end_x, end_y = x + step * drive_x, y + step * drive_y
    rest_x, rest_y, most = end_x / 3.5, end_y / ease_y, limit * step
    if rest_x * rest_x + rest_y * rest_y <= most * most:
        return -end_x / (3.5 * step), -end_y / (ease_y * step)
    x, y, turn = 0.5 * (x + end_x), 0.5 * (y + end_y), 3.5 * most
    if x * x + y * y <= turn * turn:
        x, y = end_x, end_y
    size = limit / math.sqrt(x * x + y * y)
    return -size * x, -size * y


def _seen(radius: float, physics: Physics) -> tuple[float, float]:
    """sin th and cos th of the angle at which a ball sees the nose."""
    sin = physics.cushion.nose_height / radius - 1.0
    return sin, math.sqrt(1.0 - sin * sin)


def _level(radius: float, physics: Physics) -> Nose:
    return Nose(0.0, 1.0, physics.cushion.friction, 0.0, physics.cushion.restitution)


def _lifting(radius: float, physics: Physics) -> Nose:
    """As the slate holds the ball down, what `han2005` loses upward or downward is a loss at the nose."""
    sin, cos = _seen(radius, physics)
    restitution = cos * cos * (1.0 + physics.cushion.restitution) - 1.0
    return Nose(sin, cos, physics.cushion.friction, 0.0, max(0.0, restitution))


def _pressing(radius: float, physics: Physics) -> Nose:
    cushion = physics.cushion
    return Nose(*_seen(radius, physics), cushion.friction, physics.cloth.mu_slide, cushion.restitution)


CUSHION_LAWS: dict[str, CushionLaw] = {"impulse": impulse, "han2005": han2005, "mathavan2010": mathavan2010}
# What each law makes of the nose where a ball is in it together with something else.
NoseLaw = Callable[[float, "Physics"], Nose]
NOSES: dict[str, NoseLaw] = {"impulse": _level, "han2005": _lifting, "mathavan2010": _pressing}
