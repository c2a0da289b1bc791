"""An aim refined on the engine, until throw, squirt, swerve and the rails' own angles are in it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Final

from ..physics.event import Event
from ..physics.simulate import simulate
from ..physics.values import Layout, Shot
from ..table.table import Table

# An aim is good that sends a ball within this of where it is meant to go, radians; so many looks find it.
GOOD: Final = 4e-4
LOOKS: Final = 7
# What one look may turn the cue by, radians.
_TURN: Final = 0.06


def aimed_at(table: Table, layout: Layout, shot: Shot, ball: str, direction: float, lead: float) -> Shot | None:
    """The shot turned so that it sends a ball off in a direction, radians; None where that cannot be had.

    `lead` is how far the cue ball goes before it meets the ball, m.
    """
    angle = math.radians(shot.angle)
    touch = table.touch(layout[shot.ball], layout[ball])
    meets = _first_contact(shot.ball)
    for _ in range(LOOKS):
        shot = replace(shot, angle=math.degrees(angle))
        rollout = simulate(table, layout, shot, until=meets)
        event = rollout.events[-1] if rollout.events else None
        if event is None or not any(shot.ball in pair for pair in event.pairs):
            return None
        if not any(ball in pair and shot.ball in pair for pair in event.pairs):
            return None
        sent = rollout.ball_at(ball, event.t)
        if math.hypot(sent.vx, sent.vy) < 1e-6:
            return None
        error = _turned(math.atan2(sent.vy, sent.vx) - direction)
        if abs(error) < GOOD:
            return shot
        cosine = math.cos(min(abs(_turned(direction - angle)), 1.4))
        slope = max(lead / (touch * cosine), 0.05)
        angle += min(max(error / slope, -_TURN), _TURN)
    return None


def _first_contact(cue: str) -> Callable[[Event], bool]:
    def meets(event: Event) -> bool:
        return any(cue in pair for pair in event.pairs)

    return meets


def _turned(angle: float) -> float:
    """An angle brought between -pi and pi."""
    return (angle + math.pi) % (2.0 * math.pi) - math.pi
