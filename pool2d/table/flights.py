"""Where a ball flies: from what it leaves to what it meets, how high, and over which balls."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Final, NamedTuple

from ..physics.motion import Motion
from ..physics.rollout import Rollout
from ..physics.values import AIRBORNE, GONE, Ball
from .table import Table

# In how many looks at what is below it a flying ball goes on by the two balls' radii together; and how many times the
# interval about the nearest of them is narrowed to two thirds.
_PARTS: Final = 8.0
_NARROWED: Final = 40
# Of more balls that are jumped only the one that is cleared by the least is told.
FEW: Final = 2


class Flight(NamedTuple):
    """A ball in the air from `start` to `end`, s.

    `apex` is how high its lowest point comes, m above the cloth, and `length` how far it goes, m in plan. `landing` is
    where it comes down, on the bed, a rail's top or the rim of a pocket; None where it meets anything else first.
    """

    ball: str
    start: float
    end: float
    apex: float
    length: float
    landing: Ball | None


class Cleared(NamedTuple):
    """A ball that another passes over: at its nearest, at `t` s, the two are `gap` m apart in space."""

    ball: str
    t: float
    gap: float


def flights(rollout: Rollout, ball: str) -> list[Flight]:
    """All flights of a ball, in their order."""
    track = rollout.tracks.get(ball, [])
    ends = [*(motion.t0 for motion in track[1:]), rollout.duration]
    down = {event.t: event for event in rollout.events if event.kind == "ball_slate" and ball in event.balls}
    found = []
    for motion, end in zip(track, ends, strict=False):
        if motion.phase == AIRBORNE and end > motion.t0:
            first, last = motion.at(motion.t0), motion.at(end)
            landing = down[end].before[ball] if end in down else None
            length = math.dist((first.x, first.y), (last.x, last.y))
            found.append(Flight(ball, motion.t0, end, _apex(motion, first, last, end), length, landing))
    return found


def cleared(rollout: Rollout, table: Table, flight: Flight) -> list[Cleared]:
    """The balls that are passed over in a flight, any part of them, by their distance along it."""
    way = rollout.ball_at(flight.ball, flight.start), rollout.ball_at(flight.ball, flight.end)
    found = []
    for other in rollout.start.values():
        if other.id != flight.ball and other.phase not in GONE:
            passed = _passed(rollout, table, flight, way, other)
            found += [passed] if passed is not None else []
    return sorted(found, key=lambda one: one.t)


def flies(rollout: Rollout) -> bool:
    """Whether any ball is in the air at any time."""
    return any(motion.phase == AIRBORNE for track in rollout.tracks.values() for motion in track)


@lru_cache(maxsize=4)
def jumped(rollout: Rollout, table: Table, ball: str) -> tuple[Cleared, ...]:
    """The balls that the ball which was struck passes over before it meets one."""
    met = next((event.t for event in rollout.events if any(ball in pair for pair in event.pairs)), math.inf)
    before = [flight for flight in flights(rollout, ball) if flight.start < met]
    return tuple(one for flight in before for one in cleared(rollout, table, flight))


def _apex(motion: Motion, first: Ball, last: Ball, end: float) -> float:
    """The greatest height of a motion in the air until `end`: where its speed upward, linear in time, is 0."""
    if first.vz > 0.0 > last.vz:
        return motion.at(motion.t0 + (end - motion.t0) * first.vz / (first.vz - last.vz)).z
    return max(first.z, last.z)


def _passed(rollout: Rollout, table: Table, flight: Flight, way: tuple[Ball, Ball], other: Ball) -> Cleared | None:
    """How one ball is passed over on a way; None where no part of it is, or it is met."""
    mover = way[0]
    radius, its_own = table.body_of(mover)[0], table.body_of(other)[0]
    reach = radius + its_own
    times = _looks(rollout, flight, way, other, reach)
    if not times:
        return None

    def gap(t: float) -> tuple[float, float]:
        """How far apart the centres are in plan, and the balls in space, m."""
        a, b = rollout.ball_at(mover.id, t), rollout.ball_at(other.id, t)
        plan = math.hypot(b.x - a.x, b.y - a.y)
        return plan, math.hypot(plan, a.z + radius - b.z - its_own) - reach

    near = [(here[1], i) for i, t in enumerate(times) if (here := gap(t))[0] < reach]
    if not near:
        return None
    _, i = min(near)
    low, high = times[max(0, i - 1)], times[min(len(times) - 1, i + 1)]
    for _ in range(_NARROWED):
        third = (high - low) / 3.0
        if gap(low + third)[1] <= gap(high - third)[1]:
            high -= third
        else:
            low += third
    t = 0.5 * (low + high)
    plan, least = gap(t)
    # What touches at an end of the flight is what the flight began beside, or ended at.
    return Cleared(other.id, t, least) if plan < reach and least > 1e-6 else None


def _looks(rollout: Rollout, flight: Flight, way: tuple[Ball, Ball], other: Ball, reach: float) -> list[float]:
    """Times in a flight at which to look at another ball; none where that lies still and aside of its way."""
    a, b = way
    length, seconds = flight.length, flight.end - flight.start
    begin, until = 0.0, 1.0
    track = rollout.tracks.get(other.id, [])
    if length > 0.0 and all(motion.t0 >= flight.end or motion.stays() for motion in track):
        here = rollout.ball_at(other.id, flight.start)
        ux, uy = (b.x - a.x) / length, (b.y - a.y) / length
        along, beside = (here.x - a.x) * ux + (here.y - a.y) * uy, (here.x - a.x) * uy - (here.y - a.y) * ux
        if abs(beside) >= reach or not -reach < along < length + reach:
            return []
        begin, until = max(0.0, (along - reach) / length), min(1.0, (along + reach) / length)
    count = max(8, math.ceil(_PARTS * length * (until - begin) / reach))
    return [flight.start + seconds * (begin + (until - begin) * i / count) for i in range(count + 1)]
