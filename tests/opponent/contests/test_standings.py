"""What wins say, held against closed forms and published numbers."""

from __future__ import annotations

import math

import pytest

from pool2d.opponent.contests.standings import elo, wilson


@pytest.mark.parametrize(
    ("wins", "played", "low", "high"),
    # Brown, Cai and DasGupta 2001, and by hand for the others.
    [(0, 10, 0.0, 0.2775), (10, 10, 0.7225, 1.0), (65, 100, 0.5525, 0.7364), (50, 100, 0.4038, 0.5962)],
)
def test_an_interval_is_wilsons(wins: int, played: int, low: float, high: float) -> None:
    assert wilson(wins, played) == pytest.approx((low, high), abs=5e-5)


def test_of_no_matches_nothing_is_known() -> None:
    assert wilson(0, 0) == (0.0, 1.0)


def test_two_players_are_apart_by_their_odds() -> None:
    one, two = elo([[0, 29], [9, 0]])
    assert one - two == pytest.approx(400.0 * math.log10(29.5 / 9.5))
    assert one + two == pytest.approx(3000.0)


def test_strengths_that_made_the_wins_are_found() -> None:
    true = [1300.0, 1450.0, 1750.0]
    many = 10_000_000
    wins = [[round(many / (1.0 + 10 ** ((b - a) / 400.0))) if a != b else 0 for b in true] for a in true]
    assert elo(wins) == pytest.approx(true, abs=0.01)


def test_who_always_wins_is_not_infinitely_strong() -> None:
    ratings = elo([[0, 10, 10], [0, 0, 10], [0, 0, 0]])
    assert ratings == sorted(ratings, reverse=True)
    assert ratings[0] - ratings[2] < 2000.0


def test_who_has_met_nobody_is_as_good_as_any() -> None:
    assert elo([[0, 0], [0, 0]]) == pytest.approx([1500.0, 1500.0])
