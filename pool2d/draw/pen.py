"""Antialiased shapes on a surface, in pixels."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise

import numpy as np
import numpy.typing as npt
import pygame
import pygame.gfxdraw

from .theme import Color

Point = tuple[float, float]

_Ints = npt.NDArray[np.int64]
_Floats = npt.NDArray[np.float64]

# Circles are placed to this part of a pixel.
_STEPS = 4
# Lines no wider than so many pixels are drawn by how much they cover of each pixel; of wider ones nobody sees it.
_THIN = 6.0


def line(surface: pygame.Surface, color: Color, a: Point, b: Point, width: float = 1.5) -> None:
    """A straight line of any width."""
    path(surface, color, (a, b), width)


def path(surface: pygame.Surface, color: Color, points: Sequence[Point], width: float = 1.5) -> None:
    """A line through several points, of one width at every angle."""
    if width > _THIN or surface.get_flags() & pygame.SRCALPHA:
        for a, b in pairwise(points):
            _bar(surface, color, a, b, width)
        return
    pieces = [_thin(a, b, width) for a, b in pairwise(points) if a != b]
    if not pieces:
        return
    x, y, cover = (np.concatenate(parts) for parts in zip(*pieces, strict=True))
    clip = surface.get_clip()
    seen = (x >= clip.left) & (x < clip.right) & (y >= clip.top) & (y < clip.bottom) & (cover > 0.0)
    x, y, cover = x[seen], y[seen], cover[seen]
    if not len(x):
        return
    # What two pieces cover of a pixel where they meet adds up.
    places, which = np.unique(x * surface.get_height() + y, return_inverse=True)
    part = np.minimum(np.bincount(which, cover), 1.0)[:, None] * ((color[3] if len(color) == 4 else 255) / 255.0)
    x, y = np.divmod(places, surface.get_height())
    pixels = pygame.surfarray.pixels3d(surface)
    below = pixels[x, y]
    pixels[x, y] = np.rint(below + (np.array(color[:3]) - below) * part).astype(np.uint8)


def _thin(a: Point, b: Point, width: float) -> tuple[_Ints, _Ints, _Floats]:
    """The pixels of a thin line, and how much of each it covers, 0 to 1.

    It goes pixel by pixel along the axis that it is nearer to; in each it is as high across as makes its width.
    """
    dx, dy = b[0] - a[0], b[1] - a[1]
    steep = abs(dy) > abs(dx)
    (u0, v0), (u1, v1) = sorted(((a[1], a[0]), (b[1], b[0])) if steep else (a, b))
    half = 0.5 * width * math.hypot(dx, dy) / (u1 - u0)
    u = np.arange(math.floor(u0 + 0.5), math.floor(u1 + 0.5) + 1)
    first, last = np.maximum(u - 0.5, u0), np.minimum(u + 0.5, u1)
    v = v0 + (0.5 * (first + last) - u0) * (v1 - v0) / (u1 - u0)
    rows = np.floor(v - half + 0.5)[:, None] + np.arange(math.ceil(2.0 * half) + 1)
    cover = np.minimum(v[:, None] + half, rows + 0.5) - np.maximum(v[:, None] - half, rows - 0.5)
    cover = np.clip(cover, 0.0, 1.0) * (last - first)[:, None]
    along = np.broadcast_to(u[:, None], rows.shape).ravel().astype(np.int64)
    across = rows.ravel().astype(np.int64)
    return (across, along, cover.ravel()) if steep else (along, across, cover.ravel())


def _bar(surface: pygame.Surface, color: Color, a: Point, b: Point, width: float) -> None:
    """A straight line as the polygon that it is."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = math.hypot(dx, dy)
    if length > 0.0:
        ox, oy = -dy / length * width / 2.0, dx / length * width / 2.0
        corners = [(a[0] + ox, a[1] + oy), (b[0] + ox, b[1] + oy), (b[0] - ox, b[1] - oy), (a[0] - ox, a[1] - oy)]
        polygon(surface, color, corners)


def polygon(surface: pygame.Surface, color: Color, points: Sequence[Point]) -> None:
    """A filled polygon."""
    pygame.gfxdraw.aapolygon(surface, points, color)
    pygame.gfxdraw.filled_polygon(surface, points, color)


def disc(surface: pygame.Surface, color: Color, centre: Point, radius: float) -> None:
    """A filled circle."""
    _annulus(surface, color, centre, radius, 0.0)


def ring(surface: pygame.Surface, color: Color, centre: Point, radius: float, width: float = 1.5) -> None:
    """A circle's line, half of its width to either side of the radius."""
    _annulus(surface, color, centre, radius + width / 2.0, radius - width / 2.0)


def _annulus(surface: pygame.Surface, color: Color, centre: Point, outer: float, inner: float) -> None:
    x, y = round(centre[0] * _STEPS), round(centre[1] * _STEPS)
    image = _picture(color, round(outer, 1), round(max(0.0, inner), 1), x % _STEPS, y % _STEPS)
    half = image.get_width() // 2
    surface.blit(image, (x // _STEPS - half, y // _STEPS - half))


@lru_cache(maxsize=512)
def _picture(color: Color, outer: float, inner: float, step_x: int, step_y: int) -> pygame.Surface:
    half = math.ceil(outer) + 2
    across = np.arange(-half, half + 1, dtype=np.float64)
    distance = np.hypot(across[:, None] - step_x / _STEPS, across[None, :] - step_y / _STEPS)
    cover = np.clip(outer + 0.5 - distance, 0.0, 1.0)
    if inner > 0.0:
        cover -= np.clip(inner + 0.5 - distance, 0.0, 1.0)
    image = pygame.Surface((2 * half + 1, 2 * half + 1), pygame.SRCALPHA)
    image.fill(color)
    alpha = color[3] if len(color) == 4 else 255
    pygame.surfarray.pixels_alpha(image)[...] = (cover * alpha).astype(np.uint8)
    return image
