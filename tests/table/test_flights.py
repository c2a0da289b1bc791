"""Flights: how high, how far, where they land, and what they pass over."""

from __future__ import annotations

import math

import pytest

from pool2d import Ball, Layout, Rollout, Shot, load_table, simulate
from pool2d.physics.strike import hop
from pool2d.table import leaving
from pool2d.table.flights import cleared, flies, flights, jumped

TABLE = load_table("pool-9ft")
RADIUS, MASS = TABLE.knobs.ball.radius, TABLE.knobs.ball.mass
CUE = Ball("cue", 0.7, 0.635)
JUMP = Shot(angle=0.0, speed=3.5, elevation=45.0)


def roll(*balls: Ball, shot: Shot | None = JUMP) -> Rollout:
    return simulate(TABLE, Layout(balls), shot)


def test_the_first_flight_is_as_high_as_the_hop_that_is_told_before_it() -> None:
    first, second, *_ = flights(roll(CUE), "cue")
    _, apex, time, _ = hop(JUMP, MASS, TABLE.physics)
    assert (first.start, first.end) == pytest.approx((0.0, time))
    assert first.apex == pytest.approx(apex, rel=1e-9)
    # Each bounce keeps half of the speed, a quarter of the height.
    assert (second.start, second.apex) == pytest.approx((first.end, apex / 4.0))
    assert first.landing is not None
    assert first.landing.x - CUE.x == pytest.approx(first.length)


def test_a_ball_that_is_met_in_the_air_ends_the_flight_before_it_lands() -> None:
    first = flights(roll(CUE, Ball("1", 0.95, 0.635), shot=Shot(0.0, 2.0, elevation=30.0)), "cue")[0]
    assert first.landing is None and first.length < 0.25


def test_a_level_stroke_on_the_cloth_flies_nowhere() -> None:
    level = roll(CUE, shot=Shot(0.0, 3.0))
    assert not flies(level) and flights(level, "cue") == []
    assert flies(roll(CUE))


@pytest.mark.parametrize("beside", [0.0, 0.02, 0.045])
def test_the_gap_to_a_ball_that_is_jumped_is_the_least_there_is(beside: float) -> None:
    rollout = roll(CUE, Ball("2", 1.0, 0.635 + beside))
    first = flights(rollout, "cue")[0]
    (over,) = cleared(rollout, TABLE, first)
    gaps = []
    for i in range(20001):
        ball = rollout.ball_at("cue", first.start + (first.end - first.start) * i / 20000)
        gaps.append(math.dist((ball.x, ball.y, ball.z), (1.0, 0.635 + beside, 0.0)) - 2.0 * RADIUS)
    assert over.ball == "2"
    assert over.gap == pytest.approx(min(gaps), abs=1e-7) and over.gap <= min(gaps) + 1e-12


def test_a_ball_that_lies_aside_is_not_passed_over() -> None:
    rollout = roll(CUE, Ball("2", 1.0, 0.635 + 2.0 * RADIUS + 1e-4), Ball("3", 2.4, 0.635))
    assert cleared(rollout, TABLE, flights(rollout, "cue")[0]) == []


def test_a_ball_that_rolls_through_below_is_passed_over_too() -> None:
    ahead = roll(CUE)
    t = 0.12
    x = ahead.ball_at("cue", t).x
    # It comes from the side, and is under the cue ball just then.
    rollout = roll(CUE, Ball("2", x, 0.635 - 1.5 * t, vy=1.5, wx=-1.5 / RADIUS))
    (over,) = jumped(rollout, TABLE, "cue")
    assert over.ball == "2" and over.t == pytest.approx(t, abs=0.02)
    assert over.gap == pytest.approx(ahead.ball_at("cue", t).z - 2.0 * RADIUS, abs=0.005)


def test_what_is_jumped_is_told_in_order_and_only_until_a_ball_is_met() -> None:
    balls = Ball("3", 0.97, 0.635), Ball("2", 0.9, 0.635), Ball("1", 1.9, 0.635)
    rollout = roll(CUE, *balls, shot=Shot(0.0, 4.3, elevation=45.0))
    assert [one.ball for one in jumped(rollout, TABLE, "cue")] == ["2", "3"]
    low = roll(CUE, *balls, shot=Shot(0.0, 2.0, elevation=20.0))
    assert jumped(low, TABLE, "cue") == ()


def test_a_jump_cue_sends_a_ball_off_by_a_mass_and_a_tip_of_its_own() -> None:
    with_jump_cue = Shot(0.0, 3.5, elevation=45.0, jump=True)
    high = flights(roll(CUE, shot=with_jump_cue), "cue")[0].apex
    assert high == pytest.approx(hop(with_jump_cue, MASS, TABLE.physics)[1], rel=1e-9)
    # 0.28 kg and a restitution of 0.84: 1.145 times the cue's speed, where a playing cue gives 1.316.
    speed = 1.84 * 3.5 / (1.0 + MASS / 0.28)
    assert speed == pytest.approx(1.145 * 3.5, rel=1e-3)
    assert high == pytest.approx((0.5 * speed * math.sin(math.pi / 4.0)) ** 2 / (2.0 * 9.81), rel=1e-9)
    alike = TABLE.with_knobs({"jump_cue.mass": 0.54, "jump_cue.tip_restitution": 0.73})
    own, other = (simulate(alike, Layout([CUE]), shot).digest() for shot in (JUMP, with_jump_cue))
    assert own == other


def test_a_ball_off_the_table_falls_to_the_floor() -> None:
    edge = Ball("8", 2.7, 0.6, vx=2.0, vz=1.0, z=0.1)
    after, speed = leaving.landing(edge, 9.81)
    x, y, z = leaving.place(edge, 9.81, after)
    assert (x, y, z) == pytest.approx((2.7 + 2.0 * after, 0.6, -leaving.BED))
    assert speed == pytest.approx(9.81 * after - 1.0)
    at_rest = Ball("8", 2.7, 0.6, z=0.0363)
    assert leaving.taken_off(at_rest) and leaving.place(at_rest, 9.81, 0.3) == (2.7, 0.6, 0.0363)
