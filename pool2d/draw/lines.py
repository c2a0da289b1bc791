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

_Ints = npt.NDArray[np.int64]
_Floats = npt.NDArray[np.float64]
_Flags = npt.NDArray[np.bool_]
_Covers = npt.NDArray[np.float32]
_Pixels = npt.NDArray[np.uint32]

# A pixel that is covered in full; the two of its four bytes that are mixed at once, and what rounds them.
_FULL, _BYTES, _HALVES = 256, 0x00FF00FF, 0x00800080


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
    of: _Ints


def drawable(surface: pygame.Surface) -> bool:
    """Whether these lines can be drawn on a surface: it has four bytes a pixel, and none of them says how solid."""
    return surface.get_bytesize() == 4 and not surface.get_flags() & pygame.SRCALPHA


def draw(surface: pygame.Surface, paths: Sequence[Path]) -> None:
    """Draw lines within the clip, later ones over earlier ones."""
    pieces = _pieces(paths)
    places, cover, of = _covered(pieces, surface)
    pixels = np.frombuffer(surface.get_buffer(), np.uint32)  # type: ignore[call-overload]  # It is a buffer.
    total = _blank(len(pixels))
    ends = np.searchsorted(of, np.arange(len(paths) + 1))
    for path, start, end in zip(paths, ends[:-1], ends[1:], strict=True):
        here = places[:, start:end].ravel()
        # What two pieces cover of a pixel where they meet adds up; all of its mentions then say the same.
        np.add.at(total, here, cover[:, start:end].ravel())
        part = np.minimum(total[here], 1.0)
        total[here] = 0.0
        part *= _FULL * (path.color[3] if len(path.color) == 4 else 255) / 255.0
        pixels[here] = _mixed(pixels[here], surface.map_rgb(path.color[:3]), np.rint(part).astype(np.uint32))


def _pieces(paths: Sequence[Path]) -> _Pieces:
    of = np.repeat(np.arange(len(paths)), [len(path.points) for path in paths])
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


def _covered(pieces: _Pieces, surface: pygame.Surface) -> tuple[_Ints, _Covers, _Ints]:
    """The pixels of pieces, counted row by row, how much of each is covered, 0 to 1, and the lines they belong to.

    A piece goes pixel by pixel along its axis, and in each is as high across as makes its width: each column of the
    first two is one such step. What lies outside of the clip is told as nothing of the first pixel.
    """
    steep, clip, pitch = pieces.steep, surface.get_clip(), surface.get_pitch() // 4
    first = np.maximum(np.floor(pieces.u0 + 0.5), np.where(steep, clip.top, clip.left)).astype(np.int64)
    last = np.minimum(np.floor(pieces.u1 + 0.5), np.where(steep, clip.bottom, clip.right) - 1).astype(np.int64)
    count = np.maximum(last - first + 1, 0)
    piece = np.repeat(np.arange(len(count)), count)
    u = np.arange(len(piece)) + (first - np.cumsum(count) + count)[piece]
    u0, half = pieces.u0[piece], pieces.half[piece]
    start, end = np.maximum(u - 0.5, u0), np.minimum(u + 0.5, pieces.u1[piece])
    v = pieces.v0[piece] + (0.5 * (start + end) - u0) * ((pieces.v1 - pieces.v0) / (pieces.u1 - pieces.u0))[piece]
    lowest = np.floor(v - half + 0.5)
    # Of the pixels across, counted from the lowest, all is covered that lies above `below` and not above `above`.
    below, above = ((v + side * half - lowest + 0.5).astype(np.float32) for side in (-1.0, 1.0))
    rows = np.arange(math.ceil(2.0 * half.max(initial=0.0)) + 1, dtype=np.float32)[:, None]
    cover = np.clip(above - rows, 0.0, 1.0) - np.clip(below - rows, 0.0, 1.0)
    cover *= (end - start).astype(np.float32)
    across = rows.astype(np.int64) + lowest.astype(np.int64)
    inside = (across >= np.where(steep, clip.left, clip.top)[piece]) & (
        across < np.where(steep, clip.right, clip.bottom)[piece]
    )
    across *= np.where(steep, 1, pitch)[piece]
    across += u * np.where(steep, pitch, 1)[piece]
    return across * inside, cover * inside, pieces.of[piece]


@lru_cache(maxsize=1)
def _blank(size: int) -> _Covers:
    """Room for what is covered of each pixel, left blank by whoever uses it: to fetch it anew takes long."""
    return np.zeros(size, np.float32)


def _mixed(below: _Pixels, color: int, part: _Pixels) -> _Pixels:
    """Pixels with `part` of _FULL of a colour over them."""
    rest = _FULL - part
    even = (below & _BYTES) * rest + (color & _BYTES) * part + _HALVES
    odd = (below >> 8 & _BYTES) * rest + (color >> 8 & _BYTES) * part + _HALVES
    return np.asarray(even >> 8 & _BYTES | odd & ~np.uint32(_BYTES), np.uint32)
