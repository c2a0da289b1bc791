"""The opening stroke of a rack: full at the nearest ball and thin past it, hard and soft."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Final

from ...game.actions import Stroke
from ...game.rules import Ask
from ...physics.values import Layout, Shot
from ...table.table import Table
from ..candidate import Candidate
from .calling import called
from .strokes import cleared

# How far beside the middle of the nearest ball, in touches, and what share of a player's pace.
_FULL: Final = ((0.0, 1.0), (0.12, 1.0), (-0.12, 1.0), (0.5, 0.8), (-0.5, 0.8), (0.9, 0.35), (-0.9, 0.35))


def breaks(table: Table, layout: Layout, ask: Ask, cue: str, pace: float) -> Iterator[Candidate]:
    """Strokes at the ball on that is nearest, and thin ones at the balls at either end of the rack."""
    start = layout[cue]
    on = [layout[ball] for ball in ask.on] or [ball for ball in layout.on_table() if ball.id != cue]
    nearest = min(on, key=lambda ball: math.dist((start.x, start.y), (ball.x, ball.y)))
    ends = {min(on, key=lambda ball: ball.y).id, max(on, key=lambda ball: ball.y).id} - {nearest.id}
    for target in (nearest, *(layout[ball] for ball in sorted(ends))):
        far = math.dist((start.x, start.y), (target.x, target.y))
        way = math.atan2(target.y - start.y, target.x - start.x)
        for part, share in _FULL if target is nearest else _FULL[-2:]:
            angle = way + math.asin(min(1.0, part * table.touch(start, target) / far))
            shot = cleared(table, layout, Shot(math.degrees(angle), share * pace, ball=cue))
            if shot is not None:
                yield Candidate("break", Stroke(shot, called(ask, target.id, safety=True)), target.id)
