"""The tuning panel: every knob of the table as a widget."""

from __future__ import annotations

from collections.abc import Callable

import pygame

from ...config.knobs import Knob, walk
from ...draw import theme
from ...errors import InputError
from ...table.preset import conditions, presets, title_of
from ...table.table import Table
from ..screen import Screen
from ..widgets.field import TextField
from ..widgets.form import Form
from ..widgets.inputs import ListBox, Selector, Slider
from ..widgets.widget import Button, Heading, Tabs, Widget
from ..wording.ruling_text import preset_title, table_title
from ..wording.words import Words
from .by_hand_page import ByHandPage
from .tuning import NOTHING, Tuning

# The panel's pages, and the knobs on each by the beginning of their names; on the last they are measured.
PAGES: dict[str, tuple[str, ...]] = {
    "cloth": ("gravity", "cloth."),
    "balls": ("ball.",),
    "cushions": ("cushion.", "rail."),
    "pockets": ("corner.", "side.", "facing.", "pocket."),
    "cue": ("cue.", "jump_cue."),
    "table": ("table.",),
    "by_hand": (),
}


class TuningPanel:
    """The panel by which hands tune a table: `tuning` is what they turn.

    `save` asks for a name to save the table by, `go_to` goes over to another preset; `by_hand` is the page of
    measurements.
    """

    def __init__(
        self, tuning: Tuning, words: Words, by_hand: ByHandPage, save: Callable[[], None], go_to: Callable[[str], None]
    ) -> None:  # fmt: skip
        self.tuning = tuning
        self.by_hand = by_hand
        self.words = words
        self.page = "cloth"
        self._save = save
        self._go_to = go_to
        self.chosen = tuning.session.table.source
        self._titles: dict[str, str] = {}
        self.form = Form([])
        self.fill()

    @property
    def _table(self) -> Table:
        """The table that is tuned."""
        return self.tuning.session.table

    # What the hands do.

    def handle(self, event: pygame.event.Event) -> bool:
        """Take an event; whether it was meant for the panel."""
        if event.type == pygame.MOUSEBUTTONDOWN and self.takes_text and not self.form.rect.collidepoint(event.pos):
            # Who goes on at the table has done with typing: keys mean there what they always do.
            self.form.focus = next(one for one in self.form.widgets if isinstance(one, Tabs))
        return self.form.handle(event)

    @property
    def takes_text(self) -> bool:
        """Whether keys are for a text."""
        return isinstance(self.form.focus, TextField)

    def update(self, dt: float) -> None:
        self.form.update(dt)

    def place(self, screen: Screen) -> int:
        """Lay the panel out on the right of the table; returns how wide it is, in pixels."""
        width = min(44 * screen.unit, screen.width // 2)
        self.form.place(pygame.Rect(screen.width - width, screen.top.bottom, width, screen.table[3]), screen.unit)
        return width

    def draw(self, surface: pygame.Surface) -> None:
        self.form.draw(surface)

    # What buttons do.

    def go(self) -> None:
        """Leave this table for the chosen one."""
        if self.chosen not in presets():
            self.tuning.error = self.words.say("tuning.choose")
            return
        try:
            self._go_to(self.chosen)
        except InputError as error:
            self.tuning.error = str(error)

    def save(self) -> None:
        """Ask for a name to save the table by; what was refused before it is over."""
        self.tuning.error = ""
        self._save()

    # What is on the panel.

    def fill(self) -> None:
        """Put the open page on the panel, in the language of the moment."""
        say = self.words.say
        rows: list[list[Widget]] = [
            [Heading(lambda: say("tuning.title"), theme.TEXT, large=True)],
            [Heading(self._summary)],
            [Tabs(list(PAGES), lambda: self.page, self._open, lambda page: say(f"tuning.page.{page}"))],
            *([self._widget(name, knob)] for name, knob, _ in self._knobs() if name.startswith(PAGES[self.page])),
            *(self.by_hand.rows(self.tuning, self.fill) if self.page == "by_hand" else []),
            *self._tables(),
            *self._others(),
            [
                Button(say("tuning.swap"), self.tuning.swap, say("tuning.swap_hint")),
                Button(say("tuning.reset"), self.tuning.reset, say("tuning.reset_hint")),
                Button(say("tuning.save"), self.save, say("tuning.save_hint"), strong=True),
            ],
        ]
        self.form.set_rows(rows)

    def _others(self) -> list[list[Widget]]:
        """What is laid over the preset, and what it is compared with."""
        say = self.words.say
        return [
            [
                Selector(
                    say("tuning.conditions"),
                    lambda: [NOTHING, *conditions()],
                    self._conditions,
                    self.tuning.condition,
                    say("tuning.conditions_hint"),
                    self._condition,
                )
            ],
            [
                Selector(
                    say("tuning.compare"),
                    lambda: [NOTHING, *filter(self.tuning.has_room_on, presets())],
                    self._compared,
                    self.tuning.compare,
                    say("tuning.compare_hint"),
                    lambda name: say("tuning.nothing") if name == NOTHING else self._title(name),
                )
            ],
        ]

    def _tables(self) -> list[list[Widget]]:
        """On the page of that name: the presets, to play on another."""
        say = self.words.say
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
        return preset_title(self.words, name, self._titles[name])

    def _conditions(self) -> str:
        return ", ".join(self._table.conditions) or NOTHING

    def _open(self, page: str) -> None:
        self.page = page
        self.fill()

    def _widget(self, name: str, knob: Knob) -> Widget:
        say = self.words.say
        label = say(f"knob.{name}")
        doc = self.words.say_or(f"knob.{name}_hint", knob.doc)
        if knob.choices:
            return Selector(
                label,
                lambda: knob.choices,
                lambda: str(self._value(name)),
                lambda value: self.tuning.turn(name, value),
                doc,
                lambda value: self.words.say_or(f"choice.{value}", value),
            )
        return Slider(
            label,
            knob,
            lambda: float(self._value(name)),
            lambda value: self.tuning.turn(name, value),
            lambda: self.tuning.reset(name),
            say(
                "tuning.range",
                doc=doc,
                lo=self.words.number(knob.lo, "g"),
                hi=self.words.quantity(knob.hi, "g", knob.unit),
            ),
            lambda value: self.words.quantity(value, ".4g", knob.unit),
        )

    def _knobs(self) -> list[tuple[str, Knob, float | str]]:
        return list(walk(self._table.knobs))

    def _value(self, name: str) -> float | str:
        value: object = self._table.knobs
        for part in name.split("."):
            value = getattr(value, part)
        assert isinstance(value, (float, str))
        return value

    def _summary(self) -> str:
        say = self.words.say
        table = self._table
        changed = len(table.set)
        parts = [table_title(self.words, table), *map(self._condition, table.conditions)]
        return f"{', '.join(parts)}; {say('tuning.turned', count=changed) if changed else say('tuning.unturned')}"

    def _compared(self) -> str:
        return NOTHING if self.tuning.compared is None else self.tuning.compared.source

    def _condition(self, name: str) -> str:
        """Conditions as they are told; one's own by their file's name."""
        return self.words.say("tuning.usual") if name == NOTHING else self.words.say_or(f"condition.{name}", name)
