"""The rules of the games by name. `game("nine-ball", table)` gives them for a table."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ...errors import InputError, suggest
from ...table import Table
from .base import AIM, CHOOSE, OVER, PLACE, Ask, Choice, Options, Rules, Ruling, State
from .blackball import Blackball
from .eight_ball import EightBall, EightBallState
from .english_eight_ball import EnglishEightBall
from .four_ball import FourBall
from .free_pyramid import FreePyramid
from .nine_ball import NineBall
from .one_pocket import OnePocket
from .practice import Practice
from .six_red import SixRed
from .snooker import Snooker
from .straight import Straight
from .straight_rail import StraightRail
from .ten_ball import TenBall
from .three_cushion import ThreeCushion
from .words import Note, label, say

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


def game(name: str, table: Table, options: Mapping[str, object] | None = None) -> Rules[Any]:
    """The rules of a game on a table.

    Raises InputError for an unknown game or option, and for a table that it cannot be played on.
    """
    if name not in GAMES:
        raise InputError("game", "name", name, suggest(name, GAMES))
    return GAMES[name](table, options)


def games_for(table: Table) -> list[str]:
    """The names of the games that can be played on a table."""
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
