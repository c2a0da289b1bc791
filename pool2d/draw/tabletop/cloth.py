"""The cloth under the lamp: the bed with its marks, and the cushions."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from ...table.outline import Corner, Point, edges, turn_at
from ...table.table import Table
from ..theme import rgb
from .offset import CUSHION, grown, outward
from .paint import Array, Layer, Patch, box_of, distance, ramp

# Where the light that is not the lamp's own comes from: the upper left, as balls are lit.
LIGHT = (-0.5, 0.866)
# How far a cushion's shadow reaches over the cloth, m.
_SHADOW = 0.055
# Further than any of a cushion is from its front, m.
_DEEP = 0.06
# An angle beyond which a corner turns outward, radians.
_BEND = math.pi + 1e-6
_CHALK = (222.0, 236.0, 228.0)


@dataclass(frozen=True, slots=True)
class Lamp:
    """A long lamp over the middle of the table: 1 below it, less toward the rails."""

    x: float
    y: float
    length: float
    width: float

    def at(self, patch: Patch, dim: float) -> Array:
        """The light on each pixel, which falls to `dim` far away."""
        u = (patch.x - self.x) / self.length
        v = (patch.y - self.y) / self.width
        return dim + (1.0 - dim) * np.exp(-1.35 * np.abs(u) ** 2.6) * np.exp(-1.25 * v * v)


def lamp(table: Table) -> Lamp:
    """The lamp that belongs over a table."""
    left, bottom, right, top = box_of([(corner.x, corner.y) for corner in table.geometry.corners])
    return Lamp((left + right) / 2.0, (bottom + top) / 2.0, (right - left) / 2.0, (top - bottom) / 2.0)


def layers(table: Table) -> list[Layer]:
    """The bed with its marks. What lies over it comes after: pockets, then cushions."""
    color = rgb(table.furniture.finish.cloth)
    over, outline = lamp(table), table.geometry.outline
    box = box_of(outline, 0.01)

    def bed(patch: Patch) -> None:
        part = patch.cut(box)
        if part is None:
            return
        cover = part.inside(outline)
        light = over.at(part, 0.50) * _weave(part)
        part.paint([light * (1.06 * tone) for tone in color], cover)
        _marks(part, table, cover)

    return [bed]


def _weave(patch: Patch) -> Array:
    """The cloth's threads, finer than a pixel: a faint grain, longer across than along."""
    grain = patch.speckle()
    grain = grain + np.roll(grain, 1, axis=1) + patch.speckle(1) - 1.5
    return 1.0 + 0.022 * grain


def _marks(patch: Patch, table: Table, cover: Array) -> None:
    """The head string as far as there is cloth, the D behind it, and the spots."""
    furniture, line = table.furniture, table.furniture.head_string
    thin = max(0.001, 0.5 / patch.scale)
    if line is not None:
        off = np.abs(patch.x - line)
        patch.paint(_CHALK, patch.cover(off - thin) * cover * 0.16)
        if furniture.d_radius > 0.0:
            off = np.hypot(patch.x - line, patch.y - (table.knobs.table.width / 2.0))
            off = np.abs(off - furniture.d_radius) - thin
            patch.paint(_CHALK, patch.cover(off) * cover * (patch.x < line) * 0.16)
    for x, y in furniture.spots.values():
        near = patch.cut((x - 0.02, y - 0.02, x + 0.02, y + 0.02))
        if near is not None:
            off = np.hypot(near.x - x, near.y - y) - 0.0055
            near.paint(_CHALK, near.cover(off) * 0.34)


@dataclass(frozen=True, slots=True)
class _Cushion:
    """One cushion: its front from end to end, the line that closes it behind, and the way out of the table.

    `bends` are the points where it meets another round an outward turn, with the way from there to its own side.
    """

    front: list[Point]
    back: list[Point]
    corner: Corner
    out: Point
    bends: list[tuple[Point, Point]]


def cushions(table: Table) -> list[Layer]:
    """Every cushion's shadow on the cloth, and then the cushions."""
    color = rgb(table.furniture.finish.cloth)
    over = lamp(table)
    shapes = _shapes(table)

    def shadow(shape: _Cushion, patch: Patch) -> None:
        part = patch.cut(box_of(shape.front, _SHADOW))
        if part is not None:
            # Longer below the rails that stand between the cloth and the light.
            lean = 1.0 + 0.35 * (shape.out[0] * LIGHT[0] + shape.out[1] * LIGHT[1])
            off = distance(shape.front, part, _SHADOW)
            fade = ramp(off, _SHADOW, 0.0)
            for point, way in shape.bends:
                # Two shadows go over into each other and do not add up.
                fade = fade * ramp(part.along(point, way), -0.015, 0.015)
            part.shade(1.0 - 0.62 * fade * np.exp(off * (-1.0 / (0.0125 * lean))))

    def body(shape: _Cushion, patch: Patch) -> None:
        part = patch.cut(box_of([*shape.front, *shape.back], 0.004))
        if part is None:
            return
        depth = distance(shape.front, part, _DEEP)
        light = _profile(part, shape, depth) * over.at(part, 0.62) * (0.985 + 0.03 * part.speckle(3))
        cover = part.inside([*shape.front, *shape.back[1:-1]], 4)
        part.paint([light * tone + np.maximum(light - 1.0, 0.0) * 34.0 for tone in color], cover)

    return [*(partial(shadow, shape) for shape in shapes), *(partial(body, shape) for shape in shapes)]


def _profile(patch: Patch, shape: _Cushion, depth: Array) -> Array:
    """How bright a cushion is: the face below the nose dark, the nose bright, the top level, the back in a crease."""
    ox, oy = shape.out
    behind = patch.along((shape.corner.x, shape.corner.y), shape.out)
    facing = -(ox * LIGHT[0] + oy * LIGHT[1])
    nose = max(0.0017, 0.6 / patch.scale)
    at = 0.0062
    top = 0.80 - 0.16 * ramp(depth, 0.008, CUSHION)
    face = (0.40 + 0.08 * facing) + 0.3 * ramp(depth, 0.0, 0.0055)
    light = np.where(depth < at, face, top)
    light = light + (0.52 + 0.14 * facing) * np.exp(-(((depth - at) / nose) ** 2))
    light = light + (0.26 + 0.06 * facing) * ramp(depth, 0.022, 0.0062) * (depth > at)
    crease = ramp(behind, CUSHION - 0.0055, CUSHION - 0.0005)
    return np.asarray(light * (1.0 - 0.62 * crease), np.float32)


def _shapes(table: Table) -> list[_Cushion]:
    """The cushions, mitred where one meets another without a pocket."""
    corners, cushions = table.geometry.corners, table.geometry.cushions
    backs = grown(corners, CUSHION)
    found = []
    for i, (a, b) in enumerate(edges(corners)):
        j = (i + 1) % len(corners)
        front, out = list(cushions[a.cushion]), outward(a, b)
        way = (-out[1], out[0])
        bends = []
        # The rounding of an outward turn belongs half to either cushion.
        if not a.pocket and turn_at(corners, i) > _BEND:
            front = front[_middle(front, a) :]
            bends.append((front[0], _unit(way, outward(corners[i - 1], a), 1.0)))
        if not b.pocket and turn_at(corners, j) > _BEND:
            after = cushions[b.cushion]
            front += after[1 : _middle(after, b) + 1]
            bends.append((front[-1], _unit(way, outward(b, corners[(j + 1) % len(corners)]), -1.0)))
        front = _cut(front, a, out) if a.pocket else front
        front = _cut(front[::-1], a, out)[::-1] if b.pocket else front
        ends = ([] if b.pocket else [backs[j]]) + ([] if a.pocket else [backs[i]])
        found.append(_Cushion(front, [front[-1], *ends, front[0]], a, out, bends))
    return found


def _middle(front: Sequence[Point], corner: Corner) -> int:
    """Which point of a front lies in the middle of the rounding before a corner."""
    return min(range(len(front)), key=lambda i: math.hypot(front[i][0] - corner.x, front[i][1] - corner.y))


def _unit(way: Point, other: Point, hand: float) -> Point:
    """Across the halving line of an outward turn: along a cushion, and away from the other one's back."""
    x, y = hand * way[0] - other[0], hand * way[1] - other[1]
    size = math.hypot(x, y)
    return (x / size, y / size) if size else (hand * way[0], hand * way[1])


def _cut(front: list[Point], corner: Corner, normal: Point) -> list[Point]:
    """A front that begins with a facing, from where that is as deep behind the nose as the cushion is."""
    depths = [(x - corner.x) * normal[0] + (y - corner.y) * normal[1] for x, y in front]
    first = next(i for i, depth in enumerate(depths) if depth < CUSHION)
    if first == 0:
        return front
    (ax, ay), (bx, by) = front[first - 1 : first + 1]
    part = (CUSHION - depths[first]) / (depths[first - 1] - depths[first])
    return [(bx + part * (ax - bx), by + part * (ay - by)), *front[first:]]
