"""The picture of a ball: each pixel is a point of the sphere, which turned back as the ball has turned tells its paint.

All balls of one size are worked out together, which costs little more than one alone.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import pygame

from ..physics.turning import Quaternion, matrix, unit
from ..racks import Look
from . import ball_marks, theme
from .ball_light import Floats, Light, light
from .theme import Style

# Levels of a ball's own transparency.
LEVELS = 15
# How wide a stripe, a spot, a dot are: half of it as seen from straight above, in radii.
_STRIPE, _SPOT, _DOT = 0.56, 0.52, 0.17
# Widths at which a stripe covers the whole ball, and a spot nothing.
_ALL, _NONE = 2.0, -2.0
_INK = (20, 20, 22)
# The part of the gloss that print lacks, so that it can be read under the lamp.
_MATT = 0.85


class Sprite(NamedTuple):
    """What a picture depends on: the radius in pixels, the step of `ball_light`, the orientation in any unit."""

    look: Look
    style: Style
    radius: float
    step: int
    lie: Quaternion
    level: int = LEVELS


def render(sprites: Sequence[Sprite]) -> list[pygame.Surface]:
    """The pictures of balls of one radius."""
    lamp = light(sprites[0].radius)
    side = 2 * lamp.half + 1
    lit = lamp.at([sprite.step for sprite in sprites])
    turns = np.array([matrix(unit(sprite.lie)) for sprite in sprites], dtype=np.float32)
    # Turned back: the transposed matrix.
    places = np.matmul(turns.transpose(0, 2, 1), lit[:, Light.NORMAL])
    paints = [paint_of(sprite.look, sprite.style) for sprite in sprites]
    color, gloss = _colors(paints, places, lit[:, Light.SOFT]), lit[:, Light.GLOSS]
    _print_all(sprites, paints, places, lit[:, Light.SOFT], color, gloss)
    color *= lit[:, Light.SHADE]
    color += gloss
    np.clip(color, 0.0, 255.0, out=color)
    alpha = np.array([[255.0 * sprite.level / LEVELS] for sprite in sprites], dtype=np.float32)
    pixels = np.empty((len(sprites), side * side, 4), dtype=np.uint8)
    levels = color.astype(np.uint8)
    for channel in range(3):
        pixels[:, :, 2 - channel] = levels[:, channel]
    pixels[:, :, 3] = lit[:, Light.COVER] * alpha
    return [pygame.image.frombuffer(picture.data, (side, side), "BGRA") for picture in pixels]


def _colors(paints: Sequence[Paint], places: Floats, soft: Floats) -> Floats:
    """The paint (balls, 3, points): the ball's own colour, and the second beyond the stripe and on the spots."""
    base = np.array([paint.base for paint in paints], dtype=np.float32)[:, :, None]
    other = np.array([paint.second for paint in paints], dtype=np.float32)[:, :, None] - base
    stripe = np.array([[paint.stripe] for paint in paints], dtype=np.float32)
    spot = np.array([[paint.spot] for paint in paints], dtype=np.float32)
    second = np.maximum(np.abs(places[:, 1]) - stripe, spot - _off(places[:, 2]))
    painted: Floats = base + other * _cover(second, soft)[:, None]
    return painted


def _print_all(
    sprites: Sequence[Sprite], paints: Sequence[Paint], places: Floats, soft: Floats, color: Floats, gloss: Floats
) -> None:
    """Print dots, numbers and shapes onto the balls' colours."""
    printed = np.zeros_like(soft)
    dotted = [i for i, sprite in enumerate(sprites) if sprite.look.dots]
    if dotted:
        # Six dots, where the axes come out of the ball.
        printed[dotted] = _cover(_DOT - _off(np.abs(places[dotted]).max(axis=1)), soft[dotted])
    radius = sprites[0].radius
    numbers = {i: sprite.look.number for i, sprite in enumerate(sprites) if sprite.look.number}
    _print(printed, places, numbers, 2, radius)
    _ink(color, gloss, printed, [paint.ink for paint in paints])
    shapes = {i: shape for i, sprite in enumerate(sprites) if sprite.style.patterned and (shape := _shape(sprite.look))}
    if shapes:
        shaped = np.zeros_like(soft)
        for axis in range(3):
            here = {i: shape for i, shape in shapes.items() if axis < 2 or i not in numbers}
            _print(shaped, places, here, axis, radius)
        _ink(color, gloss, shaped, [paint.sign for paint in paints])


def _ink(color: Floats, gloss: Floats, printed: Floats, inks: Sequence[tuple[int, ...]]) -> None:
    """Lay the balls' inks on their colours as far as they are printed; print is matt."""
    part = printed[:, None]
    over = np.array(inks, dtype=np.float32)[:, :, None] - color
    over *= part
    color += over
    gloss *= 1.0 - _MATT * part


def _cover(inside: Floats, soft: Floats) -> Floats:
    """How much of a pixel lies `inside` an edge, that far in radii, its slope such that it fades over a pixel."""
    part = inside * soft
    part += 0.5
    return np.clip(part, 0.0, 1.0, out=part)


def _off(along: Floats) -> Floats:
    """How far from an axis a point is that lies `along` it."""
    off: Floats = np.sqrt(np.maximum(1.0 - along * along, 0.0))
    return off


class Paint(NamedTuple):
    """A ball's colour, that of its spots and caps, its ink, that of a shape; half widths of stripe, spot and dots."""

    base: tuple[int, ...]
    second: tuple[int, ...]
    ink: tuple[int, ...]
    sign: tuple[int, ...]
    stripe: float
    spot: float
    dot: float


@lru_cache(maxsize=512)
def paint_of(look: Look, style: Style) -> Paint:
    base, white = style.palette.color(look.color)[:3], style.palette.white[:3]
    sign = white if 0.3 * base[0] + 0.59 * base[1] + 0.11 * base[2] < 120.0 else _INK
    # A number is dark on its white spot, whatever the ball; dots are red on a light ball.
    ink = _INK if look.number else white if sign == white else theme.DOT
    return Paint(
        base, white, ink, sign,
        _STRIPE if look.stripe else _ALL, _SPOT if look.number else _NONE, _DOT if look.dots else _NONE,
    )  # fmt: skip


def _shape(look: Look) -> str:
    """The name of the shape that marks a ball's colour, or none; dots are marks enough."""
    name = theme.hue(look.color)
    return name if name in ball_marks.SHAPES and not look.dots else ""


def _print(onto: Floats, places: Floats, marks: Mapping[int, str], axis: int, radius: float) -> None:
    """Print marks, by the balls' indices, where an axis comes out of the ball on either side."""
    if not marks:
        return
    count = places.shape[2]
    pictures = ball_marks.pictures(tuple(marks.get(i, "") for i in range(len(places))), radius)
    inside = np.flatnonzero(np.abs(places[:, axis]) > math.sqrt(1.0 - ball_marks.INKED**2))
    ball = inside // count
    flat, at = places.reshape(-1), inside + 2 * count * ball
    right, up, out = (flat[at + part % 3 * count] for part in (axis + 1, axis + 2, axis))
    ink = ball_marks.sample(pictures, ball, np.copysign(right, right * out), up)
    printed = onto.reshape(-1)
    printed[inside] = np.maximum(printed[inside], ink)
