"""The picture of a ball: each of its pixels is a point of the sphere, which the orientation turns back to its paint.

All balls of one radius are worked out together, which costs little more than one alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import pygame

from ...physics.orientation import Quaternion, matrix
from . import ball_skin
from .ball_light import Light, light
from .ball_paint import Coat, paint

# Levels of a ball's own transparency, and of the light that it has more of in the air.
LEVELS = 15
LIT = 8
# How much brighter a ball is that has all of that.
_BRIGHTER = 0.3


class Sprite(NamedTuple):
    """All that a ball's picture depends on.

    The radius is in pixels, the step that of `ball_light.Light`, the orientation a quaternion of any length. One
    that is not `fine` may be looked up in the ball's skin: faster, a little rough, never transparent and never `lit`.
    """

    coat: Coat
    radius: float
    step: int
    orientation: Quaternion
    level: int = LEVELS
    fine: bool = True
    lit: int = 0


def render(sprites: Sequence[Sprite], fine: bool) -> list[pygame.Surface]:
    """The pictures of sprites of one radius: painted anew where `fine`, else looked up in the balls' skins."""
    radius, steps = sprites[0].radius, [sprite.step for sprite in sprites]
    coats = [sprite.coat for sprite in sprites]
    turns = np.array([matrix(sprite.orientation) for sprite in sprites], dtype=np.float32)
    if not fine:
        return ball_skin.pictures(coats, radius, steps, turns)
    lit = light(radius).at(steps)
    # Turned back: the transposed matrix.
    places = np.matmul(turns.transpose(0, 2, 1), lit[:, Light.NORMAL])
    color, glossy = paint(coats, places, lit[:, Light.SOFT], radius)
    color *= lit[:, Light.SHADE]
    if any(sprite.lit for sprite in sprites):
        color *= np.array([[[1.0 + _BRIGHTER * sprite.lit / LIT]] for sprite in sprites], dtype=np.float32)
    color += lit[:, Light.GLOSS] * glossy[:, None]
    np.clip(color, 0.0, 255.0, out=color)
    alpha = np.array([[255.0 * sprite.level / LEVELS] for sprite in sprites], dtype=np.float32)
    pixels = np.empty((*glossy.shape, 4), dtype=np.uint8)
    levels = color.astype(np.uint8)
    for channel in range(3):
        pixels[:, :, 2 - channel] = levels[:, channel]
    pixels[:, :, 3] = lit[:, Light.COVER] * alpha
    side = 2 * light(radius).half + 1
    return [pygame.image.frombuffer(picture.data, (side, side), "BGRA") for picture in pixels]
