"""Tracks of shots that nobody played: made by the engine from known knobs, as a camera would have seen them.

What a fit makes of them can be held against the knobs that they were made from.
"""

from __future__ import annotations

import csv
import io
import math
import random
from collections.abc import Iterable, Iterator

import numpy as np

from ..physics.rollout import Rollout
from ..physics.simulate import simulate
from ..physics.values import GONE, Ball, Layout, Shot
from ..table.table import Table
from .track_file import COLUMNS
from .tracks import Track, TrackedShot

# Pictures a second, how far off a ball is seen, m, and how long it is watched before the strike, s.
RATE, NOISE, _BEFORE = 50.0, 0.0004, 0.4
# A shot is watched for so long after the strike, s.
LONGEST = 10.0
# How many balls lie on the table, and how fast a cue is, m/s.
_BALLS, _SLOWEST, _FASTEST = 3, 1.5, 4.5
# How far from the ball's centre the tip strikes, and how far beside the middle of another ball is aimed, in radii.
_ENGLISH, _BESIDE = 0.4, 1.6


def make_shots(
    table: Table, count: int, seed: int, noise: float = NOISE, longest: float = LONGEST
) -> Iterator[TrackedShot]:
    """So many shots, drawn from `seed`: balls at random places, one of them sent at another with random english."""
    rng = random.Random(seed)
    for number in range(1, count + 1):
        layout = _layout(table, rng)
        rollout = simulate(table, layout, _shot(layout, table, rng))
        yield watched(str(number), rollout, rng.randrange(1 << 31), noise, longest)


def watched(name: str, rollout: Rollout, seed: int, noise: float = NOISE, longest: float = LONGEST) -> TrackedShot:
    """A shot as a camera sees it that began a little before, at a moment of its own; `noise` in m."""
    rng = np.random.default_rng(seed)
    struck = _BEFORE + rng.uniform(0.0, 1.0 / RATE)
    count = math.ceil((struck + min(rollout.duration, longest)) * RATE) + 1
    times = np.arange(count) / RATE
    tracks = {}
    for ball in rollout.start:
        seen = [rollout.ball_at(ball, max(0.0, t - struck)) for t in times.tolist()]
        # A ball that has fallen or left the table is seen no more.
        seen = [at for at in seen if at.phase not in GONE]
        x, y = (np.array([getattr(at, axis) for at in seen]) for axis in ("x", "y"))
        tracks[ball] = Track(
            times[: len(seen)], x + rng.normal(0.0, noise, len(seen)), y + rng.normal(0.0, noise, len(seen))
        )
    return TrackedShot(name, tracks)


def to_csv(shots: Iterable[TrackedShot]) -> str:
    """The file of some shots, to a hundredth of a millimetre."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for shot in shots:
        for ball, track in shot.tracks.items():
            for t, x, y in zip(track.t.tolist(), track.x.tolist(), track.y.tolist(), strict=True):
                writer.writerow((shot.name, f"{t:.4f}", ball, f"{x:.5f}", f"{y:.5f}"))
    return text.getvalue()


def _layout(table: Table, rng: random.Random) -> Layout:
    """The cue ball and others at random, with room around each."""
    radius, size = table.knobs.ball.radius, table.knobs.table
    layout = Layout()
    for name in (table.furniture.cue, *table.furniture.balls)[:_BALLS]:
        while name not in layout:
            x, y = rng.uniform(0.0, size.length), rng.uniform(0.0, size.width)
            if table.has_room(x, y, 2.0 * radius, layout):
                layout = layout.put(Ball(name, x, y))
    return layout


def _shot(layout: Layout, table: Table, rng: random.Random) -> Shot:
    cue, other, *_ = layout.values()
    beside = rng.uniform(-_BESIDE, _BESIDE) * table.knobs.ball.radius
    side, height = _english(rng)
    return Shot(_angle(cue, other, beside), rng.uniform(_SLOWEST, _FASTEST), side, height, ball=cue.id)


def _angle(cue: Ball, other: Ball, beside: float) -> float:
    """The way, in degrees, that passes the middle of another ball at `beside` m."""
    dx, dy = other.x - cue.x, other.y - cue.y
    return math.degrees(math.atan2(dy, dx) + math.asin(beside / math.hypot(dx, dy))) % 360.0


def _english(rng: random.Random) -> tuple[float, float]:
    """Where the tip strikes, more often above the centre than below it."""
    side, height = rng.uniform(-_ENGLISH, _ENGLISH), rng.uniform(-0.5 * _ENGLISH, _ENGLISH)
    part = min(1.0, _ENGLISH / math.hypot(side, height))
    return side * part, height * part
