"""Every stroke that a player thinks of in a turn."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import islice
from typing import Final

from ...game.actions import Stroke
from ...game.rules.report import Call
from ...physics.values import Layout, Shot
from ..candidate import Candidate
from ..player import Judgement
from ..turn import Turn
from .banks import banks, potting_kicks
from .breaks import breaks
from .calling import called
from .cannons import cannons
from .combinations import combinations_of
from .kicks import kicks
from .pots import pots
from .routed import routed
from .safeties import safeties

# From so many places of a cue ball in hand more than pots is thought of, where none lies open.
_PLACES: Final = 4
# A pot that is likelier than this is not looked past.
_EASY: Final = 0.85


def candidates(turn: Turn) -> Iterator[Candidate]:
    """The strokes at every ball that may be struck, from every place where that may stand."""
    for cue in turn.cues:
        for number, (place, layout) in enumerate(turn.stands(cue)):
            whole = number == 0 or turn.opens or (number < _PLACES and next(turn.lines(layout, cue), None) is None)
            found = _from_here(turn, layout, cue) if whole else _pots(turn, layout, cue)
            yield from (replace(candidate, place=place) for candidate in found)


def _from_here(turn: Turn, layout: Layout, cue: str) -> Iterator[Candidate]:
    """The strokes at a cue ball where it lies."""
    see = _sight(turn)
    if not turn.table.geometry.pockets:
        yield from cannons(turn, layout, cue, int(see.cannons))
    if turn.opens:
        yield from breaks(turn.table, layout, turn.ask, cue, turn.player.taste.pace)
        return
    straight = list(_pots(turn, layout, cue))
    yield from straight
    yield from _by_another(turn, layout, cue, easy=any(one.prior > _EASY for one in straight))
    safe = list(safeties(turn, layout, cue, int(see.safeties)))
    yield from safe
    if "push" in turn.ask.may:
        yield from map(_pushed, safe)
    if not straight:
        yield from kicks(turn, layout, cue, int(see.kicks))


def _pushed(safety: Candidate) -> Candidate:
    """The same stroke as a push out: it need meet nothing, and the other player says who goes on."""
    return replace(safety, kind="push", stroke=replace(safety.stroke, call=Call(push=True)))


def _sight(turn: Turn) -> Judgement:
    """How much a player looks at from one ball: what is beside straight pots is shared out among all it may strike."""
    see, balls = turn.player.judgement, len(turn.cues)
    shares = {name: getattr(see, name) // balls for name in ("kicks", "banks", "combinations")}
    return replace(see, safeties=-(-see.safeties // balls), **shares)


def _by_another(turn: Turn, layout: Layout, cue: str, easy: bool) -> Iterator[Candidate]:
    """The pots that take another ball; and those that take a cushion, where none is easy without."""
    see, on, wanted = _sight(turn), turn.on(cue), turn.wanted(layout)
    yield from routed(turn, layout, cue, combinations_of(turn, layout, cue, on, wanted), int(see.combinations))
    if not easy:
        falls = [ball for ball in on if ball in wanted]
        yield from routed(turn, layout, cue, banks(turn, layout, cue, falls), int(see.banks))
        yield from routed(turn, layout, cue, potting_kicks(turn, layout, cue, falls), int(see.banks) // 2)


def _pots(turn: Turn, layout: Layout, cue: str) -> Iterator[Candidate]:
    """The pots that lie open; where the cue ball was put to suit, the likeliest alone, without english."""
    see = turn.player.judgement
    if turn.ask.where:
        see = replace(see, ways=1, sides=1)
    if not turn.opens:
        lines = islice(turn.lines(layout, cue), int(see.ways))
        yield from pots(turn.table, layout, turn.ask, cue, lines, see)


def anything(turn: Turn) -> Candidate:
    """Where nothing is thought of: a stroke at the nearest ball on."""
    cue = turn.cues[0]
    place, layout = next(turn.stands(cue))
    x, y = layout[cue].x, layout[cue].y
    ball = min((layout[ball] for ball in turn.on(cue)), key=lambda ball: math.dist((ball.x, ball.y), (x, y)))
    shot = Shot(math.degrees(math.atan2(ball.y - y, ball.x - x)), 3.0, ball=cue)
    return Candidate("hope", Stroke(shot, called(turn.ask, ball.id, safety=True)), ball.id, place=place)
