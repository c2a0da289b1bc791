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
        self._rollout: Rollout | None = None

    def rollout(self, table: Table, level: int, layout: Layout, shot: Shot) -> Rollout | None:
        """The shot as far as a guide of this level needs it; None where it cannot be played."""
        events = None if level == guide.WHOLE else guide.EVENTS
        key = (layout, table, shot, events)
        if key != self._key:
            self._key = key
            try:
                self._rollout = simulate(table, layout, shot, events=events)
            except (InputError, BudgetError):
                self._rollout = None
        return self._rollout

    def first_hit(self, table: Table, level: int, layout: Layout, shot: Shot) -> str:
        """The ball that a shot would meet first; empty where it meets none."""
        rollout = self.rollout(table, level, layout, shot)
        pairs = [pair for event in rollout.events for pair in event.pairs if shot.ball in pair] if rollout else []
        return next((ball for ball in pairs[0] if ball != shot.ball), "") if pairs else ""
