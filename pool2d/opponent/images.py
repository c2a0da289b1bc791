"""Places seen in the cushions: a ball that is sent at one's image beyond a nose comes to it by that cushion.

A nose mirrors at the line on which a ball's centre is when the ball touches it. No cushion gives a ball back just so;
what is found here is where an aim begins to be refined.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple, TypeAlias

from ..physics.detect import Rail
from ..table.table import Table

Place: TypeAlias = tuple[float, float]


class Image(NamedTuple):
    """A place as it is seen in cushions: itself, its images, each in the next nose, and those noses in their order."""

    places: tuple[Place, ...]
    noses: tuple[Rail, ...]

    @property
    def seen(self) -> Place:
        """The last image: where whoever looks from behind all the cushions sees the place."""
        return self.places[-1]


def noses(table: Table) -> list[Rail]:
    """The noses from which a ball comes back."""
    return [element for element in table.elements if isinstance(element, Rail) and not element.facing]


def images(table: Table, x: float, y: float, reach: float, cushions: int) -> list[Image]:
    """The images of a place in so many cushions, one after another."""
    found, sides = [Image(((x, y),), ())], noses(table)
    for _ in range(cushions):
        found = [image for each in found for side in sides if (image := _mirrored(each, side, reach)) is not None]
    return found


def _mirrored(image: Image, nose: Rail, reach: float) -> Image | None:
    """An image seen in one more nose; None where it lies behind that, or was just seen in it."""
    x, y = image.seen
    depth = _depth(nose, x, y, reach)
    if depth <= 0.0 or nose in image.noses[-1:]:
        return None
    # (-dy, dx) points from the nose onto the table.
    mirror = (x + 2.0 * depth * nose.dy, y - 2.0 * depth * nose.dx)
    return Image((*image.places, mirror), (*image.noses, nose))


def _depth(nose: Rail, x: float, y: float, reach: float) -> float:
    """How far a ball's centre is from where it touches a nose, m; negative beyond."""
    return nose.dx * (y - nose.ay) - nose.dy * (x - nose.ax) - reach


def way(image: Image, goal: Place, reach: float) -> list[Place] | None:
    """The corners of the way from a place by its cushions to a goal, both included; None where it misses a nose."""
    corners = [goal]
    for nose, place in zip(reversed(image.noses), reversed(image.places), strict=False):
        met = _crossing(nose, place, corners[-1], reach)
        if met is None:
            return None
        corners.append(met)
    return [image.places[0], *reversed(corners)]


def _crossing(nose: Rail, behind: Place, goal: Place, reach: float) -> Place | None:
    """Where the line from an image to a goal meets a nose; None where it does not."""
    near, far = -_depth(nose, *behind, reach), _depth(nose, *goal, reach)
    if near <= 0.0 or far <= 0.0:
        return None
    part = near / (near + far)
    x, y = behind[0] + part * (goal[0] - behind[0]), behind[1] + part * (goal[1] - behind[1])
    along = nose.dx * (x - nose.ax) + nose.dy * (y - nose.ay)
    return (x, y) if 0.0 <= along <= nose.length else None


def legs(corners: list[Place]) -> Iterator[float]:
    """How long each leg of a way is, m."""
    return (math.dist(a, b) for a, b in pairwise(corners))
