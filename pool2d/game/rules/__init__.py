"""The rules of the games by name. `game("nine-ball", table)` gives them for a table."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ...errors import InputError, suggest
from ...table.table import Table
from .base import AIM, CHOOSE, OVER, PLACE, Ask, Choice, Options, Rules, Ruling, State
from .carom.four_ball import FourBall
from .carom.straight_rail import StraightRail
from .carom.three_cushion import ThreeCushion
from .notes import Note, label, say
from .pool.blackball import Blackball
from .pool.eight_ball import EightBall, EightBallState
from .pool.english_eight_ball import EnglishEightBall
from .pool.free_pyramid import FreePyramid
from .pool.nine_ball import NineBall
from .pool.one_pocket import OnePocket
from .pool.straight import Straight
from .pool.ten_ball import TenBall
from .practice import Practice
from .snooker.six_red import SixRed
from .snooker.snooker import Snooker

GAMES: dict[str, type[Rules[Any]]] = {
    rules.name: rules
    for rules in (
        EightBall,
        NineBall,
        TenBall,
        Straight,
        OnePocket,
        EnglishEightBall,
        Blackball,
        Snooker,
        SixRed,
        ThreeCushion,
        StraightRail,
        FourBall,
        FreePyramid,
        Practice,
    )
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
    "EightBallState",
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
