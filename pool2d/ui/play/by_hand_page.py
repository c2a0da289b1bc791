"""The tuning panel's page where measurements made by hand are typed in, and what knobs they gave."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import pygame

from ...draw import theme
from ...errors import InputError
from ...fit.by_hand import HandFit, HandFits, fit_by_hand, places
from ...fit.measurements import QUANTITIES
from ...fit.readings import read
from ...table.table import Table
from ..widgets.field import TextField
from ..widgets.widget import Button, Gap, Heading, Widget
from ..wording.words import Words
from .tuning import Tuning

# What is typed in, two beside each other; what else may be known of a measurement is for files.
ROWS = (
    ("lag.seconds", "lag.gap"),
    ("hard.lengths", "hard.first"),
    ("spin.turns", "spin.seconds"),
    ("oblique.leaves", "rebound.kept"),
)
# What complaints call it.
_SOURCE = "measured"


class Entry(TextField):
    """A field for readings: Enter works them out, and no key means anything else while it has the focus."""

    def __init__(self, enter: Callable[[], None]) -> None:
        super().__init__("")
        self._enter = enter

    def key(self, key: int, mod: int) -> bool:
        if key in (pygame.K_RETURN, pygame.K_KP_ENTER):
            self._enter()
            return True
        return super().key(key, mod) or bool(mod & (pygame.KMOD_CTRL | pygame.KMOD_META))


class ByHandPage:
    """What was typed in stays while the window is open; what it gave, while the panel that shows it is.

    `entries` are the fields by the quantities that they are for.
    """

    def __init__(self, words: Words) -> None:
        self.words = words
        self.entries = {name: Entry(self.work_out) for row in ROWS for name in row}
        self._tuning: Tuning | None = None
        self._shown: Callable[[], None] = lambda: None
        self._found: HandFits | None = None
        self._before: Table | None = None

    def rows(self, tuning: Tuning, shown: Callable[[], None]) -> list[list[Widget]]:
        """What is on the page of a panel; `shown` is called where that has changed."""
        if tuning is not self._tuning:
            self._tuning, self._found, self._before = tuning, None, None
        self._shown = shown
        for name, entry in self.entries.items():
            self._label(name, entry)
        rows: list[list[Widget]] = [[Heading(lambda: self.words.say("by_hand.intro"), lines=3)], [Gap(0.2)]]
        rows += [[self.entries[name] for name in row] for row in ROWS]
        return [*rows, self._buttons(), *self._results()]

    def work_out(self) -> None:
        """Find the knobs that were measured, and set them; where that cannot be, why."""
        if self._tuning is None:
            return
        table = self._tuning.session.table
        try:
            typed = {name: entry.value for name, entry in self.entries.items() if entry.value.strip()}
            readings = {name: read(text, QUANTITIES[name], _SOURCE) for name, text in typed.items()}
            found = fit_by_hand(table, readings, _SOURCE)
        except InputError as error:
            self._tuning.error = str(error)
            return
        self._tuning.turn_all(found.values)
        if not self._tuning.error:
            self._found, self._before = found, table
            self._shown()

    def put_back(self) -> None:
        """Go back to the table from which they were last set."""
        if self._tuning is not None and self._before is not None:
            self._tuning.restore(self._before)
            self._found, self._before = None, None
            self._shown()

    # What is on the page.

    def _label(self, name: str, entry: Entry) -> None:
        say, unit = self.words.say, QUANTITIES[name].knob.unit
        label = say(f"by_hand.{name}")
        entry.label = f"{label}, {self.words.say_or(f'unit.{unit}', unit)}" if unit else label
        entry.hint = say(f"by_hand.{name}_hint", error=self.words.quantity(QUANTITIES[name].error, "g", unit))
        entry.instead = say("by_hand.assumed") if QUANTITIES[name].assumed else say("by_hand.empty")

    def _buttons(self) -> list[Widget]:
        say = self.words.say
        return [
            Button(say("by_hand.back"), self.put_back, say("by_hand.back_hint"), barred=lambda: self._before is None),
            Button(say("by_hand.find"), self.work_out, say("by_hand.find_hint"), strong=True),
        ]

    def _results(self) -> list[list[Widget]]:
        if self._found is None:
            return []
        lines = [Heading(partial(self._line, fit), theme.ACCENT) for fit in self._found.knobs]
        return [[line] for line in (*lines, *self._strained(self._found.strain))]

    def _strained(self, strain: float) -> list[Heading]:
        """What is to be said where measurements of one knob contradict each other."""
        if strain <= 2.0:
            return []
        said = self.words.number(strain, ".1f")
        return [Heading(lambda: self.words.say("by_hand.strained", times=said), theme.WARNING, lines=3)]

    def _line(self, fit: HandFit) -> str:
        number, form = self.words.number, f".{places(fit.error)}f"
        value, error, was = number(fit.now, form), number(fit.error, form), number(fit.was, ".4g")
        knob = self.words.say(f"by_hand.knob.{fit.knob}")
        return self.words.say("by_hand.found", knob=knob, value=value, error=error, was=was)
