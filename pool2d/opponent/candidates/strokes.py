"""What every stroke has to do with: the cue's way to the ball, and a look round the table."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from ...physics.event import Event
from ...physics.simulate import simulate
from ...physics.values import Layout, Shot
from ...table.clearance import least_elevation
from ...table.table import Table

# No player raises the butt by more for a stroke that is no jump, degrees; and so much more than what it has to clear.
STEEPEST: Final = 50.0
_SPARE: Final = 0.3
# Steps of a sequence that fills a space of four dimensions evenly, however long it is: powers of 1 / 1.1673039782614,
# which solves x^5 = x + 1 (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences").
_STEPS: Final = tuple(1.1673039782614187**-power for power in range(1, 5))


def cleared(table: Table, layout: Layout, shot: Shot) -> Shot | None:
    """The shot with the butt raised until the cue goes through nothing; None where it had to be raised too far."""
    needed = least_elevation(table, layout, shot)
    if needed.elevation is None or needed.elevation > STEEPEST:
        return None
    if not needed.over:
        return shot
    return replace(shot, elevation=min(89.0, needed.elevation + _SPARE))


def first_met(table: Table, layout: Layout, shot: Shot) -> str:
    """The ball that the cue ball meets first, "" for none."""

    def ends(event: Event) -> bool:
        return any(shot.ball in pair for pair in event.pairs) or event.kind == "ball_pocket"

    rollout = simulate(table, layout, shot, until=ends)
    last = rollout.events[-1]
    pair = next((pair for pair in last.pairs if shot.ball in pair), None)
    return "" if pair is None else pair[0] if pair[1] == shot.ball else pair[1]


def spot(look: int) -> tuple[float, float, float, float]:
    """The place of a look, counted from 1, in a space of four dimensions from 0 to 1, which all looks fill evenly."""
    a, b, c, d = (look * step % 1.0 for step in _STEPS)
    return a, b, c, d
