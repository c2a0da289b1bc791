"""The pockets: a stitched leather collar round a hole with some depth."""

from __future__ import annotations

import math
from functools import partial

import numpy as np

from ...physics.detect import Pocket
from ...table.table import Table
from .. import theme
from .cloth import LIGHT
from .paint import Array, Layer, Patch, ramp

# How wide the collar is round the hole, m, how far out its seam runs, and how long a stitch and its gap are.
_WIDE, _SEAM, _STITCH = 0.02, 0.0145, 0.01
_LEATHER = (62.0, 46.0, 38.0)
_THREAD = (190.0, 164.0, 122.0)


def collars(table: Table) -> list[Layer]:
    """The collars on the wood, before the cloth covers what lies in a pocket's throat."""
    return [partial(_collar, pocket) for pocket in table.geometry.pockets]


def holes(table: Table) -> list[Layer]:
    """The holes, over the cloth and below the cushions."""
    return [partial(_hole, pocket) for pocket in table.geometry.pockets]


def _near(patch: Patch, pocket: Pocket, reach: float) -> tuple[Patch, Array, Array] | None:
    """The pixels about a pocket, how far out of its middle each is, and how much it lies toward the light."""
    reach += pocket.radius
    part = patch.cut((pocket.x - reach, pocket.y - reach, pocket.x + reach, pocket.y + reach))
    if part is None:
        return None
    x, y = part.x - pocket.x, part.y - pocket.y
    out = np.hypot(x, y)
    toward = (x * LIGHT[0] + y * LIGHT[1]) / np.maximum(out, 1e-6)
    return part, out, toward


def _collar(pocket: Pocket, patch: Patch) -> None:
    near = _near(patch, pocket, _WIDE + 0.02)
    if near is None:
        return
    part, out, toward = near
    beyond = out - (pocket.radius + _WIDE)
    part.shade(1.0 - 0.6 * ramp(beyond, 0.013, 0.0))
    across = (out - (pocket.radius + _WIDE / 2.0)) / (_WIDE / 2.0)
    # A rolled edge: toward the light outside, away from it inside.
    light = 1.0 - 0.42 * across * across + 0.42 * across * toward
    light = light * (0.88 + 0.24 * part.speckle(5))
    cover = part.cover(beyond)
    part.paint([light * tone for tone in _LEATHER], cover)
    _stitches(part, pocket, out)


def _stitches(patch: Patch, pocket: Pocket, out: Array) -> None:
    """Thread round the collar, each stitch sunk a little into the leather."""
    ring = pocket.radius + _SEAM
    count = round(math.tau * ring / _STITCH)
    turn = np.arctan2(patch.y - pocket.y, patch.x - pocket.x)
    part = turn * (count / math.tau)
    along = np.abs(part - np.round(part)) * _STITCH
    off = np.hypot(np.maximum(along - 0.0026, 0.0), out - ring)
    thick = max(0.0008, 0.42 / patch.scale)
    patch.shade(1.0 - 0.45 * ramp(off, thick + 0.0016, thick))
    patch.paint(_THREAD, patch.cover(off - thick) * 0.72)


def _hole(pocket: Pocket, patch: Patch) -> None:
    """A hole: the cloth rounds off into it, its far wall catches some light, and its middle is black."""
    near = _near(patch, pocket, 0.014)
    if near is None:
        return
    part, out, toward = near
    beyond = out - pocket.radius
    part.shade(1.0 - 0.55 * ramp(beyond, 0.012, 0.0))
    deep = np.clip(out / pocket.radius, 0.0, 1.0)
    wall = ramp(deep, 0.62, 1.0)
    # Light from the upper left falls on the wall at the lower right.
    light = wall * (17.0 - 13.0 * toward) + 12.0 * ramp(deep, 0.93, 0.985)
    hole = [tone + light * tint for tone, tint in zip(theme.HOLE, (1.0, 0.86, 0.76), strict=True)]
    part.paint(hole, part.cover(beyond))
