"""Cannons: on tables without pockets players find strokes that score, by whatever the rules count."""

from __future__ import annotations

import pytest

from pool2d import Ball, Layout, load_table
from pool2d.game import GAMES, Stroke, game
from pool2d.game.judging import judged
from pool2d.game.rules import Ruling
from pool2d.opponent.candidates.cannons import cannons
from pool2d.opponent.candidates.find import candidates
from pool2d.opponent.deciding import decide
from pool2d.opponent.player import Judgement, Player
from pool2d.opponent.stray import Hand
from pool2d.opponent.turn import Turn

TABLE = load_table("carom-10ft")
SURE = Player(
    "sure", hand=Hand(0.0, 0.0, 0.0, 0.0), judgement=Judgement(cannons=200, few=2, runs=1, safeties=2, kicks=0)
)
POCKETLESS = [name for name, rules in GAMES.items() if "carom" in rules.__module__]


@pytest.mark.parametrize("name", POCKETLESS)
def test_the_opening_scores(name: str) -> None:
    rules = game(name, TABLE)
    ruling = rules.start()
    decision = decide(rules, ruling, SURE, "a")
    if decision.stroke is None:
        ruling = rules.choose(ruling.state, ruling.layout, decision.actions[0])  # type: ignore[arg-type]
        decision = decide(rules, ruling, SURE, "a")
    assert isinstance(decision.stroke, Stroke)
    assert judged(rules, ruling.state, ruling.layout, decision.stroke).ruling.points[0] > 0


def lying(cue: tuple[float, float], other: tuple[float, float], red: tuple[float, float]) -> Ruling:
    rules = game("three-cushion", TABLE)
    state = rules.aim(rules.start().state, 0)  # type: ignore[attr-defined]
    names = ("cue", TABLE.furniture.groups["other"][0], "red")
    return Ruling(state, Layout(Ball(name, *place) for name, place in zip(names, (cue, other, red), strict=True)))


def test_every_cannon_that_is_told_scores_and_the_surest_comes_first() -> None:
    ruling = lying((0.5, 0.7), (2.0, 1.2), (0.3, 0.2))
    turn = Turn(game("three-cushion", TABLE), ruling, SURE)
    found = list(cannons(turn, ruling.layout, "cue", 500))
    assert found
    assert [plan.prior for plan in found] == sorted((plan.prior for plan in found), reverse=True)
    for plan in found:
        assert judged(turn.rules, ruling.state, ruling.layout, plan.stroke).ruling.points[0] == 1


def test_a_hand_that_strays_holds_the_same_cannon_for_less_likely() -> None:
    ruling = lying((0.5, 0.7), (2.0, 1.2), (0.3, 0.2))
    rules = game("three-cushion", TABLE)
    chances = []
    for aim in (0.5, 8.0):
        turn = Turn(rules, ruling, Player("", hand=Hand(aim)))
        chances.append(max(plan.prior for plan in cannons(turn, ruling.layout, "cue", 500)))
    assert 1.0 > chances[0] > chances[1] > 0.0


def test_who_knows_no_english_plays_none_and_who_looks_for_no_cannon_finds_none() -> None:
    ruling = lying((0.5, 0.7), (2.0, 1.2), (0.3, 0.2))
    rules = game("three-cushion", TABLE)
    plain = Turn(rules, ruling, Player("", judgement=Judgement(heights=1, sides=1)))
    found = list(cannons(plain, ruling.layout, "cue", 500))
    assert found
    assert {(plan.stroke.shot.side, plan.stroke.shot.height) for plan in found} == {(0.0, 0.0)}
    blind = Turn(rules, ruling, Player("", judgement=Judgement(cannons=0)))
    assert not [plan for plan in candidates(blind) if plan.kind == "cannon"]


def test_nobody_looks_for_cannons_where_there_are_pockets() -> None:
    table = load_table("pool-9ft")
    turn = Turn(game("nine-ball", table), game("nine-ball", table).start(), SURE)
    assert not [plan for plan in candidates(turn) if plan.kind == "cannon"]


def test_a_starting_spot_is_not_changed_for_the_other_and_back_without_end() -> None:
    rules = game("three-cushion", TABLE)
    player = Player(
        "weak", hand=Hand(5.0, 5.0, 5.0, 5.0), judgement=Judgement(cannons=20, few=1, runs=2, safeties=1, kicks=0)
    )
    ruling, choices = rules.start(), 0
    while not isinstance(action := decide(rules, ruling, player, "a").actions[0], Stroke):
        ruling, choices = rules.choose(ruling.state, ruling.layout, action), choices + 1  # type: ignore[arg-type]
        assert choices < 2
