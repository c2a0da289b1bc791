"""A stroke that makes its ball fly, in words, before it is played: how high, how far, over what and into what."""

from __future__ import annotations

from collections.abc import Sequence

from ...physics.rollout import Rollout
from ...physics.strike import hop
from ...physics.values import Shot
from ...table.flights import FEW, Cleared, jumped
from ...table.table import Table
from .shot_text import ball_name, height_of, millimetres
from .words import Words

# A hop that is lower than this, m, clears nothing: it is told of no stroke.
_TOLD = 0.005


def aimed(words: Words, table: Table, shot: Shot, mass: float, foreseen: Rollout | None) -> str:
    """What is to be said of a shot that makes a ball of `mass` kg hop; nothing of one that hardly does.

    What it jumps and whether it meets a ball in the air is told as far as the shot is `foreseen`.
    """
    if shot.elevation == 0.0:
        return ""
    _, apex, _, way = hop(shot, mass, table.physics)
    over = () if foreseen is None else jumped(foreseen, table, shot.ball)
    if apex < _TOLD and not over:
        return ""
    said = [words.say("flight.hop", height=millimetres(words, apex), length=f"{words.number(way, '.2f')} m")]
    said += _over(words, over, shot.ball)
    return " ".join([*said, *([] if foreseen is None else _met(words, foreseen, shot.ball))])


def _over(words: Words, over: Sequence[Cleared], cue: str) -> list[str]:
    """What is jumped, by how much: of many the one that is cleared by the least."""
    if len(over) > FEW:
        least = min(over, key=lambda one: one.gap)
        name = ball_name(words, least.ball, cue)
        return [words.say("flight.over_many", count=len(over), ball=name, gap=millimetres(words, least.gap))]
    named = [(ball_name(words, one.ball, cue), millimetres(words, one.gap)) for one in over]
    return [words.say("flight.over", ball=name, gap=gap) for name, gap in named]


def _met(words: Words, foreseen: Rollout, cue: str) -> list[str]:
    """How high it meets the first ball, where it does so in the air."""
    event = next((event for event in foreseen.events if any(cue in pair for pair in event.pairs)), None)
    if event is None or event.kind != "ball_ball" or height_of(event) < _TOLD:
        return []
    other = next(ball for ball in event.balls if ball != cue)
    return [words.say("flight.meets", ball=ball_name(words, other, cue), height=millimetres(words, height_of(event)))]
