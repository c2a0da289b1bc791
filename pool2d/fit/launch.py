"""How a shot began: the strike, when it was, and where the balls stood. To a fit it is a row of numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from ..physics.strike import strike
from ..physics.values import Ball, Layout, Shot
from ..table.table import Table
from .evidence import Evidence
from .tracks import Floats

# The strike's numbers, in their order: degrees, m/s, radii, radii, s; then x and y, m, of each ball that moved.
STRIKE: Final = ("angle", "speed", "side", "height", "moment")
# How far each is turned at first while it is sought, and by how little for a derivative.
_SCALES, _PLACE_SCALE = (1.0, 0.2, 0.1, 0.1, 0.01), 0.001
_STEPS, _PLACE_STEP = (1e-4, 1e-6, 1e-6, 1e-6, 1e-6), 1e-7
# Number of the moment, and of the first place.
MOMENT, PLACES = 4, 5
# No tip strikes farther out; no shot is slower or faster, m/s.
_EDGE, _SLOWEST, _FASTEST = 0.9, 0.01, 30.0
# A ball stood no farther than this from where it was seen to stand, m.
_REACH = 0.03
# English that is tried at first, to the side and up.
_SIDES, _HEIGHTS = (-0.25, 0.0, 0.25), (-0.05, 0.25)
# The first way of the struck ball is taken from so many points, or until it has turned by so much, degrees.
_FIRST, _TURN = 8, 6.0


@dataclass(frozen=True, slots=True)
class Launch:
    """How a shot began; `moment` is when the cue struck, s on the tracks' clock."""

    layout: Layout
    shot: Shot
    moment: float


def scales(seen: Evidence) -> Floats:
    """How far each number of a launch is turned at first."""
    return np.array([*_SCALES, *[_PLACE_SCALE] * 2 * len(seen.moved)])


def steps(seen: Evidence) -> Floats:
    """By how little each number is turned for a derivative."""
    return np.array([*_STEPS, *[_PLACE_STEP] * 2 * len(seen.moved)])


def launch_of(seen: Evidence, numbers: Floats, elevation: float) -> Launch:
    """What a row of numbers means; what no cue can do is taken as the nearest that it can."""
    angle, speed, side, height, moment, *places = numbers.tolist()
    part = min(1.0, _EDGE / math.hypot(side, height, 1e-9))
    speed = min(max(speed, _SLOWEST), _FASTEST)
    shot = Shot(math.remainder(angle, 360.0), speed, part * side, part * height, elevation, seen.struck)
    own = dict(zip(seen.moved, zip(places[::2], places[1::2], strict=True), strict=True))
    balls = (Ball(ball, *_near(own.get(ball, place), place)) for ball, place in seen.places.items())
    return Launch(Layout(balls), shot, moment)


def _near(wanted: tuple[float, float], place: tuple[float, float]) -> tuple[float, float]:
    """A place, no farther from where a ball was seen than it may be."""
    x, y = (min(max(one, seen - _REACH), seen + _REACH) for one, seen in zip(wanted, place, strict=True))
    return x, y


def guesses(table: Table, seen: Evidence, elevation: float) -> Iterator[Floats]:
    """Rows of numbers to begin with: the first way of the struck ball, with english of several kinds."""
    angle, speed, moment = _first_way(seen)
    places = [number for ball in seen.moved for number in seen.places[ball]]
    for side in _SIDES:
        for height in _HEIGHTS:
            turned, gain = _sent(table, seen, Shot(0.0, 1.0, side, height, elevation, seen.struck))
            yield np.array([angle - turned, speed / gain, side, height, moment, *places])


def _sent(table: Table, seen: Evidence, shot: Shot) -> tuple[float, float]:
    """How a strike along x at 1 m/s sends the ball: degrees and m/s."""
    (body,) = table.bodies([Ball(seen.struck, 0.0, 0.0)])
    strike(body, replace(shot), table.physics.cue)
    return math.degrees(math.atan2(body.vy, body.vx)), math.hypot(body.vx, body.vy)


def _first_way(seen: Evidence) -> tuple[float, float, float]:
    """The struck ball's direction, degrees, its speed, m/s, and when it left, s, by its first points on the way."""
    t, x, y = _first_points(seen)
    way = math.atan2(y[-1], x[-1])
    gone = x * math.cos(way) + y * math.sin(way)
    if len(t) == 1:
        # Seen once: it left when it was last seen at its place.
        return math.degrees(way), gone[0] / max(t[0] - seen.moment, 1e-3), seen.moment
    speed, start = np.polyfit(t, gone, 1)
    return math.degrees(way), max(speed, _SLOWEST), min(-start / max(speed, _SLOWEST), float(t[0]))


def _first_points(seen: Evidence) -> tuple[Floats, Floats, Floats]:
    """The struck ball's first points from its place, until it meets something."""
    track, (x0, y0) = seen.shot.tracks[seen.struck], seen.places[seen.struck]
    first = int(np.searchsorted(track.t, seen.moment, side="right"))
    some = slice(first, first + _FIRST)
    t, x, y = track.t[some], track.x[some] - x0, track.y[some] - y0
    ways = np.unwrap(np.arctan2(np.diff(y, prepend=0.0), np.diff(x, prepend=0.0)))
    turned = np.abs(ways - ways[0]) > math.radians(_TURN)
    met = (t > seen.meeting(1)) | turned
    count = max(1, int(np.argmax(met)) if met.any() else len(t))
    return t[:count], x[:count], y[:count]
