"""The chances that an opponent sees are those that the engine gives."""

from __future__ import annotations

from statistics import fmean

from benchmarks.chances import Tried, bins, brier, tried
from pool2d.opponent.pot_chance import SPREAD

POTS = [tried(index, seed=3, runs=25) for index in range(48)]


def test_what_is_foretold_is_what_falls() -> None:
    """Of 48 pots 25 times each some 3 in 100 more or less fall by chance; over thousands they differ by less."""
    assert abs(fmean(pot.foretold() for pot in POTS) - fmean(pot.share for pot in POTS)) < 0.06
    score, floor = brier(POTS)
    assert 0.0 < score - floor < 0.03


def test_other_constants_foretell_worse() -> None:
    score, _ = brier(POTS)
    for usual in (0.4 * SPREAD.usual, 2.5 * SPREAD.usual):
        assert brier(POTS, SPREAD._replace(usual=usual))[0] > score + 0.01


def test_each_pot_is_in_one_bin() -> None:
    assert sum(count for count, _, _ in bins(POTS)) == len(POTS)


def test_the_same_number_is_the_same_pot() -> None:
    again: Tried = tried(5, seed=3, runs=25)
    assert again == POTS[5]
