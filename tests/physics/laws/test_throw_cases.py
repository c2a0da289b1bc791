"""Independent numbers for throw, each with its source in contacts.json, through the engine."""

from __future__ import annotations

import math

import pytest

from pool2d import Table
from pool2d.physics.laws.registry import BALL_LAWS
from pool2d.physics.materials import materials
from pool2d.physics.params import BallKnobs, Physics

from ...casebook import CONTACTS, Case, near
from ...hits import collide_balls, greatest, hit, touching, way
from ...scenes import open_table

cases = CONTACTS.run


def throw(table: Table, cut: float, v: float, topspin: float = 0.0, english: float = 0.0) -> float:
    """By how much the other ball is thrown off the line of centres, toward the cue ball's way, degrees."""
    return cut - way(hit(table, cut, v, topspin, english).other)


@cases("B12")
def test_throw_by_cut(case: Case) -> None:
    given = case["inputs"]
    table = open_table(ball__law="alciatore", ball__restitution=1.0)
    found = [throw(table, cut, given["v_mps"], given["R_omega_x_over_v"]) for cut in given["cut_deg"]]
    assert found == near(case, case["expected"]["throw_deg"])


@cases("B14")
def test_measured_throw_of_the_default_table(case: Case) -> None:
    expected, table = case["expected"], open_table()
    cut = greatest(lambda angle: throw(table, angle, 0.447), 5.0, 80.0)
    assert expected["max_throw_deg"][0] <= throw(table, cut, 0.447) <= expected["max_throw_deg"][1]
    assert expected["cut_of_max_deg"][0] <= cut <= expected["cut_of_max_deg"][1]
    for v in (0.447, 1.341, 3.129):
        assert expected["throw_at_10deg_cut"][0] <= throw(table, 10.0, v) <= expected["throw_at_10deg_cut"][1]


@cases("B16")
def test_gearing_english_throws_nothing(case: Case) -> None:
    expected = case["expected"]
    for law in BALL_LAWS:
        for i, cut in enumerate(case["inputs"]["cut_deg"]):
            ratio = math.sin(math.radians(cut))
            cue, other = touching(cut, 1.5, ratio * 1.5 / BallKnobs().radius)
            spin = cue.wz
            collide_balls(law, cue, other, Physics())
            assert math.degrees(math.atan2(other.vy, other.vx)) - cut == near(case, expected["throw_deg"])
            assert (cue.wz, other.wz) == pytest.approx((spin, 0.0), abs=1e-9)
            # Given to six and four digits; the greatest english is R wz / v = 1.25.
            assert ratio == pytest.approx(expected["R_omega_z_over_v"][i], abs=6e-7)
            assert 80.0 * ratio == pytest.approx(expected["percent_of_max_english"][i], abs=6e-3)


@cases("B17")
def test_friction_falls_with_slip(case: Case) -> None:
    friction = materials(open_table().knobs).ball.friction
    for key, value in case["expected"].items():
        assert friction.at(float(key[3:-1])) == near(case, value)


def test_how_friction_falls_can_be_set() -> None:
    knobs = open_table(ball__friction_a=0.05, ball__friction_b=0.2, ball__friction_c=0.5, ball__cling=2.0).knobs
    friction = materials(knobs).ball.friction
    for slip in (0.0, 0.4, 3.0):
        assert friction.at(slip) == pytest.approx(2.0 * (0.05 + 0.2 * math.exp(-0.5 * slip)))
    level = materials(open_table(ball__law="impulse", ball__friction=0.07, ball__cling=2.0).knobs).ball.friction
    assert level.at(0.0) == level.at(3.0) == pytest.approx(0.14)


@cases("B24")
def test_cling(case: Case) -> None:
    table = open_table(ball__restitution=1.0, ball__cling=2.5)
    found = [throw(table, cut, case["inputs"]["v_mps"]) for cut in case["inputs"]["cut_deg"]]
    assert found == near(case, case["expected"]["throw_deg"])


@cases("B29")
def test_throw_by_inside_english(case: Case) -> None:
    given, table = case["inputs"], open_table(ball__restitution=1.0)
    for key, expected in case["expected"].items():
        english = -1.25 * float(key.removesuffix("%")) / 100.0
        found = [throw(table, cut, given["v_mps"], english=english) for cut in given["cut_deg"]]
        assert found == near(case, expected)
