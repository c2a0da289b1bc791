"""What a player does at the table, measured piece by piece: each piece is a task of its own, and the same anywhere."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from datetime import date
from statistics import fmean
from typing import Final, NamedTuple, TypeAlias

from ...game.match import Match
from ...game.rules.pool.nine_ball import NineBall
from ...game.setup import Setup
from ...game.tally import Tally
from ...study.crew import Crew
from ...table.preset import load_table
from ..player import Player, Rates
from ..playing import played_out
from .pot_set import SHOTS, pots_in
from .ten_racks import RACKS, one_rack
from .visits import potted, visit

POOL, CAROM, SNOOKER = "pool-9ft", "carom-10ft", "snooker-12ft"
# Shots of the set in one piece; visits to the table in a match that is looked at.
_SHOTS: Final = 10
_INNINGS: Final = 8
# So many times ten racks: the balls of one ten differ by a dozen from those of the next.
_TENS: Final = 4


class Piece(NamedTuple):
    """What one task found: a count, and a second where there is one."""

    made: float
    second: float = 0.0


def _pots(player: Player, seed: int, number: int) -> Piece:
    return Piece(pots_in(load_table(POOL), player, seed, number * _SHOTS, _SHOTS))


def _rack(player: Player, seed: int, number: int) -> Piece:
    return Piece(one_rack(load_table(POOL), player, seed, number))


def _run(player: Player, seed: int, number: int) -> Piece:
    """The balls of a visit at nine-ball that begins with the break, and whether it wins the rack."""
    rules = NineBall(load_table(POOL))
    begun = rules.start(0, 1000 * seed + number)
    return Piece(*map(float, potted(rules, visit(rules, begun, player, f"nine-ball {seed} {number}"))))


def _three_cushion(player: Player, seed: int, number: int) -> Piece:
    """The points and the innings of the first visits of a match against oneself."""
    tallies = _tallies(CAROM, "three-cushion", player, seed, number)
    return Piece(sum(tally.points for tally in tallies), sum(tally.innings for tally in tallies))


def _snooker(player: Player, seed: int, number: int) -> Piece:
    return Piece(max(tally.best for tally in _tallies(SNOOKER, "snooker", player, seed, number)))


def _tallies(table: str, game: str, player: Player, seed: int, number: int) -> tuple[Tally, ...]:
    """The players' numbers after so many visits to the table, or at the end of the match."""
    match = Match(load_table(table), Setup(game, breaker=0, seed=1000 * seed + number))
    for _ in played_out(match, (player, player), f"{game} {seed} {number}"):
        if sum(tally.innings for tally in match.now.tallies) > _INNINGS:
            return match.history[-2].tallies
    return match.now.tallies


# What is measured, in how many pieces.
Find: TypeAlias = Callable[[Player, int, int], Piece]
PIECES: Final[Mapping[Find, int]] = {
    _rack: _TENS * RACKS, _pots: SHOTS // _SHOTS, _run: 20, _three_cushion: 2, _snooker: 2,
}  # fmt: skip
TOTAL: Final = sum(PIECES.values())


def measured(player: Player, seed: int, crew: Crew, how: str) -> Rates:
    """What a player does, by tasks that are done by a crew."""
    jobs = [(find, player, seed, number) for find, count in PIECES.items() for number in range(count)]
    found = crew.each(_done, jobs)
    parts = {find: [piece for job, piece in zip(jobs, found, strict=True) if job[0] is find] for find in PIECES}
    return _rates(parts, how)


def _done(find: Find, player: Player, seed: int, number: int) -> Piece:
    return find(player, seed, number)


def _rates(parts: Mapping[Find, Sequence[Piece]], how: str) -> Rates:
    innings = sum(piece.second for piece in parts[_three_cushion])
    return Rates(
        when=date.today().isoformat(),
        how=how,
        balls=_sum(parts[_rack]) / _TENS,
        pots=100.0 * _sum(parts[_pots]) / SHOTS,
        run=round(fmean(piece.made for piece in parts[_run]), 2),
        break_and_runs=round(100.0 * fmean(piece.second for piece in parts[_run]), 1),
        three_cushion=round(_sum(parts[_three_cushion]) / max(1.0, innings), 2),
        snooker_break=max(piece.made for piece in parts[_snooker]),
    )


def _sum(pieces: Sequence[Piece]) -> float:
    return sum(piece.made for piece in pieces)
