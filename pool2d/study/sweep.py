"""The shots of a study: every combination of a grid's values, each played as a hand plays it that errs a little."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

from ..physics.values import SHOT_RANGES, Shot

# What may be swept.
SWEPT = tuple(SHOT_RANGES)


@dataclass(frozen=True, slots=True)
class Sweep:
    """The shots of a study, in their order.

    `grid` has the values of what goes through several, the last of them changing fastest; `noise` standard deviations,
    in the units of `Shot`. Each combination is played `repeat` times, with errors drawn from `seed`.
    """

    base: Shot
    grid: Mapping[str, tuple[float, ...]]
    noise: Mapping[str, float]
    repeat: int
    seed: int

    def __len__(self) -> int:
        return math.prod(map(len, self.grid.values())) * self.repeat

    def shots(self) -> Iterator[Shot]:
        """Every shot. What errs beyond what can be, such as a butt below level, is at the end of its range."""
        rng = random.Random(self.seed)
        for values in product(*self.grid.values()):
            meant = _changed(self.base, dict(zip(self.grid, values, strict=True)))
            for _ in range(self.repeat):
                yield _changed(meant, {name: _erring(meant, name, self.noise[name], rng) for name in self.noise})

    def place(self, name: str, number: int) -> int:
        """Which of its grid's values something has in a shot, told by the shot's number."""
        number //= self.repeat
        for other in reversed(list(self.grid)):
            number, place = divmod(number, len(self.grid[other]))
            if other == name:
                return place
        raise KeyError(name)

    def spread(self, name: str) -> tuple[float, float]:
        """From where to where noise takes something: three deviations to either side, as far as it can be."""
        low, high, _ = SHOT_RANGES[name]
        middle, width = getattr(self.base, name), 3.0 * self.noise[name]
        return max(low, middle - width), min(high, middle + width)


def _changed(shot: Shot, values: Mapping[str, Any]) -> Shot:
    return replace(shot, **values)


def _erring(meant: Shot, name: str, deviation: float, rng: random.Random) -> float:
    low, high, _ = SHOT_RANGES[name]
    value: float = getattr(meant, name)
    return min(max(value + rng.gauss(0.0, deviation), low), high)
