"""Candidates are weighed by what comes of them: the same errors for all, the best first, none twice."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from pool2d import Ball, Layout, load_table, simulate
from pool2d.game import game
from pool2d.game.rules import Choice, Ruling, State
from pool2d.game.rules.base import Rules
from pool2d.opponent.candidates.find import candidates
from pool2d.opponent.candidates.pots import OUTERMOST, varied
from pool2d.opponent.judgement import best, glance, played, weigh
from pool2d.opponent.player import Judgement, Player, Taste
from pool2d.opponent.stray import Hand
from pool2d.opponent.turn import Turn

TABLE = load_table("pool-9ft")
SEES = Judgement(ways=2, paces=2, heights=2, sides=1, few=2, runs=10, safeties=4, kicks=0)
BALLS = Layout([Ball("cue", 1.0, 0.5), Ball("1", 1.6, 0.8), Ball("2", 0.6, 0.9), Ball("9", 2.0, 0.3)])


def turn(hand: Hand, sees: Judgement = SEES) -> Turn:
    rules: Rules[State] = game("nine-ball", TABLE)
    start = rules.start(0, 1).state
    state = replace(start, shots=3, ask=replace(start.ask, where="", on=("1",)))
    return Turn(rules, Ruling(state, BALLS), Player("a", hand=hand, judgement=sees))


def test_a_pot_that_is_varied_is_still_that_pot() -> None:
    here = turn(Hand(0.3))
    first = next(one for one in candidates(here) if one.kind == "pot" and one.stroke.shot.speed > 1.0)
    near = list(varied(TABLE, BALLS, first))
    assert len({one.stroke for one in near} - {first.stroke}) == len(near) >= 6
    for one in near:
        assert math.hypot(one.stroke.shot.side, one.stroke.shot.height) <= OUTERMOST
        fell = simulate(TABLE, BALLS, one.stroke.shot).layout()[one.ball].phase == "pocketed"
        assert fell or one.stroke.shot.speed < first.stroke.shot.speed


def test_the_best_come_first_and_hardly_any_twice() -> None:
    here = turn(Hand(0.5))
    found = best(here, candidates(here), "a")
    values = [one.value for one in found]
    assert values == sorted(values, reverse=True)
    assert {one.runs for one in found} == {10}
    strokes = [one.candidate.stroke for one in found]
    assert len(set(strokes)) == len(strokes)


def test_the_same_seed_weighs_the_same_and_draws_the_same_errors_for_all() -> None:
    here = turn(Hand(2.0))
    first = next(one for one in candidates(here) if one.kind == "pot")
    seen = glance(here, first)
    assert seen is not None
    once, again, other = (weigh(here, seen, 10, seed) for seed in "aab")
    assert once == again != other
    assert once.chance == pytest.approx(weigh(here, replace(seen, value=0.0), 10, "a").chance)


def test_who_never_strays_looks_once_and_who_strays_more_comes_off_less() -> None:
    steady, wild = turn(Hand(0.0, 0.0, 0.0, 0.0)), turn(Hand(8.0, 8.0))
    assert {one.runs for one in best(steady, candidates(steady), "a")} == {1}
    first = next(one for one in candidates(steady) if one.kind == "pot" and one.stroke.shot.speed > 1.0)
    seen = glance(steady, first)
    assert seen is not None and seen.chance > 0.9
    assert weigh(wild, seen, 20, "a").chance < 0.7


def test_a_taste_for_pots_counts_as_often_as_the_pot_comes_off() -> None:
    plain = turn(Hand(3.0, 3.0))
    fond = replace(plain, player=replace(plain.player, taste=Taste(attack=0.5)))
    first = next(one for one in candidates(plain) if one.kind == "pot" and one.stroke.shot.speed > 1.0)
    astray = replace(first, stroke=replace(first.stroke, shot=replace(first.stroke.shot, angle=180.0)))
    for candidate in (first, astray):
        seen, liked = glance(plain, candidate), glance(fond, candidate)
        assert seen is not None and liked is not None
        assert liked.value - seen.value == pytest.approx(0.5 * seen.chance)
        thought, wished = weigh(plain, seen, 10, "a"), weigh(fond, liked, 10, "a")
        assert wished.value - thought.value == pytest.approx(0.5 * thought.chance)
    assert thought.chance == 0.0


def test_a_push_out_is_thought_of_where_it_may_be_said_and_the_other_chooses_after_it() -> None:
    here = turn(Hand(0.0, 0.0, 0.0, 0.0))
    assert not [one for one in candidates(here) if one.kind == "push"]
    ask = replace(here.ask, may=("push",))
    pushing = Turn(here.rules, here.ruling._replace(state=replace(here.state, ask=ask)), here.player)
    found = [one for one in candidates(pushing) if one.kind == "push"]
    assert found and all(one.stroke.call.push for one in found)
    for one in found:
        seen, outcome = glance(pushing, one), played(pushing, one, one.stroke)
        assert seen is not None and outcome is not None
        if not outcome.ruling.foul:
            # Whoever goes on is the other player's to say: what it is worth is the lesser of both.
            options = (
                pushing.rules.choose(outcome.ruling.state, outcome.ruling.layout, Choice(key))
                for key in ("play", "pass")
            )
            assert seen.value == pytest.approx(min(pushing.worth_of(ruling) for ruling in options))
