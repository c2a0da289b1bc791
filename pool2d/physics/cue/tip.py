"""The tip after the stroke: it runs on along the cue's line, and meets the ball again where that is in its way."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final, final

from ..detect import SKIN, entering
from ..roots import INF, first_root
from .hand import FREE, Stretch, lasting, way
from .push import lines, push

if TYPE_CHECKING:
    from ..body import Body
    from ..flight.impact import Vector
    from ..motion import Motion
    from ..params import Cue
    from ..strike import TipImpulse
    from ..values import Shot

# The end of a tip is taken to be round, of this radius, m: half of what a tip is across.
ROUND: Final = 0.0064
# A tip lets go of the ball after about 1.2 ms, when that has gone 0.92 mm for each m/s of the cue. A stroke is all at
# once here: a ball has gone as far after so many seconds.
ON: Final = 7e-4
# Tip and ball that part more slowly than this stay together, m/s: a push.
TOGETHER: Final = 0.02
# A tip that has met the ball so often after the stroke has pushed it.
OFTEN: Final = 12


@final
class Tip:
    """The end of a cue that has struck a ball: a sphere on the line of the stroke.

    Its centre is at (x, y, z) at the time `t`, and moves at `speed` along the unit vector (dx, dy, dz). The hand brakes
    it from the time `brake` on, and takes it away at `gone`, or the cloth ends its way before, at the height `low`.
    Where it is still `held` to the ball, it can meet that only after the two have been apart: what presses the ball
    back on the tip, as the slate does under a steep cue, is of the same contact. The ball can lose the part `spare` of
    its speed before the tip is as fast. `hits` counts the contacts. It holds more numbers than most classes: where it
    is and goes, and what it is of.
    """

    __slots__ = (
        "index", "mass", "restitution", "cone", "x", "y", "z", "dx", "dy", "dz", "t", "speed", "brake", "gone", "low",
        "held", "spare", "hits",
    )  # fmt: skip

    def __init__(self, ball: Body, shot: Shot, stroke: TipImpulse, cue: Cue) -> None:
        self.index = ball.index
        self.mass = cue.mass
        self.restitution = cue.tip_restitution
        self.cone = math.atan(cue.tip_friction)
        (self.dx, self.dy, self.dz), n = lines(shot)
        reach = ball.radius + ROUND
        self.x, self.y = ball.x - reach * n[0], ball.y - reach * n[1]
        self.z = ball.z + ball.radius - reach * n[2]
        self.t = 0.0
        self.speed = stroke.onward
        self.gone = lasting(self.speed, cue.follow_through)
        self.brake = FREE * self.gone
        self.low = min(self.z, ball.z + ROUND)
        self.held = True
        self.spare = self._spare(ball, n)
        self.hits = 0

    def time(self, motion: Motion, radius: float, now: float) -> float:
        """When it meets its ball again, which moves as given from now on; infinite where it does not."""
        for stretch in self._way():
            first, last = max(now, stretch[0]), min(motion.end, stretch[1])
            if first <= last:
                t = self._meeting(motion, stretch, radius + ROUND - SKIN, first, last)
                if t < INF:
                    return t
        return INF

    def strike(self, ball: Body, now: float) -> bool:
        """Let it strike its ball, which it has met; whether the two part."""
        self._bring(now)
        n = self._toward(ball)
        cue = (self.dx, self.dy, self.dz)
        self.speed, parting = push(ball, n, cue, self.speed, self.mass, self.restitution, self.cone)
        self.held = True
        self.spare = self._spare(ball, n)
        self.hits += 1
        return parting >= TOGETHER and self.hits < OFTEN

    def feel(self, ball: Body, before: Motion, now: float) -> None:
        """Its ball has met something: where that stops it before a tip that is still on it, the two can meet at once.

        What is barely grazed does not stop it. Only the way in plan counts, as the slate is what throws the ball up.
        """
        if now > ON:
            return
        s = now - before.t0
        vx, vy = before.vx + 2.0 * before.hx * s, before.vy + 2.0 * before.hy * s
        if (vx - ball.vx) * self.dx + (vy - ball.vy) * self.dy > self.spare * (vx * self.dx + vy * self.dy):
            self.held = False

    def _spare(self, ball: Body, n: Vector) -> float:
        onward = ball.vx * n[0] + ball.vy * n[1] + ball.vz * n[2]
        tip = self.speed * (self.dx * n[0] + self.dy * n[1] + self.dz * n[2])
        return 1.0 - tip / onward if onward > tip else 0.0

    def _toward(self, ball: Body) -> Vector:
        x, y, z = ball.x - self.x, ball.y - self.y, ball.z + ball.radius - self.z
        size = math.sqrt(x * x + y * y + z * z)
        return x / size, y / size, z / size

    def _bring(self, now: float) -> None:
        """Go on to the present moment."""
        along, speed = 0.0, 0.0
        for start, end, s, v, h in self._way():
            if start <= now <= end:
                past = now - start
                along, speed = s + (v + h * past) * past, v + 2.0 * h * past
        self.x += along * self.dx
        self.y += along * self.dy
        self.z += along * self.dz
        self.t, self.speed = now, speed

    def _way(self) -> list[Stretch]:
        room = (self.z - self.low) / -self.dz if self.dz < 0.0 else INF
        return way(self.t, self.speed, self.brake, self.gone, room)

    def _meeting(self, motion: Motion, stretch: Stretch, touch: float, first: float, last: float) -> float:
        """When it meets its ball within a stretch of its way: a quartic."""
        start, _, s, v, h = stretch
        a, b, span = first - motion.t0, first - start, last - first
        along, speed = s + (v + h * b) * b, v + 2.0 * h * b
        x = motion.x + (motion.vx + motion.hx * a) * a - self.x - along * self.dx
        y = motion.y + (motion.vy + motion.hy * a) * a - self.y - along * self.dy
        z = motion.z + (motion.vz + motion.hz * a) * a - self.z - along * self.dz + touch + SKIN - ROUND
        vx = motion.vx + 2.0 * motion.hx * a - speed * self.dx
        vy = motion.vy + 2.0 * motion.hy * a - speed * self.dy
        vz = motion.vz + 2.0 * motion.hz * a - speed * self.dz
        hx, hy, hz = motion.hx - h * self.dx, motion.hy - h * self.dy, motion.hz - h * self.dz
        c0 = x * x + y * y + z * z - touch * touch
        c1 = 2.0 * (x * vx + y * vy + z * vz)
        c2 = vx * vx + vy * vy + vz * vz + 2.0 * (x * hx + y * hy + z * hz)
        c3 = 2.0 * (vx * hx + vy * hy + vz * hz)
        c4 = hx * hx + hy * hy + hz * hz
        # Most balls run away from the tip for as long as it is there: the distance only grows.
        if c1 >= 0.0 and 2.0 * c2 + 3.0 * min(c3, 0.0) * span >= 0.0:
            return INF
        unit = 2.0 * touch
        if self.held and c0 <= 2.0 * unit * SKIN:
            return first + first_root(min(c0, 0.0), c1, c2, c3, c4, span)
        return first + entering(c0, c1, c2, c3, c4, unit, span)
