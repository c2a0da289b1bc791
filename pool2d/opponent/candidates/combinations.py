"""Pots by two balls: a combination, a carom of the cue ball off one into another, and a kiss of a ball off another."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from typing import Final, NamedTuple

from ...game.reasons import StrokeKind
from ...physics.values import Ball, Layout
from ..images import Place
from ..mouths import middle, mouths
from ..pot_chance import spread
from ..pot_lines import PotLine, pot_lines
from ..routes import Route
from ..turn import Turn
from .routed import angle, before, free

# No ball is hit thinner than this, in either of two hits; and balls that are played together are no further apart, m.
_THIN: Final = math.cos(math.radians(65.0))
_FAR: Final = 1.0
# What of a hit's speed is left where another follows, as a share.
_LEFT: Final = 0.85
# A stroke whose first error, widened by the way to the second hit, comes to so much has half the chance, radians.
_HALVED: Final = 0.05


class _Hit(NamedTuple):
    """How a ball gets to a place where it hits another: the angle, radians, how far it is, m, and how full it hits."""

    angle: float
    lead: float
    full: float


class _Scene(NamedTuple):
    """A turn, where the balls lie, the cue ball, the balls that may be hit first and those that are to fall."""

    turn: Turn
    layout: Layout
    cue: Ball
    on: list[Ball]
    wanted: list[str]

    @property
    def touch(self) -> float:
        """How far apart the centres of two balls are that touch, m."""
        return 2.0 * self.turn.table.knobs.ball.radius

    def lines(self) -> list[PotLine]:
        """The ways of the balls that are to fall into their pockets, from wherever they are hit."""
        hand = self.turn.player.hand
        found = pot_lines(self.turn.table, self.layout, self.cue, self.wanted, hand, anywhere=True)
        return [line for line in found if line.pocket in self.turn.goals]

    def hit(self, ball: Ball, goal: Place, place: Place, *ignored: str) -> _Hit | None:
        """How a ball comes to a place from which it sends what lies beyond to a goal; None where it does not."""
        here = (ball.x, ball.y)
        aim = angle(here, place)
        full = math.cos(angle(place, goal) - aim)
        if full < _THIN or not free(self.turn.table, self.layout, here, place, ball.id, *ignored):
            return None
        return _Hit(aim, math.dist(here, place), full)

    def route(self, kind: StrokeKind, line: PotLine, first: _Hit, last: str, share: float) -> Route:
        """The route of a pot of which so much of the cue ball's speed is left, as a share."""
        strays = spread(self.turn.player.hand, 0.5 * self.touch)
        strays *= 1.0 + (first.lead + line.lead) / (max(share, 0.1) * self.touch)
        chance = line.chance / (1.0 + strays / _HALVED)
        cut = math.acos(max(0.0, min(1.0, _LEFT * share)))
        return Route(
            kind,
            line._replace(cut=cut, lead=first.lead, chance=chance),
            first.angle,
            last,
            middle(self.turn.table, line.pocket),
        )


def combinations_of(
    turn: Turn, layout: Layout, cue: str, on: Collection[str], wanted: Collection[str]
) -> Iterator[Route]:  # fmt: skip
    """Combinations, caroms and kisses, the likeliest first: `on` may be hit first, and `wanted` are to fall."""
    scene = _Scene(turn, layout, layout[cue], [layout[ball] for ball in on], [ball for ball in wanted if ball != cue])
    found = [*_kisses(scene)]
    for line in scene.lines():
        found += [*_combined(scene, line), *_caroms(scene, line)]
    yield from sorted(found, key=lambda route: -route.line.chance)


def _combined(scene: _Scene, line: PotLine) -> Iterator[Route]:
    """The cue ball sends one ball on another, and that into a pocket."""
    target = scene.layout[line.ball]
    place = before((target.x, target.y), line.direction, scene.touch)
    for ball in _near(scene.on, target):
        second = scene.hit(ball, (target.x, target.y), place, target.id, scene.cue.id)
        if second is None:
            continue
        ghost = before((ball.x, ball.y), second.angle, scene.touch)
        first = scene.hit(scene.cue, (ball.x, ball.y), ghost, ball.id)
        if first is not None:
            run = line.run + second.lead
            whole = line._replace(run=run, lead=second.lead)
            yield scene.route("combination", whole, first, ball.id, first.full * second.full)


def _caroms(scene: _Scene, line: PotLine) -> Iterator[Route]:
    """The cue ball comes off one ball to another, and sends that into a pocket."""
    target, cue = scene.layout[line.ball], scene.cue
    ghost = before((target.x, target.y), line.direction, scene.touch)
    for ball in _near(scene.on, target):
        for place in _onto((cue.x, cue.y), ball, scene.touch, ghost):
            first = scene.hit(cue, (ball.x, ball.y), place, ball.id)
            second = scene.hit(cue._replace(x=place[0], y=place[1]), (target.x, target.y), ghost, ball.id, target.id)
            if first is not None and second is not None:
                share = math.sqrt(max(0.0, 1.0 - first.full**2)) * second.full
                whole = line._replace(lead=second.lead)
                yield scene.route("carom", whole, first, cue.id, share)


def _kisses(scene: _Scene) -> Iterator[Route]:
    """A ball glances off another into a pocket."""
    mouth = mouths(scene.turn.table)
    for ball in (ball for ball in scene.on if ball.id in scene.wanted):
        others = [other for other in scene.layout.on_table() if other.id != scene.cue.id]
        for other in _near(others, ball):
            for pocket, goal in zip(mouth.names, mouth.middles.tolist(), strict=True):
                if pocket in scene.turn.goals:
                    yield from _kissed(scene, ball, other, pocket, (goal[0], goal[1]))


def _kissed(scene: _Scene, ball: Ball, other: Ball, pocket: str, goal: Place) -> Iterator[Route]:
    for place in _onto((ball.x, ball.y), other, scene.touch, goal):
        second = scene.hit(ball, (other.x, other.y), place, other.id, scene.cue.id)
        if second is None or not free(scene.turn.table, scene.layout, place, goal, ball.id, other.id, scene.cue.id):
            continue
        first = scene.hit(scene.cue, (ball.x, ball.y), before((ball.x, ball.y), second.angle, scene.touch), ball.id)
        if first is not None:
            run, share = second.lead + math.dist(place, goal), first.full * math.sqrt(max(0.0, 1.0 - second.full**2))
            line = PotLine(ball.id, pocket, second.angle, 0.0, second.lead, run, 0.5)
            yield scene.route("carom", line, first, other.id, share)


def _near(balls: Collection[Ball], ball: Ball) -> list[Ball]:
    """Those of the balls that lie near a ball."""
    return [other for other in balls if other.id != ball.id and math.dist((other.x, other.y), (ball.x, ball.y)) < _FAR]


def _onto(here: Place, ball: Ball, touch: float, goal: Place) -> Iterator[Place]:
    """Where a ball that hits another leaves it for a goal, along the tangent: the places from which it goes on."""
    far, toward = math.dist((ball.x, ball.y), goal), angle((ball.x, ball.y), goal)
    if far <= touch:
        return
    for side in (-1.0, 1.0):
        place = before((ball.x, ball.y), toward + side * math.acos(touch / far), -touch)
        if math.cos(angle(place, goal) - angle(here, place)) > 0.0:
            yield place
