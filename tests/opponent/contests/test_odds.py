"""The chance that a shot comes off, by runs with a hand's errors."""

from __future__ import annotations

import math
import pickle

import pytest

from pool2d import Ball, InputError, Layout, Rollout, Shot, load_table
from pool2d.opponent import Chance, Hand, chances
from pool2d.opponent.stray import AIM

TABLE = load_table("pool-9ft")
STEADY = Hand(0.0, 0.0, 0.0, 0.0)
AIM_ONLY = Hand(1.0, 0.0, 0.0, 0.0, 0.0)
# A ball before the side pocket and the cue ball straight behind: a stop shot pots it, hit hard with follow both fall.
STRAIGHT = Layout([Ball("cue", 1.27, 0.4), Ball("1", 1.27, 0.9)])
STOP = Shot(angle=90.0, speed=1.5, height=-0.3)


def test_who_never_strays_always_does_what_was_meant() -> None:
    assert chances(TABLE, STRAIGHT, STOP, STEADY, runs=3) == 1.0
    assert chances(TABLE, STRAIGHT, Shot(angle=60.0, speed=0.5), STEADY, runs=3) == 1.0


def test_a_scratch_is_no_shot_that_comes_off() -> None:
    assert chances(TABLE, STRAIGHT, Shot(angle=90.0, speed=1.5), STEADY, runs=3) == 0.0


def test_an_error_of_aim_meets_a_far_ball_as_often_as_a_normal_distribution_has_it() -> None:
    cue, ball = Ball("cue", 0.3, 0.635), Ball("1", 2.2, 0.635)
    shot, wide = Shot(angle=0.0, speed=0.9), Hand(12.0, 0.0, 0.0, 0.0, 0.0)
    half = math.asin(2.0 * TABLE.knobs.ball.radius / 1.9)
    sure = math.erf(half / (math.sqrt(2.0) * math.radians(12.0 * AIM)))
    chance = chances(TABLE, Layout([cue, ball]), shot, wide, runs=400)
    assert chance.low - 0.03 < sure < chance.high + 0.03
    assert 0.6 < sure < 0.9


def test_a_worse_hand_pots_less_and_the_same_seed_gives_the_same() -> None:
    def chance(aim: float, seed: int = 0) -> Chance:
        return chances(TABLE, STRAIGHT, STOP, Hand(aim, aim), runs=80, seed=seed)

    assert chance(1.0) > chance(6.0) > chance(20.0)
    assert chance(6.0) == chance(6.0)
    assert len({float(chance(6.0, seed)) for seed in range(4)}) > 1


def test_the_caller_may_say_what_comes_off() -> None:
    def never(rollout: Rollout) -> bool:
        return not rollout.events

    assert chances(TABLE, STRAIGHT, STOP, AIM_ONLY, runs=5, came_off=never) == 0.0
    assert chances(TABLE, STRAIGHT, STOP, AIM_ONLY, runs=5, came_off=lambda rollout: not never(rollout)) == 1.0


def test_another_pocket_is_another_shot() -> None:
    """A ball that without errors goes into one pocket and with them falls into another has not come off."""
    layout = Layout([Ball("cue", 0.9, 0.635), Ball("1", 1.27, 1.1)])
    direct = math.degrees(math.atan2(1.1 - 2.0 * 0.028575 - 0.635, 1.27 - 0.9))
    chance = chances(TABLE, layout, Shot(angle=direct, speed=6.0), Hand(40.0), runs=40)
    assert chance < 0.5


def test_a_chance_is_a_number_with_its_interval_and_goes_to_other_processes() -> None:
    chance = Chance(30, 40)
    again = pickle.loads(pickle.dumps(chance))
    assert (again, again.low, again.high, again.runs) == (0.75, chance.low, chance.high, 40)
    assert 0.0 < chance.low < 0.75 < chance.high < 1.0


def test_no_runs_are_refused() -> None:
    with pytest.raises(InputError, match="chances: runs = 0: allowed is a whole number from 1"):
        chances(TABLE, STRAIGHT, STOP, STEADY, runs=0)
