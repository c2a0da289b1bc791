"""Tuning a table while it is played on: what turning a knob does to the last shot."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from ...errors import BudgetError, InputError
from ...game.session import Session
from ...physics.rollout import Rollout
from ...physics.simulate import simulate
from ...physics.values import Layout, Shot
from ...table.preset import load_table
from ...table.table import Table

# In place of a name: no conditions, no table to compare with.
NOTHING = "nothing"


class Tuning:
    """A session's table as it is tuned, and a shot on it: turning a knob changes the session's table at once.

    `shot` and `start` are the shot that is shown again: `old` is what it did on the table that was there when the
    tuning began, `new` what it does now, `other` what it does on the table `compared`. `error` is what is wrong with
    the last turn of a knob; the game's message line tells it.
    """

    def __init__(self, session: Session, aimed: Shot) -> None:
        self.session = session
        self.error = ""
        self.compared: Table | None = None
        self.other: Rollout | None = None
        self._seen: object = None
        self._presets: dict[str, Table] = {}
        self.follow(aimed)

    def follow(self, aimed: Shot) -> None:
        """Take the shot that was played last, or where there is none the one that is aimed."""
        session = self.session
        seen = (session.layout, session.rollout, None if session.shot else aimed)
        if seen == self._seen:
            if self._rolled_on is not session.table:
                self.refresh()
            return
        self._seen = seen
        self.start: Layout = session.layout if session.rollout is None else session.rollout.start
        self.shot = session.shot or aimed
        self.error = ""
        self._rolled_on: Table = self.session.table
        self.old = self.new = self._roll(self._rolled_on)
        self.other = None if self.compared is None else self._roll(self.compared)

    def turn(self, name: str, value: float | str) -> None:
        """Set a knob of the table in play."""
        self.turn_all({name: value})

    def turn_all(self, values: Mapping[str, float | str]) -> None:
        """Set several of its knobs at once."""
        self._change(lambda: self.session.table.with_knobs(values))

    def restore(self, table: Table) -> None:
        """Go back to the table as it was before."""
        self._change(lambda: table)

    def reset(self, *names: str) -> None:
        """Set these knobs, or all, back to the preset's values."""
        self._change(lambda: self.session.table.reset(*names))

    def compare(self, name: str) -> None:
        """Show the shot on another preset too, or on none."""
        self.error = ""
        try:
            self.compared = None if name == NOTHING else load_table(name)
        except InputError as error:
            self.error = str(error)
            return
        self.other = None if self.compared is None else self._roll(self.compared)

    def condition(self, name: str) -> None:
        """Lay conditions over the table's preset, or none; the knobs turned stay on top."""
        table = self.session.table
        chosen = () if name == NOTHING else (name,)
        self._change(lambda: load_table(table.source, table.set, chosen))

    def swap(self) -> None:
        """Play on the table that is compared, and compare with the one in play."""
        if self.compared is not None:
            before, other = self.session.table, self.compared
            self._change(lambda: other)
            if self.session.table is other:
                self.compared, self.other = before, self._roll(before)

    def _change(self, make: Callable[[], Table]) -> None:
        self.error = ""
        try:
            table = make()
            self.session.change_table(table)
        except InputError as error:
            self.error = str(error)
            return
        self.refresh()

    def has_room_on(self, name: str) -> bool:
        """Whether a preset can be read and has room for the balls of the shot where they lay."""
        try:
            if name not in self._presets:
                self._presets[name] = load_table(name)
            self._presets[name].settle(self.start)
        except InputError:
            return False
        return True

    def refresh(self) -> None:
        """Show what the shot does on the table as it is now."""
        self._rolled_on = self.session.table
        self.new = self._roll(self._rolled_on)

    def _roll(self, table: Table) -> Rollout | None:
        """The shot on a table; None, and the reason told, where the balls do not fit on it."""
        try:
            return simulate(table, self.start, self.shot)
        except (InputError, BudgetError) as error:
            self.error = str(error)
            return None
