"""The guide: what the present aim would do, from the real simulation, and how it is drawn."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import pygame

from ..config.settings import GUIDES
from ..physics.event import Event
from ..physics.rollout import Rollout
from ..physics.values import AIRBORNE, GONE, OFF, POCKETED, ROLLING, SLIDING, Ball, EventKind, Phase
from ..table.flights import FEW, Cleared
from ..table.furniture import Look
from ..table.table import Table
from . import pen, text, theme
from .balls import ball_art
from .view import View
from .ways import WITHIN, Line, Way, dashes, joined, ways

# The levels, as the settings name them in this order.
NONE, LINE, GHOST, WHOLE = range(len(GUIDES))
# No more events than these are waited for, but for the whole guide: out of a rack a ball may be long in getting on.
EVENTS = 25
# How many more, where the ball is struck from above: it bounces.
BOUNCES = 15
# How far a path that is drawn may be from where the ball goes, px.
_PIXELS = 0.3
# How far the cue ball's way after the contact is followed, m.
_AFTER = 0.6
# How far a line is lighter than its ball, from the ball's own colour to white.
_LIFT = 0.35
_MOVING: tuple[Phase, ...] = (SLIDING, ROLLING, AIRBORNE)
_MEETINGS: tuple[EventKind, ...] = ("ball_ball", "ball_cushion", "ball_pocket", "ball_off", "cluster")
# The dashes of a way through the air, and between them, px; how large a landing's mark is, and what is written of a
# ball that is cleared, px.
_DASH, _GAP, _MARK, _SMALL = 7.0, 5.0, 3.2, 13


@dataclass(frozen=True, slots=True)
class Guide:
    """The ways of a shot that is aimed, in their parts.

    The cue ball's to its first contact with a ball; `ghost` is the cue ball there; its way on after that, and that of
    the ball it hits, up to what that meets or to where it rests. `cue`, `after` and `object` are the same as lines, m.
    """

    cue_ways: list[Way]
    ghost: Ball | None
    after_ways: list[Way]
    object_ways: list[Way]

    @property
    def cue(self) -> Line:
        return joined(self.cue_ways)

    @property
    def after(self) -> Line:
        return joined(self.after_ways)

    @property
    def object(self) -> Line:
        return joined(self.object_ways)


class Enough:
    """Says of each event of a shot whether with it all has happened that a guide of some level shows."""

    def __init__(self, level: int, cue: str) -> None:
        self._level = level
        self._cue = cue
        self._hit = ""
        # The ways that are still of interest after the contact, by ball, and how far the cue ball has come since.
        self._open: set[str] = set()
        self._place = (0.0, 0.0)
        self._gone = 0.0

    def __call__(self, event: Event) -> bool:
        if self._level == WHOLE:
            return False
        if not self._hit:
            self._hit = hit(event, self._cue)
            self._open = {self._cue, self._hit} if self._level == GHOST else set()
            if self._hit:
                self._place = self._place_of(event)
            return self._hit != "" and not self._open
        if self._hit in event.balls and (_meets(event, self._hit) or event.after[self._hit].phase not in _MOVING):
            self._open.discard(self._hit)
        if self._cue in event.balls:
            # No way is shorter than a straight one.
            before, self._place = self._place, self._place_of(event)
            self._gone += math.dist(before, self._place)
            if self._gone >= _AFTER or event.after[self._cue].phase not in _MOVING:
                self._open.discard(self._cue)
        return not self._open

    def _place_of(self, event: Event) -> tuple[float, float]:
        ball = event.after[self._cue]
        return ball.x, ball.y


@lru_cache(maxsize=4)
def foresee(rollout: Rollout, cue: str, length: float = _AFTER, within: float = WITHIN) -> Guide:
    """The guide of a rollout, its paths good to `within` m; the cue ball is followed for `length` m after contact."""
    contact = next((event for event in rollout.events if hit(event, cue)), None)
    if contact is None:
        return Guide(ways(rollout, cue, within=within), None, [], [])
    ball = hit(contact, cue)
    met = next((event.t for event in rollout.events if event.t > contact.t and _meets(event, ball)), math.inf)
    return Guide(
        ways(rollout, cue, end=contact.t, within=within),
        rollout.ball_at(cue, contact.t),
        ways(rollout, cue, start=contact.t, length=length, within=within),
        ways(rollout, ball, start=contact.t, end=met, within=within),
    )


def hit(event: Event, ball: str) -> str:
    """The ball that `ball` touches first in an event; empty where it touches none."""
    return next((b if a == ball else a for a, b in event.pairs if ball in (a, b)), "")


def _meets(event: Event, ball: str) -> bool:
    return event.kind in _MEETINGS and ball in event.balls


def draw(
    surface: pygame.Surface,
    guide: Guide,
    level: int,
    table: Table,
    view: View,
    over: Sequence[tuple[Ball, Cleared]] = (),
) -> None:
    """Draw as much of the guide as `level` says, from LINE up; `over` are balls that it jumps, in their places."""
    scale = thickness(view)
    drawn = [(theme.GUIDE_CUE, guide.cue_ways, 2.2 * scale)]
    if level == GHOST:
        # Above it, the ways on are among those of the whole shot.
        drawn.append((theme.GUIDE_CUE, guide.after_ways, 1.8 * scale))
        drawn.append((theme.GUIDE_BALL, guide.object_ways, 2.4 * scale))
    draw_ways(surface, drawn, view)
    least = min((cleared.gap for _, cleared in over), default=0.0)
    struck = view.to_screen(*guide.cue[0]) if guide.cue else None
    for ball, cleared in over:
        x, y = view.to_screen(ball.x, ball.y)
        radius = table.body_of(ball)[0] * view.scale
        pen.ring(surface, theme.GUIDE_AIR, (x, y), radius + 2.0 * scale, 1.4 * scale)
        # Of many, as of a rack, the figures would lie upon each other.
        if len(over) > FEW and cleared.gap > least:
            continue
        told, size, off = f"{1000.0 * cleared.gap:.0f} mm", round(_SMALL * scale), radius + 4.0 * scale
        wide, high = text.font(size).size(told)
        # Above the ball, unless the cue ball would lie upon it.
        if struck is not None and abs(struck[0] - x) < radius + wide / 2 and 0.0 < y - struck[1] < off + high + radius:
            text.draw(surface, told, size, theme.GUIDE_AIR, (x, y + off), (0.5, 0.0))
        else:
            text.draw(surface, told, size, theme.GUIDE_AIR, (x, y - off), (0.5, 1.0))
    if guide.ghost is None or level < GHOST:
        return
    radius = table.body_of(guide.ghost)[0] * view.scale
    centre = view.to_screen(guide.ghost.x, guide.ghost.y)
    pen.disc(surface, (*theme.GUIDE_CUE[:3], 56), centre, radius)
    pen.ring(surface, theme.GUIDE_CUE, centre, radius - 0.5, 1.4 * scale)
    if level == GHOST and guide.object_ways:
        pen.disc(surface, theme.GUIDE_BALL, view.to_screen(*guide.object[-1]), 3.0 * scale)


def draw_whole(
    surface: pygame.Surface,
    rollout: Rollout,
    table: Table,
    view: View,
    cue: theme.Color = theme.GUIDE_CUE,
    others: theme.Color | None = None,
    style: theme.Style = theme.PLAIN,
) -> None:
    """Draw every ball's path to its end, and where it rests, leaves the table, or which pocket it falls into.

    The path of the struck ball has the colour `cue`, the others `others`, or without that their ball's own.
    """
    scale = thickness(view)
    struck = next((event.balls[:1] for event in rollout.events if event.kind == "cue_ball"), ())
    moved = [ball for ball in rollout.layout().values() if len(rollout.tracks.get(ball.id, ())) > 1]
    colors = [cue if ball.id in struck else others or _own(ball_art.look_of(table, ball.id), style) for ball in moved]
    found = [ways(rollout, ball.id, within=fineness(view)) for ball in moved]
    draw_ways(surface, [(color, way, 1.8 * scale) for color, way in zip(colors, found, strict=True)], view)
    for color, ball in zip(colors, moved, strict=True):
        centre, radius = view.to_screen(ball.x, ball.y), table.body_of(ball)[0] * view.scale
        if ball.phase == POCKETED:
            pen.ring(surface, color, centre, radius, 2.0 * scale)
        elif ball.phase == OFF:
            _cross(surface, color, centre, 0.7 * radius, 2.0 * scale)
    rests = [ball_art.ghost_of(table, view, ball) for ball in moved if ball.phase not in GONE]
    ball_art.draw_all(surface, rests, style)


def draw_ways(surface: pygame.Surface, drawn: Sequence[tuple[theme.Color, list[Way], float]], view: View) -> None:
    """Draw ways, in a colour and width each: dashed where they are aloft, with a mark at each landing."""
    scale = thickness(view)
    lines = []
    for color, parts, width in drawn:
        for part in parts:
            line = _line(color, part.points, view, width)
            if part.aloft:
                lines += [line._replace(points=dash) for dash in dashes(list(line.points), _DASH * scale, _GAP * scale)]
            else:
                lines.append(line)
    pen.paths(surface, lines)
    for color, parts, width in drawn:
        for part in parts:
            if part.lands:
                pen.ring(surface, color, view.to_screen(*part.points[-1]), _MARK * scale, 0.7 * width)


def _cross(surface: pygame.Surface, color: theme.Color, centre: pen.Point, size: float, width: float) -> None:
    x, y = centre
    for side in (-size, size):
        pen.line(surface, color, (x - size, y - side), (x + size, y + side), width)


def fineness(view: View) -> float:
    """How far a path may be drawn from where the ball goes, m."""
    return _PIXELS / view.scale


def _own(look: Look, style: theme.Style) -> theme.Color:
    """A ball's colour, light enough for a line on the cloth."""
    red, green, blue = (round(part + _LIFT * (255 - part)) for part in style.palette.color(look.color)[:3])
    return red, green, blue


def thickness(view: View) -> float:
    """How much thicker lines are drawn where the table is seen large."""
    return min(max(1.0, view.scale / 400.0), 2.0)


def _line(color: theme.Color, points: Line, view: View, width: float) -> pen.Path:
    return pen.Path(color, [view.to_screen(x, y) for x, y in points], width)
