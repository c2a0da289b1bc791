"""What the matches of two players come to together."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from statistics import median
from typing import Any

from .contest import ContestOutcome, Performance


@dataclass(slots=True)
class DuelScore:
    """What several matches came to; in those that are neither's, nobody has won."""

    matches: int = 0
    illegal: int = 0
    wins: list[int] = field(default_factory=lambda: [0, 0])
    sides: tuple[Performance, Performance] = field(default_factory=lambda: (Performance(), Performance()))

    def add(self, outcome: ContestOutcome) -> None:
        """Count one more match."""
        self.matches += 1
        self.illegal += outcome.illegal
        if outcome.winner >= 0:
            self.wins[outcome.winner] += 1
        for mine, more in zip(self.sides, outcome.sides, strict=True):
            mine.add(more)

    def as_dict(self) -> dict[str, Any]:
        """The score in JSON's types; seconds are those of the stroke amid all, and the longest."""
        columns = {name: [getattr(side, name) for side in self.sides] for name in ("pots", "attempts", "fouls")}
        seconds = [list(pace(side)) for side in self.sides]
        return {"wins": self.wins, "illegal": self.illegal, "seconds_per_shot": seconds, **columns}


def pace(side: Performance) -> tuple[float, float]:
    """How long a player thought: the median and the longest of all decisions, s."""
    taken = side.seconds or [0.0]
    return round(median(taken), 4), round(max(taken), 4)


def scored(outcomes: Iterable[ContestOutcome]) -> DuelScore:
    """What matches come to."""
    score = DuelScore()
    for outcome in outcomes:
        score.add(outcome)
    return score
