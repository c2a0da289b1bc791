"""Many touching at once: what happens in the milliseconds in which a rack opens or a ball is squeezed.

Where a struck ball touches another, or a cushion, or reaches it before it has parted from what struck
it, no order of single contacts gives the right answer. So the contacts are integrated together as what
they are, springs that never pull, with friction at the surface: balls after Hertz, F = K d^1.5 for a
depth d, with a loss K-proportional eta d^0.25 d' that gives a lone pair the wanted restitution (Tsuji et
al. 1992); cushions, much softer, as `springs.NoseSpring` has it. The balls hardly move in that time, so
their places and normals are kept and only the depths run; a contact begins where the gap has been used
up. What comes out depends neither on the stiffness nor on the speed while all gaps are zero (Hertz
contacts scale), nor on the order of the balls, and a symmetric rack stays symmetric.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Container, Sequence
from typing import Final, final

from .body import Body
from .crowd import Crowd
from .detect import NOISE, Element
from .energy import take_back
from .laws.rebound import rebound
from .materials import Materials
from .roots import INF
from .springs import STEPS, BallSpring, NoseSpring, Spring, damping, pace
from .strike import TipSpring

# An impact of balls is over long before this many times the duration of one; a guard, not a limit that is met.
_LONGEST: Final = 400
# A ball that friction wedges into a cushion could stay there as long as it spins. After this many times the
# duration of a rebound that is no impact any more (see `_unjam`).
_HELD: Final = 2
# How often the approaches of wedged balls are shared out.
_ROUNDS: Final = 100


@final
class Group:
    """What touches or nearly does: pairs of balls, and balls with elements of the table, with their gaps."""

    __slots__ = ("pairs", "noses")

    def __init__(self, pairs: list[tuple[Body, Body, float]], noses: list[tuple[Body, Element, float]]) -> None:
        self.pairs = pairs
        self.noses = noses

    def balls(self) -> list[Body]:
        """Every ball of it, some more than once."""
        return [ball for a, b, _ in self.pairs for ball in (a, b)] + [ball for ball, _, _ in self.noses]


def linked(first: list[Body], crowd: Crowd, room: float, now: float) -> list[tuple[Body, Body, float]]:
    """The pairs of balls within `room` of each other that the first ones are linked to, with their gaps."""
    found: list[tuple[Body, Body, float]] = []
    balls = list(first)
    seen = {ball.index for ball in first}
    for ball in balls:
        for other in crowd.around(ball, ball.radius + crowd.largest + room, now):
            touch = 2.0 * math.sqrt(ball.radius * other.radius)
            reach = touch + room
            dx, dy = other.x - ball.x, other.y - ball.y
            # One in the air is none of them, even where it is above them.
            if dx * dx + dy * dy > reach * reach or other.aloft():
                continue
            if other.index not in seen:
                seen.add(other.index)
                balls.append(other)
            if ball.index < other.index:
                found.append((ball, other, max(0.0, math.hypot(dx, dy) - touch)))
    found.sort(key=_places)
    return found


def _places(pair: tuple[Body, Body, float]) -> tuple[int, int]:
    return pair[0].index, pair[1].index


def facing(ball: Body, elements: Sequence[Element], reach: float, room: float) -> list[tuple[Element, float]]:
    """The elements a ball touches or has within `room`, with their gaps; of one cushion no more than one.

    The nearest point of an element may lie inside another one, as where a jaw goes over into its nose.
    """
    near = [(element, gap) for element in elements if (gap := element.gap(ball.x, ball.y, reach)) <= room]
    across = [(element, gap, point) for element, gap in near if (point := element.point(ball.x, ball.y))]

    def hidden(place: int) -> bool:
        element, _, point = across[place]
        # Where two meet, each may hold the other's point within rounding: then the first stays.
        return any(
            other.covers(*point) and (number < place or not element.covers(*there))
            for number, (other, _, there) in enumerate(across)
            if number != place
        )

    return [(element, max(0.0, gap)) for place, (element, gap, _) in enumerate(across) if not hidden(place)]


def solve(
    group: Group, speed: float, materials: Materials, tip: TipSpring | None = None
) -> tuple[list[BallSpring], list[NoseSpring]]:
    """Let the impact of a group run its course; the contacts that took part, the balls changed.

    `speed` is that of the approach that set it off, m/s; a `tip` may be what drives it.
    """
    # As two balls alone part at that speed; in thousandths, of which none has to be worked out twice.
    loss = damping(round(rebound(speed, materials.ball.restitution) / speed, 3))
    pairs = [BallSpring(a, b, gap, speed, loss, materials) for a, b, gap in group.pairs]
    noses = [
        NoseSpring(ball, element, gap, [other for other, _, _ in group.noses].count(ball), materials)
        for ball, element, gap in group.noses
    ]
    springs: list[Spring] = [*pairs, *noses]
    driven = 0.0
    if tip is not None:
        springs.append(tip)
        driven = tip.energy()
    before = {ball.index: ball.energy() for spring in springs for ball in spring.balls}
    steps = [spring.step for spring in springs]
    shortest, longest = min(steps), max(steps)
    time, end = 0.0, STEPS * longest * (_HELD if noses else _LONGEST)
    while time < end:
        dt = shortest
        if shortest < longest:
            dt = longest
            for spring in springs:
                dt = min(dt, pace(spring, longest))
        closed = [spring for spring in springs if spring.press(dt)]
        for spring in closed:
            spring.act()
        if time > dt and not closed:
            break
        time += dt
    else:
        if noses:
            _unjam(springs)
    met = {ball.index: ball for spring in springs if spring.met for ball in spring.balls}
    if tip is not None:
        driven -= tip.energy()
    anchored = tip is not None or any(nose.met for nose in noses)
    take_back(list(met.values()), driven + math.fsum([before[index] for index in met]), anchored)
    return [pair for pair in pairs if pair.met], [nose for nose in noses if nose.met]


def _unjam(springs: list[Spring]) -> None:
    """Take the approaches from contacts that are still closed when an impact's time is up: balls wedged in.

    They have no restitution left. A ball that still goes into a cushion when its approaches have been shared out is
    in a wedge and stops. From then on it is a wall to the others, and so is each that stops between such walls.
    """
    held = [spring for spring in springs if spring.met]
    _share_out(held)
    # What the tip had to give it has given.
    held = [spring for spring in held if not isinstance(spring, TipSpring)]
    masses: dict[int, float] = {}
    balls = {ball.index: ball for spring in held for ball in spring.balls}
    while stopped := _wedged(held, masses):
        for index in stopped:
            ball = balls[index]
            masses[index] = ball.mass
            ball.vx = ball.vy = 0.0
            ball.mass = INF
        _share_out(held)
    for index, mass in masses.items():
        balls[index].mass = mass


def _wedged(held: list[Spring], walls: Container[int]) -> set[int]:
    """The balls, by index, that still go into a cushion, or into one of the balls that are walls."""
    found = set()
    for spring in held:
        free = [ball.index for ball in spring.balls if ball.index not in walls]
        if spring.closing() > NOISE and (len(free) < len(spring.balls) or isinstance(spring, NoseSpring)):
            found.update(free)
    return found


def _share_out(held: list[Spring]) -> None:
    """Let contacts give way until nothing approaches, all at once, each by a part that those of one ball share.

    So their order is of no consequence.
    """
    counts = Counter(ball.index for spring in held for ball in spring.balls)
    shares = [1.0 / max(counts[ball.index] for ball in spring.balls) for spring in held]
    for _ in range(_ROUNDS):
        closing = [spring.closing() for spring in held]
        if max(closing, default=0.0) <= NOISE:
            return
        for spring, speed, share in zip(held, closing, shares, strict=True):
            if speed > 0.0:
                spring.part(share * speed)
