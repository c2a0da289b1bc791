"""The balls at the moment that is shown: where they are, how they are turned, and which have gone."""

from __future__ import annotations

import math
from collections.abc import Hashable
from typing import NamedTuple

from ...game.match import Match, Moment
from ...game.orientations import BallStates, OrientationTracker
from ...physics.orientation import BallRotation
from ...physics.rollout import Rollout
from ...physics.values import Layout


class ShownBalls(NamedTuple):
    """A layout, to which `rollout`, if a shot has led there, has come `t` seconds after its start."""

    layout: Layout
    states: BallStates
    rollout: Rollout | None
    rotation: BallRotation | None
    t: float

    def gone(self, match: Match) -> tuple[str, ...]:
        """The balls that are no longer played, in the order in which they went; the table's cue ball only in a game
        where it counts."""
        cue = "" if match.rules.cue_counts else match.table.furniture.cue
        return tuple(ball for ball in self.states.gone if ball != cue)


class BallHistory:
    """Follows the balls from shot to shot, and works each moment out once."""

    def __init__(self) -> None:
        self.tracker = OrientationTracker()
        self._key: Hashable = None
        self._shown: ShownBalls | None = None

    def at_rest(self, layout: Layout, rollout: Rollout | None = None) -> ShownBalls:
        """Balls that lie; `rollout` is the shot that has led there, if one has."""
        key = rollout, layout
        if self._shown is None or key != self._key:
            self._key, self._shown = key, self._work_out(layout, rollout, math.inf)
        return self._shown

    def during(self, rollout: Rollout, t: float) -> ShownBalls:
        """The balls of a shot `t` seconds after its start."""
        key = rollout, t
        if self._shown is None or key != self._key:
            self._key, self._shown = key, self._work_out(rollout.at(t), rollout, t)
        return self._shown

    def follow(self, before: Moment, rollout: Rollout, last: Moment | None) -> None:
        """Let the balls of a stroke, played from the moment `before`, lie as the `last` stroke, if any, left them."""
        self.tracker.follow(before, rollout, last)
        self._shown = None

    def _work_out(self, layout: Layout, rollout: Rollout | None, t: float) -> ShownBalls:
        states = self.tracker.states(layout, rollout, t)
        return ShownBalls(layout, states, rollout, None if rollout is None else self.tracker.rotation(rollout), t)
