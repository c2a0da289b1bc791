"""The hand that lets a cue run on after the hit, and stops it."""

from __future__ import annotations

from typing import Final

from ..roots import INF, falling_root

# For so much of its time the tip runs on freely; then the hand stops it, evenly.
FREE: Final = 2.0 / 3.0
# A cue that is faster than this after the hit, m/s, is followed through as far as an arm goes; a slower one for as long
# as it takes at this speed.
SWING: Final = 2.4
# And one that is slower than this is stopped the sooner the slower it is: a hand can brake it well.
EASED: Final = 0.5
# Of the tip's way: from when until when, how far along it is at first, m, how fast, and half the acceleration.
Stretch = tuple[float, float, float, float, float]


def lasting(speed: float, follow_through: float) -> float:
    """For how long a tip runs on that goes at `speed` after the hit, m/s, until the hand has stopped it, s."""
    return follow_through / (FREE + 0.5 * (1.0 - FREE)) / max(speed, SWING) * min(1.0, speed / EASED)


def way(t: float, speed: float, brake: float, gone: float, room: float) -> list[Stretch]:
    """The stretches of a tip's way from the time `t` on: free, and braked by the hand; none goes beyond `room`, m."""
    found: list[Stretch] = []
    s, v = 0.0, speed
    for until in (brake, gone):
        span = until - t
        if span <= 0.0:
            continue
        h = -0.5 * v / span if until == gone else 0.0
        down = falling_root(room - s, -v, -h) if room < INF else INF
        if down < span:
            found.append((t, t + down, s, v, h))
            break
        found.append((t, until, s, v, h))
        t, s, v = until, s + (v + h * span) * span, v + 2.0 * h * span
    return found
