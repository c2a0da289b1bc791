"""The cue as it strikes: where it is at each moment around the time 0, at which it meets the ball."""

from __future__ import annotations

import pygame

from ..game.aim import Aim, drawn_back
from ..physics.values import Ball, Shot
from ..table.table import Table
from . import cue
from .effects import Effects
from .view import View

# How far the cue stands back from the ball at rest, at full pull and after the stroke, m.
REST, FULL, THROUGH = 0.02, 0.32, -0.09
# A stroke by hand goes forward in this time, s; one by key is drawn back first.
FORWARD, BACK = 0.08, 0.12
# How long it goes on after the contact, and how long it takes to fade then, s.
_FOLLOW, _FADE = 0.09, 0.22


def stand(drawn: float) -> float:
    """How far the cue stands back from the ball, m, when drawn back by a part, 0 to 1, of a full pull."""
    return REST + (FULL - REST) * drawn


def lead(drawn: bool, effects: Effects) -> float:
    """How long before the contact a shot is shown, s.

    `drawn`: the player has drawn the cue back already, so only the stroke forward is shown.
    """
    if not effects.stroke:
        return 0.0
    return FORWARD if drawn else BACK + FORWARD


def reach(drawn: float, t: float) -> tuple[float, float]:
    """The cue's distance from the ball, m, and how solid it is, 0 to 1, at `t` s after it meets the ball."""
    pulled = stand(drawn)
    if t < -FORWARD:
        return REST + (pulled - REST) * _smooth(1.0 + (t + FORWARD) / BACK), 1.0
    if t < 0.0:
        # Ever faster, until it meets the ball.
        return pulled * (1.0 - (1.0 + t / FORWARD) ** 2), 1.0
    gone = min(t / _FOLLOW, 1.0)
    return THROUGH * gone * (2.0 - gone), max(0.0, 1.0 - max(0.0, t - _FOLLOW) / _FADE)


def draw(surface: pygame.Surface, table: Table, ball: Ball, shot: Shot, t: float, view: View) -> bool:
    """Draw the cue of a shot at `t` s; `ball` is the cue ball where it was struck.

    Returns whether the cue is to be seen at that time.
    """
    back, seen = reach(drawn_back(shot.speed), t)
    if seen <= 0.0:
        return False
    aim = Aim(shot.angle, shot.speed, shot.side, shot.height, shot.elevation, shot.jump)
    cue.draw(surface, table, ball, aim, back, view, seen)
    return True


def _smooth(part: float) -> float:
    part = min(max(part, 0.0), 1.0)
    return part * part * (3.0 - 2.0 * part)
