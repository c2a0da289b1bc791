"""What was seen of shots: where each ball was, and when."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Track:
    """One ball during one shot: times, s, in order, and its centre at each, m."""

    t: Floats
    x: Floats
    y: Floats

    def __len__(self) -> int:
        return len(self.t)

    def until(self, end: float) -> Track:
        """What was seen up to a moment; of a ball that was not yet seen then, what was seen first."""
        count = max(1, int(np.searchsorted(self.t, end, side="right")))
        return Track(self.t[:count], self.x[:count], self.y[:count])


@dataclass(frozen=True, slots=True)
class TrackedShot:
    """What was seen of one shot, by the ids of the balls that were on the table."""

    name: str
    tracks: Mapping[str, Track]

    @property
    def points(self) -> int:
        """How often a ball was seen."""
        return sum(map(len, self.tracks.values()))

    @property
    def start(self) -> float:
        """When the first ball was first seen, s."""
        return min(float(track.t[0]) for track in self.tracks.values())

    @property
    def end(self) -> float:
        """When the last ball was last seen, s."""
        return max(float(track.t[-1]) for track in self.tracks.values())


@dataclass(frozen=True, slots=True)
class TrackFile:
    """Shots of one table; `table` is the preset that the file names, and `radius` its balls', m, where it does."""

    shots: tuple[TrackedShot, ...]
    table: str | None = None
    radius: float | None = None
