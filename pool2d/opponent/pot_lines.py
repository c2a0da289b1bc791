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
    others = [ball for ball in layout.on_table() if ball.id != cue.id]
    places = np.array([(layout[name].x, layout[name].y) for name in names])
    stand = np.array([(ball.x, ball.y) for ball in others])
    own = np.array([[ball.id == name for ball in others] for name in names])
    touch = table.touch(cue, layout[names[0]])
    radius = table.body_of(layout[names[0]])[0]
    direction, half = windows(seen, places, table.reach(radius))
    along = np.stack((np.cos(direction), np.sin(direction)), axis=-1)
    goal = np.broadcast_to(seen.middles[None], along.shape)
    start = np.broadcast_to(places[:, None, :], along.shape)
    run = np.hypot(*np.moveaxis(goal - start, -1, 0))
    ghost = start - touch * along
    if anywhere:
        free = _clear(start, goal, stand, own, touch) & (half > 0.0)
        lead, cut = np.full(run.shape, 0.35), np.full(run.shape, math.radians(12.0))
    else:
        here = np.broadcast_to(np.array((cue.x, cue.y)), along.shape)
        to_ghost = ghost - here
        lead = np.hypot(to_ghost[..., 0], to_ghost[..., 1])
        cosine = (to_ghost * along).sum(axis=-1) / np.maximum(lead, 1e-9)
        cut = np.arccos(np.clip(cosine, -1.0, 1.0))
        both = _clear(np.stack((start, here)), np.stack((goal, ghost)), stand, own, touch)
        free = both.all(axis=0) & (half > 0.0) & (cut < math.radians(THINNEST))
    spread = strays(hand, radius, lead, cut)
    found = []
    for i, j in zip(*np.nonzero(free), strict=True):
        chance = within(half[i, j], spread[i, j])
        way, thick, far, on = (float(value[i, j]) for value in (direction, cut, lead, run))
        found.append(PotLine(names[i], seen.names[j], way, thick, far, on, chance))
    for line in sorted(found, key=lambda line: -line.chance):
        if _has_room(table, layout[line.ball], line.direction, touch, radius):
            yield line


def _has_room(table: Table, ball: Ball, direction: float, touch: float, radius: float) -> bool:
    """Whether a cue ball has room where it meets a ball that it sends in a direction."""
    x, y = ball.x - touch * math.cos(direction), ball.y - touch * math.sin(direction)
    return table.on_cloth(x, y) and table.element_gap(x, y, radius)[0] > -_PRESSED


def _clear(a: Floats, b: Floats, stand: Floats, own: Truths, touch: float) -> Truths:
    """Whether a ball may go from each `a` to each `b`, (..., N, P, 2), by the balls that stand about, (M, 2).

    `own` (N, M) tells which of those are meant.
    """
    along = b - a
    square = np.maximum((along * along).sum(axis=-1), 1e-18)
    off = stand - a[..., None, :]
    t = np.clip((off * along[..., None, :]).sum(axis=-1) / square[..., None], 0.0, 1.0)
    gap = off - t[..., None] * along[..., None, :]
    near = (gap * gap).sum(axis=-1) < (_PASSES * touch) ** 2
    free: Truths = ~(near & ~own[:, None, :]).any(axis=-1)
    return free
