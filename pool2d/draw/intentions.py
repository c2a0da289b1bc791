"""What a stroke was meant to do, and what else was looked at, as lines on the table."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import pygame

from ..errors import BudgetError, InputError
from ..game.reasons import Reasons, Thought
from ..game.rules.spotting import put
from ..physics.rollout import Rollout
from ..physics.simulate import simulate
from ..physics.values import Ball, Layout
from ..table.table import Table
from . import guide, pen, text, theme
from .guide import Guide
from .view import View
from .ways import Way, joined, ways

# The colours of what was meant and of the others, which are numbered too.
MEANT, OTHER = theme.GUIDE_BALL, theme.PATH_COMPARED
# The widths of their lines, and the size of a number and its disc, px on a small window.
_BOLD, _THIN, _NUMBER, _DISC = 2.6, 1.6, 11, 7.5


# A colour, the parts of a way, and the width of its line, px.
_Drawn = tuple[theme.Color, list[Way], float]


class Intended(NamedTuple):
    """The ways of a stroke: the guide's, and those of the balls that it means; and where it puts a cue ball in hand."""

    fore: Guide
    balls: list[Way]
    stand: Ball | None


class Intentions(NamedTuple):
    """The ways of the stroke that was `meant`, and of the `others`; None for those that no table allows."""

    meant: Intended | None
    others: tuple[Intended | None, ...]


@lru_cache(maxsize=4)
def intentions(table: Table, start: Layout, why: Reasons) -> Intentions:
    """The ways that a stroke's reasons tell of, from the layout that it was played in.

    Of what was meant they are followed to their ends; of another the cue ball's to its contact, and that of the ball it
    meets on to what that meets, or into its pocket.
    """
    others = (_intended(table, start, other, 0.0) for other in why.others)
    return Intentions(_intended(table, start, why.meant, math.inf), tuple(others))


def _intended(table: Table, start: Layout, thought: Thought, after: float) -> Intended | None:
    """The ways of a stroke, of the cue ball `after` its contact for so many m; None of one that cannot be played."""
    try:
        rollout = _played(table, start, thought)
    except (InputError, BudgetError):
        return None
    fore = guide.foresee(rollout, thought.shot.ball, after)
    whole = (after or thought.pocket) and thought.ball in rollout.tracks
    stand = rollout.start[thought.shot.ball] if thought.place is not None else None
    return Intended(fore, ways(rollout, thought.ball) if whole else fore.object_ways, stand)


def _played(table: Table, start: Layout, thought: Thought) -> Rollout:
    ball = thought.shot.ball
    if thought.place is not None and ball in start:
        start = put(start, ball, thought.place)
    return simulate(table, start, thought.shot)


def draw(surface: pygame.Surface, found: Intentions, table: Table, view: View) -> None:
    """Draw what was meant, with the cue ball where it was to meet the ball, over the others, which are numbered."""
    scale = guide.thickness(view)
    others = [(number, other) for number, other in enumerate(found.others, 1) if other is not None]
    drawn = [line for _, other in others for line in _thin(other, _THIN * scale)]
    if found.meant is not None:
        drawn += _bold(found.meant, _BOLD * scale)
    guide.draw_ways(surface, drawn, view)
    for _, other in others:
        _ring(surface, OTHER, other.stand, table, view)
    if found.meant is not None:
        _ring(surface, theme.GUIDE_CUE, found.meant.fore.ghost, table, view)
    for number, place in numbered(others, view, 2.0 * _DISC * scale):
        _number(surface, str(number), place, scale)


def _bold(meant: Intended, width: float) -> list[_Drawn]:
    fore = meant.fore
    cue: list[_Drawn] = [(theme.GUIDE_CUE, part, width) for part in (fore.cue_ways, fore.after_ways)]
    return [*cue, *((MEANT, part, width) for part in (fore.object_ways, meant.balls))]


def _thin(other: Intended, width: float) -> list[_Drawn]:
    return [(OTHER, part, width) for part in (other.fore.cue_ways, other.balls)]


def _ring(surface: pygame.Surface, color: theme.Color, ball: Ball | None, table: Table, view: View) -> None:
    """Where a ball would lie, if anywhere."""
    if ball is not None:
        pen.ring(surface, color, view.to_screen(ball.x, ball.y), table.body_of(ball)[0] * view.scale - 0.5, 1.4)


def numbered(others: Sequence[tuple[int, Intended]], view: View, apart: float) -> list[tuple[int, pen.Point]]:
    """Where each number stands, px: at the end of its ball's way, or beside those that are there already."""
    found: list[tuple[int, pen.Point]] = []
    for number, other in others:
        if line := joined(other.balls) or other.fore.cue:
            x, y = view.to_screen(*line[-1])
            while any(abs(x - left) < apart and abs(y - top) < apart for _, (left, top) in found):
                x += apart
            found.append((number, (x, y)))
    return found


def _number(surface: pygame.Surface, number: str, place: pen.Point, scale: float) -> None:
    """A number on a dark disc, readable on any cloth."""
    pen.disc(surface, theme.PANEL, place, _DISC * scale)
    pen.ring(surface, OTHER, place, _DISC * scale, 1.4 * scale)
    text.draw(surface, number, round(_NUMBER * scale), theme.TEXT, place, (0.5, 0.5))
