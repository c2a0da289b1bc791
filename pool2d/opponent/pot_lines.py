"""The ways to pot a ball that lie open, and how likely each comes off: geometry, for many balls at once.

The chance is `pot_chance`'s.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from typing import Final, NamedTuple

import numpy as np
import numpy.typing as npt

from ..physics.values import Ball, Layout
from ..table.table import Table
from .mouths import Floats, mouths, windows
from .pot_chance import THINNEST, strays, within
from .stray import Hand

Truths = npt.NDArray[np.bool_]

# Two balls pass one another that are this share of a touch apart.
_PASSES: Final = 0.999
# Balls no further apart than this, in touches, may be in one another's ways to all pockets.
_NEAR: Final = 2.5
# A cue ball that hits its ball by so much less than it would have to is not kept from it by a cushion, m.
_PRESSED: Final = 1e-3


class PotLine(NamedTuple):
    """A ball that may be potted straight: the pocket, and how.

    `direction` is the ball's, radians; `cut` how thick it is hit, radians; `run` how far it goes and `lead` how far the
    cue ball goes before, m; `chance` of its coming off.
    """

    ball: str
    pocket: str
    direction: float
    cut: float
    lead: float
    run: float
    chance: float


def pot_lines(
    table: Table, layout: Layout, cue: Ball, balls: Collection[str], hand: Hand, anywhere: bool = False
) -> Iterator[PotLine]:
    """The pots of these balls that lie open to a cue ball, the likeliest first.

    With `anywhere` the cue ball may be put wherever it suits: all that counts is the ball's own way to the pocket.
    Whether a cushion keeps the cue ball from its ball is looked at last, as it takes the longest.
    """
    seen = mouths(table)
    names = [ball for ball in balls if ball != cue.id]
    if not names or not seen.names:
        return
    ways = _ways(table, layout, cue, names)
    free, lead, cut = _anywhere(ways) if anywhere else _from(ways, cue)
    spread = strays(hand, ways.radius, lead, cut)
    found = []
    for i, j in zip(*np.nonzero(free), strict=True):
        chance = within(ways.half[i, j], spread[i, j])
        way, thick, far, on = (float(value[i, j]) for value in (ways.direction, cut, lead, ways.run))
        found.append(PotLine(names[i], seen.names[j], way, thick, far, on, chance))
    for line in sorted(found, key=lambda line: -line.chance):
        if _has_room(table, layout[line.ball], line.direction, ways.touch, ways.radius):
            yield line


def shut(table: Table, layout: Layout, balls: Collection[str]) -> set[str]:
    """Of these balls those that cannot be potted from anywhere: others are in their ways, or behind them."""
    cue = layout[table.furniture.cue]
    names = sorted(_crowded(table, layout, cue) & set(balls))
    if not names or not mouths(table).names:
        return set()
    free, _, _ = _anywhere(_ways(table, layout, cue, names))
    return {names[i] for i in np.nonzero(~free.any(axis=-1))[0]}


def _crowded(table: Table, layout: Layout, cue: Ball) -> set[str]:
    """The object balls that have another near them: only of these all ways may be taken."""
    others = [ball for ball in layout.on_table() if ball.id != cue.id]
    if not others:
        return set()
    places = np.array([(ball.x, ball.y) for ball in others])
    apart = places[:, None] - places[None]
    near = (apart * apart).sum(axis=-1) < (_NEAR * table.touch(others[0], cue)) ** 2
    # Each is near itself.
    return {ball.id for ball, count in zip(others, near.sum(axis=-1), strict=True) if count > 1}


class _Ways(NamedTuple):
    """The ways of balls (N) to the pockets (P): `start`, `goal`, `ghost`, where the cue ball meets them, and the unit
    vectors `along` (N, P, 2); `direction`, `half` the window's angle, and `run` (N, P). `stand` (M, 2) is where balls
    are, and `own` (N, M) tells which of those goes.
    """

    start: Floats
    goal: Floats
    ghost: Floats
    along: Floats
    direction: Floats
    half: Floats
    run: Floats
    stand: Floats
    own: Truths
    touch: float
    radius: float


def _ways(table: Table, layout: Layout, cue: Ball, names: list[str]) -> _Ways:
    seen = mouths(table)
    others = [ball for ball in layout.on_table() if ball.id != cue.id]
    places = np.array([(layout[name].x, layout[name].y) for name in names])
    stand = np.array([(ball.x, ball.y) for ball in others])
    own = np.array([[ball.id == name for ball in others] for name in names])
    touch = table.touch(cue, layout[names[0]])
    radius = table.body_of(layout[names[0]])[0]
    direction, half = windows(seen, places, table.reach(radius))
    along = np.stack((np.cos(direction), np.sin(direction)), axis=-1)
    start = np.broadcast_to(places[:, None, :], along.shape)
    goal = np.broadcast_to(seen.middles[None], along.shape)
    run = np.hypot(*np.moveaxis(goal - start, -1, 0))
    return _Ways(start, goal, start - touch * along, along, direction, half, run, stand, own, touch, radius)


def _anywhere(ways: _Ways) -> tuple[Truths, Floats, Floats]:
    """Which ways are free for a cue ball that is put where it suits; and its lead and cut, (N, P), as they are then."""
    free = _clear(np.stack((ways.start, ways.ghost)), np.stack((ways.goal, ways.ghost)), ways)
    lead, cut = np.full(ways.run.shape, 0.35), np.full(ways.run.shape, math.radians(12.0))
    return free.all(axis=0) & (ways.half > 0.0), lead, cut


def _from(ways: _Ways, cue: Ball) -> tuple[Truths, Floats, Floats]:
    """Which ways are free for a cue ball that is where it is; its lead and cut, (N, P)."""
    here = np.broadcast_to(np.array((cue.x, cue.y)), ways.along.shape)
    to_ghost = ways.ghost - here
    lead = np.hypot(to_ghost[..., 0], to_ghost[..., 1])
    cosine = (to_ghost * ways.along).sum(axis=-1) / np.maximum(lead, 1e-9)
    cut: Floats = np.arccos(np.clip(cosine, -1.0, 1.0))
    free = _clear(np.stack((ways.start, here)), np.stack((ways.goal, ways.ghost)), ways)
    return free.all(axis=0) & (ways.half > 0.0) & (cut < math.radians(THINNEST)), lead, cut


def _has_room(table: Table, ball: Ball, direction: float, touch: float, radius: float) -> bool:
    """Whether a cue ball has room where it meets a ball that it sends in a direction."""
    x, y = ball.x - touch * math.cos(direction), ball.y - touch * math.sin(direction)
    return table.on_cloth(x, y) and table.element_gap(x, y, radius)[0] > -_PRESSED


def _clear(a: Floats, b: Floats, ways: _Ways) -> Truths:
    """Whether a ball may go from each `a` to each `b`, (..., N, P, 2), by the balls that stand about."""
    along = b - a
    square = np.maximum((along * along).sum(axis=-1), 1e-18)
    off = ways.stand - a[..., None, :]
    t = np.clip((off * along[..., None, :]).sum(axis=-1) / square[..., None], 0.0, 1.0)
    gap = off - t[..., None] * along[..., None, :]
    near = (gap * gap).sum(axis=-1) < (_PASSES * ways.touch) ** 2
    free: Truths = ~(near & ~ways.own[:, None, :]).any(axis=-1)
    return free
