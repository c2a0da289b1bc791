"""How far a ball may graze the jaws of a pocket and still falls: tried on the engine, for whatever table it is.

No one number holds: at jaws of 10 mm a pool ball goes in that would touch them by a tenth of its radius, at the long
curves of snooker by half of it where it comes from the other side, between the jaws of pyramid hardly at all.
"""

from __future__ import annotations

import math
from typing import Final, NamedTuple

import numpy as np
import numpy.typing as npt

from ..physics.event import Event
from ..physics.simulate import simulate
from ..physics.values import Ball, Layout
from ..table.table import Table

# Off a pocket's axis, evenly, radians.
ANGLES: Final = tuple(math.radians(angle) for angle in (-66.0, -44.0, -22.0, 0.0, 22.0, 44.0, 66.0))
# How fast balls come, m/s: a fast one has to be truer. What holds is the mean.
SPEEDS: Final = (0.8, 2.0, 3.5)
# From how far they come, m, and in how many halvings the edge is found.
_AWAY: Final = 0.4
_HALVINGS: Final = 7
# A ball that comes back further than this, in those, has not fallen.
_BACK: Final = 1.3


class GapFrame(NamedTuple):
    """A pocket's mouth: its middle, the direction from there out of the table, and the jaws as seen from the bed."""

    name: str
    middle: tuple[float, float]
    axis: float
    right: tuple[float, float]
    left: tuple[float, float]
    radius: float


def grazes(table: Table, frame: GapFrame) -> npt.NDArray[np.float64]:
    """How far a ball may graze the right and the left jaw, (2, A), in units of how far from a nose it touches.

    A pocket is its own mirror image: what holds of one jaw holds of the other the other way round.
    """
    right = [float(np.mean([_grazed(table, frame, off, speed) for speed in SPEEDS])) for off in ANGLES]
    return np.array([right, right[::-1]], dtype=float)


def _grazed(table: Table, frame: GapFrame, off: float, speed: float) -> float:
    """How far the right jaw may be grazed at an angle and a speed; where nothing falls, the window shuts there."""
    reach = table.reach(table.knobs.ball.radius)
    low = _beside(frame, frame.right, off) + frame.radius + reach
    high = _beside(frame, frame.left, off) - frame.radius - reach
    inside, outside = 0.5 * (low + high), low - reach
    if inside <= outside or not falls(table, frame, off, inside, speed):
        return (low - inside) / reach
    for _ in range(_HALVINGS):
        middle = 0.5 * (inside + outside)
        if falls(table, frame, off, middle, speed):
            inside = middle
        else:
            outside = middle
    return (low - 0.5 * (inside + outside)) / reach


def _beside(frame: GapFrame, place: tuple[float, float], off: float) -> float:
    """How far to the left a place is of the way through a mouth's middle."""
    way = frame.axis + off
    return (place[1] - frame.middle[1]) * math.cos(way) - (place[0] - frame.middle[0]) * math.sin(way)


def falls(table: Table, frame: GapFrame, off: float, beside: float, speed: float) -> bool:
    """Whether a ball falls that comes rolling so far off a pocket's axis, to pass so far beside its middle."""
    ball = _coming(table, frame, off, beside, speed)
    if not table.has_room(ball.x, ball.y, table.knobs.ball.radius, Layout()):
        return False

    def over(event: Event) -> bool:
        after = event.after["1"]
        return event.kind == "ball_pocket" or math.dist((after.x, after.y), frame.middle) > _BACK * _AWAY

    last = simulate(table, Layout([ball]), until=over).events[-1]
    return last.kind == "ball_pocket" and last.where == frame.name


def _coming(table: Table, frame: GapFrame, off: float, beside: float, speed: float) -> Ball:
    """A ball on such a way, rolling."""
    way, radius = frame.axis + off, table.knobs.ball.radius
    ux, uy = math.cos(way), math.sin(way)
    x, y = frame.middle[0] - ux * _AWAY - uy * beside, frame.middle[1] - uy * _AWAY + ux * beside
    return Ball("1", x, y, speed * ux, speed * uy, -speed * uy / radius, speed * ux / radius)
