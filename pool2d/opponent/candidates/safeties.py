"""Safeties: strokes at a ball on, thick and thin, soft and hard, that need pot nothing."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from typing import Final

from ...game.actions import Stroke
from ...game.rules import Ask
from ...physics.values import Layout, Shot
from ...table.table import Table
from ..candidate import Candidate
from .calling import called
from .strokes import cleared

# How far beside the ball's middle the cue ball goes, in touches; and how fast, m/s.
SIDES: Final = (0.0, 0.5, -0.5, 0.85, -0.85, 0.97, -0.97, 0.25, -0.25)
SPEEDS: Final = (1.0, 1.8, 0.6, 2.8)


def safeties(table: Table, layout: Layout, ask: Ask, cue: str, on: Collection[str], count: int) -> Iterator[Candidate]:
    """So many strokes at the balls on, taken in turn."""
    if not on or count <= 0:
        return
    start = layout[cue]
    near = sorted(on, key=lambda ball: math.dist((start.x, start.y), (layout[ball].x, layout[ball].y)))
    made = 0
    for part, speed in ((part, speed) for speed in SPEEDS for part in SIDES):
        for ball in near[:4]:
            other = layout[ball]
            far = math.dist((start.x, start.y), (other.x, other.y))
            way = math.atan2(other.y - start.y, other.x - start.x)
            way += math.asin(min(1.0, part * table.touch(start, other) / far))
            shot = cleared(table, layout, Shot(math.degrees(way), speed, ball=cue))
            if shot is None:
                continue
            yield Candidate("safety", Stroke(shot, called(ask, ball, safety=True)), ball)
            made += 1
            if made >= count:
                return
