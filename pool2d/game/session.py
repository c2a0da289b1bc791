"""A free game on one table: a rack, shots, and the way back."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ..physics.rollout import Rollout
from ..physics.simulate import simulate
from ..physics.values import POCKETED, Ball, Layout, Shot
from ..table import Table


@dataclass(frozen=True, slots=True)
class Position:
    """Where a game stands: the balls, whether the cue ball is in hand, how many shots were played.

    `shot` and `rollout` are of the last one, if it led here.
    """

    layout: Layout
    in_hand: bool = False
    shots: int = 0
    shot: Shot | None = None
    rollout: Rollout | None = None


class Session:
    """The balls on a table and what was done to them.

    `position` is the present one. `play`, `place` and `rack` go on, `undo` goes back to before the last
    shot or rack. Without a name, the rack is the table's first.
    """

    def __init__(self, table: Table, rack: str = "", seed: int = 0) -> None:
        self.table = table
        self.rack_name = rack or next(iter(table.furniture.racks))
        self.seed = seed
        self.position = Position(table.rack(self.rack_name, seed))
        self._past: list[Position] = []

    @property
    def layout(self) -> Layout:
        return self.position.layout

    @property
    def cue(self) -> Ball:
        """The cue ball, also while it is in hand."""
        return self.layout[self.table.furniture.cue]

    @property
    def rollout(self) -> Rollout | None:
        """The last shot, if it led here."""
        return self.position.rollout

    @property
    def in_hand(self) -> bool:
        return self.position.in_hand

    @property
    def left(self) -> int:
        """How many object balls are still on the table."""
        return sum(ball.id != self.cue.id for ball in self.layout.on_table())

    def play(self, shot: Shot) -> Rollout:
        """Play a shot to its end; afterwards a cue ball that fell is in hand.

        Raises InputError where the cue ball is in hand or the shot is out of range, BudgetError where
        it does not end; nothing has changed then.
        """
        rollout = simulate(self.table, self.layout, shot)
        end = rollout.layout()
        fallen = end[self.cue.id].phase == POCKETED
        self._go_on(Position(end, fallen, self.position.shots + 1, shot, rollout))
        return rollout

    def may_place(self, x: float, y: float) -> bool:
        """Whether the cue ball has room here, its centre on the playing surface."""
        radius = self.table.body_of(self.cue)[0]
        return self.table.on_surface(x, y) and self.table.has_room(x, y, radius, self.layout, ignore=self.cue.id)

    def place(self, x: float, y: float) -> bool:
        """Put a cue ball in hand on the table; False, and nothing done, where it has no room."""
        if not (self.in_hand and self.may_place(x, y)):
            return False
        ball = self.cue.still()._replace(x=x, y=y)
        self.position = replace(self.position, layout=self.layout.put(ball), in_hand=False)
        return True

    def rack(self, seed: int) -> None:
        """Set up a new rack."""
        self._go_on(Position(self.table.rack(self.rack_name, seed)))
        self.seed = seed

    def undo(self) -> bool:
        """Go back to before the last shot or rack; False where there is nothing to go back to."""
        if not self._past:
            return False
        self.position = self._past.pop()
        return True

    def change_table(self, table: Table) -> None:
        """Play on with other parameters; raises InputError, changing nothing, where the balls do not fit."""
        self.position = replace(self.position, layout=table.settle(self.layout))
        self.table = table

    def _go_on(self, position: Position) -> None:
        self._past.append(self.position)
        self.position = position
