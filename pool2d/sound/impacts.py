"""Which sounds a stretch of a rollout makes: of what kind, how hard, and where on the table."""

from __future__ import annotations

import math
from bisect import bisect_right
from typing import Literal, NamedTuple, TypeAlias

from ..physics.event import Event
from ..physics.rollout import Rollout
from ..physics.values import MISCUE, Ball
from ..table import leaving

SoundKind: TypeAlias = Literal[
    "ball", "cue", "cushion", "slate", "rail", "floor", "drop", "back", "miscue", "chalk", "click",
]  # fmt: skip
# A longer step of time than this, s, is a jump and not play.
_JUMP = 1.0
# Of a cluster only the strongest pairs are heard.
_PAIRS = 4
# What a ball falls by at a pocket gives it this speed, m/s, however slowly it came.
_FALL = 1.4
# A stroke that drives a ball into the slate so fast that it leaves it faster than this, m/s, is heard to do so.
_HOP = 0.1


class Impact(NamedTuple):
    """A sound: its kind (`synth` makes each), the speed of the contact, m/s, and its x on the table, m."""

    kind: SoundKind
    speed: float
    x: float


def impacts(rollout: Rollout, t0: float, t1: float, gravity: float = 9.81) -> list[Impact]:
    """The sounds of the events in (t0, t1], s; none where t1 is not after t0, or so far after that time has jumped.

    The stroke's own sound is at 0, so it is heard where `t0` is below 0. A ball off the table is heard once it has
    fallen to the floor, by `gravity` in m/s2.
    """
    if not t0 < t1 <= max(t0, 0.0) + _JUMP:
        return []
    events = rollout.events
    first, last = (bisect_right(events, t, key=lambda event: event.t) for t in (t0, t1))
    heard = [sound for event in events[first:last] for sound in _sounds(event)]
    begun = bisect_right(events, t0 - leaving.FOLLOWED, key=lambda event: event.t)
    off = (event for event in events[begun:last] if event.kind == "ball_off")
    return heard + [sound for event in off for sound in _floor(event, t0, t1, gravity)]


def _sounds(event: Event) -> list[Impact]:
    if event.kind == "cue_ball":
        ball = event.after[event.balls[0]]
        tip = Impact("miscue" if event.where == MISCUE else "cue", math.hypot(ball.vx, ball.vy, ball.vz), ball.x)
        into = [Impact("slate", ball.vz, ball.x)] if ball.vz > _HOP else []
        return [tip, *into, *_balls(event), *_cushions(event)]
    if event.kind == "ball_slate":
        ball = event.before[event.balls[0]]
        return [Impact("slate" if event.where is None else "rail", abs(ball.vz), ball.x)]
    if event.pairs or event.rails:
        return [*_balls(event), *_cushions(event)]
    if event.kind == "ball_pocket":
        ball = event.before[event.balls[0]]
        return [Impact("drop", math.hypot(ball.vx, ball.vy, _FALL), ball.x), Impact("back", 1.0, ball.x)]
    return []


def _floor(event: Event, t0: float, t1: float, gravity: float) -> list[Impact]:
    """A ball off the table meets the floor, if it does so in (t0, t1], s."""
    ball = event.before[event.balls[0]]
    if leaving.taken_off(ball):
        return []
    after, speed = leaving.landing(ball, gravity)
    return [Impact("floor", speed, ball.x)] if t0 < event.t + after <= t1 else []


def _balls(event: Event) -> list[Impact]:
    """A knock for each pair of balls that touched, at most a few.

    Its speed is the pair's approach, or half of what the contact changed of that, whichever is more: the second
    tells for balls that touched before.
    """
    before, after = event.before, event.after
    sounds = []
    for one, other in event.pairs:
        a, b = before[one], before[other]
        approach, change = _approach(a, b), _approach(a, b) - _approach(after[one], after[other])
        sounds.append(Impact("ball", max(approach, 0.5 * change, 0.0), 0.5 * (a.x + b.x)))
    sounds.sort(key=lambda sound: -sound.speed)
    return sounds[:_PAIRS]


def _cushions(event: Event) -> list[Impact]:
    """A thud for each ball that met a cushion in the event."""
    before, after = event.before, event.after
    met = dict.fromkeys(name for name, _ in event.rails)
    return [Impact("cushion", _blow(before[name], after[name]), before[name].x) for name in met]


def _approach(a: Ball, b: Ball) -> float:
    """The speed at which two balls near each other, m/s."""
    dx, dy, dz = b.x - a.x, b.y - a.y, b.z - a.z
    return ((a.vx - b.vx) * dx + (a.vy - b.vy) * dy + (a.vz - b.vz) * dz) / math.hypot(dx, dy, dz)


def _blow(before: Ball, after: Ball) -> float:
    """How hard a ball met a cushion, m/s: half the change of its velocity, about its speed across the cushion."""
    return 0.5 * math.hypot(after.vx - before.vx, after.vy - before.vy, after.vz - before.vz)
