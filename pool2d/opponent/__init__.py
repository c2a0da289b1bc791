"""Somebody to play against: a hand that misses, shots found by geometry and refined on the engine, and judgement.

The names are fetched when they are first asked for.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..lazy import fetched

if TYPE_CHECKING:
    from .contests.odds import Chance, chances
    from .deciding import Decision, decide
    from .player import Judgement, Player, Taste
    from .stray import Hand
else:
    __getattr__, __dir__ = fetched(
        __name__,
        {
            "contests.odds": ("Chance", "chances"),
            "deciding": ("Decision", "decide"),
            "player": ("Judgement", "Player", "Taste"),
            "stray": ("Hand",),
        },
    )

__all__ = ["Chance", "Decision", "Hand", "Judgement", "Player", "Taste", "chances", "decide"]
