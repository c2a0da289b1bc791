"""Looking round: in which directions the cue ball comes to a ball on, by cushions where it has to."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Final

from ...game.actions import Stroke
from ...game.rules import Ask
from ...physics.values import Layout, Shot
from ...table.table import Table
from ..candidate import Candidate
from .calling import called
from .strokes import cleared, first_met

SPEEDS: Final = (2.2, 3.5)


def kicks(table: Table, layout: Layout, ask: Ask, cue: str, on: Collection[str], looks: int) -> Iterator[Candidate]:
    """A stroke amid each run of directions in which a ball on is met first, the widest runs first."""
    if looks <= 0:
        return
    wanted = set(on)
    found: list[tuple[int, Candidate]] = []
    for speed in SPEEDS:
        met = [first_met(table, layout, Shot(360.0 * look / looks, speed, ball=cue)) for look in range(looks)]
        for start, length in _runs([ball if ball in wanted else "" for ball in met]):
            ball = met[start % looks]
            angle = 360.0 * (start + 0.5 * (length - 1)) / looks
            shot = cleared(table, layout, Shot(angle, speed, ball=cue))
            if shot is not None:
                found.append((length, Candidate("kick", Stroke(shot, called(ask, ball, safety=True)), ball)))
    yield from (plan for _, plan in sorted(found, key=lambda one: -one[0]))


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
