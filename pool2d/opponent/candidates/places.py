"""Where a cue ball in hand is put: behind balls that may be potted, about them, or along the line to stay behind."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import islice, product
from typing import Final

from ...game.rules import Ask
from ...game.rules.spotting import KITCHEN, D, may_place
from ...physics.values import Ball, Layout
from ...table.table import Table
from ..pot_lines import pot_lines
from ..stray import Hand

# How far from the ball the cue ball is put, m, and how thick it is then hit, degrees.
_LEADS: Final = (0.3, 0.6, 0.1)
_CUTS: Final = (0.0, 18.0, -18.0, 40.0, -40.0)
# For how many balls, and how many places along a line.
_BALLS: Final = 3
_ALONG: Final = 9
# How far from a ball, m, and in how many directions, it is put where no pot has to come of it.
_ABOUT: Final = (0.25, 0.5)
_ROUND: Final = 8


def places(table: Table, layout: Layout, ask: Ask, on: list[str], hand: Hand) -> Iterator[tuple[float, float]]:
    """Places in the area in which the cue ball is in hand that may suit."""
    found = _along(table, ask) if ask.where in (KITCHEN, D) else _to_suit(table, layout, layout[ask.ball], on, hand)
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


def _to_suit(table: Table, layout: Layout, cue: Ball, on: list[str], hand: Hand) -> Iterator[tuple[float, float]]:
    yield from _behind(table, layout, cue, on, hand)
    for ball in on[:_BALLS]:
        for far in _ABOUT:
            for turn in range(_ROUND):
                way = math.tau * turn / _ROUND
                yield layout[ball].x + far * math.cos(way), layout[ball].y + far * math.sin(way)


def _behind(table: Table, layout: Layout, cue: Ball, on: list[str], hand: Hand) -> Iterator[tuple[float, float]]:
    ways = list(islice(pot_lines(table, layout, cue, on, hand, anywhere=True), _BALLS))
    for lead, cut, way in product(_LEADS, _CUTS, ways):
        target, touch, back = layout[way.ball], table.touch(cue, layout[way.ball]), way.direction + math.radians(cut)
        x, y = target.x - touch * math.cos(way.direction), target.y - touch * math.sin(way.direction)
        yield x - lead * math.cos(back), y - lead * math.sin(back)


def _anywhere(table: Table, layout: Layout, ask: Ask) -> Iterator[tuple[float, float]]:
    """Any place with room, from a grid over the bed."""
    size, parts = table.knobs.table, 24
    for i in range(1, parts):
        for j in range(1, parts):
            place = size.length * i / parts, size.width * j / parts
            if may_place(table, layout, ask.ball, ask.where, *place):
                yield place
                return
