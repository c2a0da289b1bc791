"""What positions are worth."""

from __future__ import annotations

import pytest

from pool2d.opponent.worth import chance_to_win


def test_who_has_no_ball_left_has_won() -> None:
    assert chance_to_win(0.5, 0, 3) == 1.0
    assert chance_to_win(0.5, 3, 0) == 0.0


@pytest.mark.parametrize("p", [0.1, 0.5, 0.9])
def test_with_one_ball_each_it_is_a_duel_of_single_shots(p: float) -> None:
    # Who shoots first wins p + (1-p)^2 p + (1-p)^4 p + ...
    assert chance_to_win(p, 1, 1) == pytest.approx(p / (1.0 - (1.0 - p) ** 2))


@pytest.mark.parametrize("p", [0.2, 0.7])
@pytest.mark.parametrize(("n", "m"), [(1, 4), (3, 3), (5, 2)])
def test_it_satisfies_its_own_equation(p: float, n: int, m: int) -> None:
    again = p * chance_to_win(p, n - 1, m) + (1.0 - p) * (1.0 - chance_to_win(p, m, n))
    assert chance_to_win(p, n, m) == pytest.approx(again)


def test_fewer_balls_and_a_surer_hand_win_more() -> None:
    assert chance_to_win(0.7, 2, 4) > chance_to_win(0.7, 3, 4) > chance_to_win(0.7, 3, 3)
    assert chance_to_win(0.9, 7, 7) > chance_to_win(0.5, 7, 7) > 0.5
