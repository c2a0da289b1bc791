"""What positions are worth."""

from __future__ import annotations

from dataclasses import replace

import pytest

from pool2d import Ball, Layout, load_table
from pool2d.game import Match, Setup, game
from pool2d.game.rules import Ruling, State
from pool2d.game.rules.base import Rules
from pool2d.game.rules.pool.pool import GroupsState
from pool2d.opponent.stray import Hand
from pool2d.opponent.worth import Race, Scale, chance_in_common, chance_to_win


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


@pytest.mark.parametrize("p", [0.2, 0.7])
@pytest.mark.parametrize("n", [1, 4, 9])
def test_where_the_balls_are_the_same_for_both_it_satisfies_its_own_equation(p: float, n: int) -> None:
    again = p * chance_in_common(p, n - 1) + (1.0 - p) * (1.0 - chance_in_common(p, n))
    assert chance_in_common(p, n) == pytest.approx(again)


def test_with_many_balls_in_common_it_is_even() -> None:
    assert chance_in_common(0.5, 9) == pytest.approx(0.5, abs=1e-4)
    assert chance_in_common(0.8, 1) == pytest.approx(chance_to_win(0.8, 1, 1))
    assert Race(9.0, 9.0, common=True).potted() == Race(8.0, 8.0, common=True)
    assert Race(7.0, 5.0, common=False).potted() == Race(6.0, 5.0, common=False)


def test_a_race_between_whole_balls_lies_between_them() -> None:
    at = [Race(mine, 4.0, common=False).win(0.7) for mine in (3.0, 3.5, 4.0)]
    assert at[1] == pytest.approx(0.5 * (at[0] + at[2]))
    assert at[0] > at[2]


def test_balls_that_have_no_way_to_a_pocket_count_against_who_has_to_pot_them() -> None:
    """Two solids stand together at a stripe beside the rail, or apart; the cue ball has the same open ball."""
    table = load_table("pool-9ft")
    match = Match(table, Setup("eight-ball", breaker=0, seed=1))
    open_table = match.state
    assert isinstance(open_table, GroupsState)
    radius = table.knobs.ball.radius
    apart = {"3": (1.5, 0.9), "4": (1.9, 0.9), "11": (0.4, 0.9)}
    beside = {"3": (1.27, radius), "4": (1.27 + 2.0 * radius, radius), "11": (1.27 + radius, 2.75 * radius)}

    def worth(places: dict[str, tuple[float, float]]) -> float:
        fixed = [Ball("cue", 2.0, 0.6), Ball("1", 2.3, 0.3), Ball("8", 0.6, 0.3)]
        layout = Layout([*fixed, *(Ball(name, x, y) for name, (x, y) in places.items())])
        ask = replace(match.ask, where="", on=("1", "3", "4"), options=())
        state = replace(open_table, shots=1, turn=0, groups=("solid", "stripe"), ask=ask)
        return Scale(match.rules, Hand(), 0.8).value(Ruling(state, layout), 0)

    assert worth(beside) < worth(apart) - 0.02


def test_who_has_nothing_left_to_pot_is_no_surer_than_sure() -> None:
    match = Match(load_table("pool-9ft"), Setup("nine-ball", breaker=0, seed=1))
    layout = Layout([match.layout["cue"]])
    state = replace(match.state, shots=1, turn=0, ask=replace(match.ask, on=(), options=()))
    assert Scale(match.rules, Hand(), 0.8).passed(Ruling(state, layout), 0) == 0.0


@pytest.mark.parametrize("name", ["nine-ball", "eight-ball"])
@pytest.mark.parametrize("rate", [0.3, 0.7, 0.95])
def test_to_break_is_worth_more_than_to_let_the_other_break(name: str, rate: float) -> None:
    rules: Rules[State] = game(name, load_table("pool-9ft"))
    scale = Scale(rules, Hand(0.5), rate)
    mine, theirs = (scale.value(rules.start(player, 3), 0) for player in (0, 1))
    assert mine > 0.5 > theirs
