"""Pots that are not straight: banks, kicks, combinations, caroms and kisses, found on any table and played."""

from __future__ import annotations

import random
from dataclasses import replace
from typing import TypeAlias

import pytest

from pool2d import Ball, Layout, Table, load_table
from pool2d.game import game
from pool2d.game.judging import judged
from pool2d.game.rules import Ruling
from pool2d.opponent.candidate import Candidate
from pool2d.opponent.candidates.banks import banks, potting_kicks
from pool2d.opponent.candidates.combinations import combinations_of
from pool2d.opponent.candidates.find import candidates
from pool2d.opponent.candidates.routed import routed
from pool2d.opponent.deciding import decide
from pool2d.opponent.player import Judgement, Player
from pool2d.opponent.stray import Hand
from pool2d.opponent.turn import Turn

TABLE = load_table("pool-9ft")
Places: TypeAlias = dict[str, tuple[float, float]]
SURE = Player("sure", hand=Hand(0.0, 0.0, 0.0, 0.0), judgement=Judgement(paces=2, sides=1, runs=1, safeties=4, kicks=0))
BLIND = replace(SURE, judgement=replace(SURE.judgement, banks=0, combinations=0))


def turn_of(player: Player, places: Places, table: Table = TABLE, on: tuple[str, ...] = ("1",)) -> Turn:
    """A turn at nine-ball with the balls where they are named."""
    rules = game("nine-ball", table)
    layout = Layout(Ball(name, *place) for name, place in places.items())
    state = rules.to_play(replace(rules.start().state, shots=1), layout, 0, on=on)
    return Turn(rules, Ruling(state, layout), player)


def falls(turn: Turn, plan: Candidate) -> bool:
    report = judged(turn.rules, turn.state, turn.layout, plan.stroke).report
    return (plan.ball, plan.pocket) in report.pots


# In none of them does a straight line lie open.
ONLY = {
    "bank": {"cue": (0.82, 0.32), "1": (0.76, 0.14), "5": (1.91, 0.52), "7": (2.11, 0.5), "9": (2.38, 1.03)},
    "kick": {"cue": (2.28, 1.13), "1": (2.27, 0.56), "5": (2.0, 0.41), "7": (0.83, 0.52), "9": (2.32, 1.08)},
    "combination": {"cue": (0.26, 1.15), "1": (0.12, 0.89), "9": (0.11, 0.35)},
}


@pytest.mark.parametrize("kind", ONLY)
def test_where_only_one_kind_of_pot_is_good_it_is_played_and_falls(kind: str) -> None:
    turn = turn_of(SURE, ONLY[kind])
    found = decide(turn.rules, turn.ruling, SURE, "a").weighed[0]
    assert found.candidate.kind == kind
    assert falls(turn, found.candidate)


@pytest.mark.parametrize("kind", ONLY)
def test_who_does_not_know_a_kind_does_not_play_it(kind: str) -> None:
    turn = turn_of(BLIND, ONLY[kind])
    assert not [plan for plan in candidates(turn) if plan.kind == kind]


def test_the_cue_ball_comes_off_the_ball_on_into_the_nine_and_wins() -> None:
    turn = turn_of(SURE, {"cue": (0.83, 0.15), "1": (1.17, 0.25), "9": (1.13, 0.39)})
    plans = [plan for plan in candidates(turn) if plan.kind == "carom" and plan.ball == "9"]
    assert any(falls(turn, plan) for plan in plans)
    won = [judged(turn.rules, turn.state, turn.layout, plan.stroke).ruling.state.winner for plan in plans]
    assert 0 in won


def test_the_ball_on_glances_off_another_into_a_pocket() -> None:
    turn = turn_of(SURE, {"cue": (0.07, 0.1), "1": (1.05, 0.19), "5": (1.81, 0.33)})
    plans = [plan for plan in candidates(turn) if plan.kind == "carom" and plan.ball == "1"]
    assert any(falls(turn, plan) for plan in plans)


def scattered(table: Table, rng: random.Random) -> Places:
    size, layout = table.knobs.table, Layout()
    while len(layout) < 6:
        x, y = rng.uniform(0.0, size.length), rng.uniform(0.0, size.width)
        if table.has_room(x, y, 1.01 * table.knobs.ball.radius, layout):
            layout = layout.put(Ball(("cue", "1", "2", "3", "8", "9")[len(layout)], x, y))
    return {ball.id: (ball.x, ball.y) for ball in layout.values()}


@pytest.mark.parametrize("name", ["pool-9ft", "l-shape"])
def test_wherever_balls_lie_most_of_what_is_found_falls(name: str) -> None:
    table, rng, came = load_table(name), random.Random(5), []
    for _ in range(6):
        turn = turn_of(SURE, scattered(table, rng), table, ("1", "2", "3"))
        on = turn.on("cue")
        for routes in (
            combinations_of(turn, turn.layout, "cue", on, on),
            banks(turn, turn.layout, "cue", on),
            potting_kicks(turn, turn.layout, "cue", on),
        ):
            came += [falls(turn, plan) for plan in routed(turn, turn.layout, "cue", routes, 2)]
    assert len(came) > 20
    assert sum(came) > 0.7 * len(came)


def test_nothing_is_found_twice() -> None:
    turn = turn_of(replace(SURE, judgement=Judgement()), scattered(TABLE, random.Random(8)), TABLE, ("1", "2"))
    strokes = [plan.stroke for plan in candidates(turn)]
    assert len(strokes) == len(set(strokes))
