"""Where a cue ball in hand is put: behind the balls that may be potted, or along the line it must stay behind."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import islice
from typing import Final

from ...game.rules import Ask
from ...game.rules.spotting import KITCHEN, D, may_place
from ...physics.values import Ball, Layout
from ...table.table import Table
from ..pot_lines import pot_lines
from ..stray import Hand

# How far from the ball the cue ball is put, m, and how thick it is then hit, degrees.
_LEADS: Final = (0.3, 0.6)
_CUTS: Final = (0.0, 18.0, -18.0, 40.0, -40.0)
# For how many balls, and how many places along a line.
_BALLS: Final = 3
_ALONG: Final = 9


def places(table: Table, layout: Layout, ask: Ask, on: list[str], hand: Hand) -> Iterator[tuple[float, float]]:
    """Places in the area in which the cue ball is in hand that may suit."""
    found = _along(table, ask) if ask.where in (KITCHEN, D) else _behind(table, layout, layout[ask.ball], on, hand)
    good = [place for place in found if may_place(table, layout, ask.ball, ask.where, *place)]
    yield from good or _anywhere(table, layout, ask)


def _along(table: Table, ask: Ask) -> Iterator[tuple[float, float]]:
    line, head = table.furniture.head_string, table.furniture.spots.get("head")
    if line is None or head is None:
        return
    half = table.furniture.d_radius if ask.where == D else 0.5 * table.knobs.table.width - 2.0 * table.knobs.ball.radius
    # From the middle outward.
    for part in sorted(range(_ALONG), key=lambda part: abs(2 * part + 1 - _ALONG)):
        yield line - 1e-3, head[1] + 0.98 * half * (2.0 * part / (_ALONG - 1) - 1.0)


def _behind(table: Table, layout: Layout, cue: Ball, on: list[str], hand: Hand) -> Iterator[tuple[float, float]]:
    for way in islice(pot_lines(table, layout, cue, on, hand, anywhere=True), _BALLS):
        target, touch = layout[way.ball], table.touch(cue, layout[way.ball])
        ghost = (target.x - touch * math.cos(way.direction), target.y - touch * math.sin(way.direction))
        for cut in _CUTS:
            back = way.direction + math.radians(cut)
            for lead in _LEADS:
                yield ghost[0] - lead * math.cos(back), ghost[1] - lead * math.sin(back)


def _anywhere(table: Table, layout: Layout, ask: Ask) -> Iterator[tuple[float, float]]:
    """Any place with room, from a grid over the bed."""
    size, parts = table.knobs.table, 24
    for i in range(1, parts):
        for j in range(1, parts):
            place = size.length * i / parts, size.width * j / parts
            if may_place(table, layout, ask.ball, ask.where, *place):
                yield place
                return
