"""Safeties by where the cue ball comes to rest, and kicks at balls that cannot be seen."""

from __future__ import annotations

from dataclasses import replace

import pytest

from pool2d import Layout, load_table
from pool2d.game.judging import judged
from pool2d.opponent.candidate import Candidate
from pool2d.opponent.candidates.find import candidates
from pool2d.opponent.candidates.kicks import kicks
from pool2d.opponent.candidates.safeties import hidden, safeties
from pool2d.opponent.player import Judgement
from pool2d.opponent.turn import Turn

from .test_by_another import SURE, turn_of

TABLE = load_table("pool-9ft")
BEHIND = {"cue": (0.6, 0.6), "1": (1.6, 0.6), "7": (0.75, 0.6), "8": (0.74, 0.68), "9": (0.74, 0.52)}
OPEN = {"cue": (0.6, 0.6), "1": (1.0, 0.7), "7": (1.9, 0.9), "8": (1.9, 0.8), "9": (1.9, 0.7)}


def left(turn: Turn, plan: Candidate) -> float:
    found = judged(turn.rules, turn.state, turn.layout, plan.stroke)
    return hidden(turn, found.ruling.layout, "cue", ["1"])


def test_a_cue_ball_leaves_less_behind_a_ball_and_further_away() -> None:
    turn = turn_of(SURE, OPEN)

    def at(**places: tuple[float, float]) -> float:
        layout: Layout = turn_of(SURE, {**OPEN, **places}).layout
        return hidden(turn, layout, "cue", ["1"])

    assert at(cue=(2.2, 0.3), **{"1": (1.5, 0.2)}) < at(cue=(2.2, 0.3), **{"1": (0.5, 0.2)})
    assert at(cue=(2.2, 0.8), **{"1": (0.5, 0.8)}) == 1.0
    assert at(cue=(2.2, 0.3)) + 0.1 < at(cue=(2.511, 0.3)) < 1.0


def test_the_first_safeties_leave_less_than_the_last_looked_at() -> None:
    turn = turn_of(SURE, OPEN)
    few, many = list(safeties(turn, turn.layout, "cue", 4)), list(safeties(turn, turn.layout, "cue", 24))
    assert len(few) == 4
    assert left(turn, many[0]) >= left(turn, many[-1])
    assert max(left(turn, plan) for plan in few) >= 0.9
    assert not list(safeties(turn, turn.layout, "cue", 0))


@pytest.mark.parametrize("name", ["pool-9ft", "l-shape"])
def test_a_ball_that_cannot_be_seen_is_met_by_the_cushions(name: str) -> None:
    turn = turn_of(SURE, BEHIND, load_table(name))
    plans = list(kicks(turn, turn.layout, "cue", 20))
    assert plans
    met = [judged(turn.rules, turn.state, turn.layout, plan.stroke).report.first for plan in plans]
    assert met.count(("1",)) > 0.8 * len(met)


def test_ways_by_cushions_find_what_a_coarse_look_round_does_not() -> None:
    """Five directions are 72 degrees apart: by them alone nothing is met."""
    turn = turn_of(SURE, BEHIND)
    assert [plan for plan in kicks(turn, turn.layout, "cue", 10) if plan.ball == "1"]


def test_nothing_is_found_twice_by_one_who_is_snookered() -> None:
    turn = turn_of(replace(SURE, judgement=Judgement()), BEHIND)
    strokes = [plan.stroke for plan in candidates(turn)]
    assert strokes
    assert len(strokes) == len(set(strokes))
