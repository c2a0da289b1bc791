"""What is counted of a player through a match."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from .rules import Rules, Ruling
from .rules.report import Report


@dataclass(frozen=True, slots=True)
class Tally:
    """One player's numbers.

    `innings` counts visits to the table. `run` is what the last strokes of the present visit have brought, in
    points, or in balls where the game has no points; `best` the highest of the match. `pots` are the balls that count
    (`Rules.pots`). `points` are those of all frames.
    """

    frames: int = 0
    points: int = 0
    strokes: int = 0
    innings: int = 0
    pots: int = 0
    fouls: int = 0
    run: int = 0
    best: int = 0


def after_stroke(
    tallies: tuple[Tally, ...], player: int, again: bool, rules: Rules[Any], ruling: Ruling, report: Report
) -> tuple[Tally, ...]:
    """The tallies after a stroke of `player`; `again` where the visit goes on."""
    mine = tallies[player]
    pots = len(rules.pots(player, report, ruling))
    counted = ruling.points[player] if rules.scored else pots
    run = (mine.run if again else 0) + counted if counted > 0 and not ruling.foul else 0
    mine = replace(
        mine,
        strokes=mine.strokes + 1,
        innings=mine.innings + (not again),
        pots=mine.pots + pots,
        fouls=mine.fouls + ruling.foul,
        run=run,
        best=max(mine.best, run),
    )
    changed = (*tallies[:player], mine, *tallies[player + 1 :])
    return tuple(replace(tally, points=tally.points + won) for tally, won in zip(changed, ruling.points, strict=True))


def after_frame(tallies: tuple[Tally, ...], winner: int | None) -> tuple[Tally, ...]:
    """The tallies once a frame is over."""
    return tuple(replace(tally, frames=tally.frames + (i == winner)) for i, tally in enumerate(tallies))
