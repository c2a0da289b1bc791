"""What a study may have found, worked out by formulas: for pictures of it."""

from __future__ import annotations

import numpy as np

from pool2d.study.findings import MARGIN, Axis, HeatMap, Rests, cell_of

ANGLES = tuple(0.25 * i - 3.0 for i in range(25))
SPEEDS = tuple(1.0 + 0.5 * i for i in range(11))


def map_of_a_ridge() -> HeatMap:
    """A share that is highest along a line, and unknown in a corner."""
    x, y = np.meshgrid(ANGLES, SPEEDS)
    mean = np.exp(-(((x - 0.3 * (y - 3.0)) / 0.8) ** 2))
    mean[:4, 18:] = np.nan
    return HeatMap(Axis("angle", ANGLES), Axis("speed", SPEEDS), "share of shots in which 8 falls", mean)


def rests_in_a_ring(length: float, width: float) -> Rests:
    """Rests on a ring round the middle, most of them at its right, and one by itself near the origin."""
    counts = np.zeros((cell_of(width + MARGIN) + 1, cell_of(length + MARGIN) + 1))
    for i in range(4000):
        way = 2.0 * np.pi * (i / 4000.0) ** 2
        x, y = 0.5 * length + 0.5 * np.cos(way), 0.5 * width + 0.3 * np.sin(way)
        counts[cell_of(y), cell_of(x)] += 1.0
    counts[cell_of(0.2), cell_of(0.1)] += 1.0
    return Rests("cue", counts)
