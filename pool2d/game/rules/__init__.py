"""The rules of the games by name. `game("nine-ball", table)` gives them for a table.

A game is a module in one of the families beside this file. It is found there, and need be named nowhere else.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib import import_module
from pkgutil import iter_modules
from typing import Any

from ...errors import InputError, suggest
from ...table.table import Table
from .base import Options, Rules
from .notes import Note, label, say
from .practice import Practice
from .ruling import AIM, CHOOSE, OVER, PLACE, Ask, Choice, Ruling, State


def _found() -> Iterator[type[Rules[Any]]]:
    """Practice, and the games of every family: what a module defines as rules with a title."""
    yield Practice
    families = [f"{__name__}.{family.name}" for family in iter_modules(__path__) if family.ispkg]
    for family in families:
        for entry in iter_modules(import_module(family).__path__):
            module = import_module(f"{family}.{entry.name}")
            for kind in vars(module).values():
                rules = isinstance(kind, type) and issubclass(kind, Rules) and "title" in vars(kind)
                if rules and kind.__module__ == module.__name__:
                    yield kind


GAMES: dict[str, type[Rules[Any]]] = {
    rules.name: rules for rules in sorted(_found(), key=lambda rules: (rules.rank, rules.title))
}
"""The rules of every game, by its name."""


def game(name: str, table: Table, options: Mapping[str, object] | None = None) -> Rules[Any]:
    """The rules of a game on a table.

    Raises InputError for an unknown game or option, and for a table that it cannot be played on.

    Examples:
        >>> from pool2d import load_table
        >>> from pool2d.game import game
        >>> rules = game("nine-ball", load_table("pool-9ft"))
        >>> ruling = rules.start(breaker=0, seed=7)
        >>> ruling.ask.kind, ruling.ask.where, ruling.ask.on
        ('aim', 'kitchen', ('1',))
    """
    if name not in GAMES:
        raise InputError("game", "name", name, suggest(name, GAMES))
    return GAMES[name](table, options)


def games_for(table: Table) -> list[str]:
    """The names of the games that can be played on a table.

    Examples:
        >>> from pool2d import load_table
        >>> from pool2d.game import games_for
        >>> "snooker" in games_for(load_table("snooker-12ft")), "snooker" in games_for(load_table("pool-9ft"))
        (True, False)
    """
    return [name for name, rules in GAMES.items() if rules.fits(table)]


__all__ = [
    "AIM",
    "CHOOSE",
    "GAMES",
    "OVER",
    "PLACE",
    "Ask",
    "Choice",
    "Note",
    "Options",
    "Rules",
    "Ruling",
    "State",
    "game",
    "games_for",
    "label",
    "say",
]
