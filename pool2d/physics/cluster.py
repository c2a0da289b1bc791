"""Many balls touching at once: what happens in the millisecond in which a rack opens.

Where a struck ball touches another, or reaches it before it has parted from the one that struck it,
no order of two-ball collisions gives the right answer. So the contacts are integrated together as
what they are: springs after Hertz, F = K d^1.5 for a depth d, with a loss K-proportional eta d^0.25 d'
that gives a lone pair the wanted restitution (Tsuji et al. 1992), never pulling, and with friction at
the surface. The balls hardly move in that time, so their places and normals are kept and only the
depths run; a contact begins where the gap between two balls has been used up. What comes out depends
neither on the stiffness nor on the speed while all gaps are zero (Hertz contacts scale), nor on the
order of the balls, and a symmetric rack stays symmetric.
"""

from __future__ import annotations

import math
from functools import cache
from typing import TYPE_CHECKING

from .balls import FRICTION, Friction, Vector, normal, push, slip
from .gentle import rebound

if TYPE_CHECKING:
    from .motion import Body
    from .params import Physics

# Stiffness of two pool balls, N/m^1.5, and the radius it was worked out for (Marlow; Alciatore TP B.29).
STIFFNESS, RADIUS = 8.06e8, 0.028575
# Steps in the duration of one impact at the speed of approach.
STEPS = 60
# An impact is over long before this many durations of it; a guard, not a limit that is met.
_LONGEST = 400


class Contact:
    """Two balls that touch or nearly do. `depth` is negative while there is a gap; `met` once it closed.

    `slip` is the fastest so far: it sets the friction of the whole impact, as it does for two balls alone.
    """

    __slots__ = ("a", "b", "n", "depth", "met", "slip", "stiffness", "loss")

    def __init__(self, a: Body, b: Body, gap: float, loss: float) -> None:
        self.a = a
        self.b = b
        self.n = normal(a, b)
        self.depth = -gap
        self.met = False
        self.slip = 0.0
        # Springs of Hertz: K goes with the root of the effective radius.
        self.stiffness = stiffness(a, b)
        self.loss = loss * math.sqrt(self.stiffness * a.mass * b.mass / (a.mass + b.mass))


def stiffness(a: Body, b: Body) -> float:
    """K of the contact of two balls of the same stuff, N/m^1.5."""
    return STIFFNESS * math.sqrt(2.0 * a.radius * b.radius / ((a.radius + b.radius) * RADIUS))


def depth(a: Body, b: Body, speed: float) -> float:
    """How deep two balls press into each other that meet at `speed`: (5 m v^2 / (4 K))^0.4."""
    mass = a.mass * b.mass / (a.mass + b.mass)
    return math.pow(1.25 * mass * speed * speed / stiffness(a, b), 0.4)


def duration(a: Body, b: Body, speed: float) -> float:
    """How long an impact at `speed` lasts, s: 3.218 (m^2 / (K^2 v))^0.2."""
    mass = a.mass * b.mass / (a.mass + b.mass)
    return 3.218 * math.pow(mass * mass / (stiffness(a, b) ** 2 * speed), 0.2)


def gather(a: Body, b: Body, bodies: list[Body], room: float) -> list[tuple[Body, Body, float]]:
    """The pairs of balls within `room` of each other that a and b are linked to, with their gaps."""
    found: list[tuple[Body, Body, float]] = []
    linked = [a, b]
    seen = {a.index, b.index}
    for ball in linked:
        for other in bodies:
            touch = 2.0 * math.sqrt(ball.radius * other.radius)
            reach = touch + room
            dx, dy = other.x - ball.x, other.y - ball.y
            if other is ball or abs(dx) > reach or abs(dy) > reach or dx * dx + dy * dy > reach * reach:
                continue
            if other.index not in seen:
                seen.add(other.index)
                linked.append(other)
            if ball.index < other.index:
                found.append((ball, other, max(0.0, math.hypot(dx, dy) - touch)))
    found.sort(key=lambda pair: (pair[0].index, pair[1].index))
    return found


def solve(pairs: list[tuple[Body, Body, float]], speed: float, physics: Physics) -> list[Contact]:
    """Let the impact of a cluster run its course; the contacts that took part, the balls changed.

    `speed` is that of the approach that set it off, m/s.
    """
    # As two balls alone part at that speed; in thousandths, of which none has to be worked out twice.
    loss = damping(round(rebound(speed, physics.ball.restitution) / speed, 3))
    contacts = [Contact(a, b, gap, loss) for a, b, gap in pairs]
    before = {ball.index: ball.energy() for pair in pairs for ball in pair[:2]}
    friction = FRICTION[physics.ball.law]
    time = max(duration(a, b, speed) for a, b, _ in pairs)
    for step in range(_LONGEST * STEPS):
        if not _step(contacts, time / STEPS, friction, physics) and step > 1:
            break
    met = [contact for contact in contacts if contact.met]
    _settle(list({ball.index: ball for contact in met for ball in (contact.a, contact.b)}.values()), before)
    return met


def _step(contacts: list[Contact], dt: float, friction: Friction, physics: Physics) -> bool:
    """One leapfrog step of all contacts at once; whether any is closed."""
    impulses: list[tuple[Contact, float, float, float, float]] = []
    for contact in contacts:
        a, b, n = contact.a, contact.b, contact.n
        closing = (a.vx - b.vx) * n[0] + (a.vy - b.vy) * n[1]
        contact.depth = d = contact.depth + closing * dt
        if d <= 0.0:
            continue
        contact.met = True
        root = math.sqrt(d)
        along = dt * (contact.stiffness * d * root + contact.loss * math.sqrt(root) * closing)
        if along > 0.0:
            impulses.append((contact, along, *_rub(contact, closing, along, friction, physics)))
    # All impulses come from the same moment, so their order is of no consequence.
    for contact, along, fx, fy, fz in impulses:
        push(contact.a, contact.b, contact.n, along, fx, fy, fz)
    return any(contact.depth > 0.0 for contact in contacts)


def _rub(contact: Contact, closing: float, along: float, friction: Friction, physics: Physics) -> Vector:
    """The friction of one step of a contact: Coulomb's, or what ends the slip."""
    a, b = contact.a, contact.b
    sx, sy, sz = slip(a, b, contact.n, closing)
    size = math.sqrt(sx * sx + sy * sy + sz * sz)
    if size == 0.0:
        return 0.0, 0.0, 0.0
    contact.slip = max(contact.slip, size)
    limit = friction(contact.slip, physics) * along
    rub = -min(limit / size, 1.0 / (3.5 * (1.0 / a.mass + 1.0 / b.mass)))
    return rub * sx, rub * sy, rub * sz


def _settle(balls: list[Body], before: dict[int, float]) -> None:
    """Take back what the steps' rounding added to the energy, if anything, keeping the momentum.

    Of an elastic impact the steps miss some 1e-4 of the energy, to either side.
    """
    surplus = sum(ball.energy() - before[ball.index] for ball in balls)
    mass = sum(ball.mass for ball in balls)
    vx, vy = sum(ball.mass * ball.vx for ball in balls) / mass, sum(ball.mass * ball.vy for ball in balls) / mass
    # The energy of travel about the common centre; it is the springs that the steps round.
    inner = sum(0.5 * ball.mass * ((ball.vx - vx) ** 2 + (ball.vy - vy) ** 2) for ball in balls)
    if surplus <= 0.0 or inner <= 0.0:
        return
    part = math.sqrt(max(0.0, 1.0 - surplus / inner)) * (1.0 - 1e-15)
    for ball in balls:
        ball.vx, ball.vy = vx + part * (ball.vx - vx), vy + part * (ball.vy - vy)


@cache
def damping(restitution: float) -> float:
    """The loss, in units of sqrt(m K), that gives a lone pair this restitution, or 0.01 for less: by halving."""
    lo, hi = 0.0, 10.0
    for _ in range(40):
        middle = 0.5 * (lo + hi)
        lo, hi = (middle, hi) if _restitution(middle) > restitution else (lo, middle)
    return 0.5 * (lo + hi)


def _restitution(loss: float) -> float:
    """Of a lone pair with that loss, in units where mass, stiffness and speed are one."""
    depth, speed, dt = 0.0, 1.0, 3.218 / STEPS
    while True:
        depth += speed * dt
        if depth <= 0.0:
            return -speed
        speed -= dt * max(0.0, depth**1.5 + loss * depth**0.25 * speed)
