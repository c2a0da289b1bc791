"""Painting with light: strips of a picture as arrays, whose pixels know where on the table they are.

A table is drawn as a list of layers, one over the other. A layer is a function of place alone, so a picture can be
painted in strips, several at once, and is the same however it is cut.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
import numpy.typing as npt
import pygame

# Imported here and not at its first use, which may be in two threads at once.
import pygame.surfarray

from ...table.outline import Point
from ..view import View

# Single precision throughout.
Array = npt.NDArray[Any]
Box = tuple[float, float, float, float]

# Random numbers from 0 to 1 in a square that repeats; always the same ones.
_SIDE = 256
_DICE = (np.frombuffer(random.Random(8).randbytes(_SIDE * _SIDE), np.uint8) / 255.0).astype(np.float32)
_TILE: Array = _DICE.reshape(_SIDE, _SIDE)


@dataclass(frozen=True, slots=True)
class Patch:
    """A rectangle of a picture: its light (3, rows, columns) and its pixels' places on the table, m.

    The places are a row of x and a column of y. `left` and `top` are its first pixel in the picture, which `view`
    lays on the table.
    """

    rgb: Array
    x: Array
    y: Array
    left: int
    top: int
    view: View

    @property
    def scale(self) -> float:
        """Pixels per m."""
        return self.view.scale

    def part(self, box: Box) -> tuple[slice, slice]:
        """The rows and the columns within left, bottom, right, top, m."""
        left, right = np.searchsorted(self.x[0], (box[0], box[2]))
        top, bottom = np.searchsorted(-self.y[:, 0], (-box[3], -box[1]))
        return slice(int(top), int(bottom)), slice(int(left), int(right))

    def cut(self, box: Box) -> Patch | None:
        """The pixels within left, bottom, right, top, m; None where there are none."""
        rows, columns = self.part(box)
        if rows.start >= rows.stop or columns.start >= columns.stop:
            return None
        light, x, y = self.rgb[:, rows, columns], self.x[:, columns], self.y[rows]
        return Patch(light, x, y, self.left + columns.start, self.top + rows.start, self.view)

    def cover(self, distance: Array) -> Array:
        """How much of each pixel lies inside of an edge, given the distance beyond it, m."""
        return np.clip(0.5 - distance * self.scale, 0.0, 1.0)

    def paint(self, color: Any, cover: Array) -> None:
        """Cover what is there with a colour, or a picture, as far as `cover`, 0 to 1, says."""
        for plane, tone in zip(self.rgb, color, strict=True):
            plane += (tone - plane) * cover

    def shade(self, factor: Array) -> None:
        """Make what is there lighter or darker."""
        self.rgb[...] *= factor

    def along(self, origin: Point, direction: Point) -> Array:
        """How far along a direction from `origin` each pixel lies, m; a row or a column where that is enough."""
        (ox, oy), (dx, dy) = origin, direction
        if abs(dy) < 1e-9:
            return (self.x - ox) * dx
        if abs(dx) < 1e-9:
            return (self.y - oy) * dy
        return (self.x - ox) * dx + (self.y - oy) * dy

    def speckle(self, salt: int = 0) -> Array:
        """Noise from 0 to 1, independent from pixel to pixel; `salt` makes different ones."""
        rows = (np.arange(self.top, self.top + self.rgb.shape[1]) + 37 * salt) % _SIDE
        columns = (np.arange(self.left, self.left + self.rgb.shape[2]) + 91 * salt) % _SIDE
        found: Array = _TILE[rows[:, None], columns[None, :]]
        return found

    def inside(self, polygon: Sequence[Point], fine: int = 2) -> Array:
        """How much of each pixel a polygon covers, from `fine` by `fine` samples."""
        _, rows, columns = self.rgb.shape
        mask = pygame.Surface((columns * fine, rows * fine), depth=8)
        # Rounded on the whole picture, so as to be the same in every part of it.
        corners = ((fine * x, fine * y) for x, y in (self.view.to_screen(x, y) for x, y in polygon))
        middle = fine / 2.0
        points = [
            (math.floor(x + middle) - self.left * fine, math.floor(y + middle) - self.top * fine) for x, y in corners
        ]
        pygame.draw.polygon(mask, 1, points)
        found = pygame.surfarray.pixels2d(mask).T.reshape(rows, fine, columns, fine)
        total = sum(found[:, i, :, j] for i in range(fine) for j in range(fine))
        return np.asarray(total, np.float32) / (fine * fine)


Layer = Callable[[Patch], None]


def strip(view: View, width: int, top: int, rows: int) -> Patch:
    """An unpainted strip of a picture: `rows` rows from `top` on."""
    x = (np.arange(width) - view.left) / view.scale
    y = (view.bottom - np.arange(top, top + rows)) / view.scale
    black = np.zeros((3, rows, width), np.float32)
    return Patch(black, x.astype(np.float32)[None, :], y.astype(np.float32)[:, None], 0, top, view)


def noise(u: Array, v: Array) -> Array:
    """Smooth noise from 0 to 1 that changes over distances of 1; the same at the same place."""
    lu, lv = np.floor(u), np.floor(v)
    fu, fv = ease(u - lu), ease(v - lv)
    iu, iv = lu.astype(np.int32), lv.astype(np.int32)
    row, next_row = (iu % _SIDE) * _SIDE, ((iu + 1) % _SIDE) * _SIDE
    column, next_column = iv % _SIDE, (iv + 1) % _SIDE
    near = _DICE.take(row + column, mode="clip")
    near += (_DICE.take(next_row + column, mode="clip") - near) * fu
    far = _DICE.take(row + next_column, mode="clip")
    far += (_DICE.take(next_row + next_column, mode="clip") - far) * fu
    near += (far - near) * fv
    return near


def ease(part: Array) -> Array:
    """A smooth step: from 0 at 0 to 1 at 1, level at both ends."""
    return part * part * (3.0 - 2.0 * part)


def ramp(value: Array, start: float, end: float) -> Array:
    """0 up to `start`, 1 from `end` on, a smooth step between."""
    return ease(np.clip((value - start) / (end - start), 0.0, 1.0))


def distance(points: Sequence[Point], patch: Patch, reach: float) -> Array:
    """How far each pixel is from a line through points, m, where that is less than `reach`."""
    square = np.full(patch.rgb.shape[1:], reach * reach, np.float32)
    for a, b in pairwise(points):
        rows, columns = patch.part(box_of((a, b), reach))
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = dx * dx + dy * dy
        if length > 0.0:
            # Along an axis each of these stays a single row or column.
            x, y = patch.x[:, columns] - a[0], patch.y[rows] - a[1]
            along = (x * (dx / length) if dx else 0.0) + (y * (dy / length) if dy else 0.0)
            along = np.clip(along, 0.0, 1.0)
            x, y = x - along * dx if dx else x, y - along * dy if dy else y
            here = square[rows, columns]
            np.minimum(here, x * x + y * y, out=here)
    return np.asarray(np.sqrt(square))


def box_of(points: Sequence[Point], margin: float = 0.0) -> Box:
    """The box round points, with a margin, m."""
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return min(xs) - margin, min(ys) - margin, max(xs) + margin, max(ys) + margin
