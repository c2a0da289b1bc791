"""The tuning panel: every knob of the table, and what turning it does to the last shot."""

from __future__ import annotations

from collections.abc import Callable

import pygame

from ..errors import BudgetError, InputError
from ..game.session import Session
from ..knobs import Knob, walk
from ..physics.rollout import Rollout
from ..physics.simulate import simulate
from ..physics.values import Layout, Shot
from ..preset import conditions, load_table, presets
from ..table import Table
from . import theme
from .form import Form
from .hud import Screen
from .inputs import Choice, ListBox, Slider
from .widgets import Button, Heading, Tabs, Widget

# The panel's pages, and the knobs on each by the beginning of their names.
PAGES = {
    "Cloth": ("gravity", "cloth."),
    "Balls": ("ball.",),
    "Cushions": ("cushion.",),
    "Pockets": ("corner.", "side."),
    "Cue": ("cue.",),
    "Table": ("table.",),
}
NOTHING = "nothing"


class Tuning:
    """The panel over a session: turning a knob changes the session's table at once.

    `shot` and `start` are the shot that is shown again: `old` is what it did on the table that was there
    when the panel opened, `new` what it does now, `other` what it does on the table compared. `error` is
    what is wrong with the last turn of a knob; the game's message line tells it.
    """

    def __init__(self, session: Session, aimed: Shot, save: Callable[[], None], go_to: Callable[[str], None]) -> None:
        self.session = session
        self.page = "Cloth"
        self.error = ""
        self.compared: Table | None = None
        self.other: Rollout | None = None
        self._seen: object = None
        self.follow(aimed)
        self._save = save
        self._go_to = go_to
        self.chosen = session.table.source
        self.form = Form([])
        self._lay_out()

    def follow(self, aimed: Shot) -> None:
        """Take the shot that was played last, or where there is none the one that is aimed."""
        session = self.session
        seen = (session.layout, session.rollout, None if session.shot else aimed)
        if seen == self._seen:
            return
        self._seen = seen
        self.start: Layout = session.layout if session.rollout is None else session.rollout.start
        self.shot = session.shot or aimed
        self.error = ""
        self.old = self.new = self._roll(self.session.table)
        self.other = None if self.compared is None else self._roll(self.compared)

    # What the hands do.

    def handle(self, event: pygame.event.Event) -> bool:
        """Take an event; whether it was meant for the panel."""
        return self.form.handle(event)

    def update(self, dt: float) -> None:
        self.form.update(dt)

    def draw(self, surface: pygame.Surface) -> None:
        screen = Screen(*surface.get_size())
        width = self.width(screen)
        box = pygame.Rect(screen.width - width, screen.top.bottom, width, screen.table[3])
        self.form.place(box, screen.unit)
        self.form.draw(surface)

    def width(self, screen: Screen) -> int:
        """How wide the panel is, in pixels."""
        return min(44 * screen.unit, screen.width // 2)

    # What that does to the table.

    def turn(self, name: str, value: float | str) -> None:
        """Set a knob of the table in play."""
        self._change(lambda: self.session.table.with_knobs({name: value}))

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

    def go(self) -> None:
        """Leave this table for the chosen one."""
        if self.chosen not in presets():
            self.error = "Choose a table in the list."
            return
        try:
            self._go_to(self.chosen)
        except InputError as error:
            self.error = str(error)

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

    def refresh(self) -> None:
        """Show what the shot does on the table as it is now."""
        self.new = self._roll(self.session.table)

    def _roll(self, table: Table) -> Rollout | None:
        """The shot on a table; None, and the reason told, where the balls do not fit on it."""
        try:
            return simulate(table, self.start, self.shot)
        except (InputError, BudgetError) as error:
            self.error = str(error)
            return None

    # What is on the panel.

    def _lay_out(self) -> None:
        rows: list[list[Widget]] = [
            [Heading(lambda: "Tune the table", theme.TEXT, large=True)],
            [Heading(self._summary)],
            [Tabs(list(PAGES), lambda: self.page, self._open)],
            *([self._widget(name, knob)] for name, knob, _ in self._knobs() if name.startswith(PAGES[self.page])),
            *self._tables(),
            [Choice("Conditions", lambda: [NOTHING, *conditions()], self._conditions, self.condition, _CONDITIONS)],
            [Choice("Compare with", lambda: [NOTHING, *presets()], self._compared, self.compare, _COMPARE)],
            [
                Button("Swap", self.swap, "play on the table compared with, and compare with this one"),
                Button("Reset all", self.reset, "set every knob back to the preset's value"),
                Button("Save as", self._save, "keep this table as a preset of your own", strong=True),
            ],
        ]
        self.form.set_rows(rows)

    def _tables(self) -> list[list[Widget]]:
        """On the page of that name: the presets, to play on another."""
        if self.page != "Table":
            return []
        return [
            [ListBox(presets, lambda: self.chosen, self._choose, lines=6)],
            [Button("Play on this table", self.go, "leave this game for a new rack on the chosen table")],
        ]

    def _choose(self, name: str) -> None:
        self.chosen = name

    def _conditions(self) -> str:
        return ", ".join(self.session.table.conditions) or NOTHING

    def _open(self, page: str) -> None:
        self.page = page
        focus = self.form.focus
        self._lay_out()
        if isinstance(focus, Tabs):
            self.form.focus = next(widget for widget in self.form.widgets if isinstance(widget, Tabs))

    def _widget(self, name: str, knob: Knob) -> Widget:
        plain = name if self.page == "Pockets" else name.rpartition(".")[2]
        label = knob.label or plain.replace("_", " ").replace(".", " ").capitalize()
        if knob.choices:
            return Choice(
                label,
                lambda: knob.choices,
                lambda: str(self._value(name)),
                lambda value: self.turn(name, value),
                knob.doc,
            )
        return Slider(
            label,
            knob,
            lambda: float(self._value(name)),
            lambda value: self.turn(name, value),
            lambda: self.reset(name),
        )

    def _knobs(self) -> list[tuple[str, Knob, float | str]]:
        return list(walk(self.session.table.knobs))

    def _value(self, name: str) -> float | str:
        value: object = self.session.table.knobs
        for part in name.split("."):
            value = getattr(value, part)
        assert isinstance(value, (float, str))
        return value

    def _summary(self) -> str:
        changed = len(self.session.table.set)
        parts = [self.session.table.title, *self.session.table.conditions]
        return f"{', '.join(parts)}; {changed or 'no'} knob{'' if changed == 1 else 's'} turned"

    def _compared(self) -> str:
        return NOTHING if self.compared is None else self.compared.source


_CONDITIONS = "cloth, balls and cushions as they get in use; they lie over the preset and under the knobs"
_COMPARE = "show the same shot on another table too"
