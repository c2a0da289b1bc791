"""Cannons: looking round on the engine for what scores by the balls that the cue ball touches, without pockets."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import islice
from typing import Final

from ...errors import BudgetError
from ...game.actions import Stroke
from ...game.judging import seen
from ...physics.rollout import Rollout
from ...physics.simulate import simulate
from ...physics.values import Layout, Shot
from ..candidate import Candidate
from ..pot_chance import spread
from ..stray import awkward
from ..turn import Turn
from .calling import called
from .strokes import cleared, first_met, spot

# What share of the looks goes at balls; the others go anywhere, by the cushions first.
_AT_BALLS: Final = 0.75
# Speeds, m/s, and how far from the ball's middle the tip may be, in radii.
_SLOW, _FAST = 0.8, 7.0
_SIDE, _HIGH, _LOW = 0.55, 0.4, -0.35
# One in so many looks that scored is gone into, yet at least so many; and so many of those are told.
_SHARE: Final = 25
_LEAST: Final = 8
_TOLD: Final = 10
# How many directions either side are tried of a stroke that scores, and how far they are apart, in strays of the hand.
_BESIDE: Final = 3
_APART: Final = 0.6
_FINEST: Final = 5e-4


def cannons(turn: Turn, layout: Layout, cue: str, looks: int) -> Iterator[Candidate]:
    """Strokes that score, those first that do over the widest range of directions; `looks` is how many are tried."""
    scoring = (shot for shot in _around(turn, layout, cue, looks) if scores(turn, layout, shot))
    tried = [_amid(turn, layout, shot) for shot in islice(scoring, max(_LEAST, looks // _SHARE))]
    found = sorted((plan for plan in tried if plan is not None), key=lambda plan: -plan.prior)
    yield from found[:_TOLD]


def scores(turn: Turn, layout: Layout, shot: Shot) -> bool:
    """Whether a stroke brings points, as the rules have it."""
    try:
        rollout = simulate(turn.table, layout, shot)
    except BudgetError:
        return False
    if len(_met(rollout, shot.ball)) < 2:
        return False
    return seen(turn.rules, turn.state, rollout, Stroke(shot)).ruling.points[turn.me] > 0


def _met(rollout: Rollout, cue: str) -> set[str]:
    """The balls that the cue ball touches."""
    return {ball for event in rollout.events for pair in event.pairs if cue in pair for ball in pair} - {cue}


def _around(turn: Turn, layout: Layout, cue: str, looks: int) -> Iterator[Shot]:
    """Strokes spread evenly over directions, speeds and tips that the player knows."""
    see = turn.player.judgement
    for look in range(1, looks + 1):
        way, pace, right, up = spot(look)
        side = _SIDE * (2.0 * right - 1.0) if see.sides > 1 else 0.0
        height = _LOW + (_HIGH - _LOW) * up if see.heights > 1 else 0.0
        speed = _SLOW + (_FAST - _SLOW) * pace
        yield Shot(_direction(turn, layout, cue, way), speed, side, height, ball=cue)


def _direction(turn: Turn, layout: Layout, cue: str, part: float) -> float:
    """A direction, degrees, by a number from 0 to 1: over the width of each ball in turn, and then all round."""
    part /= _AT_BALLS
    if part >= 1.0:
        return 360.0 * (part - 1.0) * _AT_BALLS / (1.0 - _AT_BALLS)
    balls = [ball for ball in layout.on_table() if ball.id != cue]
    start, target = layout[cue], balls[int(part * len(balls))]
    beside = (2.0 * (part * len(balls) % 1.0) - 1.0) * turn.table.touch(start, target)
    far = math.dist((start.x, start.y), (target.x, target.y))
    return math.degrees(
        math.atan2(target.y - start.y, target.x - start.x) + math.asin(max(-1.0, min(1.0, beside / far)))
    )


def _amid(turn: Turn, layout: Layout, shot: Shot) -> Candidate | None:
    """A stroke turned to the middle of the directions about it that score, as likely as the hand stays among them."""
    clear = cleared(turn.table, layout, shot)
    if clear is None or (clear != shot and not scores(turn, layout, clear)):
        return None
    step = math.degrees(_APART * max(_FINEST, _stray(turn, layout, clear)))
    right, left = (_reach(turn, layout, clear, way * step) for way in (-1.0, 1.0))
    amid = replace(clear, angle=clear.angle + 0.5 * (left - right) * step)
    chance = math.erf(0.5 * (left + right + 1) * _APART / math.sqrt(2.0))
    ball = first_met(turn.table, layout, amid)
    return Candidate("cannon", Stroke(amid, called(turn.ask, ball)), ball, prior=chance)


def _stray(turn: Turn, layout: Layout, shot: Shot) -> float:
    """How much the cue ball's direction strays, radians, in a stroke as awkward as this."""
    hand, radius = turn.player.hand, turn.table.body_of(layout[shot.ball])[0]
    return spread(hand, radius) * awkward(turn.table, layout, shot, hand.strain)


def _reach(turn: Turn, layout: Layout, shot: Shot, step: float) -> int:
    """How many steps a stroke may be turned by and still scores."""
    turned = (replace(shot, angle=shot.angle + step * count) for count in range(1, _BESIDE + 1))
    return next((count for count, each in enumerate(turned) if not scores(turn, layout, each)), _BESIDE)
