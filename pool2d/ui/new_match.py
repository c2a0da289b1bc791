"""What is agreed before a match: the table, the game and its options, the players, the race, who breaks."""

from __future__ import annotations

import random
from collections.abc import Callable

from ..errors import InputError
from ..game.rules import GAMES, games_for
from ..game.rules.base import YES_NO
from ..game.session import PRACTICE, Session, recorded
from ..game.setup import BREAKS, COIN, LAG, Setup, can_lag
from ..knobs import Knob, walk
from ..preset import load_table, presets, title_of
from ..settings import Store
from ..table import Table
from . import rulings, theme
from .dialog import Dialog
from .field import TextField
from .inputs import Choice
from .scene import Scene
from .widgets import Button, Gap, Heading, Toggle, Widget
from .words import say, say_or

_RACES = tuple(str(frames) for frames in (*range(1, 16), 17, 19, 21, 25, 35))
# What is offered for a number, as far as its range goes.
_LADDER = (*range(11), 12, 15, 20, 25, 30, 35, 40, 50, 60, 75, 80, 100, 125, 150, 200, 250, 300, 400, 500, 750, 1000)
# As many rows as the game with the most options takes, lest the panel jump from one game to the next.
_TALL = 5.0
# What stands for the table as it is being practised on, where that is not as its preset has it.
TUNED = "*"
_SETTINGS = ("players.first", "players.second")


class NewMatch(Dialog):
    """Sets up a match and has it begin. What cannot be played is told, and nothing is lost.

    The names of the players are kept in `store`; `begin` leads to the match.
    """

    width = 64

    def __init__(self, below: Scene, store: Store, table: Table, begin: Callable[[Session], Scene]) -> None:
        super().__init__(below, "", [])
        self.store = store
        self.begin = begin
        self.table = table.source
        self.game = ""
        self.race = "1"
        self.breaker = str(COIN)
        self.breaks = BREAKS[0]
        self.options: dict[str, float | str] = {}
        self.wrong = ""
        # A table that was tuned is one more to choose.
        self._tables: dict[str, Table | None] = {}
        if table.set or table.conditions:
            self._tables[TUNED] = table
        players = store.values.players
        self.fields = [_name_field(number, name) for number, name in enumerate(players.names)]
        self._take_table(self.table)

    @property
    def games(self) -> list[str]:
        """What can be played on the chosen table."""
        table = self._loaded()
        return [] if table is None else [name for name in games_for(table) if name != PRACTICE]

    @property
    def names(self) -> tuple[str, ...]:
        """The players as they are called in the match."""
        given = [field.value.strip() for field in self.fields]
        return tuple(name or field.instead for name, field in zip(given, self.fields, strict=True))

    def start(self) -> None:
        """Begin the match; what speaks against it is told."""
        for name, field in zip(_SETTINGS, self.fields, strict=True):
            self.store.turn(name, field.value.strip())
        table = self._loaded()
        if table is None or not self.game:
            return
        setup = Setup(
            self.game, self.options, self.names, int(self.race), self.breaks, int(self.breaker),
            random.randrange(1 << 30),
        )  # fmt: skip
        try:
            session = recorded(table, setup)
        except InputError as error:
            self.wrong = str(error)
            return
        self.go(self.begin(session))

    # What is on the panel.

    def _lay_out(self) -> None:
        options = self._option_widgets()
        breaks = Choice(
            say("match.breaks"), lambda: BREAKS, lambda: self.breaks, self._take_breaks, "",
            lambda name: say(f"match.breaks_by.{name}"),
        )  # fmt: skip
        self.form.set_rows(
            [
                [Heading(lambda: say("match.title"), theme.TEXT, large=True)],
                [Gap(0.2)],
                [Choice(say("match.table"), self._all_tables, lambda: self.table, self._take_table, shown=self._title)],
                [Choice(say("match.game"), lambda: self.games, lambda: self.game, self._take_game, shown=_game)],
                [Gap(0.2)],
                [*self.fields],
                [Choice(say("match.race"), lambda: _RACES, lambda: self.race, self._take_race, say("match.race_hint"))],
                [Choice(say("match.breaker"), self._breakers, lambda: self.breaker, self._take_breaker, "", self._who)],
                [breaks if self.race != "1" else Gap(breaks.rows)],
                [Gap(0.2)],
                *([widget] for widget in options),
                [Gap(max(0.2, _TALL - sum(widget.rows for widget in options)))],
                [Heading(lambda: self.wrong, theme.WARNING, lines=2)],
                [Button(say("form.cancel"), self._cancel), Button(say("match.start"), self.start, strong=True)],
            ]
        )

    def _option_widgets(self) -> list[Widget]:
        if not self.game:
            return []
        return [self._option(name, knob) for name, knob, _ in walk(GAMES[self.game].options_type())]

    def _option(self, name: str, knob: Knob) -> Widget:
        label, hint = rulings.setting(name), rulings.setting_hint(self.game, name, knob.doc)

        def put(value: float | str) -> None:
            self.options[name] = value

        def get() -> float | str:
            return self.options.get(name, knob.default)

        if knob.choices == YES_NO:
            return Toggle(label, lambda: get() == "yes", lambda on: put("yes" if on else "no"), hint)
        if knob.choices:
            return Choice(label, lambda: knob.choices, lambda: str(get()), put, hint, _choice)
        steps = [f"{step}" for step in _LADDER if knob.lo <= step <= knob.hi]
        # What a number means that is none, such as no limit.
        return Choice(
            label, lambda: steps, lambda: f"{float(get()):g}", lambda step: put(float(step)), hint,
            lambda step: say_or(f"option.{name}_{step}", step),
        )  # fmt: skip

    # What is chosen.

    def _take_table(self, name: str) -> None:
        self.table, self.wrong = name, ""
        games = self.games
        if not games and not self.wrong:
            self.wrong = say("match.no_game")
        self._take_game(self.game if self.game in games else next(iter(games), ""))

    def _take_game(self, name: str) -> None:
        if name != self.game:
            self.options = {}
        self.game = name
        if self.breaker not in self._breakers():
            self.breaker = str(COIN)
        self._lay_out()

    def _take_race(self, race: str) -> None:
        self.race = race
        self._lay_out()

    def _take_breaker(self, breaker: str) -> None:
        self.breaker = breaker

    def _take_breaks(self, breaks: str) -> None:
        self.breaks = breaks

    def _loaded(self) -> Table | None:
        """The chosen table; None, and what is wrong with it told, where it cannot be loaded."""
        if self._tables.get(self.table) is None:
            try:
                self._tables[self.table] = load_table(self.table)
            except InputError as error:
                self.wrong = str(error)
                self._tables[self.table] = None
        return self._tables[self.table]

    def _all_tables(self) -> list[str]:
        return list(dict.fromkeys((*presets(), *self._tables)))

    def _title(self, name: str) -> str:
        """The name of a table as its preset has it; that of the preset where it cannot be read."""
        table = self._tables.get(name)
        if name == TUNED and table is not None:
            return say("match.tuned", table=rulings.table_title(table))
        return rulings.preset_title(name, title_of(name) if table is None else table.title)

    def _breakers(self) -> list[str]:
        """Who may be said to break first, as a setup has them."""
        table = self._loaded()
        lag = table is not None and self.game != "" and can_lag(GAMES[self.game], table)
        return [str(who) for who in (COIN, *([LAG] if lag else []), 0, 1)]

    def _who(self, breaker: str) -> str:
        if breaker == str(COIN):
            return say("match.coin")
        return say("match.lag") if breaker == str(LAG) else self.names[int(breaker)]

    def _cancel(self) -> None:
        self.done = True


def _name_field(player: int, value: str) -> TextField:
    name = _SETTINGS[player]
    field = TextField(say(f"setting.{name}"), value)
    field.hint = say(f"setting.{name}_hint")
    field.instead = say("match.player", number=player + 1)
    return field


def _game(name: str) -> str:
    return rulings.title(name) if name else ""


def _choice(value: str) -> str:
    return say(f"choice.{value}")
