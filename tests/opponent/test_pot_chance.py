"""How much a ball's direction strays, and the chance that it goes in all the same."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pool2d.opponent.pot_chance import Spread, strays, within
from pool2d.opponent.stray import AIM, Hand

RADIUS = 0.028575
PLAIN = Spread(turn=0.0, throw=0.0, usual=1.0)


def strayed(hand: Hand, lead: float, cut: float, fitted: Spread = PLAIN) -> float:
    return float(strays(hand, RADIUS, np.array(lead), np.array(math.radians(cut)), fitted))


def test_an_error_of_aim_grows_with_the_distance_over_two_radii_and_the_cosine_of_the_cut() -> None:
    assert strayed(Hand(1.0), 1.0, 0.0) == pytest.approx(math.radians(AIM) / (2.0 * RADIUS), rel=1e-3)
    assert strayed(Hand(1.0), 1.0, 60.0) == pytest.approx(2.0 * strayed(Hand(1.0), 1.0, 0.0), rel=1e-3)
    assert strayed(Hand(2.0), 0.5, 0.0) == pytest.approx(strayed(Hand(1.0), 1.0, 0.0), rel=1e-3)


def test_throw_strays_even_where_the_cue_ball_has_no_way_to_go() -> None:
    throw = Spread(turn=0.0, throw=0.2, usual=1.0)
    assert strayed(Hand(1.0, 1.0), 0.0, 0.0, throw) > 2.0 * strayed(Hand(1.0, 0.0), 0.0, 0.0, throw)


def test_who_never_strays_is_still_no_truer_than_an_aim() -> None:
    steady = Hand(0.0, 0.0, 0.0, 0.0)
    assert 0.0 < strayed(steady, 2.0, 70.0, Spread(0.1, 0.2, 1.2)) < 1e-3
    assert within(math.radians(1.0), strayed(steady, 2.0, 70.0)) == pytest.approx(1.0)


def test_the_chance_is_that_of_a_normal_distribution() -> None:
    assert within(1.0, 1.0) == pytest.approx(0.6827, abs=1e-4)
    assert within(1.96, 1.0) == pytest.approx(0.95, abs=1e-4)
