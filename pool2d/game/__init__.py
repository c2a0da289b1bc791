"""What is played on a table, without a screen.

The names are fetched when they are first asked for, so that who needs one rule does not read them all.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..lazy import fetched

if TYPE_CHECKING:
    from .actions import Concede, NextFrame, Stroke
    from .match import Match
    from .reasons import Fear, Reasons, Thought
    from .referee import observe
    from .rules import GAMES, game, games_for
    from .rules.base import Rules
    from .rules.report import Call, Contact, Report
    from .rules.ruling import Ask, Choice, Ruling, State
    from .setup import Setup
else:
    __getattr__, __dir__ = fetched(
        __name__,
        {
            "actions": ("Concede", "NextFrame", "Stroke"),
            "match": ("Match",),
            "reasons": ("Fear", "Reasons", "Thought"),
            "referee": ("observe",),
            "rules": ("GAMES", "game", "games_for"),
            "rules.base": ("Rules",),
            "rules.report": ("Call", "Contact", "Report"),
            "rules.ruling": ("Ask", "Choice", "Ruling", "State"),
            "setup": ("Setup",),
        },
    )

__all__ = [
    "GAMES",
    "Ask",
    "Call",
    "Choice",
    "Concede",
    "Contact",
    "Fear",
    "Match",
    "NextFrame",
    "Reasons",
    "Report",
    "Rules",
    "Ruling",
    "Setup",
    "State",
    "Stroke",
    "Thought",
    "game",
    "games_for",
    "observe",
]
