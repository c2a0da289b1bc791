"""The cue seen from above, and its shadow.

How the cue looks along and across is painted once, finer than the screen: its skin. To draw it at any angle, each
pixel near the cue's line takes the skin's colour at its place, which is a matter of some thousand pixels.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import numpy.typing as npt
import pygame

from ..game.aim import Aim
from ..physics.values import Ball
from ..table.table import Table
from .tabletop.cloth import LIGHT
from .tabletop.paint import Array, noise, ramp
from .view import View

# Where along the cue, m from the tip, its parts end: tip, ferrule, shaft, joint, forearm, wrap, sleeve, bumper.
_TIP, _FERRULE, _SHAFT, _JOINT, _FOREARM, _WRAP, _SLEEVE, _LENGTH = 0.011, 0.034, 0.735, 0.757, 1.02, 1.3, 1.437, 1.45
# A jump cue has the same parts, shorter: so long is it, m.
_JUMP_LENGTH = 1.04
# Half the cue's width along its length: (m from the tip, m).
_TAPER = ((0.0, 0.0058), (0.003, 0.0064), (0.3, 0.0066), (_SHAFT, 0.0105), (_SLEEVE, 0.0147), (_LENGTH, 0.0140))
# A skin has so many samples across for each pixel.
_FINE = 4
# Skins are made for so many scales from one to the double of it.
_SCALES = 3
# How steeply the cue rises toward the butt when it is called level, and how far its shadow moves with height.
_RISE, _SLANT = 0.06, 0.75
_CHALK, _IVORY, _MAPLE = (66.0, 128.0, 184.0), (240.0, 234.0, 216.0), (224.0, 188.0, 134.0)
_EBONY, _INLAY, _LINEN, _BLACK = (64.0, 34.0, 26.0), (222.0, 190.0, 128.0), (46.0, 46.0, 50.0), (20.0, 20.0, 22.0)
_STEEL = (196.0, 198.0, 202.0)

Pixels = npt.NDArray[np.uint32]
# Two of a pixel's four bytes, to work on both at once.
_EVEN, _ODD = np.uint32(0x00FF00FF), np.uint32(0xFF00FF00)


@dataclass(frozen=True, slots=True)
class _Skin:
    """The cue's look or its shadow, by place along and across: `fine` samples for each metre across.

    A sample holds a packed pixel, the colour times its cover, and how much of the ground still shows, of 256.
    """

    light: Pixels
    left: Pixels
    fine: float


def draw(
    surface: pygame.Surface, table: Table, ball: Ball, aim: Aim, back: float, view: View, seen: float = 1.0
) -> None:
    """Draw the cue behind a ball, its tip `back` m away from it and where the aim's side and height have it.

    `seen` from 0 to 1 is how solid it is. The surface has to have 32 bits a pixel, as a window has.
    """
    radius = table.body_of(ball)[0]
    angle, raised = math.radians(aim.angle), math.radians(aim.elevation)
    ahead, right = (math.cos(angle), math.sin(angle)), (math.sin(angle), -math.cos(angle))
    length = _JUMP_LENGTH if aim.jump else _LENGTH
    # Seen from above a raised cue is shorter.
    flat = math.cos(raised)
    gap = radius * math.sqrt(1.0 - aim.side * aim.side) + 0.006 + back * flat
    x = ball.x - ahead[0] * gap + right[0] * aim.side * radius
    y = ball.y - ahead[1] * gap + right[1] * aim.side * radius

    def at(along: float, height: float) -> tuple[float, float]:
        fall = _SLANT * height
        return view.to_screen(x - ahead[0] * along - LIGHT[0] * fall, y - ahead[1] * along - LIGHT[1] * fall)

    shifts = surface.get_shifts()[:3]
    low = radius + back * math.sin(raised)
    high = low + length * (_RISE + math.sin(raised))
    scale, part = _scale(view.scale), round(256.0 * seen)
    shadow = _shadow(scale, round(20.0 * high), shifts)
    _lay(surface, shadow, at(0.0, low), at(length * flat, high), view.scale, part)
    # Which side of the cue is toward the light.
    facing = round(-4.0 * (right[0] * LIGHT[0] + right[1] * LIGHT[1]))
    _lay(surface, _wood(scale, facing, shifts), at(0.0, 0.0), at(length * flat, 0.0), view.scale, part)


def _scale(scale: float) -> int:
    """The scale, pixels per m, of the skin to use: one of a few, so that a moving camera finds most of them made."""
    return round(math.pow(2.0, round(_SCALES * math.log2(scale)) / _SCALES))


def _lay(
    surface: pygame.Surface, skin: _Skin, tip: tuple[float, float], butt: tuple[float, float], scale: float, part: int
) -> None:
    """Lay a skin over the surface from tip to butt at so many pixels for each metre, `part` of 256 of it."""
    length = math.dist(tip, butt)
    if length < 1.0:
        return
    fine = skin.fine / scale
    x, y = _near(tip, butt, skin.left.shape[1] / (2.0 * fine), surface.get_size())
    dx, dy = (butt[0] - tip[0]) / length, (butt[1] - tip[1]) / length
    u, v = (x - tip[0]).astype(np.float32), (y - tip[1]).astype(np.float32)
    rows, columns = skin.left.shape
    # The first and the last row are empty: what lies beyond an end takes those.
    along = np.clip((u * dx + v * dy) * ((rows - 2) / length) + 1.0, 0.0, rows - 1.0).astype(np.intp)
    beside = np.clip((v * dx - u * dy) * fine + columns / 2.0, 0.0, columns - 1.0).astype(np.intp)
    sample = along * columns + beside
    pixels = np.asarray(surface.get_view("0")).view(np.uint32)
    place = y * (surface.get_pitch() // 4) + x
    seen = (y >= 0) & (y < surface.get_height()) & (x >= 0) & (x < surface.get_width())
    if not seen.all():
        place, sample = place[seen], sample[seen]
    light, left = skin.light.reshape(-1).take(sample), skin.left.reshape(-1).take(sample)
    if part < 256:
        light = _dimmed(light, np.uint32(part))
        left = np.asarray(256 - (((256 - left) * np.uint32(part)) >> 8), np.uint32)
    pixels[place] = _dimmed(pixels.take(place), left) + light


def _dimmed(pixels: Pixels, part: Pixels | np.uint32) -> Pixels:
    """Packed pixels with each byte multiplied by `part` of 256."""
    even = (((pixels & _EVEN) * part) >> 8) & _EVEN
    odd = (((pixels & _ODD) >> 8) * part) & _ODD
    return np.asarray(even | odd, np.uint32)


def _near(
    tip: tuple[float, float], butt: tuple[float, float], half: float, size: tuple[int, int]
) -> tuple[Array, Array]:
    """The pixels within `half` of the line from tip to butt, and a few more, as arrays of x and of y."""
    steep = abs(butt[0] - tip[0]) < abs(butt[1] - tip[1])
    (ax, ay), (bx, by) = (tip[::-1], butt[::-1]) if steep else (tip, butt)
    slope = (by - ay) / (bx - ax)
    reach = math.ceil(half * math.hypot(1.0, slope)) + 1
    first, last = max(0.0, min(ax, bx) - half), min(size[steep] - 1.0, max(ax, bx) + half)
    step = np.arange(math.floor(first), math.ceil(last) + 1)
    aside = np.arange(-reach, reach + 1)
    middle = np.rint(ay + (step - ax) * slope).astype(np.intp)
    if steep:
        return middle[:, None] + aside[None, :], step[:, None]
    return step[None, :], middle[None, :] + aside[:, None]


@lru_cache(maxsize=10)
def _wood(scale: int, facing: int, shifts: tuple[int, ...]) -> _Skin:
    """The cue itself, lit from `facing` quarters of the way to one side."""
    along, across = _grid(scale, 0.0165)
    half = _half(along)
    side = np.clip(across / half, -1.0, 1.0)
    crown, toward = np.sqrt(1.0 - side * side), facing / 4.0
    light = 0.42 + 0.60 * crown + 0.20 * side * toward
    gleam = 0.34 * np.exp(-(((side - 0.55 * toward) / 0.24) ** 2)) * np.where(along < _TIP, 0.2, 1.0)
    color = [np.minimum(tone * light + 150.0 * gleam, 255.0) for tone in _colors(along, across, side)]
    return _skin(color, np.clip(0.5 + (half - np.abs(across)) * scale, 0.0, 1.0), scale, shifts)


@lru_cache(maxsize=4)
def _shadow(scale: int, high: int, shifts: tuple[int, ...]) -> _Skin:
    """The cue's shadow, with a butt `high` twentieths of a metre above the cloth: softer the higher."""
    soft = 0.006 + 0.014 * min(1.0, high / 20.0)
    along, across = _grid(scale, 0.0165 + soft)
    half = _half(along)
    blur = 0.004 + soft * along / _LENGTH
    fade = ramp((half - np.abs(across)) / blur, -1.0, 1.0) * (0.46 - 0.16 * along / _LENGTH)
    fade = fade * ramp(along, 0.0, 0.006) * ramp(along, _LENGTH, _LENGTH - 2.0 * soft)
    return _skin([np.zeros_like(fade)] * 3, fade, scale, shifts)


def _half(along: Array) -> Array:
    """Half the cue's width at each place, m."""
    return np.interp(along, [at for at, _ in _TAPER], [half for _, half in _TAPER]).astype(np.float32)


def _grid(scale: int, half: float) -> tuple[Array, Array]:
    """Places along the cue, as a column, and across it, as a row, m."""
    along = np.linspace(0.0, _LENGTH, max(2, round(_LENGTH * scale)))
    count = 2 * math.ceil(half * scale * _FINE)
    across = (np.arange(count) + 0.5 - count / 2.0) / (scale * _FINE)
    return along.astype(np.float32)[:, None], across.astype(np.float32)[None, :]


def _skin(color: list[Array], cover: Array, scale: int, shifts: tuple[int, ...]) -> _Skin:
    """A skin of a colour where it covers, with an empty row at either end; `shifts` is how a pixel is packed."""
    left = np.full((cover.shape[0] + 2, cover.shape[1]), 256, np.uint32)
    left[1:-1] = np.rint(256.0 * (1.0 - cover))
    light = np.zeros_like(left)
    for plane, shift in zip(color, shifts, strict=True):
        # No more than the ground leaves room for.
        light[1:-1] |= (plane * (256 - left[1:-1]) / 256.0).astype(np.uint32) << np.uint32(shift)
    return _Skin(light, left, float(_FINE * scale))


def _colors(along: Array, across: Array, side: Array) -> list[Array]:
    """What each place is made of."""
    grain = noise(along * 14.0, across * 420.0) - 0.5
    thread = noise(along * 620.0, across * 620.0)
    parts: list[tuple[Array, tuple[float, float, float], Array | float]] = [
        (along < _TIP, _CHALK, 0.25 * (thread - 0.5)),
        (along < _FERRULE - 0.0015, _IVORY, 0.0),
        (along < _FERRULE, _BLACK, 0.0),
        (along < _SHAFT, _MAPLE, 0.16 * grain),
        (_ring(along, _SHAFT, _JOINT), _STEEL, 0.0),
        (along < _JOINT, _IVORY, 0.0),
        (_ring(along, _FOREARM, _FOREARM + 0.009), _STEEL, 0.0),
        (_ring(along, _WRAP, _WRAP + 0.009), _STEEL, 0.0),
        (along > _SLEEVE, _BLACK, 0.0),
        (_inlaid(along, side), _INLAY, 0.1 * grain),
        ((along > _FOREARM) & (along < _WRAP), _LINEN, 1.1 * (thread - 0.4)),
        (along > 0.0, _EBONY, 0.5 * grain),
    ]
    where = [np.broadcast_to(mask, side.shape) for mask, _, _ in parts]
    tones = [np.broadcast_to(1.0 + tone, side.shape) for _, _, tone in parts]
    shade = np.select(where, tones, 1.0)
    return [_soft(np.select(where, [color[i] for _, color, _ in parts], 0.0) * shade) for i in range(3)]


def _soft(plane: Array) -> Array:
    """The mean over a pixel's width, so that no inlay has a stepped edge."""
    across = sum(np.roll(plane, i, axis=1) for i in range(-(_FINE // 2), _FINE // 2)) / _FINE
    return np.asarray((across + np.roll(across, 1, axis=0)) / 2.0)


def _ring(along: Array, start: float, end: float) -> Array:
    """A thin ring at either end of a collar."""
    return ((along >= start) & (along < start + 0.003)) | ((along > end - 0.003) & (along <= end))


def _inlaid(along: Array, side: Array) -> Array:
    """The points of the forearm, from above and from either side, and diamonds in the sleeve."""
    middle = (along - 0.83) / (_FOREARM - 0.02 - 0.83) * 0.44
    flank = 1.0 - (along - 0.90) / (_FOREARM - 0.02 - 0.90) * 0.30
    points = (along < _FOREARM - 0.02) & ((np.abs(side) < middle) | (np.abs(side) > flank)) & (along > _JOINT)
    diamond = np.abs(along - (_WRAP + _SLEEVE) / 2.0) / 0.026 + np.abs(side) / 0.5 < 1.0
    return np.asarray(points | diamond)
