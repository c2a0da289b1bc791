"""A light trail behind moving balls: where each has been in the last moments, as the rollout says."""

from __future__ import annotations

import math
from bisect import bisect_right
from functools import lru_cache
from itertools import pairwise
from operator import attrgetter

import numpy as np
import pygame

from ..physics.rollout import Rollout
from ..physics.values import POCKETED, RESTING, SLIDING, SPINNING
from ..table import Table
from .view import View

# How far back a trail goes, s; a ball that slides may run in a curve, which is followed in steps of so many s.
LENGTH = 0.3
_STEP = 0.1
# A trail is light that is added in soft dabs: their colour where the trail is fresh, how far the light
# spreads (the deviation of a normal distribution) and how far apart they are, in the ball's radii. At twice
# the spread they add up to an even band.
_COLOR = (38, 38, 36)
_SPREAD, _PITCH = 0.42, 0.84
# How many steps there are from fresh to faded, and from which on there is light enough to be seen.
_LEVELS, _SEEN = 24, 4
# So many dabs have one box: of more the box would have room for much else, of fewer there would be many boxes.
_BOX = 4

_BEGIN = attrgetter("t0")

Trace = list[tuple[float, float, float]]
Dab = tuple[pygame.Surface, tuple[float, float]]


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
    points: Trace = []
    at = start
    for motion, until in zip(track[first - 1 : last], [*(after.t0 for after in track[first:last]), end], strict=True):
        steps = math.ceil((until - at) / _STEP) if motion.phase == SLIDING else 1
        times = (at + (until - at) * i / steps for i in range(steps))
        points += [(then, *motion.place(then)) for then in times]
        at = until
    return [*points, (end, *track[last - 1].place(end))]


def draw(surface: pygame.Surface, rollout: Rollout, t: float, table: Table, view: View) -> list[pygame.Rect]:
    """Draw the trail of every ball that moves, or did a moment ago; returns the boxes in which it has drawn."""
    drawn: list[pygame.Rect] = []
    for ball_id, ball in rollout.start.items():
        points = tail(rollout, ball_id, t)
        if points:
            radius = table.body_of(ball)[0] * view.scale
            dabs = _along([(1.0 - (t - then) / LENGTH, *view.to_screen(x, y)) for then, x, y in points], radius)
            boxes = [surface.blit(dab, at, None, pygame.BLEND_RGB_ADD) for dab, at in dabs]
            drawn += [boxes[i].unionall(boxes[i + 1 : i + _BOX]) for i in range(0, len(boxes), _BOX)]
    return drawn


def _along(points: Trace, radius: float) -> list[Dab]:
    """Dabs along points (freshness from 0 to 1, x, y), at even distances back from the last."""
    levels = _dabs(max(1, round(radius)))
    half, pitch = levels[0].get_width() / 2.0, _PITCH * radius
    dabs: list[Dab] = []
    # What lies right below the ball is not seen.
    ahead = 0.5 * radius
    for (new, ax, ay), (old, bx, by) in pairwise(reversed(points)):
        length = math.hypot(bx - ax, by - ay)
        while ahead < length:
            part = ahead / length
            fresh = int((new + part * (old - new)) * (_LEVELS - 1))
            if fresh < _SEEN:
                return dabs
            dabs.append((levels[fresh], (ax + part * (bx - ax) - half, ay + part * (by - ay) - half)))
            ahead += pitch
        ahead -= length
    return dabs


@lru_cache(maxsize=8)
def _dabs(radius: int) -> list[pygame.Surface]:
    """The light of one dab for a ball of `radius` pixels, from faded to fresh."""
    half = math.ceil(2.5 * _SPREAD * radius)
    across = (np.arange(-half, half + 1) / (_SPREAD * radius)) ** 2
    light = np.exp(-0.5 * (across[:, None] + across[None, :])) * _PITCH / (_SPREAD * math.sqrt(math.tau))
    light = np.maximum(light - light[half, 0], 0.0)
    # Rounded up or down by chance, so that a faint trail shows no steps.
    chance = np.random.default_rng(1).random(light.shape) * (light > 0.0)
    dabs = [pygame.Surface(light.shape) for _ in range(_LEVELS)]
    for i, dab in enumerate(dabs):
        fresh = (i / (_LEVELS - 1)) ** 1.5
        lit = fresh * light[:, :, None] * _COLOR + chance[:, :, None]
        pygame.surfarray.blit_array(dab, lit.astype(np.uint8))
    return dabs
