"""What a study found, from its results: an outcome over two things that were swept, and where a ball comes to rest."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import isqrt
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from .study_file import Study
from .sweep import Sweep

Floats: TypeAlias = npt.NDArray[np.float64]
# Steps into which a thing that only errs is divided, from one end of its spread to the other: so few that there are
# shots in most cells.
_STEPS = (5, 25)
_IN_A_CELL = 10
# Where fewer shots than this happen to fall into a cell, their mean says nothing.
_FEWEST = 5
# The side of a square in which rests are counted, m: a pixel of a large picture.
CELL = 0.002
# How far outside the noses rests are counted, m: some balls lie on a pocket's shelf.
MARGIN = 0.1


@dataclass(frozen=True, slots=True)
class Axis:
    """One side of a map: what was swept, and the values in the middle of its cells, in their order."""

    name: str
    values: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class HeatMap:
    """An outcome's mean in each cell of two axes, (rows of y, columns of x); nan where it is not known."""

    x: Axis
    y: Axis
    title: str
    mean: Floats


@dataclass(frozen=True, slots=True)
class Rests:
    """How often the struck ball came to rest in each square of `CELL`: (along y, along x), from `MARGIN` outside."""

    ball: str
    counts: Floats


@dataclass(frozen=True, slots=True)
class Findings:
    """All of it, with the numbers of shots, and of those among them that failed."""

    heat: HeatMap | None
    rests: Rests
    shots: int
    failed: int


def columns_of(study: Study) -> tuple[str, ...]:
    """The columns of the results that findings are made of."""
    ball = study.sweep.base.ball
    return tuple(dict.fromkeys((*study.outcome.columns, *(study.axes or ()), f"{ball}.x", f"{ball}.y", "error")))


def findings(study: Study, rows: Iterable[Mapping[str, str]]) -> Findings:
    """Go through the results once."""
    ball, size = study.sweep.base.ball, study.table.knobs.table
    counts = np.zeros(tuple(cell_of(side + MARGIN) + 1 for side in (size.width, size.length)))
    heat = _Heat(study) if study.axes else None
    shots = failed = 0
    for number, row in enumerate(rows):
        shots += 1
        if row["error"]:
            failed += 1
            continue
        if heat:
            heat.add(number, row)
        if row[f"{ball}.x"]:
            counts[cell_of(float(row[f"{ball}.y"])), cell_of(float(row[f"{ball}.x"]))] += 1.0
    return Findings(heat.map() if heat else None, Rests(ball, counts), shots, failed)


def cell_of(place: float) -> int:
    """The square that a place lies in, along either side, by its distance from the table's origin, m."""
    return round((place + MARGIN) / CELL)


class _Heat:
    """Sums an outcome up in the cells of a map."""

    def __init__(self, study: Study) -> None:
        assert study.axes
        self.outcome = study.outcome
        self.x, self.y = (_Side(study.sweep, name) for name in study.axes)
        self.sums = np.zeros((len(self.y.axis.values), len(self.x.axis.values)))
        self.shots = np.zeros_like(self.sums)

    def add(self, number: int, row: Mapping[str, str]) -> None:
        x, y = self.x.place(number, row), self.y.place(number, row)
        if x is not None and y is not None:
            self.sums[y, x] += self.outcome.value(row)
            self.shots[y, x] += 1.0

    def map(self) -> HeatMap:
        mean = np.full_like(self.sums, np.nan)
        fewest = 1 if self.x.in_grid and self.y.in_grid else _FEWEST
        np.divide(self.sums, self.shots, out=mean, where=self.shots >= fewest)
        return HeatMap(self.x.axis, self.y.axis, self.outcome.title, mean)


class _Side:
    """Finds the cell of a shot along one axis: by what was meant where there is a grid, else by what was played."""

    def __init__(self, sweep: Sweep, name: str) -> None:
        self.sweep = sweep
        self.name = name
        self.in_grid = name in sweep.grid
        if self.in_grid:
            values = sweep.grid[name]
            order = sorted(range(len(values)), key=values.__getitem__)
            self.rank = {place: rank for rank, place in enumerate(order)}
            self.axis = Axis(name, tuple(sorted(values)))
        else:
            low, high = sweep.spread(name)
            steps = min(max(_STEPS[0], isqrt(len(sweep) // _IN_A_CELL)), _STEPS[1])
            step = (high - low) / steps
            self.edges = [low + step * i for i in range(steps)] + [high]
            self.axis = Axis(name, tuple(low + step * (i + 0.5) for i in range(steps)))

    def place(self, number: int, row: Mapping[str, str]) -> int | None:
        """The cell; None for a shot that errs so far that it lies outside the map."""
        if self.in_grid:
            return self.rank[self.sweep.place(self.name, number)]
        value = float(row[self.name])
        if not self.edges[0] <= value <= self.edges[-1]:
            return None
        return min(bisect_right(self.edges, value), len(self.axis.values)) - 1
