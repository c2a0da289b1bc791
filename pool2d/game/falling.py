"""Balls that sink into a pocket or leave the table, and the order in which they went: of a rollout and a time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from ..physics.detect import Pocket
from ..physics.event import Event
from ..physics.orientation import BallRotation, Quaternion, product, turn
from ..physics.rollout import Rollout
from ..physics.values import EventKind
from ..table import leaving
from ..table.table import Table

# How long a ball takes from the rim out of sight, s.
DROP = 0.3
# How long it takes at most to come over the middle of the hole, s, and at least.
_OVER = (0.06, 0.2)
# How long a ball is seen yet after the event with which it goes, s.
_SEEN: dict[EventKind, float] = {"ball_pocket": DROP, "ball_off": leaving.FOLLOWED}


class Fall(NamedTuple):
    """A ball sinking: its place, m; `depth` from 0 at the rim to 1 out of sight; its orientation."""

    ball: str
    x: float
    y: float
    depth: float
    orientation: Quaternion
    z: float = 0.0


class Leaving(NamedTuple):
    """A ball leaving the table: its place and height, m; `part` of the time for which it is seen; its orientation."""

    ball: str
    x: float
    y: float
    z: float
    part: float
    orientation: Quaternion


def falling(rollout: Rollout, turning: BallRotation, pockets: Sequence[Pocket], t: float) -> list[Fall]:
    """The balls that are sinking `t` s into the shot, which may be past its end; the deepest first."""
    holes = {pocket.name: pocket for pocket in pockets}
    return [
        _fall(event, holes[event.where], turning, t - event.t)
        for event in _going(rollout, t)
        if event.kind == "ball_pocket" and event.where in holes
    ]


def flying_off(rollout: Rollout, turning: BallRotation, table: Table, t: float) -> list[Leaving]:
    """The balls that have gone over the edge of the table and are seen yet, `t` s into the shot."""
    return [
        _leave(event, turning, table.physics.gravity, t - event.t)
        for event in _going(rollout, t)
        if event.kind == "ball_off"
    ]


def gone(rollout: Rollout, t: float = math.inf) -> list[str]:
    """The balls that are out of sight `t` s into the shot, in the order in which they went."""
    return [event.balls[0] for event in _goings(rollout) if event.t + _SEEN[event.kind] <= t]


def ending(rollout: Rollout) -> float:
    """When there is nothing more to see of the shot, s: all balls rest and none is sinking."""
    return max([rollout.duration, *(event.t + _SEEN[event.kind] for event in _goings(rollout))])


def settling(rollout: Rollout) -> float:
    """When the last ball has reached its place, s; it may still spin there."""
    stops = [event.t for event in rollout.events if event.kind != "spin_end"]
    return max([0.0, *stops, *(event.t + _SEEN[event.kind] for event in _goings(rollout))])


def _goings(rollout: Rollout) -> list[Event]:
    return [event for event in rollout.events if event.kind in _SEEN]


def _going(rollout: Rollout, t: float) -> list[Event]:
    """The events with which those balls went that are seen yet at a time."""
    return [event for event in _goings(rollout) if event.t <= t < event.t + _SEEN[event.kind]]


def _fall(event: Event, hole: Pocket, turning: BallRotation, s: float) -> Fall:
    """A ball `s` seconds after it came over the rim: it slows toward the middle of the hole, and turns on."""
    ball = event.before[event.balls[0]]
    way, speed = math.dist((ball.x, ball.y), (hole.x, hole.y)), math.hypot(ball.vx, ball.vy)
    over = min(max(2.0 * way / speed if speed > 0.0 else math.inf, _OVER[0]), _OVER[1])
    part = 1.0 - max(0.0, 1.0 - s / over) ** 2
    x, y = ball.x + part * (hole.x - ball.x), ball.y + part * (hole.y - ball.y)
    return Fall(ball.id, x, y, s / DROP, _turned(event, turning, s), ball.z)


def _leave(event: Event, turning: BallRotation, gravity: float, s: float) -> Leaving:
    """A ball `s` seconds after it left the table."""
    ball = event.before[event.balls[0]]
    part = s / leaving.FOLLOWED
    return Leaving(ball.id, *leaving.place(ball, gravity, s), part, _turned(event, turning, s))


def _turned(event: Event, turning: BallRotation, s: float) -> Quaternion:
    """The orientation of the ball of an event, `s` seconds later: its spin lasts."""
    ball = event.before[event.balls[0]]
    return product(turn(s * ball.wx, s * ball.wy, s * ball.wz), turning.at(ball.id, event.t))
