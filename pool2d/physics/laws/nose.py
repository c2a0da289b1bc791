"""A ball at a cushion's nose: the frame of the contact, and what laws share.

In the frame of the contact X runs along the cushion, Y into it, Z up. The nose stands above the ball's
centre: with th the angle at which the ball sees it, sin th = h/R - 1, the contact is at
R (0, cos th, sin th) from the centre, and the slip of the ball's surface there is
sX = vX + R wY sin th - R wZ cos th along the cushion, sY = -vY sin th + R wX up across it.
"""

from __future__ import annotations

import math

from ..body import Body
from .law import CushionNumbers, Nose
from .rebound import rebound

State = tuple[float, float, float, float, float]


def seen(radius: float, numbers: CushionNumbers) -> tuple[float, float]:
    """sin th and cos th of the angle at which a ball sees the nose."""
    sin = numbers.nose_height / radius - 1.0
    return sin, math.sqrt(1.0 - sin * sin)


def kick(ball: Body, nx: float, ny: float, push: float, nose: Nose) -> None:
    """Apply a normal impulse at the nose and the friction it allows: what stops the slip, and the springing back."""
    sin, cos, friction = nose.sin, nose.cos, nose.rubber
    vx, vy = ball.vx * ny - ball.vy * nx, ball.vx * nx + ball.vy * ny
    radius = ball.radius
    qx, qy, qz = radius * (ball.wx * ny - ball.wy * nx), radius * (ball.wx * nx + ball.wy * ny), radius * ball.wz
    sx, sy = vx + qy * sin - qz * cos, qx - vy * sin
    slip = math.hypot(sx, sy)
    rub = 0.0 if slip == 0.0 else -min(friction * push, 2.0 / 7.0 * ball.mass * slip) / (slip * ball.mass)
    fx, fy = rub * sx, rub * sy
    if nose.tangential > 0.0:
        fx += springing_back(fx, push / ball.mass, nose)
    vx += fx
    vy -= push / ball.mass * cos + fy * sin
    give(ball, nx, ny, vx, vy, qx + 2.5 * fy, qy + 2.5 * fx * sin, qz - 2.5 * fx * cos)


def springing_back(along: float, push: float, nose: Nose) -> float:
    """What rubber that friction has sheared along the rail gives back as it lets the ball go, an impulse per mass.

    `along` is the friction's impulse along the rail, per mass, `push` the normal one. The rubber gives back e_t of
    the former, so that a slip which friction has stopped turns about to e_t of what it was (Cross, "Grip-slip
    behavior of a bouncing ball", Am. J. Phys. 70:1093, 2002; Stronge, "Impact Mechanics", 2000, for the compliance
    that it comes of), as far as Coulomb's limit allows both together (Walton 1993). The limit is that along the
    rail alone: a ball that also slips up across the nose uses all friction, and would get nothing back, but on
    tracked shots it is reverse english, which does, that comes back most.
    """
    room = nose.rubber * push - abs(along)
    return math.copysign(min(nose.tangential * abs(along), max(0.0, room)), along)


def dragged(state: State, fx: float, nose: Nose) -> State:
    """A state after an impulse fx, per mass, along the rail at the nose."""
    vx, vy, qx, qy, qz = state
    return vx + fx, vy, qx, qy + 2.5 * fx * nose.sin, qz - 2.5 * fx * nose.cos


def slip_along(state: State, nose: Nose) -> float:
    """How fast the ball's surface slips along the rail at the nose, m/s."""
    return state[0] + state[3] * nose.sin - state[4] * nose.cos


def drag(turned: float, nose: Nose) -> float:
    """The impulse along the rail that has changed R wZ by `turned`: nothing else at the nose does."""
    return turned / (-2.5 * nose.cos)


def give(ball: Body, nx: float, ny: float, vx: float, vy: float, qx: float, qy: float, qz: float) -> None:
    """Set a ball's velocity and spin (times its radius) from the frame of the contact.

    A ball that a model leaves in the cushion, jammed by friction or without restitution, is let go gently.
    """
    vy = min(vy, -0.1 * rebound(ball.vx * nx + ball.vy * ny, 0.0))
    ball.vx, ball.vy = vx * ny + vy * nx, vy * ny - vx * nx
    ball.wx, ball.wy = (qx * ny + qy * nx) / ball.radius, (qy * ny - qx * nx) / ball.radius
    ball.wz = qz / ball.radius


def along_nose(ball: Body, nx: float, ny: float) -> State:
    """(vX, vY, R wX, R wY, R wZ) of a ball, in the frame of a contact with (nx, ny) into the cushion."""
    radius = ball.radius
    return (
        ball.vx * ny - ball.vy * nx, ball.vx * nx + ball.vy * ny,
        radius * (ball.wx * ny - ball.wy * nx), radius * (ball.wx * nx + ball.wy * ny), radius * ball.wz,
    )  # fmt: skip


def rate(state: State, nose: Nose, step: float) -> State:
    """What a unit of the nose's impulse, per mass, does to (vX, vY, R wX, R wY, R wZ) in a step."""
    vx, vy, qx, qy, qz = state
    sin, cos, rubber, cloth = nose.sin, nose.cos, nose.rubber, nose.cloth
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
