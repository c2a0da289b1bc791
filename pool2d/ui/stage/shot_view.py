"""A running shot on the table: its balls, their trails, and the cue that struck."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pygame

from ...draw import cue_motion, trail
from ...draw.effects import Effects
from ..scene import Boxes
from .playback import Playback
from .stage import Stage

if TYPE_CHECKING:
    pass


def in_motion(surface: pygame.Surface, stage: Stage, shown: Playback, effects: Effects) -> Boxes:
    """The balls of a shot at its moment, their trails, and the cue that struck.

    Returns the boxes in which it has drawn; None while the cue is in sight, which takes much room.
    """
    surface.set_clip(stage.screen.table)
    drawn = trail.draw(surface, shown.rollout, shown.time, stage.table, stage.view) if effects.trail else []
    drawn += stage.balls(surface, shown.rollout.at(shown.time), shown.rollout, shown.time, running=shown.running)
    surface.set_clip(None)
    if not effects.stroke or shown.shot is None:
        return drawn
    start = shown.rollout.start[shown.shot.ball]
    return None if cue_motion.draw(surface, stage.table, start, shown.shot, shown.time, stage.view) else drawn
