"""What the aimed shot would do, worked out once for each shot."""

from __future__ import annotations

from collections.abc import Hashable

from ...draw import guide
from ...errors import BudgetError, InputError
from ...physics.rollout import Rollout
from ...physics.simulate import simulate
from ...physics.values import Layout, Shot
from ...table.table import Table


class Foresight:
    """Remembers the last shot that was foreseen."""

    def __init__(self) -> None:
        self._key: Hashable = None
        self._level = guide.NONE
        self._rollout: Rollout | None = None

    def rollout(self, table: Table, level: int, layout: Layout, shot: Shot) -> Rollout | None:
        """The shot as far as a guide of this level needs it; None where it cannot be played."""
        level = max(level, guide.LINE)
        key = (layout, table, shot)
        if key != self._key or level > self._level:
            self._key, self._level = key, level
            bounces = guide.BOUNCES if shot.elevation > 0.0 else 0
            events = None if level == guide.WHOLE else guide.EVENTS + bounces
            try:
                self._rollout = simulate(table, layout, shot, events=events, until=guide.Enough(level, shot.ball))
            except (InputError, BudgetError):
                self._rollout = None
        return self._rollout

    def first_hit(self, table: Table, level: int, layout: Layout, shot: Shot) -> str:
        """The ball that a shot would meet first; empty where it meets none."""
        rollout = self.rollout(table, level, layout, shot)
        hits = (guide.hit(event, shot.ball) for event in rollout.events) if rollout else ()
        return next(filter(None, hits), "")
