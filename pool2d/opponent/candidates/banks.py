"""Banks, of a ball by one cushion or two into a pocket; and kicks that pot a ball by a cushion."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from itertools import pairwise
from typing import Final

import numpy as np

from ...physics.values import Ball, Layout
from ..images import Image, Place, images, legs, way
from ..mouths import middle, mouths, windows
from ..pot_chance import THINNEST, strays, within
from ..pot_lines import PotLine, pot_lines
from ..routes import Route
from ..turn import Turn
from .routed import angle, before, free

# What a cushion leaves of a ball's speed, as a share: a way behind it counts by its square.
_KEPT: Final = 0.6
# No ball is banked that is cut thinner, nor over a longer way, as a multiple of the table's length.
_THIN: Final = math.cos(math.radians(min(65.0, THINNEST)))
_FAR: Final = 2.0


def banks(turn: Turn, layout: Layout, cue: str, balls: Collection[str], cushions: int = 2) -> Iterator[Route]:
    """The banks that lie open, the likeliest first."""
    seen = [(ball, image) for ball in balls for image in _images(turn, layout, ball, cushions)]
    mouth = mouths(turn.table)
    if not seen or not mouth.names:
        return
    reach = turn.table.reach(turn.table.knobs.ball.radius)
    _, half = windows(mouth, np.array([image.seen for _, image in seen]), reach)
    found = [
        route
        for i, j in zip(*np.nonzero(half > 0.0), strict=True)
        if mouth.names[j] in turn.goals
        and (route := _bank(turn, layout, cue, seen[i], mouth.names[j], float(half[i, j])))
    ]
    yield from sorted(found, key=lambda route: -route.line.chance)


def _images(turn: Turn, layout: Layout, ball: str, cushions: int) -> Iterator[Image]:
    reach = turn.table.reach(turn.table.body_of(layout[ball])[0])
    for count in range(1, cushions + 1):
        yield from images(turn.table, layout[ball].x, layout[ball].y, reach, count)


def _bank(turn: Turn, layout: Layout, cue: str, seen: tuple[str, Image], pocket: str, half: float) -> Route | None:
    """A bank of a ball into a pocket; None where something is in the way, or it is out of reach."""
    (ball, image), table, goal = seen, turn.table, middle(turn.table, pocket)
    reach, touch = table.reach(table.body_of(layout[ball])[0]), table.touch(layout[cue], layout[ball])
    corners = way(image, goal, reach)
    if corners is None or math.dist(image.seen, goal) > _FAR * table.knobs.table.length:
        return None
    here, direction = (layout[cue].x, layout[cue].y), angle(*corners[:2])
    ghost = before(corners[0], direction, touch)
    aim, lead = angle(here, ghost), math.dist(here, ghost)
    full = math.cos(direction - aim)
    if full < _THIN or not _open(turn, layout, cue, ball, [ghost, *corners]):
        return None
    cut = math.acos(min(1.0, full))
    width = float(strays(turn.player.hand, table.knobs.ball.radius, np.array(lead), np.array(cut)))
    chance = within(half, width) * _KEPT ** (len(image.noses) - 1)
    line = PotLine(ball, pocket, direction, cut, lead, _run(corners), chance)
    return Route("bank", line, aim, image.noses[-1].name, goal)


def _open(turn: Turn, layout: Layout, cue: str, ball: str, corners: list[Place]) -> bool:
    """Whether nothing is in the way of the cue ball to where it meets its ball, nor of that by its cushions."""
    places = [(layout[cue].x, layout[cue].y), *corners]
    return all(free(turn.table, layout, *leg, cue, ball) for leg in pairwise(places))


def _run(corners: list[Place]) -> float:
    """How far a ball would have to run straight to need as much speed, m."""
    return sum(leg / _KEPT ** (2 * met) for met, leg in enumerate(legs(corners)))


def potting_kicks(turn: Turn, layout: Layout, cue: str, balls: Collection[str]) -> Iterator[Route]:
    """Pots by a cushion that the cue ball meets first, the likeliest first."""
    found = [
        route
        for image in _images(turn, layout, cue, 1)
        for line in pot_lines(turn.table, layout, _seen(layout[cue], image), balls, turn.player.hand)
        if line.pocket in turn.goals and (route := _kick(turn, layout, cue, image, line))
    ]
    yield from sorted(found, key=lambda route: -route.line.chance)


def _seen(ball: Ball, image: Image) -> Ball:
    return ball._replace(x=image.seen[0], y=image.seen[1])


def _kick(turn: Turn, layout: Layout, cue: str, image: Image, line: PotLine) -> Route | None:
    """The kick at a ball that would be potted straight from the cue ball's image; None where a ball is in its way."""
    target, touch = layout[line.ball], turn.table.touch(layout[cue], layout[line.ball])
    ghost = before((target.x, target.y), line.direction, touch)
    corners = way(image, ghost, turn.table.reach(turn.table.body_of(layout[cue])[0]))
    if corners is None or not free(turn.table, layout, corners[0], corners[1], cue):
        return None
    line = line._replace(lead=_run(corners))
    return Route("kick", line, angle(*corners[:2]), cue, middle(turn.table, line.pocket))
