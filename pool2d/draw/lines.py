"""Thin lines, drawn by how much they cover of each pixel: of one width at every angle, and many at once."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
import pygame

from .theme import Color

Point = tuple[float, float]
# From left and top to right and bottom, which are not within it.
_Clip = tuple[int, int, int, int]

_Ints = npt.NDArray[np.int64]
_Lines = npt.NDArray[np.int16]
_Floats = npt.NDArray[np.float64]
_Flags = npt.NDArray[np.bool_]
_Covers = npt.NDArray[np.float32]
_Pixels = npt.NDArray[np.uint32]

# A pixel that is covered in full; the two of its four bytes that are mixed at once, and what rounds them.
_FULL, _BYTES, _HALVES = 256, 0x00FF00FF, 0x00800080
# No line at all: more than are ever drawn at once.
_NONE = (1 << 15) - 1


class Path(NamedTuple):
    """A line through several points; points and width in pixels."""

    color: Color
    points: Sequence[Point]
    width: float = 1.5


class _Pieces(NamedTuple):
    """The straight pieces of lines, each from u0 to u1, the greater, along the axis that it is nearer to.

    `steep` where that is y. v is the other coordinate, along which a piece reaches `half` to either side. `of` counts
    the lines that they belong to.
    """

    u0: _Floats
    v0: _Floats
    u1: _Floats
    v1: _Floats
    half: _Floats
    steep: _Flags
    of: _Lines


def drawable(surface: pygame.Surface) -> bool:
    """Whether these lines can be drawn on a surface: it has four bytes a pixel, and none of them says how solid."""
    return surface.get_bytesize() == 4 and not surface.get_flags() & pygame.SRCALPHA


def draw(surface: pygame.Surface, paths: Sequence[Path]) -> None:
    """Draw lines within the clip, later ones over earlier ones."""
    pixels = np.frombuffer(surface.get_buffer(), np.uint32)  # type: ignore[call-overload]  # It is a buffer.
    clip, pitch = surface.get_clip(), surface.get_pitch() // 4
    fixed = tuple([path._replace(points=tuple(path.points)) for path in paths])
    colors = np.array([surface.map_rgb(path.color[:3]) for path in paths], np.uint32)
    for places, of, part in _layers(fixed, (*clip.topleft, *clip.bottomright), pitch, len(pixels)):
        pixels[places] = _mixed(pixels.take(places), colors.take(of), part)


@lru_cache(maxsize=8)
def _layers(paths: tuple[Path, ...], clip: _Clip, pitch: int, size: int) -> list[tuple[_Ints, _Lines, _Pixels]]:
    """The pixels to be mixed with colours, all of a layer at once: which, of which lines, and to what part of _FULL.

    A second layer has those pixels where a line lies over another, a third those where one more does: a call costs more
    than many pixels. What rests while something beside it changes is not worked out again.
    """
    places, of, cover = _covered(_pieces(paths), clip, pitch)
    solid = np.array([path.color[3] if len(path.color) == 4 else 255 for path in paths], np.float32) * (_FULL / 255.0)
    total, first = _blank(size)
    layers = []
    while len(places):
        np.minimum.at(first, places, of)
        now = first.take(places) == of
        here, line = places[now], of[now]
        # What two pieces cover of a pixel where they meet adds up; all of its mentions then say the same.
        np.add.at(total, here, cover[now])
        part = np.rint(np.minimum(total.take(here), 1.0) * solid.take(line)).astype(np.uint32)
        layers.append((here, line, part))
        total[here], first[here] = 0.0, _NONE
        places, of, cover = places[~now], of[~now], cover[~now]
    return layers


def _pieces(paths: Sequence[Path]) -> _Pieces:
    of = np.repeat(np.arange(len(paths), dtype=np.int16), [len(path.points) for path in paths])
    points = np.array([point for path in paths for point in path.points], np.float64).reshape(-1, 2)
    a, b = points[:-1], points[1:]
    some = (of[:-1] == of[1:]) & (a != b).any(axis=1)
    a, b, of = a[some], b[some], of[:-1][some]
    step = np.abs(b - a)
    steep = step[:, 1] > step[:, 0]
    a[steep], b[steep] = a[steep, ::-1], b[steep, ::-1]
    ahead = (a[:, 0] < b[:, 0])[:, None]
    (u0, v0), (u1, v1) = np.where(ahead, a, b).T, np.where(ahead, b, a).T
    half = 0.5 * np.array([path.width for path in paths])[of] * np.hypot(u1 - u0, v1 - v0) / (u1 - u0)
    return _Pieces(u0, v0, u1, v1, half, steep, of)


def _covered(pieces: _Pieces, clip: _Clip, pitch: int) -> tuple[_Ints, _Lines, _Covers]:
    """The pixels of pieces, counted row by row, the lines they belong to, and how much of each is covered, up to 1.

    A piece goes pixel by pixel along its axis, and in each is as high across as makes its width.
    """
    steep, (left, top, right, bottom) = pieces.steep, clip
    first = np.maximum(np.floor(pieces.u0 + 0.5), np.where(steep, top, left)).astype(np.int64)
    last = np.minimum(np.floor(pieces.u1 + 0.5), np.where(steep, bottom, right) - 1).astype(np.int64)
    count = np.maximum(last - first + 1, 0)
    piece = np.repeat(np.arange(len(count)), count)
    u = np.arange(len(piece)) + (first - np.cumsum(count) + count)[piece]
    u0, half = pieces.u0[piece], pieces.half[piece]
    start, end = np.maximum(u - 0.5, u0), np.minimum(u + 0.5, pieces.u1[piece])
    v = pieces.v0[piece] + (0.5 * (start + end) - u0) * ((pieces.v1 - pieces.v0) / (pieces.u1 - pieces.u0))[piece]
    below = np.maximum(v - half, (np.where(steep, left, top) - 0.5)[piece])
    above = np.minimum(v + half, (np.where(steep, right, bottom) - 0.5)[piece])
    lowest = np.floor(below + 0.5)
    # The pixels across are counted from the lowest, and so is from where to where the piece reaches in them.
    below, above = ((side - lowest + 0.5).astype(np.float32) for side in (below, above))
    rows = np.arange(math.ceil(2.0 * half.max(initial=0.0)) + 1)[:, None]
    cover = np.minimum(above, (rows + 1).astype(np.float32)) - np.maximum(below, rows.astype(np.float32))
    cover *= (end - start).astype(np.float32)
    up, on = np.where(steep, 1, pitch), np.where(steep, pitch, 1)
    places = rows * up[piece] + (lowest.astype(np.int64) * up[piece] + u * on[piece])
    some = cover > 0.0
    return places[some], np.broadcast_to(pieces.of[piece], some.shape)[some], cover[some]


@lru_cache(maxsize=1)
def _blank(size: int) -> tuple[_Covers, _Lines]:
    """Room for how much of each pixel is covered, and by which line first.

    It is left blank by whoever uses it: to fetch it anew takes long.
    """
    return np.zeros(size, np.float32), np.full(size, _NONE, np.int16)


def _mixed(below: _Pixels, color: _Pixels, part: _Pixels) -> _Pixels:
    """Pixels with `part` of _FULL of a colour over each."""
    rest = _FULL - part
    even = (below & _BYTES) * rest + (color & _BYTES) * part + _HALVES
    odd = (below >> 8 & _BYTES) * rest + (color >> 8 & _BYTES) * part + _HALVES
    return np.asarray(even >> 8 & _BYTES | odd & ~np.uint32(_BYTES), np.uint32)
