"""Ways into a pocket that are not straight: a ball is met, or a cushion, before the ball is on its way there.

Geometry says where to begin; then the cue is turned, on the engine, until the ball that has met the last thing on its
way heads for the pocket.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Final, NamedTuple

from ..game.reasons import StrokeKind
from ..physics.event import Event
from ..physics.rollout import Rollout
from ..physics.simulate import simulate
from ..physics.values import Layout, Shot
from ..table.table import Table
from .pot_lines import PotLine

# A ball is on its way that passes the middle of its mouth this near, m; so many looks find it.
_NEAR: Final = 1.5e-3
_LOOKS: Final = 9
# What the cue is turned by at first, and at most, radians.
_FIRST: Final = 1e-3
_MOST: Final = 0.04
# How far apart the aims are with which it begins, as shares of the width of the ball that is met first, and how many.
_APART: Final = 0.08
_BEGINNINGS: Final = (0, 1, -1, 2, -2, 3, -3, 4, -4)
# What is slower than this heads nowhere, m/s.
_STILL: Final = 1e-3


class Route(NamedTuple):
    """A ball's way into a pocket, as geometry has it.

    `angle` is where the cue is to point, radians; `last` what the ball meets last before it heads for `goal`, a ball
    or a cushion. `line` is the straight pot that asks as much of the cue's speed.
    """

    kind: StrokeKind
    line: PotLine
    angle: float
    last: str
    goal: tuple[float, float]


def homed(table: Table, layout: Layout, shot: Shot, route: Route) -> Shot | None:
    """The shot turned until its ball heads for its pocket; None where that is not found."""
    begun = next(_beginnings(table, layout, shot, route), None)
    if begun is None:
        return None
    shot, off = begun
    turn = _FIRST
    for _ in range(_LOOKS):
        if abs(off) < _NEAR:
            return shot
        turned = replace(shot, angle=shot.angle + math.degrees(turn))
        missed = miss(table, layout, turned, route)
        if missed is None or missed == off:
            turn *= 0.5
            continue
        step = missed * turn / (off - missed)
        shot, off, turn = turned, missed, max(-_MOST, min(_MOST, step))
    return None


def _beginnings(table: Table, layout: Layout, shot: Shot, route: Route) -> Iterator[tuple[Shot, float]]:
    """Aims about the one that geometry gives with which the ball meets what it is to meet, and how far off it is."""
    step = _APART * 2.0 * table.body_of(layout[shot.ball])[0] / max(route.line.lead, 0.05)
    for count in _BEGINNINGS:
        turned = replace(shot, angle=math.degrees(route.angle + count * step))
        off = miss(table, layout, turned, route)
        if off is not None:
            yield turned, off


def miss(table: Table, layout: Layout, shot: Shot, route: Route) -> float | None:
    """How far to the left of its goal a ball heads, m; None where it does not head for it at all."""
    rollout = simulate(table, layout, shot, until=_after(route.line.ball, route.last))
    return _beside(rollout, route)


def _beside(rollout: Rollout, route: Route) -> float | None:
    ball, events = route.line.ball, rollout.events
    if not any(_meets(event, ball, route.last) for event in events) or ball not in events[-1].before:
        return None
    here = events[-1].before[ball]
    speed = math.hypot(here.vx, here.vy)
    x, y = route.goal[0] - here.x, route.goal[1] - here.y
    if speed < _STILL or x * here.vx + y * here.vy <= 0.0:
        return None
    return (y * here.vx - x * here.vy) / speed


def _after(ball: str, last: str) -> Callable[[Event], bool]:
    """Ends a shot with what happens to a ball next after it has met the last thing on its way."""
    met = False

    def ends(event: Event) -> bool:
        nonlocal met
        over = met and ball in event.balls
        met = met or _meets(event, ball, last)
        return over

    return ends


def _meets(event: Event, ball: str, last: str) -> bool:
    return any(ball in pair and last in pair for pair in (*event.pairs, *event.rails))
