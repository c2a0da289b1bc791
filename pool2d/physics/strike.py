"""The cue's strike: what the tip's impulse does to a ball, alone or with others in its way."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final, final

from .body import Body
from .detect import TOUCH
from .springs import STEPS, SoftSpring
from .values import Shot

if TYPE_CHECKING:
    from .params import Cue, Physics

# How long a tip is on a ball, s: six times as long as two balls are on each other. (1 to 2 ms; Jacksonville project,
# 1999.) What comes out depends on it only in that it is much softer than a ball.
CONTACT: Final = 1.5e-3


def miscue_limit(tip_friction: float) -> float:
    """How far from the centre the tip may hit, in radii, before it slips (friction cone, TP 2.1)."""
    return tip_friction / math.hypot(1.0, tip_friction)


def squirt(side: float, height: float, ball_mass: float, end_mass: float) -> float:
    """The angle by which a ball leaves turned away from the english, radians.

    Positive to the left, for a tip to the right. (Alciatore TP A.31, where the tip is at the height of the centre;
    the same impulses on a rigid sphere for a tip above or below it, which then stands less deep behind the centre.)
    """
    if end_mass == 0.0:
        return 0.0
    square = 1.0 - side * side
    depth = math.sqrt(max(0.0, square - height * height))
    return math.atan(2.5 * side * depth / (1.0 + ball_mass / end_mass + 2.5 * square))


def hop(shot: Shot, mass: float, physics: Physics) -> tuple[float, float, float, float]:
    """How a ball struck downward would leave the slate: speed up, height, time in the air, way made in it.

    What the engine does, in closed form, for who is about to strike: the ball is driven into the slate at
    v sin(th) and comes back at e times that. Friction with the cloth, which shortens the way, is left out.
    """
    cue = physics.struck_by(shot).cue
    offsets = 2.5 * (shot.side**2 + shot.height**2)
    inertia = 1.0 / cue.mass + (1.0 + offsets) / mass
    speed = (1.0 + cue.tip_restitution) * shot.speed / (inertia * mass)
    return flight(speed, shot.elevation, physics.cloth.bounce, physics.gravity)


def flight(speed: float, elevation: float, bounce: float, gravity: float) -> tuple[float, float, float, float]:
    """Speed up, height, time and way of a ball sent into the slate at `speed` m/s and `elevation` degrees."""
    tilt = math.radians(elevation)
    up = bounce * speed * math.sin(tilt)
    time = 2.0 * up / gravity
    return up, up * up / (2.0 * gravity), time, speed * math.cos(tilt) * time


def strike(ball: Body, shot: Shot, cue: Cue) -> TipImpulse:
    """Set `ball` moving as the cue sends it where nothing is in its way.

    The cue pushes along its own line, or, past the friction limit, along the nearest line that the
    friction cone allows. With that line e, the tip meets an inertia of |e_xy|^2/m + 5 |r x e|^2 / (2 m)
    (r in radii; the slate takes the vertical part) and the cue one of (d.e)^2/M, so the impulse is
    J = (1 + e_tip) V (d.e) / their sum. For a clean hit this is Alciatore TP A.30 with elevation.

    With the butt raised the ball leaves the tip as one that nothing holds, |e|^2/m, along e: downward, or, where a
    tip that slips digs under it, upward. What the slate then answers is not in it yet. Two impacts one after the
    other, the tip's and the slate's, are the bound that holds if the tip is off the ball before the slate has given
    back, as a hard tip is; a soft one holds a ball down. A level stroke is one in the plane of the cloth.
    """
    a, b = shot.side, shot.height
    tilt = math.radians(shot.elevation)
    cos, sin = math.cos(tilt), math.sin(tilt)
    offset = min(math.hypot(a, b), 1.0)
    depth = math.sqrt(1.0 - offset * offset)
    clean = offset <= miscue_limit(cue.tip_friction)
    # In the cue's frame (along it, to its right, up across it) the ball's centre sees the tip at
    # (-depth, a, b), and the push is (cos, sin) of the miss angle along and away from the centre line.
    miss = 0.0 if clean else math.acos(depth) - math.atan(cue.tip_friction)
    along, away = math.cos(miss), -math.sin(miss)
    right, up = (away * a / offset, away * b / offset) if offset > 0.0 else (0.0, 0.0)
    # The moment r x e, about the axes (along, right, up), which are left-handed. About the first it is rounding, and
    # stays, so that recorded strokes keep their bits.
    m_along = b * right - a * up
    m_right = -b * along - depth * up
    m_up = depth * right + a * along
    ahead = along * cos + up * sin
    rise = up * cos - along * sin if sin > 0.0 else 0.0
    pushed = ahead * ahead + right * right + rise * rise
    inertia = (pushed + 2.5 * (m_along**2 + m_right**2 + m_up**2)) / ball.mass
    impulse = (1.0 + cue.tip_restitution) * shot.speed * along / (inertia + along * along / cue.mass)
    # To the table's frame turned to the aim: x ahead, y left, z up.
    speed, turn = impulse / ball.mass, 2.5 * impulse / (ball.mass * ball.radius)
    vx, vy = speed * ahead, -speed * right
    wx, wy, wz = turn * (m_along * cos + m_up * sin), -turn * m_right, turn * (m_up * cos - m_along * sin)
    aim = math.radians(shot.angle) + squirt(a, b, ball.mass, cue.end_mass)
    ca, sa = math.cos(aim), math.sin(aim)
    ball.vx, ball.vy = vx * ca - vy * sa, vx * sa + vy * ca
    ball.vz = speed * rise
    ball.wx, ball.wy, ball.wz = wx * ca - wy * sa, wx * sa + wy * ca, wz
    return TipImpulse(clean, impulse, along, shot.speed, cue.mass, cue.tip_restitution)


@final
class TipImpulse:
    """How a tip has set a ball moving that nothing was in the way of.

    Whether it met it cleanly; its impulse, N s, and the part of that which the cue feels `along` itself; the cue's
    speed before, and `onward` after it, m/s, and mass, kg; the tip's restitution.
    """

    __slots__ = ("clean", "impulse", "along", "speed", "mass", "restitution", "onward")

    def __init__(
        self, clean: bool, impulse: float, along: float, speed: float, mass: float, restitution: float
    ) -> None:
        self.clean = clean
        self.impulse = impulse
        self.along = along
        self.speed = speed
        self.mass = mass
        self.restitution = restitution
        self.onward = speed - impulse * along / mass


@final
class TipSpring(SoftSpring):
    """The tip on a ball: a soft spring along the line of the stroke, between the ball and the cue that runs on.

    The ball moves as the stroke has sent it; in the cluster, where it starts at rest, an impulse has the same line
    and the same moment.
    """

    __slots__ = ("ball", "answer", "rise", "speed", "along", "mass", "ease", "push")

    def __init__(self, ball: Body, stroke: TipImpulse) -> None:
        rate = math.pi / CONTACT
        super().__init__((ball,), 0.0, CONTACT / STEPS, rate * rate, stroke.restitution)
        self.ball = ball
        impulse = stroke.impulse
        vx, vy, wx, wy, wz = ball.velocity()
        # What a unit of the impulse does to the ball.
        self.answer = (vx / impulse, vy / impulse, wx / impulse, wy / impulse, wz / impulse)
        self.rise = ball.vz / impulse
        self.speed = stroke.speed
        self.along = stroke.along
        self.mass = stroke.mass
        self.ease = self._onward() / impulse + self.along * self.along / self.mass
        self.push = 0.0

    def closing(self) -> float:
        return self.speed * self.along - self._onward()

    def part(self, speed: float) -> None:
        self._give(speed / self.ease)

    def press(self, dt: float) -> bool:
        closing = self.closing()
        self.depth = d = self.depth + closing * dt
        if d <= 0.0:
            self.deepest = 0.0
            return False
        self.met = self.met or d > TOUCH
        force = self.force(d)
        if closing < 0.0 and self.spent(force):
            self.depth = self.deepest = 0.0
            return False
        self.push = force * dt / self.ease
        return True

    def act(self) -> None:
        self._give(self.push)

    def energy(self) -> float:
        """That of the cue, J."""
        return 0.5 * self.mass * self.speed * self.speed

    def _onward(self) -> float:
        """How fast the place where the tip meets the ball moves along the line of the stroke, m/s."""
        ball, (vx, vy, wx, wy, wz) = self.ball, self.answer
        turn = 0.4 * ball.radius * ball.radius * (wx * ball.wx + wy * ball.wy + wz * ball.wz)
        return ball.mass * (vx * ball.vx + vy * ball.vy + turn + self.rise * ball.vz)

    def _give(self, impulse: float) -> None:
        ball, (vx, vy, wx, wy, wz) = self.ball, self.answer
        ball.vx += impulse * vx
        ball.vy += impulse * vy
        ball.vz += impulse * self.rise
        ball.wx += impulse * wx
        ball.wy += impulse * wy
        ball.wz += impulse * wz
        self.speed -= impulse * self.along / self.mass
