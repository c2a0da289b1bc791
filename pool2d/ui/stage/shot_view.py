"""A running shot on the table: its balls, their trails, and the cue that struck."""

from __future__ import annotations

from ...draw import cue_motion, trail
from ...draw.effects import Effects
from ..frame import Frame
from .playback import Playback
from .shown_balls import ShownBalls
from .stage import Stage


def in_motion(frame: Frame, stage: Stage, balls: ShownBalls, shown: Playback, effects: Effects) -> None:
    """Draw the balls of a shot at its moment, their trails, and the cue that struck."""
    surface = frame.surface
    surface.set_clip(stage.screen.table)
    if effects.trail:
        frame.add(trail.draw(surface, shown.rollout, shown.time, stage.table, stage.view))
    stage.balls(frame, balls, running=shown.running)
    surface.set_clip(None)
    if effects.stroke and shown.shot is not None:
        start = shown.rollout.start[shown.shot.ball]
        if cue_motion.draw(surface, stage.table, start, shown.shot, shown.time, stage.view):
            # A cue takes much room, and lies over the bars too.
            frame.cover()
