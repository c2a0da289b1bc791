"""The pockets as a player sees them: which directions lead a ball in."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Final, NamedTuple

import numpy as np
import numpy.typing as npt

from ..physics.detect import Jaw
from ..table.table import Table

Floats = npt.NDArray[np.float64]

# A ball goes in that meets a jaw by up to this share of its radius: what `benchmarks.chances` finds on the engine.
SLACK: Final = 0.15
# A ball that lies between the jaws goes in whichever way, radians.
_WIDE: Final = 0.6


class Mouths(NamedTuple):
    """The pockets of a table, in its order: names, middles of the mouths (P, 2), jaws (P, 2, 2) and their radii, m."""

    names: tuple[str, ...]
    middles: Floats
    jaws: Floats
    radii: Floats


@lru_cache(maxsize=8)
def mouths(table: Table) -> Mouths:
    """The pockets of a table; where a pocket has no jaws, its hole alone is its mouth."""
    names, middles, jaws, radii = [], [], [], []
    for pocket in table.geometry.pockets:
        found = [each for each in table.elements if isinstance(each, Jaw) and each.name == f"{pocket.name} jaw"]
        if len(found) != 2:
            continue
        a, b = found
        names.append(pocket.name)
        middles.append((0.5 * (a.x + b.x), 0.5 * (a.y + b.y)))
        jaws.append(((a.x, a.y), (b.x, b.y)))
        radii.append(a.radius)
    return Mouths(
        tuple(names),
        np.array(middles, dtype=float).reshape(-1, 2),
        np.array(jaws, dtype=float).reshape(-1, 2, 2),
        np.array(radii, dtype=float),
    )


def middle(table: Table, pocket: str) -> tuple[float, float]:
    """The middle of a pocket's mouth, (x, y)."""
    seen = mouths(table)
    x, y = seen.middles[seen.names.index(pocket)].tolist()
    return x, y


def windows(seen: Mouths, places: Floats, reach: float) -> tuple[Floats, Floats]:
    """For balls at `places` (N, 2): the direction to each pocket's middle way in, and half the angle open about it.

    Both are (N, P), radians; half the angle is negative where a pocket is shut. `reach` is how far from a nose a
    ball's centre is when it touches, m.
    """
    to_jaw = seen.jaws[None] - places[:, None, None, :]
    distance = np.hypot(to_jaw[..., 0], to_jaw[..., 1])
    to_middle = seen.middles[None] - places[:, None, :]
    straight = np.arctan2(to_middle[..., 1], to_middle[..., 0])
    turned = np.arctan2(to_jaw[..., 1], to_jaw[..., 0]) - straight[..., None]
    turned = (turned + math.pi) % (2.0 * math.pi) - math.pi
    clear = (1.0 - SLACK) * reach + seen.radii[None, :, None]
    taken = np.arcsin(np.minimum(1.0, clear / np.maximum(distance, 1e-9)))
    # Seen from the bed one jaw is to the right, where angles are less, and one to the left.
    ends = np.sort(turned, axis=2)
    swapped = turned[..., 0] > turned[..., 1]
    right = np.where(swapped, taken[..., 1], taken[..., 0])
    left = np.where(swapped, taken[..., 0], taken[..., 1])
    low, high = ends[..., 0] + right, ends[..., 1] - left
    near = np.hypot(to_middle[..., 0], to_middle[..., 1]) < 1.5 * reach
    way = straight + np.where(near, 0.0, 0.5 * (low + high))
    return way, np.where(near, _WIDE, 0.5 * (high - low))
