"""Writing GIF files, which pygame cannot: 256 colours, LZW, and of each picture only what has changed.

Source: Graphics Interchange Format, Version 89a, CompuServe 1990.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, TypeAlias

import numpy as np

# Pictures and palettes: rows of red, green and blue from 0 to 255.
Pixels: TypeAlias = np.ndarray[Any, np.dtype[np.uint8]]
Ints: TypeAlias = np.ndarray[Any, np.dtype[np.int64]]

# One of the 256 is kept for what has not changed.
COLORS = 255
_CLEAR = 255
# How many bits of each channel tell colours apart.
_BITS = 7


def encode(pictures: Iterable[Pixels], palette: Pixels, delay: int, hold: int = 0) -> bytes:
    """A GIF of pictures of one size that goes round; `delay` is between them, in hundredths of a second.

    The last is held for another `hold`. All share a palette, so that what stands still does not flicker;
    `median_cut` makes one.
    """
    find = _Finder(palette)
    out: list[bytes] = []
    before: Pixels | None = None
    for picture in pictures:
        indices = find(picture)
        if before is None:
            height, width = indices.shape
            out += [b"GIF89a", struct.pack("<HHBBB", width, height, 0xF7, 0, 0)]
            out += [palette.tobytes().ljust(3 * 256, b"\0"), b"\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00"]
        out += _image(indices, before, delay)
        before = indices
    assert before is not None
    out += _image(before, before, hold) if hold else []
    return b"".join([*out, b"\x3b"])


def _image(indices: Pixels, before: Pixels | None, delay: int) -> Iterator[bytes]:
    """One picture: how long it is shown, where it lies, its pixels."""
    top, left, shown = 0, 0, indices
    if before is not None:
        changed = indices != before
        rows, columns = np.flatnonzero(changed.any(axis=1)), np.flatnonzero(changed.any(axis=0))
        top, bottom, left, right = (
            (int(rows[0]), int(rows[-1]) + 1, int(columns[0]), int(columns[-1]) + 1) if len(rows) else (0, 1, 0, 1)
        )
        box = (slice(top, bottom), slice(left, right))
        shown = np.where(changed[box], indices[box], np.uint8(_CLEAR))
    # Left as it is for the next; with a colour that is not drawn.
    yield struct.pack("<BBBBHBB", 0x21, 0xF9, 4, 0x04 | (before is not None), delay, _CLEAR, 0)
    yield struct.pack("<BHHHHB", 0x2C, left, top, shown.shape[1], shown.shape[0], 0)
    coded = lzw(shown.tobytes())
    yield b"\x08"
    yield b"".join(bytes([len(part)]) + part for part in (coded[i : i + 255] for i in range(0, len(coded), 255)))
    yield b"\x00"


def lzw(data: bytes) -> bytes:
    """Bytes compressed as GIF has it: codes of 9 to 12 bits, the lowest bit first."""
    clear, end, most = 256, 257, 4096
    known: dict[int, int] = {}
    size, free = 9, 258
    bits, filled = clear, 9
    out = bytearray()
    prefix = data[0]
    for byte in data[1:]:
        key = prefix << 8 | byte
        code = known.get(key)
        if code is not None:
            prefix = code
            continue
        bits |= prefix << filled
        filled += size
        if free < most:
            known[key] = free
            # The reader is one code behind: it needs the wider codes once this one is in its table.
            size += free >> size
            free += 1
        else:
            bits |= clear << filled
            filled += size
            known, size, free = {}, 9, 258
        prefix = byte
        while filled >= 8:
            out.append(bits & 0xFF)
            bits >>= 8
            filled -= 8
    bits |= prefix << filled
    filled += size
    size += free >> size if free < most else 0
    bits |= end << filled
    filled += size
    return bytes(out) + bits.to_bytes((filled + 7) // 8, "little")


def median_cut(pictures: Sequence[Pixels], most: int = COLORS) -> Pixels:
    """At most so many colours that stand for all of some pictures.

    The box of colours that spreads most is halved, again and again (Heckbert 1982). How often
    a colour comes counts by its square root, so that a ball keeps its colour on so much cloth.
    """
    colors = np.concatenate([picture.reshape(-1, 3) for picture in pictures])
    keys, counts = np.unique(_keys(colors), return_counts=True)
    first = np.full(1 << 3 * _BITS, -1, np.int64)
    first[_keys(colors)] = np.arange(len(colors))
    points = colors[first[keys]].astype(np.int64)
    weights = np.sqrt(counts)
    boxes = [np.arange(len(points))]
    spreads = [_spread(points, weights, boxes[0])]
    while len(boxes) < most and max(spreads)[0] > 0.0:
        at = max(range(len(boxes)), key=spreads.__getitem__)
        box, channel = boxes[at], spreads[at][1]
        order = box[np.argsort(points[box, channel], kind="stable")]
        along = np.cumsum(weights[order])
        half = min(max(int(np.searchsorted(along, along[-1] / 2)), 1), len(order) - 1)
        boxes[at : at + 1] = [order[:half], order[half:]]
        spreads[at : at + 1] = [_spread(points, weights, order[:half]), _spread(points, weights, order[half:])]
    means = [np.average(points[box], axis=0, weights=weights[box]) for box in boxes]
    return np.asarray(np.rint(means), np.uint8)


def _spread(points: Ints, weights: Any, box: Ints) -> tuple[float, int]:
    """How much the colours of a box differ, weighted, and in which channel most."""
    inside, weight = points[box], weights[box]
    mean = np.average(inside, axis=0, weights=weight)
    spread = (weight[:, None] * (inside - mean) ** 2).sum(axis=0)
    channel = int(np.argmax(spread))
    return float(spread[channel]) if len(box) > 1 else 0.0, channel


class _Finder:
    """Finds the nearest colour of a palette for every pixel, remembering what it found."""

    def __init__(self, palette: Pixels) -> None:
        self.palette = palette.astype(np.int64)
        self.known = np.full(1 << 3 * _BITS, -1, np.int16)

    def __call__(self, picture: Pixels) -> Pixels:
        keys = _keys(picture)
        for part in np.array_split(new := np.unique(keys[self.known[keys] < 0]), len(new) // 4096 + 1):
            half = 1 << (7 - _BITS)
            middle = np.stack([(part >> shift & (1 << _BITS) - 1) * 2 * half + half for shift in (2 * _BITS, _BITS, 0)])
            far = ((middle.T[:, None, :] - self.palette[None, :, :]) ** 2).sum(axis=2)
            self.known[part] = far.argmin(axis=1)
        return self.known[keys].astype(np.uint8)


def _keys(colors: Pixels) -> Ints:
    """Each colour as one number, of the upper bits of its channels."""
    upper = colors.astype(np.int64) >> (8 - _BITS)
    return np.asarray(upper[..., 0] << 2 * _BITS | upper[..., 1] << _BITS | upper[..., 2], np.int64)
