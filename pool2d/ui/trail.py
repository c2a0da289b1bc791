"""A light trail behind moving balls: where each has been in the last moments, as the rollout says."""

from __future__ import annotations

import math
from bisect import bisect_right
from itertools import pairwise
from operator import attrgetter

import pygame

from ..physics.rollout import Rollout
from ..physics.values import POCKETED, RESTING, SPINNING
from ..table import Table
from .view import View

# How far back a trail goes, s; in how many steps it is drawn at most, and how long they are at least, m.
LENGTH = 0.3
_STEPS = 12
_STEP = 0.06
# Its colour, how strong it is at the ball, and how wide there, in radii.
_COLOR = (236, 244, 238)
_STRENGTH = 54
_WIDTH = 0.75
# A turn sharper than this (its cosine) is rounded on the outside.
_SHARP = 0.97

_BEGIN = attrgetter("t0")

Trace = list[tuple[float, float, float]]


def tail(rollout: Rollout, ball: str, t: float) -> Trace:
    """Where a ball was in the last LENGTH s before `t`, as (time, x, y) from then to now; every turn is a point.

    Empty for a ball that did not move, or is off the table.
    """
    track = rollout.tracks.get(ball, ())
    start, end = max(0.0, t - LENGTH), min(max(t, 0.0), rollout.duration)
    if len(track) < 2 or end <= start:
        return []
    first, last = bisect_right(track, start, key=_BEGIN), bisect_right(track, end, key=_BEGIN)
    if track[last - 1].phase == POCKETED or (first == last and track[last - 1].phase in (RESTING, SPINNING)):
        return []
    turns = [motion.t0 for motion in track[first:last]]
    then, now = rollout.ball_at(ball, start), rollout.ball_at(ball, end)
    speed = max(math.hypot(then.vx, then.vy), math.hypot(now.vx, now.vy))
    steps = min(max(round(speed * (end - start) / _STEP), 3), _STEPS)
    balls = ((at, rollout.ball_at(ball, at)) for i in range(1, steps) for at in [start + (end - start) * i / steps])
    met = ((at, rollout.ball_at(ball, at)) for at in turns)
    points = sorted((at, there.x, there.y) for at, there in (*balls, *met))
    return [(start, then.x, then.y), *points, (end, now.x, now.y)]


def draw(surface: pygame.Surface, rollout: Rollout, t: float, table: Table, view: View) -> None:
    """Draw the trail of every ball that moves, or did a moment ago."""
    for ball_id, ball in rollout.start.items():
        points = tail(rollout, ball_id, t)
        if points:
            radius = _WIDTH * table.body_of(ball)[0] * view.scale
            _ribbon(surface, [(1.0 - (t - then) / LENGTH, *view.to_screen(x, y)) for then, x, y in points], radius)


def _ribbon(surface: pygame.Surface, points: Trace, radius: float) -> None:
    """A band through points (freshness from 0 to 1, x, y): narrow and faint where it is old."""
    xs, ys = [x for _, x, _ in points], [y for _, _, y in points]
    left, top = math.floor(min(xs) - radius) - 1, math.floor(min(ys) - radius) - 1
    box = pygame.Rect(left, top, math.ceil(max(xs) + radius) + 1 - left, math.ceil(max(ys) + radius) + 1 - top)
    box = box.clip(surface.get_rect())
    if not box:
        return
    # Drawn, not blended, on a layer of its own, the pieces do not add up where they meet.
    layer = pygame.Surface(box.size, pygame.SRCALPHA)
    ux = uy = 0.0
    for (old, ax, ay), (new, bx, by) in pairwise(points):
        length = math.hypot(bx - ax, by - ay)
        if length < 0.5:
            continue
        color = (*_COLOR, round(_STRENGTH * (0.5 * (old + new)) ** 1.5))
        a, b = (ax - box.left, ay - box.top), (bx - box.left, by - box.top)
        start, end = radius * (0.25 + 0.75 * old), radius * (0.25 + 0.75 * new)
        turned = ux * (bx - ax) + uy * (by - ay) < _SHARP * length
        ux, uy = (bx - ax) / length, (by - ay) / length
        if turned and start >= 2.0:
            pygame.draw.circle(layer, color, a, start)
        pygame.draw.polygon(layer, color, [
            (a[0] + uy * start, a[1] - ux * start), (b[0] + uy * end, b[1] - ux * end),
            (b[0] - uy * end, b[1] + ux * end), (a[0] - uy * start, a[1] + ux * start),
        ])  # fmt: skip
    surface.blit(layer, box)
