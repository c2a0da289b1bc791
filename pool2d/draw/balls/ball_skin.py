"""A ball's paint, kept for small cells all over its surface: a moving ball is looked up, not painted.

The cube round the ball is cut into cells, and those that the surface runs through are numbered. A point of the
surface finds its cell by rounding its coordinates; a skin is an array of one colour for each cell.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
import numpy.typing as npt
import pygame

from .ball_light import Floats, Pixels, light
from .ball_paint import Coat, paint

# By the number of the cell.
Skin = Pixels

# Cells to a pixel, and along the cube at most: on large balls they are coarser than pixels, which nobody sees
# in a picture that stands for a sixtieth of a second.
_FINE, _MOST = 2, 96


class Cells:
    """The numbered cells of a ball of `radius` pixels."""

    def __init__(self, radius: float) -> None:
        self.radius = radius
        self.side = min(round(2.0 * radius * _FINE), _MOST)
        middles = (np.arange(self.side, dtype=np.float32) + 0.5) * (2.0 / self.side) - 1.0
        squares = middles * middles
        far = np.sqrt(squares[:, None, None] + squares[:, None] + squares)
        # A point of the surface is at most half a cell's diagonal from the middle of its cell.
        near = np.flatnonzero(np.abs(far - 1.0) <= np.sqrt(3.0) / self.side)
        self._numbers = np.zeros(self.side**3, dtype=np.int32)
        # What makes of a cell's column, row and layer its place among all; whole numbers well below 2^24.
        self._order = np.array([[self.side**2, self.side, 1]], dtype=np.float32)
        self._numbers[near] = np.arange(len(near))
        places = middles[np.stack(np.unravel_index(near, far.shape))]
        self.places: Floats = places / far.reshape(-1)[near]

    def numbers(self, turns: Floats, normals: Floats) -> npt.NDArray[np.intp]:
        """The numbers (balls, points) of the cells seen at the normals (balls, 3, points).

        `turns` (balls, 3, 3) are the rotation matrices of the balls.
        """
        half = 0.5 * self.side
        # Turned back: the transposed matrix. No normal is longer than 1 but for rounding, for which there is room.
        places = np.matmul(turns.transpose(0, 2, 1) * np.float32(half - 1e-3), normals)
        places += half
        np.floor(places, out=places)
        found: npt.NDArray[np.int32] = self._numbers.take(np.matmul(self._order, places)[:, 0].astype(np.intp))
        # What `take` takes as it is.
        return found.astype(np.intp)


@lru_cache(maxsize=2)
def cells(radius: float) -> Cells:
    return Cells(radius)


# Skins made before, the latest last. Like a function's cache, it changes no picture.
_skins: dict[tuple[Coat, float], Skin] = {}
_KEPT = 40


def known(coat: Coat, radius: float) -> bool:
    """Whether the skin of a coat at a radius, in pixels, has been made."""
    return (coat, radius) in _skins


def skin(coat: Coat, radius: float) -> Skin:
    """The skin of a coat for balls of `radius` pixels; made once, then remembered."""
    found = _skins.get((coat, radius))
    if found is None:
        found = _skins[coat, radius] = _made(coat, radius)
        if len(_skins) > _KEPT:
            del _skins[next(iter(_skins))]
    return found


def _made(coat: Coat, radius: float) -> Skin:
    places = cells(radius).places[None]
    soft = np.full(places[:, 0].shape, radius, np.float32)
    pixels = np.full((places.shape[2], 4), 255, dtype=np.uint8)
    pixels[:, :3] = paint([coat], places, soft, radius).color[0, ::-1].T
    found: Skin = pixels.view(np.uint32)[:, 0]
    return found


def pictures(coats: Sequence[Coat], radius: float, steps: Sequence[int], turns: Floats) -> list[pygame.Surface]:
    """Pictures of lit balls of one radius, in pixels, from their skins, by steps and rotation matrices (3, 3)."""
    lamp = light(radius)
    numbers = cells(radius).numbers(turns, lamp.normals(steps))
    pixels = np.empty(numbers.shape, dtype=np.uint32)
    for coat, found, row in zip(coats, numbers, pixels, strict=True):
        # No number is beyond the skin; not to check them spares a copy.
        skin(coat, radius).take(found, out=row, mode="clip")
    column = lamp.column(pixels)
    shade, gloss = lamp.layers(steps)
    column.blit(shade, (0, 0), None, pygame.BLEND_RGBA_MULT)
    column.blit(gloss, (0, 0), None, pygame.BLEND_RGB_ADD)
    side = column.get_width()
    return [column.subsurface((0, side * i, side, side)) for i in range(len(coats))]
