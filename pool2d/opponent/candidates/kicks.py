"""Kicks: in which directions the cue ball comes to a ball on, by cushions where it has to.

It is looked for all round; and where no ball on lies open, by its images in the cushions too, which is how narrow ways
are found.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import islice, pairwise
from typing import Final

from ...game.actions import Stroke
from ...physics.values import Layout, Shot
from ..candidate import Candidate
from ..images import Image, Place, images, legs, way
from ..turn import Turn
from .calling import called
from .routed import angle, free, in_sight
from .strokes import cleared, first_met

SPEEDS: Final = (2.2, 3.5)
# In so many directions one kick is told; and by so many cushions a ball is looked for.
_SHARE: Final = 5
_CUSHIONS: Final = 3
# Directions about that to an image, in shares of the width of a ball seen from there, either way.
_ABOUT: Final = 3
_APART: Final = 1.0
# So many balls are looked for in the cushions.
_BALLS: Final = 3


def kicks(turn: Turn, layout: Layout, cue: str, looks: int) -> Iterator[Candidate]:
    """Kicks at balls on, the surest of either way to find them first; `looks` is in how many directions it is tried."""
    yield from islice(_round(turn, layout, cue, looks), looks // _SHARE)
    if not any(in_sight(turn, layout, cue, ball) for ball in turn.on(cue)):
        yield from _by_cushions(turn, layout, cue, looks // (2 * _SHARE))


def _round(turn: Turn, layout: Layout, cue: str, looks: int) -> Iterator[Candidate]:
    """A stroke amid each run of directions in which a ball on is met first, the widest runs first."""
    wanted = set(turn.on(cue))
    found: list[tuple[int, Candidate]] = []
    for speed in SPEEDS if looks > 0 else ():
        met = [first_met(turn.table, layout, Shot(360.0 * look / looks, speed, ball=cue)) for look in range(looks)]
        for start, length in _runs([ball if ball in wanted else "" for ball in met]):
            shot = Shot(360.0 * (start + 0.5 * (length - 1)) / looks, speed, ball=cue)
            found += [(length, plan) for plan in _kick(turn, layout, shot, met[start % looks])]
    yield from (plan for _, plan in sorted(found, key=lambda one: -one[0]))


def _kick(turn: Turn, layout: Layout, shot: Shot, ball: str) -> Iterator[Candidate]:
    """The kick with the butt as high as it has to be, where that meets the ball too."""
    clear = cleared(turn.table, layout, shot)
    if clear is not None and (clear is shot or first_met(turn.table, layout, clear) == ball):
        yield Candidate("kick", Stroke(clear, called(turn.ask, ball, safety=True)), ball)


def _by_cushions(turn: Turn, layout: Layout, cue: str, count: int) -> Iterator[Candidate]:
    """Strokes at the images of the balls on, the shortest ways first."""
    ways = sorted(_ways(turn, layout, cue), key=lambda one: sum(legs(one[1])))
    for ball, corners in ways[:count]:
        speed = SPEEDS[len(corners) > 3]
        clear = cleared(turn.table, layout, Shot(math.degrees(angle(corners[0], corners[1])), speed, ball=cue))
        met = None if clear is None else _amid(turn, layout, clear, ball, sum(legs(corners)))
        if met is not None:
            yield from _kick(turn, layout, met, ball)


def _ways(turn: Turn, layout: Layout, cue: str) -> Iterator[tuple[str, list[Place]]]:
    """The ways by cushions to the balls on that lie open, and the ball that each leads to."""
    near = sorted(turn.on(cue), key=lambda ball: math.dist(layout[cue][1:3], layout[ball][1:3]))[:_BALLS]
    for image in _images(turn, layout, cue):
        for ball in near:
            corners = way(image, (layout[ball].x, layout[ball].y), turn.table.reach(turn.table.body_of(layout[cue])[0]))
            if corners is not None and _open(turn, layout, corners, cue, ball):
                yield ball, corners


def _images(turn: Turn, layout: Layout, cue: str) -> Iterator[Image]:
    reach = turn.table.reach(turn.table.body_of(layout[cue])[0])
    for cushions in range(1, _CUSHIONS + 1):
        yield from images(turn.table, layout[cue].x, layout[cue].y, reach, cushions)


def _open(turn: Turn, layout: Layout, corners: list[Place], *ignored: str) -> bool:
    return all(free(turn.table, layout, *leg, *ignored) for leg in pairwise(corners))


def _amid(turn: Turn, layout: Layout, shot: Shot, ball: str, far: float) -> Shot | None:
    """The stroke amid those about a direction that meet a ball; None where none does."""
    step = math.degrees(_APART * turn.table.knobs.ball.radius / far)
    turned = [replace(shot, angle=shot.angle + step * count) for count in range(-_ABOUT, _ABOUT + 1)]
    met = [one for one in turned if first_met(turn.table, layout, one) == ball]
    return met[len(met) // 2] if met else None


def _runs(met: list[str]) -> Iterator[tuple[int, int]]:
    """Runs of one ball, round the circle: where each begins, and how long it is."""
    size = len(met)
    if len(set(met)) == 1:
        if met[0]:
            yield 0, size
        return
    first = next(i for i in range(size) if met[i] != met[i - 1])
    start = first
    for i in range(first + 1, first + size + 1):
        if met[i % size] != met[start % size]:
            if met[start % size]:
                yield start, i - start
            start = i
