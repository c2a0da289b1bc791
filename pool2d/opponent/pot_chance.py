"""How likely a pot comes off: a model that is quick enough for every ball and pocket after every stroke.

A ball goes in where its direction is within the pocket's window, which `grazes` finds on the engine. How much that
direction strays is what the hand's errors come to: those of the cue ball's direction, which a distance and a thin cut
make wider, and what spin that was not meant adds by throw. `python -m benchmarks.chances` plays random pots with the
errors of random hands and holds this against what falls; with `--fit` it finds the constants again. Of 1600 pots other
than those of the fit, 50 strokes each, no tenth of the chances was off by more than 4 in 100; Brier's score was 0.122,
and 0.113 the least that could be had. Soft strokes come off a little more often than it says, hard ones less.
"""

from __future__ import annotations

import math
from typing import Final, NamedTuple

import numpy as np
import numpy.typing as npt

from .stray import AIM, TIP, Hand

Floats = npt.NDArray[np.float64]

# A ball is cut by no more than this, degrees.
THINNEST: Final = 78.0
# An aim is no truer than this, radians: see `aiming.GOOD`.
_TRUE: Final = 4e-4


class Spread(NamedTuple):
    """What `python -m benchmarks.chances --fit` finds on the engine.

    `turn` is what the tip's error, in radii, turns the cue ball by, radians: squirt, and swerve beside it; `throw` what
    it turns the ball by that is hit; `usual` how much wider errors are than in easy strokes (`stray.awkward`).
    """

    turn: float
    throw: float
    usual: float


SPREAD: Final = Spread(turn=0.083, throw=0.2, usual=1.2)


def spread(hand: Hand, radius: float, fitted: Spread = SPREAD) -> float:
    """How much the cue ball's direction strays in an easy stroke, radians."""
    return math.hypot(math.radians(AIM) * hand.aim, fitted.turn * TIP * hand.tip / radius)


def strays(hand: Hand, radius: float, lead: Floats, cut: Floats, fitted: Spread = SPREAD) -> Floats:
    """How much a ball's direction strays, radians, that is cut so thick by a cue ball that comes from so far, m.

    A cue ball that is turned meets its ball `lead` times that beside the place that was meant; the line through both
    turns by this over the distance of their middles, and over the cosine of the cut.
    """
    gain = lead / (2.0 * radius * np.cos(np.minimum(cut, math.radians(THINNEST))))
    thrown = fitted.throw * TIP * hand.tip / radius
    found: Floats = np.hypot(fitted.usual * np.hypot(spread(hand, radius, fitted) * gain, thrown), _TRUE)
    return found


def within(half: float, strays: float) -> float:
    """The chance that a direction that strays so much is within half a window of what was meant."""
    return math.erf(half / (math.sqrt(2.0) * strays))
