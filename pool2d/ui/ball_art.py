"""Balls as lit spheres, at any size and placed to a quarter of a pixel."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import numpy.typing as npt
import pygame

from ..racks import Look
from . import text
from .theme import BALLS, DOT, IVORY

_Array = npt.NDArray[np.float64]

_LIGHT = np.array([-0.36, 0.48, 0.80])
# Where the lamp is mirrored: half way between the light and the eye above.
_MIRROR = (_LIGHT + np.array([0.0, 0.0, 1.0])) / np.linalg.norm(_LIGHT + np.array([0.0, 0.0, 1.0]))
_STEPS = 4
# Where the dots of a spotted ball are, one more opposite each, and how wide they are as seen from its middle.
_DOTS = ((0.36, 0.48, 0.80), (0.80, -0.60, 0.0), (-0.48, -0.64, 0.60))
_DOT_COSINE = math.cos(0.2)


def draw(
    surface: pygame.Surface,
    ball: str,
    centre: tuple[float, float],
    radius: float,
    faint: bool = False,
    look: Look | None = None,
) -> None:
    """Draw a ball and its shadow; `faint` for one that is not really there.

    Without a look, a ball that is a number looks like that ball of a pool set, and any other is white.
    """
    size = max(2.0, round(radius * 4.0) / 4.0)
    x, y = round(centre[0] * _STEPS), round(centre[1] * _STEPS)
    image = _sprite(look or usual(ball), size, x % _STEPS, y % _STEPS, faint)
    half = (image.get_width() - 1) // 2
    if not faint:
        shade = _shadow(size)
        surface.blit(
            shade,
            (x // _STEPS - shade.get_width() // 2 + size * 0.12, y // _STEPS - shade.get_height() // 2 + size * 0.2),
        )
    surface.blit(image, (x // _STEPS - half, y // _STEPS - half))


def usual(ball: str) -> Look:
    """The look of a ball that its preset says nothing of."""
    number = int(ball) if ball.isdecimal() and len(ball) < 4 else 0
    if number == 0:
        return Look(_hex(IVORY))
    color = BALLS.get(number if number <= 8 else number - 8, (150, 150, 150))
    return Look(_hex(color), stripe=number > 8, number=ball)


def _hex(color: tuple[int, ...]) -> str:
    return "#" + bytes(color[:3]).hex()


@lru_cache(maxsize=2048)
def _sprite(look: Look, radius: float, step_x: int, step_y: int, faint: bool) -> pygame.Surface:
    half = math.ceil(radius) + 2
    across = np.arange(-half, half + 1, dtype=np.float64)
    x = (across[:, None] - step_x / _STEPS) / radius
    y = -(across[None, :] - step_y / _STEPS) / radius
    square = x * x + y * y
    z = np.sqrt(np.clip(1.0 - square, 0.0, 1.0))
    paint = _paint(look, x, y, z, radius)
    lit = np.clip(x * _LIGHT[0] + y * _LIGHT[1] + z * _LIGHT[2], 0.0, 1.0)
    gleam = np.clip(x * _MIRROR[0] + y * _MIRROR[1] + z * _MIRROR[2], 0.0, 1.0) ** 60
    color = paint * (0.42 + 0.62 * lit)[..., None] + 190.0 * gleam[..., None]
    cover = np.clip((1.0 - np.sqrt(square)) * radius + 0.5, 0.0, 1.0)
    image = pygame.Surface((2 * half + 1, 2 * half + 1), pygame.SRCALPHA)
    pygame.surfarray.pixels3d(image)[...] = np.clip(color, 0.0, 255.0).astype(np.uint8)
    pygame.surfarray.pixels_alpha(image)[...] = (cover * (110.0 if faint else 255.0)).astype(np.uint8)
    if look.number:
        digits = text.picture(
            look.number, max(6, round(radius * (1.0 if len(look.number) == 1 else 0.85))), (20, 20, 22)
        )
        if faint:
            digits = digits.copy()
            digits.set_alpha(110)
        x0 = half + 0.5 + step_x / _STEPS - digits.get_width() / 2
        y0 = half + 0.5 + step_y / _STEPS - digits.get_height() / 2
        image.blit(digits, (round(x0), round(y0)))
    return image


def _paint(look: Look, x: _Array, y: _Array, z: _Array, radius: float) -> _Array:
    """The colour of each point of the sphere before any light falls on it."""
    ivory = np.array(IVORY, dtype=np.float64)
    color = np.array(list(bytes.fromhex(look.color[1:])), dtype=np.float64)
    painted: _Array = np.broadcast_to(color, (*z.shape, 3))
    if look.stripe:
        band = np.clip((0.62 - np.abs(y)) * radius + 0.5, 0.0, 1.0) + 0.0 * x
        painted = ivory + (color - ivory) * band[..., None]
    if look.number:
        spot = np.clip((0.56 - np.sqrt(x * x + y * y)) * radius + 0.5, 0.0, 1.0)
        painted = painted + (ivory - painted) * spot[..., None]
    if look.dots:
        # Dark dots on a light ball, light ones on a dark one.
        ink = np.array(DOT, dtype=np.float64) if color.mean() > 120.0 else ivory
        nearest = np.max([np.abs(x * dx + y * dy + z * dz) for dx, dy, dz in _DOTS], axis=0)
        cover = np.clip((nearest - _DOT_COSINE) * radius * 5.0 + 0.5, 0.0, 1.0)
        painted = painted + (ink - painted) * cover[..., None]
    return painted


@lru_cache(maxsize=16)
def _shadow(radius: float) -> pygame.Surface:
    half = math.ceil(radius * 1.5) + 1
    across = np.arange(-half, half + 1, dtype=np.float64) / radius
    distance = np.sqrt(across[:, None] ** 2 + across[None, :] ** 2)
    image = pygame.Surface((2 * half + 1, 2 * half + 1), pygame.SRCALPHA)
    pygame.surfarray.pixels_alpha(image)[...] = (120.0 * np.clip((1.35 - distance) / 0.6, 0.0, 1.0)).astype(np.uint8)
    return image
