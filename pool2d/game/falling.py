"""Balls that sink into a pocket, and the order in which they fell: functions of a rollout and a time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from ..physics.detect import Pocket
from ..physics.event import Event
from ..physics.orientation import BallRotation, Quaternion, product, turn
from ..physics.rollout import Rollout

# How long a ball takes from the rim out of sight, s.
DROP = 0.3
# How long it takes at most to come over the middle of the hole, s, and at least.
_OVER = (0.06, 0.2)


class Fall(NamedTuple):
    """A ball sinking: its place, m; `depth` from 0 at the rim to 1 out of sight; its orientation."""

    ball: str
    x: float
    y: float
    depth: float
    orientation: Quaternion


def falling(rollout: Rollout, turning: BallRotation, pockets: Sequence[Pocket], t: float) -> list[Fall]:
    """The balls that are sinking `t` s into the shot, which may be past its end; the deepest first."""
    holes = {pocket.name: pocket for pocket in pockets}
    return [
        _fall(event, holes[event.where], turning, t - event.t)
        for event in _drops(rollout)
        if event.t <= t < event.t + DROP and event.where in holes
    ]


def fallen(rollout: Rollout, t: float = math.inf) -> list[str]:
    """The balls that are out of sight `t` s into the shot, in the order in which they fell."""
    return [event.balls[0] for event in _drops(rollout) if event.t + DROP <= t]


def ending(rollout: Rollout) -> float:
    """When there is nothing more to see of the shot, s: all balls rest and none is sinking."""
    return max([rollout.duration, *(event.t + DROP for event in _drops(rollout))])


def settling(rollout: Rollout) -> float:
    """When the last ball has reached its place, s; it may still spin there."""
    stops = [event.t for event in rollout.events if event.kind != "spin_end"]
    return max([0.0, *stops, *(event.t + DROP for event in _drops(rollout))])


def _drops(rollout: Rollout) -> list[Event]:
    return [event for event in rollout.events if event.kind == "ball_pocket"]


def _fall(event: Event, hole: Pocket, turning: BallRotation, s: float) -> Fall:
    """A ball `s` seconds after it came over the rim: it slows toward the middle of the hole, and turns on."""
    ball = event.before[event.balls[0]]
    way, speed = math.dist((ball.x, ball.y), (hole.x, hole.y)), math.hypot(ball.vx, ball.vy)
    over = min(max(2.0 * way / speed if speed > 0.0 else math.inf, _OVER[0]), _OVER[1])
    part = 1.0 - max(0.0, 1.0 - s / over) ** 2
    orientation = product(turn(s * ball.wx, s * ball.wy, s * ball.wz), turning.at(ball.id, event.t))
    return Fall(ball.id, ball.x + part * (hole.x - ball.x), ball.y + part * (hole.y - ball.y), s / DROP, orientation)
