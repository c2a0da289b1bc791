"""A match that is being agreed on, without a window: the game and its options, the table, the race, who breaks."""

from __future__ import annotations

import random
from contextlib import suppress
from functools import cached_property

from ...config.knobs import walk
from ...config.settings import Store
from ...errors import InputError
from ...game.rules import GAMES
from ...game.session import PRACTICE
from ...game.setup import BREAKS, COIN, LAG, Setup, can_lag
from ...opponent.player import Player
from ...opponent.player_file import load_player, player_names
from ...table.preset import load_table, presets
from ...table.table import Table

RACES = (*range(1, 16), 17, 19, 21, 25, 35)
# What stands for the table as it is being practised on, where that is not as its preset has it.
TUNED = "*"
# What stands for a person, where who plays is named.
PERSON = ""


class MatchDraft:
    """What is agreed so far. A game and a table that do not go together are brought together by `take_...`.

    `preset` is the table by its preset's name, or TUNED; `sides` are who plays, by the names of files, PERSON for a
    person; `race`, `breaker` and `breaks` are as in a `Setup`. It begins
    with what was agreed for the match before, as `store` has it, or with `table`, on which is practised.
    """

    def __init__(self, store: Store, table: Table) -> None:
        last = store.values.match
        self.sides = [name if name in self.offered else PERSON for name in store.values.players.sides]
        self.preset = last.table or table.source
        game, _, options = last.game.partition(" ")
        self.game = game if game in self.games else ""
        self.race = int(last.race) if last.race in RACES else 1
        self.breaker = int(last.breaker) if last.breaker.is_integer() else COIN
        self.breaks = last.breaks if last.breaks in BREAKS else BREAKS[0]
        self.options: dict[str, float | str] = {}
        self._errors: dict[str, str] = {}
        # A table that was tuned is one more to choose.
        self._tables: dict[str, Table | None] = {TUNED: table} if table.set or table.conditions else {}
        if self.game:
            self.take_game(self.game)
            self.options = _understood(options, self.game)
        else:
            self.take_table(table.source)

    @property
    def offered(self) -> tuple[str, ...]:
        """Who may play a side: a person, and all players, the weakest first."""
        return (PERSON, *self._players)

    def player(self, side: int) -> Player | None:
        """Who plays a side; None for a person."""
        return self.player_of(self.sides[side])

    def player_of(self, name: str) -> Player | None:
        """A player by the name of a file; None for a person."""
        return self._players.get(name)

    @cached_property
    def _players(self) -> dict[str, Player]:
        """The players whose files can be read."""
        found: dict[str, Player] = {}
        for name in player_names():
            with suppress(InputError):
                found[name] = load_player(name)
        return found

    @property
    def games(self) -> list[str]:
        """What can be played."""
        return [name for name in GAMES if name != PRACTICE]

    @property
    def tables(self) -> list[str]:
        """What the chosen game can be played on; also what cannot be read, so that it can be told why."""
        return [name for name in dict.fromkeys((*presets(), *self._tables)) if self.fits(name)]

    @property
    def breakers(self) -> list[int]:
        """Who may be said to break first, as a setup has them."""
        table = self.table
        lag = table is not None and self.game != "" and can_lag(GAMES[self.game], table)
        return [COIN, *([LAG] if lag else []), 0, 1]

    @property
    def table(self) -> Table | None:
        """The chosen table; None where it cannot be loaded, of which `error` tells why."""
        return self.table_of(self.preset)

    @property
    def error(self) -> str:
        """What is wrong with the chosen table's file; empty where it can be loaded."""
        return "" if self.table is not None else self._errors[self.preset]

    def table_of(self, name: str) -> Table | None:
        """A table by its preset's name; None where it cannot be loaded."""
        if name not in self._tables:
            try:
                self._tables[name] = load_table(name)
            except InputError as error:
                self._errors[name], self._tables[name] = str(error), None
        return self._tables[name]

    def fits(self, name: str, game: str = "") -> bool:
        """Whether a game, or else the one chosen, can be played on a table; so it may be on one that cannot be read."""
        table, rules = self.table_of(name), GAMES.get(game or self.game)
        return table is None or (rules is not None and rules.fits(table))

    # What is chosen.

    def take_table(self, name: str) -> None:
        """Play on this table; where the game cannot be, another one."""
        self.preset = name
        fitting = [game for game in self.games if self.fits(name, game)]
        self.take_game(self.game if self.game in fitting else next(iter(fitting), self.game))

    def take_game(self, name: str) -> None:
        """Play this game; where the table is none for it, on the first that is."""
        if name != self.game:
            self.options = {}
        self.game = name
        if not self.fits(self.preset):
            self.preset = next((table for table in self.tables if self._tables.get(table) is not None), self.preset)
        if self.breaker not in self.breakers:
            self.breaker = COIN

    # What becomes of it.

    def setup(self, names: tuple[str, ...]) -> Setup:
        """The setup of the match, its racks and its coin drawn anew."""
        seed = random.randrange(1 << 30)
        sides = tuple(self.sides)
        return Setup(self.game, self.options, names, self.race, self.breaks, self.breaker, seed, sides)

    def keep(self, store: Store) -> None:
        """Let the next match be set up as this one; a table as it was tuned is gone by then."""
        agreed = {
            "game": " ".join([self.game, *(f"{name}={value}" for name, value in self.options.items())]),
            "table": self.table.source if self.table is not None else "",
            "race": float(self.race),
            "breaker": float(self.breaker),
            "breaks": self.breaks,
        }
        for name, value in agreed.items():
            store.turn(f"match.{name}", value)
        for side, name in zip(("first", "second"), self.sides, strict=True):
            store.turn(f"players.{side}_by", name)


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
