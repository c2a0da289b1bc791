"""From a table's sizes to the shapes that balls meet: noses, facings, rounded jaws and drops.

An outline (see `outline`) is a polygon of corners, counter-clockwise, with the playing surface on its
left. A corner may hold a pocket, also where the outline goes straight on: a side pocket is a corner of
180 degrees. Where the outline turns outward, as at the inner corner of an L, the nose is rounded.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from ..config.knobs import knob
from ..errors import InputError
from ..physics.detect import Element, Jaw, Pocket, Rail
from .outline import Corner, Point, distance_to_edge, edges, turn_at

# The least room between a pocket's hole and a cushion elsewhere, m: the largest ball's radius.
_ROOM = 0.06
# An outline that bends by no more than this, radians, goes straight on.
_STRAIGHT = 1e-6


@dataclass(frozen=True, slots=True)
class TableKnobs:
    length: float = knob(2.54, 0.5, 30.0, "m", "length of the playing surface, nose to nose")
    width: float = knob(1.27, 0.3, 20.0, "m", "width of the playing surface, nose to nose")
    nose_radius: float = knob(0.03, 0.0, 0.5, "m", "rounding of the nose where the outline turns outward")


@dataclass(frozen=True, slots=True)
class CornerKnobs:
    mouth: float = knob(0.1159, 0.04, 0.3, "m", "width of a corner pocket between the tips of its jaws")
    angle: float = knob(142.0, 95.0, 170.0, "degrees", "angle between nose and facing at a corner pocket")
    shelf: float = knob(0.0413, 0.0, 0.1, "m", "from a corner pocket's mouth to where the slate ends")
    jaw_radius: float = knob(0.01, 0.0, 0.2, "m", "rounding of a corner pocket's jaws")
    drop_radius: float = knob(0.06, 0.02, 0.2, "m", "radius of a corner pocket's hole in the slate")


@dataclass(frozen=True, slots=True)
class SideKnobs:
    mouth: float = knob(0.1286, 0.04, 0.3, "m", "width of a side pocket between the tips of its jaws")
    angle: float = knob(104.0, 90.0, 170.0, "degrees", "angle between nose and facing at a side pocket")
    shelf: float = knob(0.0048, 0.0, 0.06, "m", "from a side pocket's mouth to where the slate ends")
    jaw_radius: float = knob(0.008, 0.0, 0.2, "m", "rounding of a side pocket's jaws")
    drop_radius: float = knob(0.06, 0.02, 0.2, "m", "radius of a side pocket's hole in the slate")


@dataclass(frozen=True, slots=True)
class Geometry:
    """The built table.

    `corners` are the outline's; `elements` what balls meet; `cushions` the cushions' fronts as
    polylines, by name, one from each corner to the next; `outline` goes once round the cloth, through
    the throats of the pockets.
    """

    corners: tuple[Corner, ...]
    elements: tuple[Element, ...]
    cushions: dict[str, tuple[Point, ...]]
    outline: tuple[Point, ...]

    @property
    def pockets(self) -> list[Pocket]:
        return [element for element in self.elements if isinstance(element, Pocket)]


def build(corners: Sequence[Corner], table: TableKnobs, corner: CornerKnobs, side: SideKnobs, source: str) -> Geometry:
    """Noses, facings, jaws and drops along an outline.

    Raises InputError where a pocket's numbers contradict each other, leave no cushion between two
    pockets, or reach another cushion.
    """
    elements: list[Element] = []
    drops: list[Element] = []
    cushions: dict[str, tuple[Point, ...]] = {}
    for i, here in enumerate(corners):
        j = (i + 1) % len(corners)
        after, turn = corners[j], turn_at(corners, i)
        length = math.hypot(after.x - here.x, after.y - here.y)
        dx, dy = (after.x - here.x) / length, (after.y - here.y) / length
        knobs, other = (side if each.kind == "side" else corner for each in (here, after))
        if here.pocket:
            _check(here.kind, turn, knobs, source)
            drops.append(_drop(here, turn, (dx, dy), knobs))
        first = _end(here, turn, (dx, dy), 1.0, knobs, table)
        last = _end(after, turn_at(corners, j), (-dx, -dy), -1.0, other, table)
        if (last.nose[0] - first.nose[0]) * dx + (last.nose[1] - first.nose[1]) * dy <= 0.0:
            raise _no_nose(here, after, table, corner, side, source)
        elements += [*first.elements, Rail(here.cushion, *first.nose, *last.nose), *last.elements]
        cushions[here.cushion] = (*reversed(first.front), *last.front)
    outline = tuple(point for front in cushions.values() for point in front)
    geometry = Geometry(tuple(corners), (*elements, *drops), cushions, outline)
    _check_apart(geometry, source)
    return geometry


def _no_nose(
    here: Corner, after: Corner, table: TableKnobs, corner: CornerKnobs, side: SideKnobs, source: str
) -> InputError:
    """The complaint that nothing is left of a cushion."""
    key, value = "corner.mouth, side.mouth", (corner.mouth, side.mouth)
    if here.pocket and after.pocket:
        return InputError(source, key, value, f"the pockets leave no {here.cushion} cushion between them")
    allowed = f"pocket and rounding leave no {here.cushion} cushion"
    return InputError(source, f"{key}, table.nose_radius", (*value, table.nose_radius), allowed)


@dataclass(frozen=True, slots=True)
class _End:
    """One end of a cushion: where its straight nose ends, its jaw and facing, its front from there on."""

    nose: Point
    elements: list[Element]
    front: list[Point]


def _end(
    corner: Corner, turn: float, away: Point, hand: float, knobs: CornerKnobs | SideKnobs, table: TableKnobs
) -> _End:
    """The end of a cushion at `corner`; `away` points from there along the cushion.

    `hand` is +1 where the cushion leaves the corner, -1 where it arrives. `turn` is the interior angle.
    """
    if not corner.pocket:
        return _bend(corner, turn, away, hand, table.nose_radius)
    name = f"{corner.pocket} jaw"
    ax, ay = away
    # Into the cushion: to the right of the outline's way.
    ix, iy = (ay, -ax) if hand > 0.0 else (-ay, ax)
    tip = knobs.mouth / (2.0 * math.sin(turn / 2.0))
    tx, ty = corner.x + ax * tip, corner.y + ay * tip
    cut = math.radians(knobs.angle)
    fx, fy = ax * math.cos(cut) + ix * math.sin(cut), ay * math.cos(cut) + iy * math.sin(cut)
    # The facing reaches as deep as the drop's centre, beyond where a ball can be.
    length = (knobs.shelf + knobs.drop_radius) / -math.cos(cut + turn / 2.0)
    trim = knobs.jaw_radius / math.tan(cut / 2.0)
    nose = (tx + ax * trim, ty + ay * trim)
    centre = (nose[0] + ix * knobs.jaw_radius, nose[1] + iy * knobs.jaw_radius)
    inner = (tx + fx * trim, ty + fy * trim)
    back = (tx + fx * length, ty + fy * length)
    facing = Rail(name, *back, *inner, True) if hand > 0.0 else Rail(name, *inner, *back, True)
    return _End(nose, [facing, Jaw(name, *centre, knobs.jaw_radius, True)], [*_arc(centre, nose, inner), back])


def _bend(corner: Corner, turn: float, away: Point, hand: float, radius: float) -> _End:
    """The end of a cushion where there is no pocket: the corner itself, or a rounding if it turns outward.

    The rounding touches both noses; it belongs to the cushion that leaves.
    """
    if turn <= math.pi + _STRAIGHT:
        return _End((corner.x, corner.y), [], [(corner.x, corner.y)])
    ax, ay = away
    trim = radius / math.tan(math.pi - turn / 2.0)
    nose = (corner.x + ax * trim, corner.y + ay * trim)
    if hand < 0.0:
        return _End(nose, [], [nose])
    centre = (nose[0] + ay * radius, nose[1] - ax * radius)
    # From here the nose that arrives lies at the interior angle.
    bx, by = ax * math.cos(turn) - ay * math.sin(turn), ay * math.cos(turn) + ax * math.sin(turn)
    other = (corner.x + bx * trim, corner.y + by * trim)
    return _End(nose, [Jaw(corner.cushion, *centre, radius)], _arc(centre, nose, other))


def _check_apart(geometry: Geometry, source: str) -> None:
    """Raises InputError where a pocket reaches another cushion than the two it lies between."""
    corners = geometry.corners
    for pocket in geometry.pockets:
        at = next(i for i, corner in enumerate(corners) if corner.pocket == pocket.name)
        for i, edge in enumerate(edges(corners)):
            if i in (at, (at - 1) % len(corners)):
                continue
            if distance_to_edge(pocket.x, pocket.y, edge) < pocket.radius + _ROOM:
                key, allowed = f"outline, pocket {pocket.name}", f"it reaches the {edge[0].cushion} cushion"
                raise InputError(source, key, (round(pocket.x, 4), round(pocket.y, 4)), allowed)


def _check(kind: str, turn: float, knobs: CornerKnobs | SideKnobs, source: str) -> None:
    """Raises InputError where a pocket's numbers do not make a pocket."""
    lean = math.radians(knobs.angle) + turn / 2.0 - math.pi
    depth = knobs.shelf + knobs.drop_radius
    if not -math.pi / 4.0 < lean < math.pi / 3.0:
        raise InputError(source, f"{kind}.angle", knobs.angle, "the facings do not lead into the pocket")
    slope = math.tan(lean)
    if knobs.mouth / 2.0 <= depth * slope:
        raise InputError(source, f"{kind}.angle", knobs.angle, "the facings meet before the pocket's drop")
    # At its centre the hole is as wide as what the facings leave there.
    least = (knobs.mouth / 2.0 - knobs.shelf * slope) / (1.0 + slope)
    if knobs.drop_radius < least:
        allowed = f"a ball could pass beside the hole; allowed is {least:.4f} m or more"
        raise InputError(source, f"{kind}.drop_radius", knobs.drop_radius, allowed)
    if knobs.jaw_radius / math.tan(math.radians(knobs.angle) / 2.0) >= depth / math.cos(lean):
        raise InputError(source, f"{kind}.jaw_radius", knobs.jaw_radius, "the jaws are rounder than the pocket is deep")


def _drop(corner: Corner, turn: float, towards: Point, knobs: CornerKnobs | SideKnobs) -> Pocket:
    """The hole of a corner's pocket; `towards` points along the cushion that leaves the corner."""
    half = turn / 2.0
    # Half the turn from the cushion lies the pocket's axis, pointing into the table.
    ux = towards[0] * math.cos(half) - towards[1] * math.sin(half)
    uy = towards[0] * math.sin(half) + towards[1] * math.cos(half)
    place = knobs.mouth / (2.0 * math.tan(half)) - knobs.shelf - knobs.drop_radius
    return Pocket(corner.pocket, corner.x + ux * place, corner.y + uy * place, knobs.drop_radius, ux, uy)


def _arc(centre: Point, start: Point, end: Point, steps: int = 6) -> list[Point]:
    """Points on the shorter arc from `start` to `end`, both included."""
    cx, cy = centre
    radius = math.hypot(start[0] - cx, start[1] - cy)
    first = math.atan2(start[1] - cy, start[0] - cx)
    sweep = math.remainder(math.atan2(end[1] - cy, end[0] - cx) - first, math.tau)
    angles = (first + sweep * step / steps for step in range(steps + 1))
    return [(cx + radius * math.cos(angle), cy + radius * math.sin(angle)) for angle in angles]
