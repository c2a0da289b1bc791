"""A hand: how far a stroke strays from what is meant.

The errors are normal distributions whose widths are multiples of those of the computer pool tournaments: the same hand
with all multiples at 1 is theirs. The units are what FastFiz, the simulator by Archibald and Altman that those were
played on, gives its `GaussianNoise` (`Noise.h` of version 0.2; a and b of the tip 0.5 mm, theta of the butt 0.1 and phi
of the aim 0.125 degrees, v 0.075 m/s). What makes a stroke awkward widens all of them.
"""

from __future__ import annotations

import math
import random
from dataclasses import dataclass, replace
from typing import Final

from ..config.knobs import knob
from ..physics.values import Ball, Layout, Shot
from ..table.table import Table

# The units: aim and elevation in degrees, the tip's place in m, the cue's speed in m/s.
AIM: Final = 0.125
TIP: Final = 0.0005
SPEED: Final = 0.075
ELEVATION: Final = 0.1

# How much each of these widens errors is common sense: tutors say that it does, by how much was found nowhere.
# A player reaches so far over the bed without a stretch, m; a cue ball that near to the rail behind it, m, has the
# bridge on the rail; strokes up to that speed, m/s, are not hard; a butt raised by so many degrees doubles the errors.
_REACH: Final = 1.0
_BRIDGE: Final = 0.25
_EASY_PACE: Final = 3.0
_RAISED: Final = 30.0
# Slower than this, m/s, and further from the ball's centre than this, in radii, no hand strays.
_SLOWEST: Final = 0.05
_WIDEST: Final = 0.99


@dataclass(frozen=True, slots=True)
class Hand:
    """Errors in multiples of the units above; `strain` is how much awkward strokes widen them."""

    aim: float = knob(1.0, 0.0, 50.0, "", "error of the cue's direction, in units of 0.125 degrees")
    tip: float = knob(1.0, 0.0, 50.0, "", "error of the tip's place on the ball, in units of 0.5 mm")
    speed: float = knob(1.0, 0.0, 50.0, "", "error of the cue's speed, in units of 0.075 m/s")
    elevation: float = knob(1.0, 0.0, 50.0, "", "error of the butt's angle, in units of 0.1 degrees")
    strain: float = knob(1.0, 0.0, 5.0, "", "how much stretch, a rail, a raised butt and pace widen the errors")

    @property
    def steady(self) -> bool:
        """Whether every stroke comes out as it was meant."""
        return not (self.aim or self.tip or self.speed or self.elevation)

    def stray(self, shot: Shot, radius: float, widened: float, rng: random.Random) -> Shot:
        """The stroke that comes of a shot that was meant.

        `radius` is the ball's, m; `widened` what the errors are multiplied by, as `awkward` says. Four numbers are
        drawn whatever the hand, so that hands can be compared stroke by stroke.
        """
        turn, right, up, pace, butt = (rng.gauss(0.0, 1.0) for _ in range(5))
        if self.steady:
            return shot
        tip = TIP * self.tip * widened / radius
        side, height = shot.side + tip * right, shot.height + tip * up
        offset = math.hypot(side, height)
        shrink = min(1.0, _WIDEST / offset) if offset else 1.0
        elevation = abs(shot.elevation + ELEVATION * self.elevation * widened * butt)
        return replace(
            shot,
            angle=shot.angle + AIM * self.aim * widened * turn,
            side=side * shrink,
            height=height * shrink,
            speed=max(_SLOWEST, shot.speed + SPEED * self.speed * widened * pace),
            # A cue that lies level, or on what it has to clear, does not sink into it.
            elevation=max(shot.elevation, elevation) if shot.elevation else 0.0,
        )


def awkward(table: Table, layout: Layout, shot: Shot, strain: float = 1.0) -> float:
    """By how much a stroke's errors are wider than those of an easy one: 1 where nothing is in a player's way.

    What adds to it: a cue ball far from where the player stands, a rail under the bridge, a raised butt, a hard
    stroke.
    """
    cue = layout[shot.ball]
    way = math.radians(shot.angle)
    dx, dy = -math.cos(way), -math.sin(way)
    behind, _ = table.cast(cue.x, cue.y, dx, dy, Layout())
    if math.isinf(behind):
        behind = _to_edge(table, cue, dx, dy)
    stretch = max(0.0, behind - _REACH)
    rail = max(0.0, 1.0 - behind / _BRIDGE)
    pace = max(0.0, shot.speed / _EASY_PACE - 1.0)
    return 1.0 + strain * (0.5 * stretch + 0.5 * rail + shot.elevation / _RAISED + 0.4 * pace)


def _to_edge(table: Table, ball: Ball, dx: float, dy: float) -> float:
    """How far a ball is from the edge of the bed along (dx, dy), m: a way through a pocket's mouth may meet nothing."""
    size = table.knobs.table
    ways = ((ball.x, dx, size.length), (ball.y, dy, size.width))
    return min(max(0.0, ((end if step > 0.0 else 0.0) - at) / step) for at, step, end in ways if step)


def strayed(table: Table, layout: Layout, shot: Shot, hand: Hand, rng: random.Random) -> Shot:
    """The stroke that a hand makes of a shot that was meant, as awkward as it is."""
    radius = table.body_of(layout[shot.ball])[0]
    return hand.stray(shot, radius, awkward(table, layout, shot, hand.strain), rng)
