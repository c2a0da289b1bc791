"""What is agreed before a match: the game and its options, the table, the players, the race, who breaks."""

from __future__ import annotations

import random
from collections.abc import Callable

from ...config.knobs import Knob, walk
from ...config.settings import Store
from ...draw import theme
from ...errors import InputError
from ...game.rules import GAMES
from ...game.rules.base import YES_NO
from ...game.session import PRACTICE, Session, recorded
from ...game.setup import BREAKS, COIN, LAG, Setup, can_lag
from ...table.preset import load_table, presets, title_of
from ...table.table import Table
from ..dialogs.dialog import Dialog
from ..scene import Scene
from ..widgets.field import TextField
from ..widgets.inputs import Selector
from ..widgets.widget import Button, Gap, Heading, Toggle, Widget
from ..wording import ruling_text
from ..wording.words import say, say_or

_RACES = tuple(str(frames) for frames in (*range(1, 16), 17, 19, 21, 25, 35))
# What is offered for a number, as far as its range goes.
_LADDER = (*range(11), 12, 15, 20, 25, 30, 35, 40, 50, 60, 75, 80, 100, 125, 150, 200, 250, 300, 400, 500, 750, 1000)
# As many rows as the game with the most options takes, lest the panel jump from one game to the next.
_TALL = 5.0
# What stands for the table as it is being practised on, where that is not as its preset has it.
TUNED = "*"
_SETTINGS = ("players.first", "players.second")


class NewMatch(Dialog):
    """Sets up a match and has it begin: a game, and a table that it can be played on.

    What cannot be played is told, and nothing is lost. All that is agreed is kept in `store`, and stands there the
    next time; `begin` leads to the match.
    """

    width = 64

    def __init__(self, below: Scene, store: Store, table: Table, begin: Callable[[Session], Scene]) -> None:
        super().__init__(below, "", [])
        self.store = store
        self.begin = begin
        last = store.values.match
        self.preset = last.table or table.source
        game, _, options = last.game.partition(" ")
        self.game = game if game in self.games else ""
        self.race = f"{last.race:g}" if f"{last.race:g}" in _RACES else "1"
        self.breaker = f"{last.breaker:g}"
        self.breaks = last.breaks if last.breaks in BREAKS else BREAKS[0]
        self.options: dict[str, float | str] = {}
        # What went wrong with the last start.
        self.wrong = ""
        self._errors: dict[str, str] = {}
        # A table that was tuned is one more to choose.
        self._tables: dict[str, Table | None] = {}
        if table.set or table.conditions:
            self._tables[TUNED] = table
        players = store.values.players
        self.fields = [_name_field(number, name) for number, name in enumerate(players.names)]
        if self.game:
            self._take_game(self.game)
            self.options = _understood(options, self.game)
            self._fill()
        else:
            self._take_table(table.source)

    @property
    def games(self) -> list[str]:
        """What can be played."""
        return [name for name in GAMES if name != PRACTICE]

    @property
    def tables(self) -> list[str]:
        """What the chosen game can be played on; also what cannot be read, so that it can be told why."""
        return [name for name in dict.fromkeys((*presets(), *self._tables)) if self._fits(name)]

    @property
    def barred(self) -> str:
        """Why no match can start as it is set up; empty where one can."""
        if self._loaded() is None:
            return self._errors[self.preset]
        if self.game and self._fits(self.preset):
            return ""
        table = self._title(self.preset)
        if self.game and any(self._fits(self.preset, game) for game in self.games):
            return say("match.other_game", game=_game(self.game), table=table)
        return say("match.no_game", table=table)

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
        if table is None or self.barred:
            return
        self._keep()
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

    def _keep(self) -> None:
        """Let the next match be set up as this one; a table as it was tuned is gone by then."""
        table = self._loaded()
        agreed = {
            "game": " ".join([self.game, *(f"{name}={value}" for name, value in self.options.items())]),
            "table": table.source if table is not None else "",
            "race": float(self.race),
            "breaker": float(self.breaker),
            "breaks": self.breaks,
        }
        for name, value in agreed.items():
            self.store.turn(f"match.{name}", value)

    # What is on the panel.

    def _fill(self) -> None:
        options = self._option_widgets()
        breaks = Selector(
            say("setting.match.breaks"), lambda: BREAKS, lambda: self.breaks, self._take_breaks,
            say("setting.match.breaks_hint"),
            lambda name: say(f"match.breaks_by.{name}"),
        )  # fmt: skip
        self.form.set_rows(
            [
                [Heading(lambda: say("match.title"), theme.TEXT, large=True)],
                [Gap(0.2)],
                [
                    Selector(
                        say("setting.match.game"),
                        lambda: self.games,
                        lambda: self.game,
                        self._take_game,
                        say("setting.match.game_hint"),
                        _game,
                    )
                ],
                [
                    Selector(
                        say("setting.match.table"),
                        lambda: self.tables,
                        lambda: self.preset,
                        self._take_table,
                        shown=self._title,
                    )
                ],
                [Gap(0.2)],
                [*self.fields],
                [
                    Selector(
                        say("setting.match.race"),
                        lambda: _RACES,
                        lambda: self.race,
                        self._take_race,
                        say("setting.match.race_hint"),
                    )
                ],
                [
                    Selector(
                        say("setting.match.breaker"),
                        self._breakers,
                        lambda: self.breaker,
                        self._take_breaker,
                        say("setting.match.breaker_hint"),
                        self._who,
                    )
                ],
                [breaks if self.race != "1" else Gap(breaks.rows)],
                [Gap(0.2)],
                *([widget] for widget in options),
                [Gap(max(0.2, _TALL - sum(widget.rows for widget in options)))],
                [Heading(lambda: self.wrong or self.barred, theme.WARNING, lines=2)],
                [
                    Button(say("form.cancel"), self._cancel),
                    Button(say("match.start"), self.start, strong=True, barred=lambda: bool(self.barred)),
                ],
            ]
        )

    def _option_widgets(self) -> list[Widget]:
        if not self.game:
            return []
        return [self._option(name, knob) for name, knob, _ in walk(GAMES[self.game].options_type())]

    def _option(self, name: str, knob: Knob) -> Widget:
        label, hint = ruling_text.setting(name), ruling_text.setting_hint(self.game, name, knob.doc)

        def put(value: float | str) -> None:
            self.options[name] = value

        def get() -> float | str:
            return self.options.get(name, knob.default)

        if knob.choices == YES_NO:
            return Toggle(label, lambda: get() == "yes", lambda on: put("yes" if on else "no"), hint)
        if knob.choices:
            return Selector(label, lambda: knob.choices, lambda: str(get()), put, hint, _choice)
        steps = [f"{step}" for step in _LADDER if knob.lo <= step <= knob.hi]
        # What a number means that is none, such as no limit.
        return Selector(
            label, lambda: steps, lambda: f"{float(get()):g}", lambda step: put(float(step)), hint,
            lambda step: say_or(f"option.{name}_{step}", step),
        )  # fmt: skip

    # What is chosen.

    def _take_table(self, name: str) -> None:
        """Play on this table; where the game cannot be, another one."""
        self.preset = name
        fitting = [game for game in self.games if self._fits(name, game)]
        self._take_game(self.game if self.game in fitting else next(iter(fitting), self.game))

    def _take_game(self, name: str) -> None:
        """Play this game; where the table is none for it, on the first that is."""
        if name != self.game:
            self.options = {}
        self.game, self.wrong = name, ""
        if not self._fits(self.preset):
            self.preset = next((table for table in self.tables if self._tables.get(table) is not None), self.preset)
        if self.breaker not in self._breakers():
            self.breaker = str(COIN)
        self._fill()

    def _take_race(self, race: str) -> None:
        self.race = race
        self._fill()

    def _take_breaker(self, breaker: str) -> None:
        self.breaker = breaker

    def _take_breaks(self, breaks: str) -> None:
        self.breaks = breaks

    def _loaded(self) -> Table | None:
        """The chosen table; None, and what is wrong with it told, where it cannot be loaded."""
        return self._table(self.preset)

    def _table(self, name: str) -> Table | None:
        if name not in self._tables:
            try:
                self._tables[name] = load_table(name)
            except InputError as error:
                self._errors[name], self._tables[name] = str(error), None
        return self._tables[name]

    def _fits(self, name: str, game: str = "") -> bool:
        """Whether a game, or else the one chosen, can be played on a table; so it may be on one that cannot be read."""
        table, rules = self._table(name), GAMES.get(game or self.game)
        return table is None or (rules is not None and rules.fits(table))

    def _title(self, name: str) -> str:
        """The name of a table as its preset has it; that of the preset where it cannot be read."""
        table = self._tables.get(name)
        if name == TUNED and table is not None:
            return say("match.tuned", table=ruling_text.table_title(table))
        return ruling_text.preset_title(name, title_of(name) if table is None else table.title)

    def _breakers(self) -> list[str]:
        """Who may be said to break first, as a setup has them."""
        table = self._loaded()
        lag = table is not None and self.game != "" and can_lag(GAMES[self.game], table)
        return [str(player) for player in (COIN, *([LAG] if lag else []), 0, 1)]

    def _who(self, breaker: str) -> str:
        if breaker == str(COIN):
            return say("match.coin")
        return say("match.lag") if breaker == str(LAG) else self.names[int(breaker)]

    def _cancel(self) -> None:
        self.done = True


def _understood(kept: str, game: str) -> dict[str, float | str]:
    """The options of a game as they were kept, as far as they are allowed."""
    knobs = {name: knob for name, knob, _ in walk(GAMES[game].options_type())}
    options: dict[str, float | str] = {}
    for name, _, said in (pair.partition("=") for pair in kept.split()):
        knob = knobs.get(name)
        if knob is not None and knob.choices and said in knob.choices:
            options[name] = said
        elif knob is not None and not knob.choices and said.replace(".", "", 1).isdecimal():
            options[name] = min(max(float(said), knob.lo), knob.hi)
    return options


def _name_field(player: int, value: str) -> TextField:
    name = _SETTINGS[player]
    field = TextField(say(f"setting.{name}"), value)
    field.hint = say(f"setting.{name}_hint")
    field.instead = say("match.player", number=player + 1)
    return field


def _game(name: str) -> str:
    return ruling_text.title(name) if name else ""


def _choice(value: str) -> str:
    return say(f"choice.{value}")
