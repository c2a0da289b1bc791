"""The paint at any points of a ball's surface: colour, stripe, spots, dots, number and shape.

The points of several balls are worked out together, which costs little more than those of one.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ...table.furniture import Look
from .. import theme
from ..theme import Style
from . import ball_marks
from .ball_light import Floats

# How wide a stripe, a spot, a dot are: half of it as seen from straight above, in radii.
_STRIPE, _SPOT, _DOT = 0.56, 0.52, 0.17
# Widths at which a stripe covers the whole ball, and a spot nothing.
_ALL, _NONE = 2.0, -2.0
_INK = (20, 20, 22)
# The part of the gloss that print lacks, so that it can be read under the lamp.
_MATT = 0.85


class Coat(NamedTuple):
    """Which paint a ball has: its look, from the preset, and the style in which balls are drawn."""

    look: Look
    style: Style


class Painted(NamedTuple):
    """The paint at points: `color` (balls, 3, points), from 0 to 255, and `glossy` (balls, points).

    `glossy` is the part of the full gloss that a point has: 1 for lacquer, less for print.
    """

    color: Floats
    glossy: Floats


def paint(coats: Sequence[Coat], places: Floats, soft: Floats, radius: float) -> Painted:
    """The paint of balls of `radius` pixels at `places` (balls, 3, points): unit vectors in the balls' own axes.

    `soft` (balls, points) is how many pixels a radius on the surface spans there: edges fade over one pixel.
    """
    paints = [_paint_of(*coat) for coat in coats]
    painted = Painted(_colors(paints, places, soft), np.ones_like(soft))
    printed = np.zeros_like(soft)
    dotted = [i for i, coat in enumerate(coats) if coat.look.dots]
    if dotted:
        # Six dots, where the axes come out of the ball.
        printed[dotted] = _cover(_DOT - _off(np.abs(places[dotted]).max(axis=1)), soft[dotted])
    numbers = {i: coat.look.number for i, coat in enumerate(coats) if coat.look.number}
    _print(printed, places, numbers, 2, radius)
    _ink(painted, printed, [part.ink for part in paints])
    shapes = {i: shape for i, coat in enumerate(coats) if coat.style.patterned and (shape := _shape(coat.look))}
    if shapes:
        shaped = np.zeros_like(soft)
        for axis in range(3):
            here = {i: shape for i, shape in shapes.items() if axis < 2 or i not in numbers}
            _print(shaped, places, here, axis, radius)
        _ink(painted, shaped, [part.sign for part in paints])
    return painted


class _Paint(NamedTuple):
    """The colours of a ball: its own, the second (spots, caps), that of print, that of shapes.

    `stripe` and `spot` are half widths, in radii.
    """

    base: tuple[int, ...]
    second: tuple[int, ...]
    ink: tuple[int, ...]
    sign: tuple[int, ...]
    stripe: float
    spot: float


@lru_cache(maxsize=512)
def _paint_of(look: Look, style: Style) -> _Paint:
    base, white = style.palette.color(look.color)[:3], style.palette.white[:3]
    sign = white if 0.3 * base[0] + 0.59 * base[1] + 0.11 * base[2] < 120.0 else _INK
    # A number is dark on its white spot, whatever the ball; dots are red on a light ball.
    ink = _INK if look.number else white if sign == white else theme.DOT
    return _Paint(base, white, ink, sign, _STRIPE if look.stripe else _ALL, _SPOT if look.number else _NONE)


def _colors(paints: Sequence[_Paint], places: Floats, soft: Floats) -> Floats:
    """The colours at points before print: the ball's own, and the second beyond the stripe and on the spots."""
    base = np.array([paint.base for paint in paints], dtype=np.float32)[:, :, None]
    other = np.array([paint.second for paint in paints], dtype=np.float32)[:, :, None] - base
    stripe = np.array([[paint.stripe] for paint in paints], dtype=np.float32)
    spot = np.array([[paint.spot] for paint in paints], dtype=np.float32)
    second = np.maximum(np.abs(places[:, 1]) - stripe, spot - _off(places[:, 2]))
    painted: Floats = base + other * _cover(second, soft)[:, None]
    return painted


def _ink(painted: Painted, printed: Floats, inks: Sequence[tuple[int, ...]]) -> None:
    """Mix the balls' inks into their colours, as far as they are printed; print has less gloss."""
    over = np.array(inks, dtype=np.float32)[:, :, None] - painted.color
    over *= printed[:, None]
    painted.color[...] += over
    painted.glossy[...] *= 1.0 - _MATT * printed


def _cover(inside: Floats, soft: Floats) -> Floats:
    """How much of a pixel is covered whose middle lies `inside` an edge, in radii; `soft` is pixels a radius."""
    part = inside * soft
    part += 0.5
    return np.clip(part, 0.0, 1.0, out=part)


def _off(along: Floats) -> Floats:
    """The distance from an axis, in radii, of a point of the sphere whose part along the axis is `along`."""
    off: Floats = np.sqrt(np.maximum(1.0 - along * along, 0.0))
    return off


def _shape(look: Look) -> str:
    """The name of the shape that tells a ball's colour; "" for a dotted ball, which needs none."""
    name = theme.hue(look.color)
    return name if name in ball_marks.SHAPES and not look.dots else ""


def _print(onto: Floats, places: Floats, marks: Mapping[int, str], axis: int, radius: float) -> None:
    """Add the ink of marks, given by the balls' indices, where an axis leaves the ball on either side."""
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
