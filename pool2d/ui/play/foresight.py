"""What the aimed shot would do, worked out once for each shot."""

from __future__ import annotations

import math
from collections.abc import Hashable
from dataclasses import replace

from ...draw import guide
from ...errors import BudgetError, InputError
from ...physics.cue.hand import SWING, lasting
from ...physics.rollout import Rollout
from ...physics.simulate import simulate
from ...physics.strike import miscue_limit
from ...physics.values import Layout, Shot
from ...table.clearance import Clearance, least_elevation
from ...table.table import Table

# At how many places round the ball it is tried whether a tip can be there.
_TIPS = 8


class Foresight:
    """Remembers the last shot that was foreseen, and how its cue was clear."""

    def __init__(self) -> None:
        self._key: Hashable = None
        self._level = guide.NONE
        self._rollout: Rollout | None = None
        self._aimed: Hashable = None
        self._clearance = Clearance(0.0, "")
        self._others: bool | None = None

    def clearance(self, table: Table, layout: Layout, shot: Shot) -> Clearance:
        """How far the butt has to be raised for a shot, and over what; a ball that is not there needs nothing."""
        key = (layout, table, replace(shot, speed=0.0))
        if key != self._aimed:
            self._aimed, self._others = key, None
            try:
                self._clearance = least_elevation(table, layout, shot)
            except InputError:
                self._clearance = Clearance(shot.elevation, "")
        return self._clearance

    def other_tips(self, table: Table, layout: Layout, shot: Shot) -> bool:
        """Whether a ball whose cue has something in its way can be struck along that aim elsewhere.

        That is in its middle, or at the edge of a miscue.
        """
        self.clearance(table, layout, shot)
        if self._others is None:
            far = miscue_limit(table.knobs.cue.tip_friction)
            ways = [math.tau * part / _TIPS for part in range(_TIPS)]
            tips = [(0.0, 0.0), *((far * math.cos(way), far * math.sin(way)) for way in ways)]
            shots = (replace(shot, side=side, height=height) for side, height in tips)
            self._others = any(least_elevation(table, layout, other).elevation is not None for other in shots)
        return self._others

    def rollout(self, table: Table, level: int, layout: Layout, shot: Shot) -> Rollout | None:
        """The shot as far as a guide of this level needs it; None where it cannot be played."""
        level = max(level, guide.LINE)
        key = (layout, table, shot)
        if key != self._key or level > self._level:
            self._key, self._level = key, level
            bounces = guide.BOUNCES if shot.elevation > 0.0 else 0
            events = None if level == guide.WHOLE else guide.EVENTS + bounces
            enough = guide.Enough(level, shot.ball)
            # What the tip may do yet is foreseen too.
            tip = lasting(SWING, table.knobs.cue.follow_through)
            try:
                self._rollout = simulate(
                    table, layout, shot, events=events, until=lambda event: enough(event) and event.t >= tip
                )
            except (InputError, BudgetError):
                self._rollout = None
        return self._rollout

    def strikes_twice(self, table: Table, level: int, layout: Layout, shot: Shot) -> bool:
        """Whether the tip would meet the ball again."""
        rollout = self.rollout(table, level, layout, shot)
        return rollout is not None and sum(event.kind == "cue_ball" for event in rollout.events) > 1

    def first_hit(self, table: Table, level: int, layout: Layout, shot: Shot) -> str:
        """The ball that a shot would meet first; empty where it meets none."""
        rollout = self.rollout(table, level, layout, shot)
        hits = (guide.hit(event, shot.ball) for event in rollout.events) if rollout else ()
        return next(filter(None, hits), "")
