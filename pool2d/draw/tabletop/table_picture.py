"""The table as a picture: frame, cushions, cloth, pockets and marks, to scale, for any outline."""

from __future__ import annotations

import os
from collections.abc import Hashable
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pygame

from ...table.table import Table
from ..view import View
from . import cache, cloth, leather, paint, wood

# As many rows are painted at a time, and so many strips at once.
_ROWS = 96
_WORKERS = min(4, os.cpu_count() or 1)
# A draft has so many times fewer pixels each way.
_COARSE = 3


def draw(table: Table, size: tuple[int, int], view: View, workers: int = _WORKERS) -> pygame.Surface:
    """The table without balls, on a surface of `size` pixels; kept on disk from then on.

    The surface has 24 bits a pixel: it takes little memory, but is slow to blit and cannot be drawn on well;
    `window_copy` makes a copy that can. It may be called on any thread; `workers` is how many strips are painted at
    once, on threads of their own.
    """
    picture = kept(table, size, view)
    if picture is None:
        pixels = _pixels(table, size, view, workers)
        cache.save(_name(table, size, view), pixels)
        picture = pygame.image.frombuffer(pixels, size, "RGB")
    return picture


def kept(table: Table, size: tuple[int, int], view: View) -> pygame.Surface | None:
    """The picture that `draw` has kept on disk; None where there is none."""
    pixels = cache.load(_name(table, size, view), 3 * size[0] * size[1])
    return None if pixels is None else pygame.image.frombuffer(pixels, size, "RGB")


def draft(table: Table, size: tuple[int, int], view: View) -> pygame.Surface:
    """A picture in a fraction of the time, less sharp: for while the view or the table is being changed."""
    small = (max(1, size[0] // _COARSE), max(1, size[1] // _COARSE))
    pixels = _pixels(table, small, view.zoomed(small[0] / size[0]), _WORKERS)
    return pygame.transform.smoothscale(pygame.image.frombuffer(pixels, small, "RGB"), size)


def window_copy(picture: pygame.Surface) -> pygame.Surface:
    """A copy in the window's pixel format, to be drawn on and blitted fast."""
    return picture.convert() if pygame.display.get_surface() else picture.copy()


def content(table: Table) -> Hashable:
    """All of a table that its picture depends on."""
    furniture, geometry = table.furniture, table.geometry
    pockets = tuple((pocket.x, pocket.y, pocket.radius) for pocket in geometry.pockets)
    sights = (table.knobs.table.length, furniture.sights, furniture.sight_inset)
    lines = (table.knobs.table.width, furniture.head_string, furniture.d_radius, tuple(furniture.spots.values()))
    return geometry.corners, geometry.outline, pockets, sights, lines, furniture.finish


def _name(table: Table, size: tuple[int, int], view: View) -> str:
    return cache.name_of((content(table), size, view), __file__)


def _pixels(table: Table, size: tuple[int, int], view: View, workers: int) -> memoryview:
    """The picture's pixels, row by row, as red, green and blue."""
    width, height = size
    layers = [
        *wood.layers(table), *wood.sights(table), *leather.collars(table),
        *cloth.layers(table), *leather.holes(table), *cloth.cushions(table),
    ]  # fmt: skip
    pixels = np.empty((height, width, 3), np.uint8)

    def fill(top: int) -> None:
        patch = paint.strip(view, width, top, min(_ROWS, height - top))
        for layer in layers:
            layer(patch)
        # Dither: a slow fall of light shows no steps.
        light = patch.rgb + 1.6 * (patch.speckle(7) - 0.5) + 0.5
        pixels[top : top + _ROWS] = np.clip(light, 0.0, 255.0).astype(np.uint8).transpose(1, 2, 0)

    tops = range(0, height, _ROWS)
    if workers > 1:
        with ThreadPoolExecutor(workers) as pool:
            # Asking for the results raises what went wrong.
            list(pool.map(fill, tops))
    else:
        # Without a pool, whose end Python would wait for when the player quits.
        for top in tops:
            fill(top)
    return pixels.data.cast("B")
