"""A shot from its stroke to rest: what the engine offers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Final, Protocol

from ..errors import BudgetError
from .body import Body
from .detect import Element
from .event import Event
from .flight.bed import Bed
from .params import Physics
from .rollout import Rollout
from .values import Ball, Layout, Shot
from .world import World

# Far above what any shot takes (a break takes some hundreds).
BUDGET: Final = 50_000


class Field(Protocol):
    """What the loop needs of a table."""

    @property
    def physics(self) -> Physics: ...

    @property
    def elements(self) -> Sequence[Element]: ...

    @property
    def bed(self) -> Bed: ...

    def bodies(self, balls: Sequence[Ball]) -> list[Body]:
        """The balls as the engine moves them, in this order."""
        ...

    def settle(self, layout: Layout) -> Layout:
        """The layout with its balls exactly where they may stand; raises InputError where they may not."""
        ...

    def scenario(self, layout: Layout, shot: Shot | None) -> dict[str, Any]:
        """Table, balls and shot in the form of a scenario file."""
        ...


def simulate(
    table: Field,
    layout: Layout,
    shot: Shot | None = None,
    *,
    events: int | None = None,
    until: Callable[[Event], bool] | None = None,
    budget: int = BUDGET,
) -> Rollout:
    """Play `layout` from its velocities and, where given, a shot, until every ball is at rest.

    `events` stops after that many events, `until` after the first that it says True of. Raises InputError where the
    shot's ball is not on the table or the shot is out of range, BudgetError where the shot takes more than `budget`
    events.

    Examples:
        >>> from pool2d import Ball, Layout, Shot, load_table, simulate
        >>> layout = Layout([Ball("cue", 1.27, 0.4), Ball("1", 1.27, 0.9)])
        >>> roll = simulate(load_table("pool-9ft"), layout, Shot(angle=90.0, speed=1.5))
        >>> [(event.kind, *event.balls) for event in roll.events if event.where]
        [('ball_pocket', '1'), ('ball_pocket', 'cue')]
        >>> simulate(load_table("pool-9ft"), layout, Shot(angle=90.0, speed=1.5), events=2).truncated
        True
        >>> shot = Shot(angle=90.0, speed=1.5)
        >>> roll = simulate(load_table("pool-9ft"), layout, shot, until=lambda event: event.kind == "ball_ball")
        >>> roll.events
        [<0.000000 cue_ball cue>, <0.257281 ball_ball 1 cue>]
    """
    layout = table.settle(layout)
    physics = table.physics if shot is None else table.physics.struck_by(shot)
    # Sorted, so that the order in which balls are given is of no consequence.
    world = World(table.bodies(sorted(layout.on_table())), physics, list(table.elements), table.bed)
    if shot is not None:
        world.strike(shot)
    limit = budget if events is None else min(events, budget)
    stopped = world.run(limit, until)
    truncated = world.advance(look=True)
    if truncated and limit != events and not stopped:
        raise BudgetError(budget, world.now, table.scenario(layout, shot))
    return Rollout(layout, {track[0].id: track for track in world.tracks}, world.events, truncated)
