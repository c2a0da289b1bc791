"""Safeties: strokes at a ball on that need pot nothing, chosen by where the cue ball comes to rest.

It is played through on the engine, thick and thin, soft and hard; those are judged that hide the cue ball, or leave it
far from what the other player is on, or on a cushion.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Final

from ...errors import BudgetError
from ...game.actions import Stroke
from ...game.judging import seen
from ...physics.rollout import Rollout
from ...physics.simulate import simulate
from ...physics.values import GONE, Ball, Layout, Shot
from ...table.outline import distance_to_edge, edges
from ..candidate import Candidate
from ..turn import Turn
from .calling import called
from .routed import in_sight
from .strokes import cleared, spot

# So many strokes are played through for each that is told.
_LOOKS: Final = 4
# At how many balls, how thin, as shares of a touch, how fast, m/s, and how far from the middle the tip, in radii.
_BALLS: Final = 4
_THIN: Final = 0.97
_SLOW, _FAST = 0.5, 3.6
_HEIGHT: Final = 0.4
# What it is worth to leave the cue ball on a cushion, and what a table's length from what the other is on, where that
# it is hidden from it counts 1; nearer to a nose than this it is on it, m.
_ON_RAIL: Final = 0.15
_AWAY: Final = 0.5
_NEAR_RAIL: Final = 0.05


def safeties(turn: Turn, layout: Layout, cue: str, count: int) -> Iterator[Candidate]:
    """So many strokes, those that leave least first."""
    played = [
        one for shot, ball in _tried(turn, layout, cue, _LOOKS * count) if (one := _through(turn, layout, shot, ball))
    ]
    if not played:
        return
    theirs = _theirs(turn, *played[0][:2])
    left = [(hidden(turn, rollout.layout(), cue, theirs), shot, ball) for rollout, shot, ball in played]
    for _, shot, ball in sorted(left, key=lambda one: -one[0])[:count]:
        clear = cleared(turn.table, layout, shot)
        if clear is not None:
            yield Candidate("safety", Stroke(clear, called(turn.ask, ball, safety=True)), ball)


def _tried(turn: Turn, layout: Layout, cue: str, looks: int) -> Iterator[tuple[Shot, str]]:
    """Strokes at the nearest balls on, spread evenly over thickness, speed and height of the tip."""
    near = _near(turn, layout, cue)
    # How high the butt has to be takes long to find: it is much the same for all strokes at one ball.
    butts = [_butt(turn, layout, cue, ball) for ball in near]
    for look in range(1, looks + 1):
        part, pace, up, _ = spot(look)
        ball, butt = near[look % len(near)], butts[look % len(near)]
        height = _HEIGHT * (2.0 * up - 1.0) if turn.player.judgement.heights > 1 else 0.0
        way = _toward(turn, layout[cue], ball, _THIN * (2.0 * part - 1.0))
        yield Shot(way, _SLOW * (_FAST / _SLOW) ** pace, 0.0, height, butt, ball=cue), ball.id


def _near(turn: Turn, layout: Layout, cue: str) -> list[Ball]:
    """The balls on that are nearest, those first that are seen."""
    nearest = sorted((layout[ball] for ball in turn.on(cue)), key=lambda ball: _apart(layout[cue], ball))
    return sorted(nearest, key=lambda ball: not in_sight(turn, layout, cue, ball.id))[:_BALLS]


def _butt(turn: Turn, layout: Layout, cue: str, ball: Ball) -> float:
    """How high the butt has to be for a stroke at a ball, degrees."""
    clear = cleared(turn.table, layout, Shot(_toward(turn, layout[cue], ball, 0.0), ball=cue))
    return 0.0 if clear is None else clear.elevation


def _toward(turn: Turn, start: Ball, ball: Ball, part: float) -> float:
    """The direction, degrees, that passes a ball's middle by so many touches."""
    beside = math.asin(max(-1.0, min(1.0, part * turn.table.touch(start, ball) / _apart(start, ball))))
    return math.degrees(math.atan2(ball.y - start.y, ball.x - start.x) + beside)


def _through(turn: Turn, layout: Layout, shot: Shot, ball: str) -> tuple[Rollout, Shot, str] | None:
    """A stroke played through; None where it meets another ball first, or the cue ball is lost."""
    try:
        rollout = simulate(turn.table, layout, shot)
    except BudgetError:
        return None
    first = next((pair for event in rollout.events for pair in event.pairs if shot.ball in pair), ())
    return (rollout, shot, ball) if ball in first and rollout.layout()[shot.ball].phase not in GONE else None


def _theirs(turn: Turn, rollout: Rollout, shot: Shot) -> list[str]:
    """What the other player is on after a stroke that pots nothing, as it is judged after one of them."""
    ask = seen(turn.rules, turn.state, rollout, Stroke(shot)).ruling.ask
    return list(ask.on or turn.rules.on_table(rollout.layout()))


def hidden(turn: Turn, layout: Layout, cue: str, on: list[str]) -> float:
    """How little a cue ball leaves that lies there to who is on those balls."""
    start, table = layout[cue], turn.table
    rail = min(distance_to_edge(start.x, start.y, side) for side in edges(table.geometry.corners))
    away = min((_apart(start, layout[ball]) for ball in on if in_sight(turn, layout, cue, ball)), default=math.inf)
    return _ON_RAIL * (rail < _NEAR_RAIL) + min(1.0, _AWAY * away / table.knobs.table.length)


def _apart(a: Ball, b: Ball) -> float:
    return math.dist((a.x, a.y), (b.x, b.y))
