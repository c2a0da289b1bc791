"""The numbers of a player through a match: frames, points, strokes, runs."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from .rules import Rules, Ruling
from .rules.report import Report


@dataclass(frozen=True, slots=True)
class Tally:
    """The numbers of one player through a match.

    `innings` are visits to the table. `run` is what the present visit has made without a break, in points, or in
    balls where the game has none; `best` the highest run. `pots` are the balls that count as potted (`Rules.pots`).
    `points` are those of all frames.
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
    """The tallies after a stroke of `player`; `again` where the visit to the table goes on from the stroke before."""
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
