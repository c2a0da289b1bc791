"""Lines beside an outline: where the cushions end behind their noses, and the rails behind those."""

from __future__ import annotations

import math
from collections.abc import Sequence

from ...table.outline import Corner, Point

# How wide the cushions are behind their noses, m (WPA: 1 7/8 to 2 in).
CUSHION = 0.05
# Where the wood ends behind the noses, m.
EDGE = 0.146


def outward(a: Corner, b: Corner) -> Point:
    """The unit vector out of the table from the edge between two corners."""
    length = math.hypot(b.x - a.x, b.y - a.y)
    return (b.y - a.y) / length, (a.x - b.x) / length


def grown(corners: Sequence[Corner], by: float) -> list[Point]:
    """The outline's corners moved outward, so that every side lies `by` further out."""
    moved = []
    for i, here in enumerate(corners):
        (ax, ay), (bx, by_) = (
            outward(*edge) for edge in ((corners[i - 1], here), (here, corners[(i + 1) % len(corners)]))
        )
        far = by / (1.0 + ax * bx + ay * by_)
        moved.append((here.x + far * (ax + bx), here.y + far * (ay + by_)))
    return moved
