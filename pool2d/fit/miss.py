"""How far the engine's balls are from where they were seen, and how that changes with what a shot began with."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace

import numpy as np

from ..errors import BudgetError, InputError
from ..physics.rollout import Rollout
from ..physics.simulate import simulate
from ..physics.values import Ball, Layout
from ..table.table import Table
from . import launch
from .evidence import Evidence
from .tracks import Floats, Track

# Balls that are seen a little in each other or in a cushion are set apart in so many rounds.
_ROUNDS = 30
# And a hair more, m, lest rounding undo it.
_HAIR = 1e-9


@dataclass(frozen=True, slots=True)
class Stretch:
    """A shot as far as it is looked at: until `end`, s on the tracks' clock."""

    seen: Evidence
    end: float
    elevation: float = 0.0
    # What is looked at of each ball's track.
    tracks: Mapping[str, Track] = field(init=False)

    def __post_init__(self) -> None:
        tracks = {ball: track.until(self.end) for ball, track in self.seen.shot.tracks.items()}
        object.__setattr__(self, "tracks", tracks)

    def up_to(self, seconds: float) -> Stretch:
        """The same shot so far only, s from the strike."""
        return replace(self, end=min(self.end, self.seen.moment + seconds))


def misses(table: Table, stretch: Stretch, numbers: Floats) -> Floats:
    """How far off each ball is at each of its points, m: all of x and y, ball by ball."""
    return off(stretch, play(table, stretch, numbers), numbers[launch.MOMENT])


def off(stretch: Stretch, rollout: Rollout, moment: float) -> Floats:
    """As `misses`, of a shot that was played, where the cue struck at `moment`."""
    parts = []
    for ball, track in stretch.tracks.items():
        x, y = places(rollout, ball, track.t - moment)
        parts += [x - track.x, y - track.y]
    return np.concatenate(parts)


def places(rollout: Rollout, ball: str, times: Floats) -> tuple[Floats, Floats]:
    """Where a ball is at times of a rollout, s; before the strike it is where it stood."""
    motions = np.array([(m.t0, m.x, m.y, m.vx, m.vy, m.hx, m.hy) for m in rollout.tracks[ball]])
    times = np.maximum(times, 0.0)
    t, x, y, vx, vy, hx, hy = motions[np.searchsorted(motions[:, 0], times, side="right") - 1].T
    since = times - t
    return x + (vx + hx * since) * since, y + (vy + hy * since) * since


def play(table: Table, stretch: Stretch, numbers: Floats) -> Rollout:
    """The shot that a row of numbers means, as far as it is looked at."""
    begun = launch.launch_of(stretch.seen, numbers, stretch.elevation)
    last = stretch.end - begun.moment
    layout = standing(table, begun.layout)
    try:
        return simulate(table, layout, begun.shot, until=lambda event: event.t > last)
    except BudgetError:
        return simulate(table, layout)


def standing(table: Table, layout: Layout) -> Layout:
    """The layout with balls set apart that were seen in each other or in a cushion; raises InputError where they lie
    so deep that they were not."""
    for _ in range(_ROUNDS):
        try:
            return table.settle(layout)
        except InputError:
            layout = _parted(table, layout)
    return table.settle(layout)


def stands(table: Table, seen: Evidence) -> bool:
    """Whether balls can stand where they were seen before the strike, or a little beside."""
    with suppress(InputError):
        return bool(standing(table, Layout(Ball(ball, x, y) for ball, (x, y) in seen.places.items())))
    return False


def _parted(table: Table, layout: Layout) -> Layout:
    """The layout with each ball moved out of a cushion and of those before it."""
    for ball in layout.on_table():
        x, y = ball.x, ball.y
        gap, element = table.element_gap(x, y, table.body_of(ball)[0])
        if element is not None and gap < 0.0:
            nx, ny = element.normal(x, y)
            x, y = x + (gap - _HAIR) * nx, y + (gap - _HAIR) * ny
        for other in layout.on_table():
            far, touch = np.hypot(x - other.x, y - other.y), table.touch(ball, other)
            if other.id < ball.id and far < touch:
                part = (touch + _HAIR) / max(far, _HAIR) - 1.0
                x, y = x + part * (x - other.x), y + part * (y - other.y)
        layout = layout.put(ball._replace(x=float(x), y=float(y)))
    return layout


def launch_slopes(table: Table, stretch: Stretch, numbers: Floats) -> Floats:
    """How the misses change with each number of the launch: a column for each."""
    rollout = play(table, stretch, numbers)
    base, step = off(stretch, rollout, numbers[launch.MOMENT]), launch.steps(stretch.seen)
    columns = np.empty((len(base), len(numbers)))
    for i, size in enumerate(step):
        turned = numbers.copy()
        turned[i] += size
        # Another moment is the same shot at another time.
        there = off(stretch, rollout, turned[i]) if i == launch.MOMENT else misses(table, stretch, turned)
        columns[:, i] = (there - base) / size
    return columns
