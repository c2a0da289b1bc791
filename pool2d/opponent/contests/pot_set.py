"""A fixed set of shots: one ball anywhere and the cue ball anywhere, of which each player picks a pot."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import replace
from itertools import islice
from typing import Final

from ...game.rules import Ruling
from ...game.rules.pool.nine_ball import NineBall
from ...physics.values import POCKETED, Ball, Layout
from ...table.table import Table
from ..player import Player
from ..pot_lines import pot_lines
from .ten_racks import attacking
from .visits import potted, visit

SHOTS: Final = 100
_SEED: Final = "one ball and the cue ball"
# Of the bed, a margin in which no ball is put, in radii.
_MARGIN: Final = 1.5


def shots(table: Table, player: Player) -> Iterator[Layout]:
    """Layouts in which a pot lies open, always the same."""
    rng, ball = random.Random(_SEED), NineBall.last
    cue = table.furniture.cue
    while True:
        layout = Layout([Ball(cue, *_anywhere(table, rng)), Ball(ball, *_anywhere(table, rng))])
        apart = table.touch(layout[cue], layout[ball]) * 1.5
        near = (layout[cue].x - layout[ball].x) ** 2 + (layout[cue].y - layout[ball].y) ** 2 < apart**2
        if not near and pot_lines(table, layout, layout[cue], (ball,), player.hand):
            yield layout


def _anywhere(table: Table, rng: random.Random) -> tuple[float, float]:
    size, margin = table.knobs.table, _MARGIN * table.knobs.ball.radius
    return rng.uniform(margin, size.length - margin), rng.uniform(margin, size.width - margin)


def pots_in(table: Table, player: Player, seed: int, first: int, count: int) -> int:
    """How many of so many shots of the set, from the first on, a player pots."""
    rules, eager = NineBall(table), attacking(player)
    layouts = islice(shots(table, player), first, first + count)
    asked = ((number, _asked(rules, layout)) for number, layout in enumerate(layouts, first))
    return sum(_pots(rules, ruling, eager, f"pots {seed} {number}") for number, ruling in asked)


def _pots(rules: NineBall, ruling: Ruling, player: Player, seed: str) -> bool:
    """Whether the first stroke pots the ball, and is no foul."""
    return potted(rules, islice(visit(rules, ruling, player, seed), 1))[1]


def _asked(rules: NineBall, layout: Layout) -> Ruling:
    """The last ball of a rack of nine-ball, as it lies."""
    start = rules.start(0, 0)
    gone = [ball._replace(phase=POCKETED) for ball in start.layout.values() if ball.id not in layout]
    layout = layout.put(*gone)
    return rules.ruled(rules.next(replace(start.state, shots=2), layout, 0), layout)
