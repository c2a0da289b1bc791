"""A light trail behind moving balls: where each has been in the last moments, as the rollout says."""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
import pygame

from ..physics.motion import Motion
from ..physics.rollout import Rollout
from ..physics.values import AIRBORNE, ROLLING, SLIDING
from ..table.table import Table
from .view import View

# How far back a trail goes, s. A way is followed in straight lines of so many s, at most 4 mm beside a curve.
LENGTH = 0.3
_STEP = 0.1
# A trail is light that is added in soft dabs: their colour where the trail is fresh, how far the light
# spreads (the deviation of a normal distribution) and how far apart they are, in the ball's radii. At twice
# the spread they add up to an even band.
_COLOR = (38, 38, 36)
_SPREAD, _PITCH = 0.42, 0.84
# How many steps there are from faded to fresh, and from which on there is light enough to be seen.
_LEVELS, _SEEN = 24, 4
# So many dabs have one box: of more the box would have room for much else, of fewer there would be many boxes.
_BOX = 4


class Marks(NamedTuple):
    """The marks of a ball's trail: the times at which it passes them, s, and their places on the table, m."""

    times: list[float]
    places: list[tuple[float, float]]


def draw(surface: pygame.Surface, rollout: Rollout, t: float, table: Table, view: View) -> list[pygame.Rect]:
    """Draw the trails of balls that move or have just moved; returns the rectangles drawn in, in pixels."""
    drawn: list[pygame.Rect] = []
    begin, rate = t - LENGTH, (_LEVELS - 1) / LENGTH
    for ball_id, (times, places) in marks(rollout, table).items():
        first, last = bisect_left(times, begin + _SEEN / rate), bisect_right(times, t)
        if first == last:
            continue
        levels = _dabs(max(1, round(table.body_of(rollout.start[ball_id])[0] * view.scale)))
        half = levels[0].get_width() / 2.0
        left, bottom, scale, how = view.left - half, view.bottom - half, view.scale, pygame.BLEND_RGB_ADD
        # What `blits` takes; its type does not know of all it may be, nor that it returns boxes unless told not to.
        dabs: list[Any] = [
            (levels[int((then - begin) * rate)], (left + x * scale, bottom - y * scale), None, how)
            for then, (x, y) in zip(times[first:last], places[first:last], strict=True)
        ]
        boxes = surface.blits(dabs) or []
        drawn += [boxes[i].unionall(boxes[i + 1 : i + _BOX]) for i in range(0, len(boxes), _BOX)]
    return drawn


@lru_cache(maxsize=2)
def marks(rollout: Rollout, table: Table) -> dict[str, Marks]:
    """The marks on the way of each ball of a shot that moves, evenly apart from its start on."""
    bodies = {ball_id: table.body_of(ball) for ball_id, ball in rollout.start.items()}
    return {
        ball_id: _along(track, rollout.duration, _PITCH * bodies[ball_id][0])
        for ball_id, track in rollout.tracks.items()
        if len(track) > 1
    }


def _along(track: Sequence[Motion], duration: float, pitch: float) -> Marks:
    """Marks along a ball's motions, `pitch` m apart."""
    times: list[float] = []
    places: list[tuple[float, float]] = []
    ahead = 0.5 * pitch
    for motion, end in zip(track, [*(after.t0 for after in track[1:]), duration], strict=True):
        if motion.phase not in (SLIDING, ROLLING, AIRBORNE) or end == motion.t0:
            continue
        steps = math.ceil((end - motion.t0) / _STEP)
        moments = (motion.t0 + (end - motion.t0) * i / steps for i in range(steps + 1))
        for (t, x, y), (u, next_x, next_y) in pairwise((moment, *motion.place(moment)) for moment in moments):
            length = math.hypot(next_x - x, next_y - y)
            while ahead < length:
                part = ahead / length
                times.append(t + part * (u - t))
                places.append((x + part * (next_x - x), y + part * (next_y - y)))
                ahead += pitch
            ahead -= length
    return Marks(times, places)


@lru_cache(maxsize=8)
def _dabs(radius: int) -> list[pygame.Surface]:
    """The pictures of one mark for a ball of `radius` pixels, from faded to fresh."""
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
