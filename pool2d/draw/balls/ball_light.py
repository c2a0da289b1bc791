"""Light on balls of one radius, and their shadows: worked out once for each place within a pixel, then looked up."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
import numpy.typing as npt
import pygame

from .. import theme

Floats = npt.NDArray[np.float32]
Doubles = npt.NDArray[np.float64]
# One number a pixel; its bytes are blue, green, red, cover.
Pixels = npt.NDArray[np.uint32]

# Balls are placed to this part of a pixel.
STEPS = 4
# The lamp hangs above the table, a little to the upper left: the direction its light comes from.
_LAMP = (-0.34, 0.46, 0.82)
# Its mirror image: middle and half sizes on a plane one radius above, and how soft its edges are,
# which on a small ball is at least so much over the radius in pixels.
_IMAGE, _HALF, _EDGE, _BLUR = (-0.62, 0.74), (0.34, 0.15), 0.10, 2.8
# Light from all round; from the lamp; thrown back by the cloth, as parts of the paint's own.
_AROUND, _DIRECT, _BOUNCE = 0.28, 0.75, 0.29
_GLEAM, _SHEEN, _RIM = 205.0, 26.0, 20.0
_DITHER = 0.8


class Light:
    """Normals, shading, gloss and cover of every pixel of a ball, for balls of `radius` pixels.

    They are kept for a square of 2 `half` + 1 pixels a side, row by row, about the pixel nearest to the ball's
    centre. They depend on where in that pixel the centre is, to a quarter of a pixel: that is its step, `STEPS`
    times the quarters to the right of the leftmost place, plus those down from the topmost.
    """

    # Where things are in what `at` returns: out of the ball, x right and y up; what a paint's colour is
    # multiplied by; what is then added; how much of a pixel the ball takes; and how many pixels a radius
    # on the surface spans.
    NORMAL, SHADE, GLOSS, COVER, SOFT = slice(0, 3), slice(3, 6), slice(6, 9), 9, 10

    def __init__(self, radius: float) -> None:
        self.radius = radius
        self.half = math.ceil(radius + 0.5)
        # The rows of those steps that were asked for: a camera on its way asks for few, of many sizes of ball.
        self._rows: dict[int, int] = {}
        self._table: Floats = np.empty((0, 11, (2 * self.half + 1) ** 2), dtype=np.float32)
        self._shades: Pixels = np.empty((0, self._table.shape[2]), dtype=np.uint32)
        self._glosses = self._shades

    def at(self, steps: Sequence[int]) -> Floats:
        """The light on balls at these steps, as an array (balls, 11, pixels); `NORMAL` to `SOFT` name the 11."""
        rows = self._rows_at(steps)
        lit: Floats = self._table[rows]
        return lit

    def normals(self, steps: Sequence[int]) -> Floats:
        """Only the normals of `at`, as an array (balls, 3, pixels)."""
        rows = self._rows_at(steps)
        normals: Floats = self._table[rows, self.NORMAL]
        return normals

    def layers(self, steps: Sequence[int]) -> tuple[pygame.Surface, pygame.Surface]:
        """The light on balls at these steps, as two pictures of the balls below each other.

        The paint is multiplied by the first, which is transparent beside the balls, and then the second is added.
        """
        rows = self._rows_at(steps)
        return self.column(self._shades[rows]), self.column(self._glosses[rows])

    def column(self, pixels: Pixels) -> pygame.Surface:
        """A surface of balls below each other that shares the memory of `pixels`, an array (balls, pixels)."""
        side = 2 * self.half + 1
        return pygame.image.frombuffer(pixels.data.cast("B"), (side, side * len(pixels)), "BGRA")

    def _rows_at(self, steps: Sequence[int]) -> list[int]:
        """Where in the table the light for these steps stands; what is missing is worked out."""
        for step in steps:
            if step not in self._rows:
                self._rows[step] = len(self._rows)
                lit = self._lit(*offset(step))
                shade, gloss = np.clip(255.0 * lit[self.SHADE], 0.0, 255.0), np.clip(lit[self.GLOSS], 0.0, 255.0)
                cut, added = _pixels(shade, 255.0 * lit[self.COVER]), _pixels(gloss, np.zeros_like(gloss[0]))
                self._table = np.concatenate([self._table, lit[None]])
                self._shades = np.concatenate([self._shades, cut[None]])
                self._glosses = np.concatenate([self._glosses, added[None]])
        return [self._rows[step] for step in steps]

    def _lit(self, right: float, down: float) -> Floats:
        """The light on a ball whose centre is `right` and `down` pixels off the middle of its pixel."""
        across = np.arange(-self.half, self.half + 1, dtype=np.float64)
        x = np.tile((across - right) / self.radius, len(across))
        y = np.repeat((down - across) / self.radius, len(across))
        far = np.hypot(x, y)
        # Pixels on the edge take the normal of the nearest point of the ball.
        inward = np.minimum(1.0, 0.999 / np.maximum(far, 1e-9))
        x, y = x * inward, y * inward
        z = np.sqrt(1.0 - x * x - y * y)
        toward = x * _LAMP[0] + y * _LAMP[1]
        direct = np.clip((toward + z * _LAMP[2] + 0.16) / 1.16, 0.0, 1.0)
        cloth = np.array(theme.CLOTH, dtype=np.float64)[:, None]
        # What faces sideways sees the cloth, which is brighter on the lamp's other side than in the shadow.
        bounce = _BOUNCE * (cloth / cloth.max()) * (1.0 - z) ** 1.5 * (0.6 + 0.4 * toward)
        edge = 1.0 - 0.5 * (1.0 - z) ** 5
        # Polish mirrors more at a slant (Fresnel): the rim shows the room.
        rim = _RIM * (1.0 - z) ** 3 * (0.35 + 0.65 * cloth / 255.0)
        row = np.empty((11, len(x)), dtype=np.float32)
        row[self.NORMAL] = x, y, z
        row[self.SHADE] = (_AROUND * (0.55 + 0.45 * z) + _DIRECT * direct**1.1) * edge + bounce
        row[self.GLOSS] = _mirrored(x, y, z, max(_EDGE, _BLUR / self.radius)) + rim + _noise(len(x))
        row[self.COVER] = np.clip((1.0 - far) * self.radius + 0.5, 0.0, 1.0)
        row[self.SOFT] = self.radius * np.clip(z, 0.35, 1.0)
        return row


def _pixels(rgb: Floats, alpha: Floats) -> Pixels:
    """Colours (3, ...) from 0 to 255 and alpha from 0 to 1 as packed 32-bit pixels, BGRA."""
    pixels: Pixels = np.stack([rgb[2], rgb[1], rgb[0], alpha], axis=1).astype(np.uint8).view(np.uint32)[:, 0]
    return pixels


@lru_cache(maxsize=48)
def light(radius: float) -> Light:
    return Light(radius)


def place(centre: tuple[float, float]) -> tuple[int, int, int]:
    """The pixel nearest to a ball's centre, and the step (see `Light`) of the centre in it."""
    x, right = divmod(round(centre[0] * STEPS) + STEPS // 2, STEPS)
    y, down = divmod(round(centre[1] * STEPS) + STEPS // 2, STEPS)
    return x, y, STEPS * right + down


def offset(step: int) -> tuple[float, float]:
    """How far right and down of the middle of its pixel a ball's centre is at this step, in pixels."""
    return step // STEPS / STEPS - 0.5, step % STEPS / STEPS - 0.5


def _mirrored(x: Doubles, y: Doubles, z: Doubles, edge: float) -> Doubles:
    """How bright the lamp's reflection is at surface normals (x, y, z), seen from straight above.

    It is the lamp's own image, whose rim fades over `edge`, and a wide sheen round it.
    """
    up = 2.0 * z * z - 1.0
    seen_x, seen_y = (2.0 * z * part / np.maximum(up, 0.05) for part in (x, y))
    out_x = np.maximum(np.abs(seen_x - _IMAGE[0]) - _HALF[0], 0.0)
    out_y = np.maximum(np.abs(seen_y - _IMAGE[1]) - _HALF[1], 0.0)
    away = np.hypot(out_x, out_y)
    image = 1.0 - np.clip(away / edge, 0.0, 1.0)
    seen: Doubles = np.where(up > 0.0, _GLEAM * image**2 * (3.0 - 2.0 * image) + _SHEEN * np.exp(-3.0 * away), 0.0)
    return seen


def _noise(count: int) -> Doubles:
    """Noise of less than one grey level, added so that slow gradients show no bands."""
    return np.random.default_rng(1).uniform(-_DITHER, _DITHER, count)


def shadow_of(height: float) -> tuple[float, float]:
    """How far right and down of a ball its shadow falls that is `height` above the cloth; all in the same units."""
    return -_LAMP[0] / _LAMP[2] * height, _LAMP[1] / _LAMP[2] * height


@lru_cache(maxsize=128)
def shadow(radius: float, step: int, height: float = 0.0) -> tuple[pygame.Surface, int, int]:
    """The shadow of a ball: dark where the ball touches the cloth, soft around, long on the side away from the lamp.

    The `height` of a ball over the cloth is in its radii: the higher, the softer and fainter its shadow, which then
    lies about the place that `shadow_of` says. With the picture come the offsets, right and down in pixels, from the
    middle pixel of the ball or of that place to its top left corner.
    """
    # The part of a shadow that is cast by a ball's being so near, and how much its edge is spread.
    near, spread = math.exp(-2.5 * height), 0.45 * height
    half = math.ceil(radius * (2.4 + spread)) + 1
    across = np.arange(-half, half + 1, dtype=np.float64)
    right, down = offset(step)
    x = ((across - right) / radius)[:, None]
    y = ((across - down) / radius)[None, :]
    contact = _blot(x - 0.05, y - 0.09, 1.0, 0.16)
    soft = _blot(x - 0.18 * near, y - 0.26 * near, 0.95, 0.50 + spread)
    # The long one: a stadium from the ball away from the lamp.
    length = math.hypot(_LAMP[0], _LAMP[1])
    ox, oy = -_LAMP[0] / length, _LAMP[1] / length
    along = np.clip(x * ox + y * oy, 0.0, 0.85 * near)
    long = _blot(x - along * ox, y - along * oy, 0.72, 0.62 + spread)
    depth = 1.0 / (1.0 + 0.35 * height)
    light_left = (1.0 - 0.52 * near * contact) * (1.0 - (0.40 + 0.22 * (1.0 - near)) * depth * soft)
    light_left *= 1.0 - 0.20 * depth * long
    image = pygame.Surface((2 * half + 1, 2 * half + 1), pygame.SRCALPHA)
    level = 255.0 * (1.0 - light_left) + _noise(light_left.size).reshape(light_left.shape)
    pygame.surfarray.pixels_alpha(image)[...] = np.where(light_left > 0.998, 0.0, np.clip(level, 0.0, 255.0)).astype(
        np.uint8
    )
    box = image.get_bounding_rect()
    # A copy of its own: no more is held, or read, than there is to be seen.
    return image.subsurface(box).copy(), box.left - half, box.top - half


def _blot(x: Doubles, y: Doubles, size: float, soft: float) -> Doubles:
    """A disc whose edge fades over `soft` to either side."""
    inside: Doubles = np.clip((size + soft - np.hypot(x, y)) / (2.0 * soft), 0.0, 1.0)
    return inside * inside * (3.0 - 2.0 * inside)
