"""A light trail behind moving balls: where each has been in the last moments, as the rollout says."""

from __future__ import annotations

import math
from itertools import pairwise

import pygame

from ..physics.rollout import Rollout
from ..physics.values import POCKETED
from ..table import Table
from .pen import Point
from .view import View

# How far back a trail goes, s, and in how many steps it is drawn.
LENGTH = 0.3
_STEPS = 12
# Its colour, and how strong it is at the ball: in the middle, and toward its edges.
_COLOR = (236, 244, 238)
_STRENGTH = (26, 54)


def tail(rollout: Rollout, ball: str, t: float) -> list[tuple[float, float, float]]:
    """Where a ball was in the last LENGTH s before `t`, as (time, x, y) from then to now; every turn is a point.

    Empty for a ball that was at rest, or is off the table.
    """
    track = rollout.tracks.get(ball, ())
    start, end = max(0.0, t - LENGTH), min(max(t, 0.0), rollout.duration)
    if len(track) < 2 or end <= start or rollout.ball_at(ball, end).phase == POCKETED:
        return []
    times = {start + (end - start) * step / _STEPS for step in range(_STEPS + 1)}
    times.update(motion.t0 for motion in track if start < motion.t0 < end)
    balls = [(moment, rollout.ball_at(ball, moment)) for moment in sorted(times)]
    points = [(moment, at.x, at.y) for moment, at in balls]
    return points if any(math.dist(a[1:], b[1:]) > 1e-5 for a, b in pairwise(points)) else []


def draw(surface: pygame.Surface, rollout: Rollout, t: float, table: Table, view: View) -> None:
    """Draw the trail of every ball that moves, or did a moment ago."""
    for ball_id, ball in rollout.start.items():
        points = tail(rollout, ball_id, t)
        if points:
            radius = table.body_of(ball)[0] * view.scale
            _ribbon(surface, [(1.0 - (t - then) / LENGTH, view.to_screen(x, y)) for then, x, y in points], radius)


def _ribbon(surface: pygame.Surface, points: list[tuple[float, Point]], radius: float) -> None:
    """A band through points, each with its freshness from 0 to 1: narrow and faint where it is old."""
    xs, ys = [p[0] for _, p in points], [p[1] for _, p in points]
    box = pygame.Rect(math.floor(min(xs)), math.floor(min(ys)), 0, 0)
    box.width, box.height = math.ceil(max(xs)) - box.left, math.ceil(max(ys)) - box.top
    box = box.inflate(2 * radius + 4, 2 * radius + 4).clip(surface.get_rect())
    if not box:
        return
    layer = pygame.Surface(box.size, pygame.SRCALPHA)
    # Drawn, not blended, on a layer of its own, the pieces do not add up where they meet.
    for strength, part in zip(_STRENGTH, (0.9, 0.55), strict=True):
        for (old, a), (new, b) in pairwise(points):
            color = (*_COLOR, round(strength * (0.5 * (old + new)) ** 1.5))
            _piece(layer, color, (a[0] - box.left, a[1] - box.top), (b[0] - box.left, b[1] - box.top),
                   part * radius * (0.25 + 0.75 * old), part * radius * (0.25 + 0.75 * new))  # fmt: skip
    surface.blit(layer, box)


def _piece(layer: pygame.Surface, color: tuple[int, int, int, int], a: Point, b: Point, wa: float, wb: float) -> None:
    """A band from a to b with a half width at each end."""
    length = math.dist(a, b)
    if length < 1e-3:
        return
    nx, ny = (b[1] - a[1]) / length, (a[0] - b[0]) / length
    corners = [(a[0] + nx * wa, a[1] + ny * wa), (b[0] + nx * wb, b[1] + ny * wb),
               (b[0] - nx * wb, b[1] - ny * wb), (a[0] - nx * wa, a[1] - ny * wa)]  # fmt: skip
    pygame.draw.polygon(layer, color, corners)
    if wb >= 2.0:
        # Rounds the outside of a turn.
        pygame.draw.circle(layer, color, b, wb)
