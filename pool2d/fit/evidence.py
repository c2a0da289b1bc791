"""What the tracks of a shot tell by themselves: which ball was struck and when, where balls stood, when balls met."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations

import numpy as np
import numpy.typing as npt

from ..table.table import Table
from .tracks import Floats, Track, TrackedShot

# A ball has left its place when it is so far from it, m, or so many times what it is seen off by.
_AWAY, _AWAY_NOISES = 0.002, 6.0
# How many of the first points say where a ball stood.
_FIRST = 5
# Balls are taken to meet where the ways between their points come so near, m, from so far; in so many steps a point.
_NEAR, _FAR, _STEPS = 0.015, 0.05, 8
# Meetings as near in time as this, s, are one.
_ONE = 0.05


@dataclass(frozen=True, slots=True)
class Evidence:
    """A tracked shot and what it tells at a glance.

    `places` are where balls stood at first, m; `moved` those that left their place, the struck one first; `moment`
    about when the cue struck, and `meetings` about when balls met, s.
    """

    shot: TrackedShot
    places: Mapping[str, tuple[float, float]]
    moved: tuple[str, ...]
    moment: float
    meetings: tuple[float, ...]

    @property
    def struck(self) -> str:
        """The ball that was struck."""
        return self.moved[0]

    def meeting(self, number: int) -> float:
        """When balls met for the so-manieth time, from 1; the shot's end where they did not as often, s."""
        return self.meetings[number - 1] if len(self.meetings) >= number else self.shot.end


def evidence(shot: TrackedShot, table: Table, noise: float) -> Evidence | None:
    """What the tracks tell on their own, seen `noise` m off; None where no ball moves."""
    left = {ball: _departure(track, noise) for ball, track in shot.tracks.items()}
    moved = sorted(
        (ball for ball in left if left[ball] < len(shot.tracks[ball])), key=lambda ball: _time(shot, ball, left)
    )
    if not moved:
        return None
    places = {ball: _place(track, left[ball]) for ball, track in shot.tracks.items()}
    starts = [_time(shot, ball, left) for ball in moved]
    meets = sorted([*starts[1:], *_approaches(shot, moved, 2.0 * table.knobs.ball.radius)])
    return Evidence(shot, places, tuple(moved), starts[0], tuple(_merged(meets)))


def _departure(track: Track, noise: float) -> int:
    """The number of the first point at which a ball has left its place, as the next confirms; as many as there are."""
    gone = np.hypot(track.x - np.median(track.x[:_FIRST]), track.y - np.median(track.y[:_FIRST]))
    away = gone > max(_AWAY, _AWAY_NOISES * noise)
    return _first(away & np.append(away[1:], away[-1:]))


def _first(flags: npt.NDArray[np.bool_]) -> int:
    """The number of the first that is so; as many as there are where none is."""
    return int(np.argmax(flags)) if flags.any() else len(flags)


def _time(shot: TrackedShot, ball: str, left: Mapping[str, int]) -> float:
    """When a ball left its place: between the last point there and the next."""
    t, first = shot.tracks[ball].t, left[ball]
    return float(t[first] if first == 0 else 0.5 * (t[first] + t[first - 1]))


def _place(track: Track, left: int) -> tuple[float, float]:
    """Where a ball stood. The last point before it was seen away may be on the way already."""
    count = max(1, left - 1 if left < len(track) else left)
    return float(np.mean(track.x[:count])), float(np.mean(track.y[:count]))


def _approaches(shot: TrackedShot, moved: list[str], touch: float) -> Iterator[float]:
    """When two balls that both move come near each other after they were apart, s."""
    for a, b in combinations(moved, 2):
        first, second = shot.tracks[a], shot.tracks[b]
        times = _between(first.t[(first.t >= second.t[0]) & (first.t <= second.t[-1])])
        gaps = (
            np.hypot(
                *(
                    np.interp(times, first.t, p) - np.interp(times, second.t, q)
                    for p, q in ((first.x, second.x), (first.y, second.y))
                )
            )
            - touch
        )
        apart = True
        for t, gap in zip(times.tolist(), gaps.tolist(), strict=True):
            if apart and gap < _NEAR:
                yield t
            apart = gap > _FAR or (apart and gap >= _NEAR)


def _between(times: Floats) -> Floats:
    """Times, and some more between each and the next."""
    return np.interp(np.arange(_STEPS * len(times)) / _STEPS, np.arange(len(times)), times) if len(times) else times


def _merged(times: list[float]) -> Iterator[float]:
    """The times without those that follow another at once."""
    last = -math.inf
    for t in times:
        if t - last > _ONE:
            yield t
        last = t
