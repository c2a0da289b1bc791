"""Antialiased shapes on a surface, in pixels."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import groupby, pairwise

import numpy as np
import pygame
import pygame.gfxdraw

from . import lines
from .lines import Path as Path
from .lines import Point as Point
from .theme import Color

# Circles are placed to this part of a pixel.
_STEPS = 4
# Lines no wider than so many pixels are drawn by how much they cover of each pixel; of wider ones nobody sees it.
_THIN = 6.0


def line(surface: pygame.Surface, color: Color, a: Point, b: Point, width: float = 1.5) -> None:
    """A straight line of any width."""
    paths(surface, [Path(color, (a, b), width)])


def paths(surface: pygame.Surface, drawn: Iterable[Path]) -> None:
    """Lines through several points, later ones over earlier ones; many are faster drawn together than one by one."""
    drawable = lines.drawable(surface)
    for thin, some in groupby(drawn, lambda path: drawable and path.width <= _THIN):
        if thin:
            lines.draw(surface, list(some))
            continue
        for path in some:
            for a, b in pairwise(path.points):
                _bar(surface, path.color, a, b, path.width)


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
