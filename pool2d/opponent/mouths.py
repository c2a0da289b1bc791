"""The pockets as a player sees them: which directions lead a ball in."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import Final, NamedTuple

import numpy as np
import numpy.typing as npt

from ..physics.detect import Jaw, Pocket
from ..table.table import Table
from .grazes import ANGLES, GapFrame, grazes

Floats = npt.NDArray[np.float64]

# A ball that lies between the jaws goes in whichever way, radians.
_WIDE: Final = 0.6
# Pockets are the same that differ by less than this, m.
_SAME: Final = 1e-6


class Mouths(NamedTuple):
    """The pockets of a table, in its order.

    Their names; the middles of the mouths (P, 2); the directions from there out of the table (P,), radians; the jaws
    (P, 2, 2), the right one first as seen from the bed, and their radii, m; and how far a ball may graze them (P, 2, A)
    that comes in at one of `grazes.ANGLES`, in units of how far from a nose its centre is when it touches.
    """

    names: tuple[str, ...]
    middles: Floats
    axes: Floats
    jaws: Floats
    radii: Floats
    grazed: Floats


@lru_cache(maxsize=8)
def mouths(table: Table) -> Mouths:
    """The pockets of a table that have jaws."""
    frames = list(_frames(table))
    known: dict[tuple[int, int], Floats] = {}
    for frame in frames:
        if _kind(frame) not in known:
            known[_kind(frame)] = grazes(table, frame)
    return Mouths(
        tuple(frame.name for frame in frames),
        np.array([frame.middle for frame in frames], dtype=float).reshape(-1, 2),
        np.array([frame.axis for frame in frames], dtype=float),
        np.array([(frame.right, frame.left) for frame in frames], dtype=float).reshape(-1, 2, 2),
        np.array([frame.radius for frame in frames], dtype=float),
        np.array([known[_kind(frame)] for frame in frames], dtype=float).reshape(-1, 2, len(ANGLES)),
    )


def _kind(frame: GapFrame) -> tuple[int, int]:
    """What pockets that are cut alike have in common: how wide and how round they are."""
    return round(math.dist(frame.right, frame.left) / _SAME), round(frame.radius / _SAME)


def _frames(table: Table) -> Iterator[GapFrame]:
    for pocket in table.geometry.pockets:
        found = [each for each in table.elements if isinstance(each, Jaw) and each.name == f"{pocket.name} jaw"]
        if len(found) == 2:
            yield _frame(pocket, *found)


def _frame(pocket: Pocket, a: Jaw, b: Jaw) -> GapFrame:
    # From the bed one looks against (ux, uy): the left jaw is then on the right-hand side of it.
    if (a.x - b.x) * pocket.uy - (a.y - b.y) * pocket.ux < 0.0:
        a, b = b, a
    middle = (0.5 * (a.x + b.x), 0.5 * (a.y + b.y))
    return GapFrame(pocket.name, middle, math.atan2(-pocket.uy, -pocket.ux), (b.x, b.y), (a.x, a.y), a.radius)


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
    to_middle = seen.middles[None] - places[:, None, :]
    straight = np.arctan2(to_middle[..., 1], to_middle[..., 0])
    to_jaw = seen.jaws[None] - places[:, None, None, :]
    turned = _turned(np.arctan2(to_jaw[..., 1], to_jaw[..., 0]) - straight[..., None])
    clear = (1.0 - _grazed(seen, _turned(straight - seen.axes))) * reach + seen.radii[None, :, None]
    distance = np.hypot(to_jaw[..., 0], to_jaw[..., 1])
    taken = np.arcsin(np.clip(clear / np.maximum(distance, 1e-9), -1.0, 1.0))
    low, high = turned[..., 0] + taken[..., 0], turned[..., 1] - taken[..., 1]
    near = np.hypot(to_middle[..., 0], to_middle[..., 1]) < 1.5 * reach
    way = straight + np.where(near, 0.0, 0.5 * (low + high))
    return way, np.where(near, _WIDE, 0.5 * (high - low))


def _grazed(seen: Mouths, off: Floats) -> Floats:
    """How far either jaw may be grazed (N, P, 2) by balls that come in so far off a pocket's axis (N, P)."""
    place = np.clip((off - ANGLES[0]) / (ANGLES[1] - ANGLES[0]), 0.0, len(ANGLES) - 1.0)
    below = np.minimum(place.astype(int), len(ANGLES) - 2)
    pocket = np.arange(len(seen.names))
    at, beyond = seen.grazed[pocket, :, below], seen.grazed[pocket, :, below + 1]
    found: Floats = at + (place - below)[..., None] * (beyond - at)
    return found


def _turned(angle: Floats) -> Floats:
    """Angles brought between -pi and pi."""
    found: Floats = (angle + math.pi) % (2.0 * math.pi) - math.pi
    return found
