"""The stroke for a lag: along the table, once off the foot cushion, and back as near to the head cushion as can be."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from ..game.actions import Stroke
from ..game.judging import judged
from ..physics.values import Shot
from .turn import Turn

# The speeds that are tried, m/s: so far apart at first, then nearer and nearer, so often.
_SLOWEST: Final = 0.6
_STEP: Final = 0.1
_TRIED: Final = 40
_NEARER: Final = 6


def lag(turn: Turn) -> Stroke:
    """The stroke that leaves the ball nearest to the head cushion, of those that come back from the foot cushion once.

    Harder strokes end nearer to it until the ball comes off the head cushion again: the first speed of that kind is
    meant.
    """
    speeds = [_SLOWEST + _STEP * step for step in range(_TRIED)]
    best = min(_until_worse(turn, speeds), key=lambda speed: _rest(turn, speed), default=speeds[0])
    step = _STEP
    for _ in range(_NEARER):
        step *= 0.5
        best = min((best - step, best, best + step), key=lambda speed: _rest(turn, speed))
    return _stroke(turn, best)


def _until_worse(turn: Turn, speeds: list[float]) -> Iterator[float]:
    """The speeds with which the ball comes back, up to the first that leaves it farther off than the one before."""
    before = None
    for speed in speeds:
        rest = _rest(turn, speed)
        if before is not None and rest > before:
            return
        if rest < turn.table.knobs.table.length:
            before = rest
            yield speed


def _rest(turn: Turn, speed: float) -> float:
    """How far from the head cushion a stroke of this speed leaves the ball, m; more than a table at a fault."""
    found = judged(turn.rules, turn.state, turn.layout, _stroke(turn, speed))
    faulty = any(note.key == "lag.bad" for note in found.ruling.notes)
    length = turn.table.knobs.table.length
    return 2.0 * length if faulty else found.rollout.layout()[turn.ask.ball].x


def _stroke(turn: Turn, speed: float) -> Stroke:
    return Stroke(Shot(0.0, speed, ball=turn.ask.ball))
