"""The guide: what the present aim would do, from the real simulation, and how it is drawn."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import pygame

from ..config.settings import GUIDES
from ..physics.event import Event
from ..physics.motion import Motion
from ..physics.rollout import Rollout
from ..physics.values import AIRBORNE, POCKETED, ROLLING, SLIDING, Ball, EventKind, Phase
from ..table.furniture import Look
from ..table.table import Table
from . import pen, theme
from .balls import ball_art
from .view import View

# The levels, as the settings name them in this order.
OFF, LINE, GHOST, WHOLE = range(len(GUIDES))
# No more events than these are waited for, but for the whole guide: out of a rack a ball may be long in getting on.
EVENTS = 25
# How far a path that is drawn may be from where the ball goes, px, and one that is asked for, m: less than is seen.
_PIXELS, _WITHIN = 0.3, 0.0003
# How far the cue ball's way after the contact is followed, m.
_AFTER = 0.6
# How far a line is lighter than its ball, from the ball's own colour to white.
_LIFT = 0.35
_MOVING: tuple[Phase, ...] = (SLIDING, ROLLING, AIRBORNE)
_MEETINGS: tuple[EventKind, ...] = ("ball_ball", "ball_cushion", "ball_pocket", "ball_off", "cluster")

Line = list[tuple[float, float]]


@dataclass(frozen=True, slots=True)
class Guide:
    """The paths of a shot that is aimed, as points in m.

    The cue ball's to its first contact with a ball; `ghost` is the cue ball there; `after` its path on, `object`
    that of the ball it hits, up to what that meets or to where it rests.
    """

    cue: Line
    ghost: Ball | None
    after: Line
    object: Line


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
def foresee(rollout: Rollout, cue: str, length: float = _AFTER, within: float = _WITHIN) -> Guide:
    """The guide of a rollout, its paths good to `within` m; the cue ball is followed for `length` m after contact."""
    contact = next((event for event in rollout.events if hit(event, cue)), None)
    if contact is None:
        return Guide(trace(rollout, cue, within=within), None, [], [])
    ball = hit(contact, cue)
    met = next((event.t for event in rollout.events if event.t > contact.t and _meets(event, ball)), math.inf)
    return Guide(
        trace(rollout, cue, end=contact.t, within=within),
        rollout.ball_at(cue, contact.t),
        trace(rollout, cue, start=contact.t, length=length, within=within),
        trace(rollout, ball, start=contact.t, end=met, within=within),
    )


def hit(event: Event, ball: str) -> str:
    """The ball that `ball` touches first in an event; empty where it touches none."""
    return next((b if a == ball else a for a, b in event.pairs if ball in (a, b)), "")


def _meets(event: Event, ball: str) -> bool:
    return event.kind in _MEETINGS and ball in event.balls


def trace(
    rollout: Rollout,
    ball: str,
    start: float = 0.0,
    end: float = math.inf,
    length: float = math.inf,
    within: float = _WITHIN,
) -> Line:
    """The path of a ball between two times, s, as points, m; cut off after `length` m.

    The straight lines between the points are nowhere farther than `within` m from where the ball goes.
    """
    points: Line = []
    track = rollout.tracks[ball]
    ends = [*(motion.t0 for motion in track[1:]), rollout.duration]
    for motion, last in zip(track, ends, strict=True):
        t0, t1 = max(start, motion.t0), min(end, last)
        if t0 < t1 and not motion.stays():
            steps = _steps(motion, t0, t1, within)
            # It begins where the last has ended.
            first = 1 if points else 0
            points += [motion.place(t0 + (t1 - t0) * step / steps) for step in range(first, steps + 1)]
    return _cut(points, length)


def draw(surface: pygame.Surface, guide: Guide, level: int, table: Table, view: View) -> None:
    """Draw as much of the guide as `level` says, from LINE up."""
    scale = _scale(view)
    lines = [_line(theme.GUIDE_CUE, guide.cue, view, 2.2 * scale)]
    if level == GHOST:
        # Above it, the ways on are among those of the whole shot.
        lines.append(_line(theme.GUIDE_CUE, guide.after, view, 1.8 * scale))
        lines.append(_line(theme.GUIDE_BALL, guide.object, view, 2.4 * scale))
    pen.paths(surface, lines)
    if guide.ghost is None or level < GHOST:
        return
    radius = table.body_of(guide.ghost)[0] * view.scale
    centre = view.to_screen(guide.ghost.x, guide.ghost.y)
    pen.disc(surface, (*theme.GUIDE_CUE[:3], 56), centre, radius)
    pen.ring(surface, theme.GUIDE_CUE, centre, radius - 0.5, 1.4 * scale)
    if level == GHOST and guide.object:
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
    """Draw every ball's path to its end, and where it rests or which pocket it falls into.

    The path of the struck ball has the colour `cue`, the others `others`, or without that their ball's own.
    """
    scale = _scale(view)
    struck = next((event.balls[:1] for event in rollout.events if event.kind == "cue_ball"), ())
    moved = [ball for ball in rollout.layout().values() if len(rollout.tracks.get(ball.id, ())) > 1]
    colors = [cue if ball.id in struck else others or _own(ball_art.look_of(table, ball.id), style) for ball in moved]
    ways = [trace(rollout, ball.id, within=fineness(view)) for ball in moved]
    pen.paths(surface, [_line(color, way, view, 1.8 * scale) for color, way in zip(colors, ways, strict=True)])
    for color, ball in zip(colors, moved, strict=True):
        if ball.phase == POCKETED:
            radius = table.body_of(ball)[0] * view.scale
            pen.ring(surface, color, view.to_screen(ball.x, ball.y), radius, 2.0 * scale)
    rests = [ball_art.ghost_of(table, view, ball) for ball in moved if ball.phase != POCKETED]
    ball_art.draw_all(surface, rests, style)


def fineness(view: View) -> float:
    """How far a path may be drawn from where the ball goes, m."""
    return _PIXELS / view.scale


def _own(look: Look, style: theme.Style) -> theme.Color:
    """A ball's colour, light enough for a line on the cloth."""
    red, green, blue = (round(part + _LIFT * (255 - part)) for part in style.palette.color(look.color)[:3])
    return red, green, blue


def _scale(view: View) -> float:
    """How much thicker lines are drawn where the table is seen large."""
    return min(max(1.0, view.scale / 400.0), 2.0)


def _steps(motion: Motion, start: float, end: float, within: float) -> int:
    """How many chords of equal time keep `within` m of a motion's path, a parabola.

    The chord of a step of s seconds leaves it by h_n (s/2)^2, where h_n is the part of half the acceleration across
    the chord: |h x v| over the speed in the middle of the step. Where the ball turns back, the chord misses the turn by
    what h has along it too.
    """
    hx, hy, time = motion.hx, motion.hy, end - start
    since = 2.0 * (start - motion.t0)
    vx, vy = motion.vx + hx * since, motion.vy + hy * since
    wx, wy = vx + 2.0 * hx * time, vy + 2.0 * hy * time
    across = abs(hx * vy - hy * vx)
    turns = hx * vx + hy * vy < 0.0 < hx * wx + hy * wy
    if not turns and across * time**2 <= 4.0 * within * math.hypot(vx + hx * time, vy + hy * time):
        return 1
    most, slowest = math.hypot(hx, hy), min(math.hypot(vx, vy), math.hypot(wx, wy))
    bend = most if turns or across >= most * slowest else across / slowest
    return max(1, math.ceil(0.5 * time * math.sqrt(bend / within)))


def _cut(points: Line, length: float) -> Line:
    """The first `length` m of a line."""
    for i in range(1, len(points)):
        (ax, ay), (bx, by) = points[i - 1], points[i]
        step = math.hypot(bx - ax, by - ay)
        if step > length:
            part = length / step
            return [*points[:i], (ax + part * (bx - ax), ay + part * (by - ay))]
        length -= step
    return points


def _line(color: theme.Color, points: Line, view: View, width: float) -> pen.Path:
    return pen.Path(color, [view.to_screen(x, y) for x, y in points], width)
