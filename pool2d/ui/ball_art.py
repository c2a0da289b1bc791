"""Balls as lit spheres, at any size and placed to a quarter of a pixel."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import numpy.typing as npt
import pygame

from . import text
from .theme import BALLS, IVORY

_Array = npt.NDArray[np.float64]

_LIGHT = np.array([-0.36, 0.48, 0.80])
# Where the lamp is mirrored: half way between the light and the eye above.
_MIRROR = (_LIGHT + np.array([0.0, 0.0, 1.0])) / np.linalg.norm(_LIGHT + np.array([0.0, 0.0, 1.0]))
_STEPS = 4


def draw(surface: pygame.Surface, ball: str, centre: tuple[float, float], radius: float, faint: bool = False) -> None:
    """Draw a ball and its shadow; `faint` for one that is not really there."""
    size = max(2.0, round(radius * 4.0) / 4.0)
    x, y = round(centre[0] * _STEPS), round(centre[1] * _STEPS)
    image = _sprite(ball, size, x % _STEPS, y % _STEPS, faint)
    half = (image.get_width() - 1) // 2
    if not faint:
        shade = _shadow(size)
        surface.blit(
            shade,
            (x // _STEPS - shade.get_width() // 2 + size * 0.12, y // _STEPS - shade.get_height() // 2 + size * 0.2),
        )
    surface.blit(image, (x // _STEPS - half, y // _STEPS - half))


@lru_cache(maxsize=2048)
def _sprite(ball: str, radius: float, step_x: int, step_y: int, faint: bool) -> pygame.Surface:
    half = math.ceil(radius) + 2
    across = np.arange(-half, half + 1, dtype=np.float64)
    x = (across[:, None] - step_x / _STEPS) / radius
    y = -(across[None, :] - step_y / _STEPS) / radius
    square = x * x + y * y
    z = np.sqrt(np.clip(1.0 - square, 0.0, 1.0))
    paint = _paint(ball, x, y, z, radius)
    lit = np.clip(x * _LIGHT[0] + y * _LIGHT[1] + z * _LIGHT[2], 0.0, 1.0)
    gleam = np.clip(x * _MIRROR[0] + y * _MIRROR[1] + z * _MIRROR[2], 0.0, 1.0) ** 60
    color = paint * (0.42 + 0.62 * lit)[..., None] + 190.0 * gleam[..., None]
    cover = np.clip((1.0 - np.sqrt(square)) * radius + 0.5, 0.0, 1.0)
    image = pygame.Surface((2 * half + 1, 2 * half + 1), pygame.SRCALPHA)
    pygame.surfarray.pixels3d(image)[...] = np.clip(color, 0.0, 255.0).astype(np.uint8)
    pygame.surfarray.pixels_alpha(image)[...] = (cover * (110.0 if faint else 255.0)).astype(np.uint8)
    if ball.isdigit():
        digits = text.picture(ball, max(6, round(radius * (1.0 if len(ball) == 1 else 0.85))), (20, 20, 22))
        if faint:
            digits = digits.copy()
            digits.set_alpha(110)
        x0 = half + 0.5 + step_x / _STEPS - digits.get_width() / 2
        y0 = half + 0.5 + step_y / _STEPS - digits.get_height() / 2
        image.blit(digits, (round(x0), round(y0)))
    return image


def _paint(ball: str, x: _Array, y: _Array, z: _Array, radius: float) -> _Array:
    """The colour of each point of the sphere before any light falls on it."""
    ivory = np.array(IVORY, dtype=np.float64)
    if not ball.isdigit():
        return np.broadcast_to(ivory, (*z.shape, 3))
    number = int(ball)
    color = np.array(BALLS.get(number if number <= 8 else number - 8, (150, 150, 150)), dtype=np.float64)
    if number > 8:
        band = np.clip((0.62 - np.abs(y)) * radius + 0.5, 0.0, 1.0) + 0.0 * x
        base = ivory + (color - ivory) * band[..., None]
    else:
        base = np.broadcast_to(color, (*z.shape, 3))
    spot = np.clip((0.56 - np.sqrt(x * x + y * y)) * radius + 0.5, 0.0, 1.0)
    painted: _Array = base + (ivory - base) * spot[..., None]
    return painted


@lru_cache(maxsize=16)
def _shadow(radius: float) -> pygame.Surface:
    half = math.ceil(radius * 1.5) + 1
    across = np.arange(-half, half + 1, dtype=np.float64) / radius
    distance = np.sqrt(across[:, None] ** 2 + across[None, :] ** 2)
    image = pygame.Surface((2 * half + 1, 2 * half + 1), pygame.SRCALPHA)
    pygame.surfarray.pixels_alpha(image)[...] = (120.0 * np.clip((1.35 - distance) / 0.6, 0.0, 1.0)).astype(np.uint8)
    return image
