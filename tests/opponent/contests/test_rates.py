"""What is measured of a player comes in pieces, which add up the same whoever does them."""

from __future__ import annotations

import pytest

from pool2d.opponent.contests import rates
from pool2d.opponent.contests.rates import Piece, measured
from pool2d.opponent.player import Player
from pool2d.study.crew import Crew, crew

from .quick_players import WILD


def _counting(player: Player, seed: int, number: int) -> Piece:
    return Piece(float(seed + number), 2.0)


def test_pieces_add_up(monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[int] = []
    monkeypatch.setattr(rates, "_done", lambda find, player, seed, number: _counting(player, seed, number))
    found = measured(WILD, 1, Crew(None, told.append), "by a test")
    # Four times ten racks, ten times ten shots, twenty racks, two matches each: 1 + 2 + ... of them.
    assert (found.balls, found.pots, found.run, found.snooker_break) == (820.0 / 4.0, 55.0, 10.5, 2.0)
    assert (found.break_and_runs, found.three_cushion) == (200.0, 0.75)
    assert (found.how, len(found.when)) == ("by a test", 10)
    assert sum(told) == rates.TOTAL


def test_a_piece_is_the_same_in_another_process() -> None:
    job = (next(iter(rates.PIECES)), WILD, 2, 1)
    with crew(2, lambda count: None) as team:
        assert team.each(rates._done, [job]) == [rates._done(*job)]


@pytest.mark.parametrize("find", rates.PIECES, ids=lambda find: find.__name__)
def test_every_piece_is_measured(find: rates.Find, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rates, "_INNINGS", 2)
    monkeypatch.setattr(rates, "_SHOTS", 1)
    piece = find(WILD, 0, 0)
    assert piece.made >= 0.0
    assert piece.second == 2.0 or piece.second in (0.0, 1.0)
