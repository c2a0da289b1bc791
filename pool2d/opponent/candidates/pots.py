"""Pots: the balls that lie open, struck at several speeds and with several spins."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Final

from ...game.actions import Stroke
from ...game.rules import Ask
from ...physics.values import Layout, Shot
from ...table.table import Table
from ..aiming import aimed_at
from ..candidate import Candidate
from ..player import Judgement
from ..pot_lines import PotLine
from .calling import called
from .strokes import cleared

# Speeds as multiples of what the ball needs to fall, and where on the cue ball the tip may meet it, in radii.
PACES: Final = (1.15, 1.6, 2.3, 3.2)
HEIGHTS: Final = (0.0, -0.45, 0.4)
SIDES: Final = (0.0, 0.3, -0.3)
FASTEST: Final = 7.0
_SOFTEST: Final = 0.35
# No tip is meant to meet the ball further out than this, in radii: beyond 0.51 a chalked one slips.
OUTERMOST: Final = 0.46
# How far a pot is varied about one that is good already: the tip in radii, the speed as multiples.
_NUDGE: Final = 0.15
_PACES_BESIDE: Final = (0.85, 0.92, 1.08, 1.17)
# How far a ball would run on beyond its pocket's mouth, m.
_BEYOND: Final = 0.15


def needed(table: Table, line: PotLine, height: float, side: float) -> float:
    """The cue's speed, m/s, at which a ball just reaches its pocket, and a little more, with the tip at (side, height).

    A ball that is hit full slides, and rolls on at 5/7 of its speed. The cue ball slides too until it rolls, then at
    5/7 (1 + height) of the speed it was given (v = 5/7 v + 2/7 R w, with R w = 5/2 height v).
    """
    cloth, gravity = table.knobs.cloth, table.knobs.gravity
    ball = 1.4 * math.sqrt(2.0 * cloth.mu_roll * gravity * (line.run + _BEYOND))
    met = ball / (0.95 * max(math.cos(line.cut), 0.2))
    slid = math.sqrt(met * met + 2.0 * cloth.mu_slide * gravity * line.lead)
    rolled = math.sqrt(met * met + 2.0 * cloth.mu_roll * gravity * line.lead) * 1.4 / (1.0 + height)
    return max(_SOFTEST, min(slid, rolled) / given(table, math.hypot(side, height)))


def given(table: Table, offset: float) -> float:
    """A ball's speed over the cue's that struck it so many radii off its centre (`strike.hop` has the same)."""
    cue, mass = table.knobs.cue, table.knobs.ball.mass
    return (1.0 + cue.tip_restitution) / (mass / cue.mass + 1.0 + 2.5 * offset * offset)


def stroked(
    table: Table, layout: Layout, cue: str, line: PotLine, height: float, side: float, paces: Sequence[float]
) -> Iterator[Shot]:
    """The shots that pot a ball in that line at several paces, refined; none where the cue cannot get at it."""
    speed = needed(table, line, height, side)
    shot = Shot(math.degrees(_toward(table, layout, cue, line)), 1.0, side, height, ball=cue)
    yield from _at_speeds(table, layout, shot, line, [min(FASTEST, pace * speed) for pace in paces])


def _toward(table: Table, layout: Layout, cue: str, line: PotLine) -> float:
    """The direction in which the cue ball meets its ball where it has to, radians."""
    target, touch = layout[line.ball], table.touch(layout[cue], layout[line.ball])
    x, y = target.x - touch * math.cos(line.direction), target.y - touch * math.sin(line.direction)
    return math.atan2(y - layout[cue].y, x - layout[cue].x)


def _at_speeds(table: Table, layout: Layout, shot: Shot, line: PotLine, speeds: Iterable[float]) -> Iterator[Shot]:
    """A shot at several speeds, each refined, from where the one before came to."""
    clear = cleared(table, layout, shot)
    for speed in speeds if clear is not None else ():
        refined = aimed_at(table, layout, replace(clear or shot, speed=speed), line.ball, line.direction, line.lead)
        if refined is not None:
            clear = refined
            yield refined


def _sound(height: float, side: float) -> tuple[float, float]:
    """That tip, or in the same direction as far out as it does not slip."""
    share = min(1.0, OUTERMOST / max(math.hypot(height, side), OUTERMOST))
    return share * height, share * side


def spins(heights: int, sides: int) -> list[tuple[float, float]]:
    """The (height, side) that a player knows of, the plain ones first."""
    found = [_sound(height, side) for side in SIDES[:sides] for height in HEIGHTS[:heights]]
    return sorted(found, key=lambda one: (one[1] != 0.0, one[0] != 0.0))


def pots(
    table: Table, layout: Layout, ask: Ask, cue: str, lines: Iterable[PotLine], see: Judgement
) -> Iterator[Candidate]:
    """A candidate for each line, each spin and each pace that a player knows of."""
    paces = PACES[: int(see.paces)]
    for line in lines:
        call = called(ask, line.ball, line.pocket)
        for height, side in spins(int(see.heights), int(see.sides)):
            for shot in stroked(table, layout, cue, line, height, side, paces):
                yield Candidate("pot", Stroke(shot, call), line.ball, line.pocket, prior=line.chance, line=line)


def varied(table: Table, layout: Layout, candidate: Candidate) -> Iterator[Candidate]:
    """The same pot a little softer and harder, lower and higher, and with a little more english to either side."""
    shot, line = candidate.stroke.shot, candidate.line
    if line is None:
        return
    for height, side in ((0.0, 0.0), (_NUDGE, 0.0), (-_NUDGE, 0.0), (0.0, _NUDGE), (0.0, -_NUDGE)):
        tip = replace(shot, height=shot.height + height, side=shot.side + side)
        if math.hypot(tip.height, tip.side) <= OUTERMOST:
            paces = _PACES_BESIDE if height == side == 0.0 else (1.0,)
            for near in _at_speeds(table, layout, tip, line, [pace * shot.speed for pace in paces]):
                yield replace(candidate, stroke=replace(candidate.stroke, shot=near))
