"""The tuning panel: every knob of the table, and what turning it does to the last shot."""

from __future__ import annotations

from collections.abc import Callable

import pygame

from ...config.knobs import Knob, walk
from ...draw import theme
from ...errors import BudgetError, InputError
from ...game.session import Session
from ...physics.rollout import Rollout
from ...physics.simulate import simulate
from ...physics.values import Layout, Shot
from ...table.preset import conditions, load_table, presets, title_of
from ...table.table import Table
from ..screen import Screen
from ..widgets.form import Form
from ..widgets.inputs import ListBox, Selector, Slider
from ..widgets.widget import Button, Heading, Tabs, Widget
from ..wording.ruling_text import preset_title, table_title
from ..wording.words import number, say, say_or, unit

# The panel's pages, and the knobs on each by the beginning of their names.
PAGES = {
    "cloth": ("gravity", "cloth."),
    "balls": ("ball.",),
    "cushions": ("cushion.",),
    "pockets": ("corner.", "side."),
    "cue": ("cue.",),
    "table": ("table.",),
}
NOTHING = "nothing"


class Tuning:
    """The panel over a session: turning a knob changes the session's table at once.

    `shot` and `start` are the shot that is shown again: `old` is what it did on the table that was there
    when the panel opened, `new` what it does now, `other` what it does on the table compared. `error` is
    what is wrong with the last turn of a knob; the game's message line tells it. It is larger than
    most classes, as each widget of its pages has one method to read and one to do what it does.
    """

    def __init__(self, session: Session, aimed: Shot, save: Callable[[], None], go_to: Callable[[str], None]) -> None:
        self.session = session
        self.page = "cloth"
        self.error = ""
        self.compared: Table | None = None
        self.other: Rollout | None = None
        self._seen: object = None
        self.follow(aimed)
        self._save = save
        self._go_to = go_to
        self.chosen = session.table.source
        self._titles: dict[str, str] = {}
        self._presets: dict[str, Table] = {}
        self.form = Form([])
        self.fill()

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

    # What the hands do.

    def handle(self, event: pygame.event.Event) -> bool:
        """Take an event; whether it was meant for the panel."""
        return self.form.handle(event)

    def update(self, dt: float) -> None:
        self.form.update(dt)

    def place(self, screen: Screen) -> int:
        """Lay the panel out on the right of the table; returns how wide it is, in pixels."""
        width = min(44 * screen.unit, screen.width // 2)
        self.form.place(pygame.Rect(screen.width - width, screen.top.bottom, width, screen.table[3]), screen.unit)
        return width

    def draw(self, surface: pygame.Surface) -> None:
        self.form.draw(surface)

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
            self.error = say("tuning.choose")
            return
        try:
            self._go_to(self.chosen)
        except InputError as error:
            self.error = str(error)

    def save(self) -> None:
        """Ask for a name to save the table by; what was refused before it is over."""
        self.error = ""
        self._save()

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
        self._rolled_on = self.session.table
        self.new = self._roll(self._rolled_on)

    def _roll(self, table: Table) -> Rollout | None:
        """The shot on a table; None, and the reason told, where the balls do not fit on it."""
        try:
            return simulate(table, self.start, self.shot)
        except (InputError, BudgetError) as error:
            self.error = str(error)
            return None

    # What is on the panel.

    def fill(self) -> None:
        """Put the open page on the panel, in the language of the moment."""
        rows: list[list[Widget]] = [
            [Heading(lambda: say("tuning.title"), theme.TEXT, large=True)],
            [Heading(self._summary)],
            [Tabs(list(PAGES), lambda: self.page, self._open, lambda page: say(f"tuning.page.{page}"))],
            *([self._widget(name, knob)] for name, knob, _ in self._knobs() if name.startswith(PAGES[self.page])),
            *self._tables(),
            *self._others(),
            [
                Button(say("tuning.swap"), self.swap, say("tuning.swap_hint")),
                Button(say("tuning.reset"), self.reset, say("tuning.reset_hint")),
                Button(say("tuning.save"), self.save, say("tuning.save_hint"), strong=True),
            ],
        ]
        self.form.set_rows(rows)

    def _others(self) -> list[list[Widget]]:
        """What is laid over the preset, and what it is compared with."""
        return [
            [
                Selector(
                    say("tuning.conditions"),
                    lambda: [NOTHING, *conditions()],
                    self._conditions,
                    self.condition,
                    say("tuning.conditions_hint"),
                    _condition,
                )
            ],
            [
                Selector(
                    say("tuning.compare"),
                    lambda: [NOTHING, *filter(self._holds, presets())],
                    self._compared,
                    self.compare,
                    say("tuning.compare_hint"),
                    lambda name: say("tuning.nothing") if name == NOTHING else self._title(name),
                )
            ],
        ]

    def _tables(self) -> list[list[Widget]]:
        """On the page of that name: the presets, to play on another."""
        if self.page != "table":
            return []
        return [
            [ListBox(presets, lambda: self.chosen, self._choose, lines=6, shown=self._title)],
            [Button(say("tuning.go"), self.go, say("tuning.go_hint"))],
        ]

    def _choose(self, name: str) -> None:
        self.chosen = name

    def _title(self, name: str) -> str:
        """The title of a preset; its file is read once as long as the panel is open."""
        if name not in self._titles:
            self._titles[name] = title_of(name)
        return preset_title(name, self._titles[name])

    def _conditions(self) -> str:
        return ", ".join(self.session.table.conditions) or NOTHING

    def _open(self, page: str) -> None:
        self.page = page
        self.fill()

    def _widget(self, name: str, knob: Knob) -> Widget:
        label = say(f"knob.{name}")
        doc = say_or(f"knob.{name}_hint", knob.doc)
        if knob.choices:
            return Selector(
                label,
                lambda: knob.choices,
                lambda: str(self._value(name)),
                lambda value: self.turn(name, value),
                doc,
                lambda value: say_or(f"choice.{value}", value),
            )
        return Slider(
            label,
            knob,
            lambda: float(self._value(name)),
            lambda value: self.turn(name, value),
            lambda: self.reset(name),
            say(
                "tuning.range",
                doc=doc,
                lo=number(knob.lo, "g"),
                hi=f"{number(knob.hi, 'g')} {unit(knob.unit)}".rstrip(),
            ),
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
        table = self.session.table
        parts = [table_title(table), *map(_condition, table.conditions)]
        return f"{', '.join(parts)}; {say('tuning.turned', count=changed) if changed else say('tuning.unturned')}"

    def _holds(self, name: str) -> bool:
        """Whether a preset can be read and has room for the balls of the shot where they lay."""
        try:
            if name not in self._presets:
                self._presets[name] = load_table(name)
            self._presets[name].settle(self.start)
        except InputError:
            return False
        return True

    def _compared(self) -> str:
        return NOTHING if self.compared is None else self.compared.source


def _condition(name: str) -> str:
    """Conditions as they are told; one's own by their file's name."""
    return say("tuning.usual") if name == NOTHING else say_or(f"condition.{name}", name)
