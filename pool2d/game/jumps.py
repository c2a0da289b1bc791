"""What the cue ball did in the air, as a referee sees it: over which balls it passed, before and after it met one."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from typing import NamedTuple

from ..physics.event import Event
from ..physics.motion import Motion, pieces
from ..physics.rollout import Rollout
from ..physics.roots import first_root
from ..physics.values import AIRBORNE, MISCUE, Ball
from ..table.flights import Flight, flights
from ..table.table import Table

# A ball is passed over where it is covered this much in plan, m: a ball on the cloth comes no nearer, so that what is
# less is no jump but a hop that went by.
COVERED = 2e-4
# Flights are as high as they are told to be within this, m.
_HAIR = 1e-9
# A hop lower than this is not seen, m.
SEEN = 5e-3


class Jumps(NamedTuple):
    """What the cue ball did in the air; see the attributes of `Report` that have the same names."""

    airborne: bool = False
    over: tuple[str, ...] = ()
    over_later: tuple[str, ...] = ()
    vaulted: tuple[str, ...] = ()


class _Pass(NamedTuple):
    """The time, s, for which the cue ball is over a part of a ball."""

    ball: str
    begin: float
    end: float


def jumps(table: Table, rollout: Rollout, cue: str, met: Event | None, first: Collection[str]) -> Jumps:
    """What a cue ball did in the air; `met` is the event at which it met its first balls, None where it met none."""
    passes = [one for flight in flights(rollout, cue) for one in _passes(table, rollout, flight)]
    when = math.inf if met is None else met.t
    # To come down on a ball is to meet it.
    over = [one.ball for one in passes if one.begin < when and (one.end < when or one.ball not in first)]
    later = [one.ball for one in passes if one.end > when]
    if met is None:
        return Jumps(over=_once(over))
    before = met.before[cue]
    flies = before.phase == AIRBORNE or before.z > 0.0
    vaulted = [ball for ball in first if _vaults(rollout, passes, before, met, ball)] if passes else []
    return Jumps(flies, _once(over), _once(later), tuple(vaulted))


def scooped(rollout: Rollout, cue: str) -> bool:
    """Whether the tip slipped off below the ball's centre and the ball rose, so that it can be seen."""
    for event in rollout.events:
        if event.kind == "cue_ball" and event.where == MISCUE and cue in event.balls:
            ball = event.after[cue]
            rises = any(flight.start == event.t and flight.apex >= SEEN for flight in flights(rollout, cue))
            # It turns backward about the axis across its way.
            if rises and ball.vx * ball.wy - ball.vy * ball.wx < 0.0:
                return True
    return False


def _vaults(rollout: Rollout, passes: list[_Pass], before: Ball, met: Event, ball: str) -> bool:
    """Whether the cue ball goes over a ball that it has just met, and comes down beyond it before it meets more."""
    events = [event for event in rollout.events if event.t >= met.t and event is not met and before.id in event.balls]
    for event in events:
        if event.kind in ("ball_slate", "ball_pocket", "ball_off"):
            over = any(one.ball == ball and one.end >= met.t and one.begin <= event.t for one in passes)
            down, there = event.before[before.id], rollout.ball_at(ball, event.t)
            beyond = (down.x - there.x) * before.vx + (down.y - there.y) * before.vy > 0.0
            return over and beyond and (event.kind != "ball_slate" or event.where is None)
        if event.rails or any(before.id in pair and ball not in pair for pair in event.pairs):
            return False
    return False


def _passes(table: Table, rollout: Rollout, flight: Flight) -> Iterator[_Pass]:
    """The balls that the ball of a flight passes over, with when."""
    mover = rollout.start[flight.ball]
    radius = table.body_of(mover)[0]
    for other in rollout.start.on_table():
        if other.id != mover.id:
            its_own = table.body_of(other)[0]
            reach = radius + its_own - COVERED
            # So much higher than the other's its centre has to be where they are that near: a small hop never is.
            if flight.apex + radius - its_own < math.sqrt(COVERED * (radius + its_own + reach)) - _HAIR:
                continue
            for motion, begin, end in pieces(rollout.tracks.get(other.id, ()), flight.start, flight.end):
                passed = _covered(rollout.ball_at(mover.id, begin), motion, begin, end, reach)
                if passed is not None:
                    t = 0.5 * (passed.begin + passed.end)
                    # Not under it.
                    if rollout.ball_at(mover.id, t).z + radius > rollout.ball_at(other.id, t).z + its_own:
                        yield passed


def _covered(flying: Ball, motion: Motion, begin: float, end: float, reach: float) -> _Pass | None:
    """When, from `begin` to `end`, a ball that flies is within `reach` of another in plan; None where it is not."""
    other = motion.at(begin)
    x, y, vx, vy = other.x - flying.x, other.y - flying.y, other.vx - flying.vx, other.vy - flying.vy
    hx, hy = motion.hx, motion.hy
    apart = (
        x * x + y * y - reach * reach,
        2.0 * (x * vx + y * vy),
        vx * vx + vy * vy + 2.0 * (x * hx + y * hy),
        2.0 * (vx * hx + vy * hy),
        hx * hx + hy * hy,
    )
    comes = first_root(*apart, end - begin) if apart[0] > 0.0 else 0.0
    if not comes < math.inf:
        return None
    c0, c1, c2, c3, c4 = apart
    return _Pass(motion.id, begin + comes, begin + min(end - begin, first_root(-c0, -c1, -c2, -c3, -c4, end - begin)))


def _once(balls: list[str]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(balls))
