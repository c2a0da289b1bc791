"""Strokes along ways that are not straight: at several paces, refined on the engine."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from itertools import islice
from typing import Final

from ...game.actions import Stroke
from ...physics.values import GONE, Layout, Shot
from ...table.table import Table
from ..candidate import Candidate
from ..images import Place
from ..routes import Route, homed
from ..turn import Turn
from .calling import called
from .pots import FASTEST, needed
from .strokes import cleared

# Speeds as multiples of what the way needs at least.
_PACES: Final = (1.25, 1.8)


def routed(turn: Turn, layout: Layout, cue: str, routes: Iterable[Route], count: int) -> Iterator[Candidate]:
    """Strokes along the first so many routes."""
    for route in islice(routes, count):
        call = called(turn.ask, route.line.ball, route.line.pocket)
        for shot in _along(turn.table, layout, cue, route):
            stroke = Stroke(shot, call)
            yield Candidate(route.kind, stroke, route.line.ball, route.line.pocket, prior=route.line.chance)


def _along(table: Table, layout: Layout, cue: str, route: Route) -> Iterator[Shot]:
    shot = cleared(table, layout, Shot(math.degrees(route.angle), 1.0, ball=cue))
    if shot is None:
        return
    least = needed(table, route.line, 0.0, 0.0)
    paced = (_at(shot, min(FASTEST, pace * least)) for pace in _PACES)
    yield from (found for each in paced if (found := homed(table, layout, each, route)) is not None)


def _at(shot: Shot, speed: float) -> Shot:
    return Shot(shot.angle, speed, elevation=shot.elevation, ball=shot.ball)


def free(table: Table, layout: Layout, a: Place, b: Place, *ignored: str) -> bool:
    """Whether a ball may go from one place to another past all balls but those ignored."""
    touch = 2.0 * table.knobs.ball.radius
    return not any(
        _gap(a, b, (ball.x, ball.y)) < touch for ball in layout.on_table() if ball.id not in ignored
    )  # fmt: skip


def in_sight(turn: Turn, layout: Layout, cue: str, ball: str) -> bool:
    """Whether a ball on the table can be hit full, straight from the cue ball."""
    start, target = layout[cue], layout[ball]
    here, there = (start.x, start.y), (target.x, target.y)
    return ball != cue and target.phase not in GONE and free(turn.table, layout, here, there, cue, ball)


def _gap(a: Place, b: Place, place: Place) -> float:
    """How near a place is to the way from `a` to `b`, m."""
    x, y = b[0] - a[0], b[1] - a[1]
    square = max(x * x + y * y, 1e-18)
    part = min(1.0, max(0.0, ((place[0] - a[0]) * x + (place[1] - a[1]) * y) / square))
    return math.dist(place, (a[0] + part * x, a[1] + part * y))


def before(place: Place, direction: float, touch: float) -> Place:
    """Where a ball is when it touches one at a place, and is about to send it in a direction."""
    return place[0] - touch * math.cos(direction), place[1] - touch * math.sin(direction)


def angle(a: Place, b: Place) -> float:
    """The direction from one place to another, radians."""
    return math.atan2(b[1] - a[1], b[0] - a[0])
