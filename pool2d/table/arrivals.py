"""Which of a ball's contacts with a rail are arrivals, and which come of lying pressed against it."""

from __future__ import annotations

from ..physics.motion import pieces
from ..physics.rollout import Rollout
from ..physics.values import Ball
from .table import Table

# Balls and cushions no further apart than this touch, as far as a referee can tell, m.
FROZEN = 2e-5
# A ball has left a cushion once it has been this far from it, m.
LEFT = 2e-4


class Arrivals:
    """Told of a rollout's contacts with rails in their order, it says which of them are a ball that comes there."""

    def __init__(self, table: Table, rollout: Rollout) -> None:
        self._table = table
        self._rollout = rollout
        # When each ball was last on each cushion.
        self._last: dict[tuple[str, str], float] = {}

    def arrives(self, ball: str, cushion: str, t: float) -> bool:
        """Whether a ball comes to a cushion at `t`, rather than being pressed against it where it lay."""
        if cushion not in self._table.rails:
            # The back of a pocket, on which no ball lies.
            return True
        last = self._last.get((ball, cushion))
        self._last[ball, cushion] = t
        if last is None:
            if self._gap(self._rollout.start[ball], cushion) > FROZEN:
                return True
            last = 0.0
        moments = [moment for _, a, b in pieces(self._rollout.tracks[ball], last, t) for moment in (a, 0.5 * (a + b))]
        return any(self._gap(self._rollout.ball_at(ball, moment), cushion) > LEFT for moment in moments)

    def _gap(self, ball: Ball, cushion: str) -> float:
        """How far a ball is from a cushion, m."""
        reach = self._table.reach(self._table.body_of(ball)[0])
        return min([rail.gap(ball.x, ball.y, reach) for rail in self._table.rails[cushion]])
