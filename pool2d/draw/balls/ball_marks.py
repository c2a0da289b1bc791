"""The numbers and shapes printed on balls, as small pictures of how much ink is where."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import numpy.typing as npt
import pygame

from .. import text

Picture = npt.NDArray[np.float32]
Indices = npt.NDArray[np.intp]
Spots = list[tuple[float, float]]

# A picture reaches this far from its middle, in radii of the ball, and its ink as far.
REACH, INKED = 0.6, 0.54
# The box that digits fill, in radii: their height, and the greatest width.
_TALL, _WIDE = 0.66, 0.70
# Pictures are first drawn this large, in pixels.
_LARGE = 96
_BOLD = 2
# On large balls they have so many points for each pixel.
_FINE = 2


def _ring(corners: int, size: float, turned: float = 0.0, waist: float = 1.0) -> Spots:
    """A polygon round the origin; with a `waist` below 1 every second corner lies that far in: a star."""
    count = corners * (1 if waist == 1.0 else 2)
    angles = (math.tau * (i / count + turned) - math.pi / 2.0 for i in range(count))
    sizes = (size * (waist if i % 2 else 1.0) for i in range(count))
    return [(r * math.cos(a), r * math.sin(a)) for r, a in zip(sizes, angles, strict=True)]


def _box(x: float, y: float, width: float, height: float) -> Spots:
    return [
        (x - width / 2, y - height / 2), (x + width / 2, y - height / 2),
        (x + width / 2, y + height / 2), (x - width / 2, y + height / 2),
    ]  # fmt: skip


_PLUS = [_box(0.0, 0.0, 0.9, 0.26), _box(0.0, 0.0, 0.26, 0.9)]
# The shape that marks each colour, in radii: polygons filled one after the other. Red and white are plain.
SHAPES: dict[str, list[Spots]] = {
    "yellow": [_ring(3, 0.5)],
    "blue": _PLUS,
    "purple": [_box(0.0, y, 0.84, 0.17) for y in (-0.3, 0.0, 0.3)],
    "orange": [[(x * 0.7 - y * 0.7, x * 0.7 + y * 0.7) for x, y in part] for part in _PLUS],
    "green": [_box(0.0, 0.0, 0.72, 0.72)],
    "maroon": [_box(-0.24, 0.0, 0.24, 0.84), _box(0.24, 0.0, 0.24, 0.84)],
    "black": [_ring(5, 0.54, 0.0, 0.42)],
    "brown": [_ring(4, 0.46, 0.0)],
    "pink": [_ring(24, 0.42)],
}
# The shape that is a ring has a hole.
_HOLES = {"pink": _ring(24, 0.22)}


@lru_cache(maxsize=12)
def pictures(marks: tuple[str, ...], radius: float) -> Picture:
    """The ink of marks on balls of `radius` pixels, stacked: (marks, rows, columns), from 0 to 1."""
    pixels = 2.0 * REACH * radius
    side = max(_LARGE, _LARGE * math.ceil(_FINE * pixels / _LARGE))
    # Blurred over a pixel's width beforehand, so that one may look up just the nearest point.
    return np.stack([_picture(mark, side, round((side / pixels - 1.0) / 2.0)) for mark in marks])


@lru_cache(maxsize=256)
def _picture(mark: str, side: int, blur: int) -> Picture:
    """The ink of one mark, a number or the name of a shape, from 0 to 1, with an empty border; "" is empty.

    Rows run downward.
    """
    if not mark:
        return np.zeros((side, side), np.float32)
    large = _shape(mark) if mark in SHAPES else _number(mark)
    if side > _LARGE:
        large = pygame.transform.smoothscale(large, (side, side))
    ink = _blurred(pygame.surfarray.array_red(large).T / 255.0, blur)
    # What is half ink stays, more and less part.
    ink = np.clip((ink - 0.5) * 1.35 + 0.5, 0.0, 1.0)
    ink[[0, -1]] = 0.0
    ink[:, [0, -1]] = 0.0
    return ink.astype(np.float32)


def _blurred(ink: npt.NDArray[np.float64], by: int) -> npt.NDArray[np.float64]:
    """A picture averaged over squares of 2 `by` + 1 pixels a side."""
    if by > 0:
        for _ in range(2):
            total = np.cumsum(np.pad(ink, ((by + 1, by), (0, 0)), mode="edge"), axis=0)
            ink = ((total[2 * by + 1 :] - total[: -2 * by - 1]) / (2 * by + 1)).T
    return ink


def sample(pictures: Picture, which: Indices, right: Picture, up: Picture) -> Picture:
    """The ink at points of the pictures numbered `which`; `right` and `up` are in ball radii from the middle."""
    side = pictures.shape[1]
    scale, middle = np.float32(side / (2.0 * REACH)), np.float32(side / 2.0)
    column, row = (right * scale + middle).astype(np.intp), (middle - up * scale).astype(np.intp)
    ink: Picture = pictures.reshape(-1)[(which * side + row) * side + column]
    return ink


def _shape(name: str) -> pygame.Surface:
    large = pygame.Surface((_LARGE, _LARGE), depth=32)
    for parts, color in ((SHAPES[name], (255, 255, 255)), ([_HOLES[name]] if name in _HOLES else [], (0, 0, 0))):
        for part in parts:
            pygame.draw.polygon(
                large, color, [((x / REACH + 1) * _LARGE / 2, (y / REACH + 1) * _LARGE / 2) for x, y in part]
            )
    return large


def _number(digits: str) -> pygame.Surface:
    """The digits, as large as the box allows; 6 and 9 are underlined, so that they can be told apart."""
    large = pygame.Surface((_LARGE, _LARGE), depth=32)
    written = text.font(_LARGE).render(digits, True, (255, 255, 255), (0, 0, 0))
    written = written.subsurface(_ink_box(written))
    unit = _LARGE / (2.0 * REACH)
    factor = min(_TALL * unit / written.get_height(), _WIDE * unit / written.get_width())
    lined = digits in ("6", "9")
    factor *= 0.9 if lined else 1.0
    width, height = round(written.get_width() * factor), round(written.get_height() * factor)
    left, top = (_LARGE - width) // 2, (_LARGE - height) // 2 - (round(0.06 * unit) if lined else 0)
    # Scaled in the depth of `large`, which `convert` would ask the display for.
    plain = pygame.Surface(written.get_size(), depth=32)
    plain.blit(written, (0, 0))
    scaled = pygame.transform.smoothscale(plain, (width, height))
    # The font's strokes are made bolder: they have to be read when they are a pixel wide.
    for x, y in ((-_BOLD, 0), (_BOLD, 0), (0, -_BOLD), (0, _BOLD)):
        large.blit(scaled, (left + x, top + y), special_flags=pygame.BLEND_RGB_MAX)
    if lined:
        large.fill((255, 255, 255), (left, top + height + round(0.06 * unit), width, round(0.08 * unit)))
    return large


def _ink_box(written: pygame.Surface) -> pygame.Rect:
    ink = pygame.surfarray.array3d(written)[..., 0] > 100
    columns, rows = np.flatnonzero(ink.any(axis=1)), np.flatnonzero(ink.any(axis=0))
    return pygame.Rect(columns[0], rows[0], columns[-1] - columns[0] + 1, rows[-1] - rows[0] + 1)
