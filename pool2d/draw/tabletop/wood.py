"""The frame: wooden rails mitred at the corners, diamonds of pearl in them, and their shadow on the floor."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from ...table.outline import Corner, Point, sides
from ...table.table import Table
from .. import theme
from ..theme import rgb
from .cloth import LIGHT, Lamp, lamp
from .offset import CUSHION, EDGE, grown, outward
from .paint import Array, Layer, Patch, box_of, distance, noise, ramp

# The rounding of the frame's corners, m.
_ROUND = 0.07
# How far the frame's shadow reaches over the floor, m, and how far down the picture it falls.
_SHADOW, _FALL = 0.11, 0.018
# What the lamp adds to the floor below the table's middle.
_SPILL = (30.0, 25.0, 21.0)


@dataclass(frozen=True, slots=True)
class _Rail:
    """A straight rail: its inner and outer corners, the way along it and the way out."""

    number: int
    inner: tuple[Point, Point]
    outer: tuple[Point, Point]
    core: tuple[Point, Point]
    way: Point
    out: Point


def layers(table: Table) -> list[Layer]:
    """The floor with the table's shadow, and the rails."""
    corners = [a for a, _ in sides(table.geometry.corners)]
    rails = _rails(corners)
    over = lamp(table)
    color = rgb(table.furniture.finish.wood)
    core = grown(corners, EDGE - _ROUND)
    spread = Lamp(over.x, over.y, 1.25 * over.length, 1.7 * over.width)

    def floor(patch: Patch) -> None:
        spill = spread.at(patch, 0.0)
        ground = [tone + gain * spill for tone, gain in zip(theme.BACKGROUND, _SPILL, strict=True)]
        for plane, tone in zip(patch.rgb, ground, strict=True):
            plane[...] = tone
        part = patch.cut(box_of(core, _ROUND + _SHADOW + _FALL))
        if part is not None:
            lifted = [(x, y - _FALL) for x, y in [*core, core[0]]]
            off = distance(lifted, part, _ROUND + _SHADOW) - _ROUND
            part.shade(ramp(off, -0.02, _SHADOW) * 0.85 + 0.15)

    def rail(one: _Rail, patch: Patch) -> None:
        part = patch.cut(box_of([*one.inner, *one.outer], 0.002))
        if part is not None:
            part.paint(_grain(part, one, color, _light(part, one) * over.at(part, 0.55)), _cover(part, one))

    return [floor, *(partial(rail, one) for one in rails)]


def _rails(corners: Sequence[Corner]) -> list[_Rail]:
    outer, core = grown(corners, EDGE), grown(corners, EDGE - _ROUND)
    found = []
    for i, a in enumerate(corners):
        j = (i + 1) % len(corners)
        b, out = corners[j], outward(a, corners[j])
        inner = ((a.x, a.y), (b.x, b.y))
        found.append(_Rail(i, inner, (outer[i], outer[j]), (core[i], core[j]), (-out[1], out[0]), out))
    return found


def _cover(patch: Patch, rail: _Rail) -> Array:
    """The rail's own part of the frame: between its mitres, within the rounded edge."""
    (ax, ay), (bx, by) = rail.core
    length = math.hypot(bx - ax, by - ay)
    along, behind = patch.along(rail.core[0], rail.way), patch.along(rail.core[0], rail.out)
    beyond = np.maximum(np.maximum(-along, along - length), 0.0)
    cover = patch.cover(np.hypot(beyond, np.maximum(behind, 0.0)) - _ROUND)
    for (ix, iy), (ox, oy), hand in (
        (rail.inner[0], rail.outer[0], 1.0),
        (rail.inner[1], rail.outer[1], -1.0),
    ):
        size = math.hypot(ox - ix, oy - iy)
        mitre = patch.along((ix, iy), (hand * (oy - iy) / size, -hand * (ox - ix) / size))
        cover = cover * patch.cover(mitre)
    return cover


def _light(patch: Patch, rail: _Rail) -> Array:
    """The rail's shape in the light: a crisp arris inside, a soft crown, and an edge that rolls away."""
    behind = patch.along(rail.inner[0], rail.out)
    facing = rail.out[0] * LIGHT[0] + rail.out[1] * LIGHT[1]
    (ax, ay), (bx, by) = rail.core
    along = patch.along(rail.core[0], rail.way)
    beyond = np.maximum(np.maximum(-along, along - math.hypot(bx - ax, by - ay)), 0.0)
    over = np.maximum(behind - (EDGE - _ROUND), 0.0)
    left = _ROUND - np.hypot(beyond, over)
    crown = (behind - ((CUSHION + EDGE) / 2.0)) / ((EDGE - CUSHION) / 2.0)
    light = 1.08 - 0.14 * crown * crown
    light = light - 0.60 * ramp(left, 0.016, 0.0) + 0.22 * facing * ramp(left, 0.022, 0.008)
    bright = np.exp(-(((left - 0.0105) / 0.0028) ** 2))
    light = light + bright * (0.20 + 0.16 * facing)
    arris = np.exp(-(((behind - (CUSHION + 0.0045)) / 0.0018) ** 2))
    light = light + arris * (0.22 - 0.10 * facing)
    return np.asarray(light * (0.25 + 0.75 * ramp(behind, CUSHION, CUSHION + 0.003)))


def _grain(patch: Patch, rail: _Rail, color: Sequence[float], light: Array) -> list[Array]:
    """Wood sawn along the rail: growth rings cut at a slant, fibres and pores, from dark to pale."""
    u = patch.along(rail.inner[0], rail.way) + (3.7 * rail.number + 11.0)
    v = patch.along(rail.inner[0], rail.out) + (1.3 * rail.number + 5.0)
    fine = min(700.0, 0.5 * patch.scale)
    sway = noise(u * 1.7, v * 13.0)
    bow = noise(u * 4.5, v * 60.0)
    rings = 62.0 * v + 5.0 * sway + 1.6 * bow
    rings = rings - np.floor(rings)
    # A ring darkens slowly through summer and ends in autumn.
    late = rings * rings * ramp(rings, 1.0, 0.70)
    streak = noise(u * 2.4 + 40.0, v * (0.45 * fine))
    fibre = noise(u * 9.0, v * fine)
    lustre = noise(u * 4.0 + 70.0, v * 22.0 + sway * 2.0)
    tone = 0.60 - 0.80 * late + 0.42 * (streak - 0.5)
    tone = tone + 0.26 * (fibre - 0.5) + 0.55 * (lustre - 0.45)
    tone = np.clip(tone, 0.0, 1.0)
    dark = [0.34 * color[0], 0.27 * color[1], 0.24 * color[2]]
    pale = [1.58 * color[0] + 14.0, 1.58 * color[1] + 8.0, 1.42 * color[2] + 4.0]
    return [(d + (p - d) * tone) * light for d, p in zip(dark, pale, strict=True)]


def sights(table: Table) -> list[Layer]:
    """The diamonds: as far apart on every side as the preset divides the length, clear of the pockets."""
    furniture = table.furniture
    found: list[Layer] = []
    if not furniture.sights:
        return found
    pitch = table.knobs.table.length / furniture.sights
    for a, b in sides(table.geometry.corners):
        out, length = outward(a, b), math.hypot(b.x - a.x, b.y - a.y)
        parts = max(1, round(length / pitch))
        for i in range(1, parts):
            x = a.x + (b.x - a.x) * i / parts + out[0] * furniture.sight_inset
            y = a.y + (b.y - a.y) * i / parts + out[1] * furniture.sight_inset
            if all(math.hypot(x - pocket.x, y - pocket.y) > pocket.radius + 0.035 for pocket in table.geometry.pockets):
                found.append(partial(_diamond, (x, y), out))
    return found


def _diamond(place: Point, out: Point, patch: Patch) -> None:
    """A diamond of pearl, pointing across the rail: four facets that catch the light each in its way."""
    x, y = place
    part = patch.cut((x - 0.02, y - 0.02, x + 0.02, y + 0.02))
    if part is None:
        return
    short, long = 0.0066, 0.0118
    u, v = part.along(place, (-out[1], out[0])), part.along(place, out)
    beyond = (np.abs(u) / short + np.abs(v) / long - 1.0) * (short * long / math.hypot(short, long))
    part.shade(1.0 - 0.62 * ramp(beyond, 0.0034, 0.0))
    right, up = part.along(place, (1.0, 0.0)), part.along(place, (0.0, 1.0))
    facet = 0.85 + 0.09 * np.sign(up) - 0.06 * np.sign(right)
    sheen = noise(part.x * 210.0, part.y * 210.0) - 0.5
    pearl = [facet * tone + sheen * tint for tone, tint in zip((250.0, 246.0, 234.0), (26.0, 14.0, 34.0), strict=True)]
    part.paint(pearl, part.cover(beyond))
