"""Independent numbers for a ball and a cushion, each with its source in contacts.json, through the engine.

The cushion lies along +x and beyond +y, as X and Y do in the papers. A rebound is told by the way from
the cushion line: 90 degrees is square, and more comes back to the side it came from.
"""

from __future__ import annotations

import math
import random
from collections.abc import Mapping
from itertools import pairwise
from typing import Any, NamedTuple

import pytest

from pool2d import Ball, Layout, Table, load_table, simulate
from pool2d.physics.body import Body
from pool2d.physics.laws.registry import CUSHION_LAWS
from pool2d.physics.params import BallKnobs, Physics
from pool2d.physics.values import SLIDING

from ...casebook import CONTACTS, Case, near
from ...hits import collide_cushion
from ...scenes import open_table

cases = CONTACTS.run


class Rebound(NamedTuple):
    """The ball as it leaves the cushion, and as it stops sliding; R w over its speed before, as it leaves."""

    ball: Ball
    settled: Ball
    spin: tuple[float, float, float]


def bounce(
    table: Table, incidence: float = 90.0, v: float = 1.0, topspin: float = 0.0, english: float = 0.0
) -> Rebound:
    """A ball into the top cushion at an angle from it, degrees; spins are R w / v, english about the vertical."""
    turn, radius = math.radians(incidence), table.knobs.ball.radius
    vx, vy, spin = v * math.cos(turn), v * math.sin(turn), topspin * v / radius
    return meet(table, vx, vy, -spin * math.sin(turn), spin * math.cos(turn), english * v / radius)


def meet(table: Table, vx: float, vy: float, wx: float, wy: float, wz: float) -> Rebound:
    radius = table.knobs.ball.radius
    # From so near that the cloth has no time to act.
    ball = Ball("cue", 1.5, 4.0 - table.reach(radius) - 1e-9, vx, vy, wx, wy, wz)
    roll = simulate(table, Layout([ball]))
    first = roll.events[0]
    assert (first.kind, first.where) == ("ball_cushion", "top-left")
    after, size = first.after["cue"], radius / math.hypot(vx, vy)
    motion = next(motion for motion in roll.tracks["cue"][1:] if motion.phase != SLIDING)
    return Rebound(after, motion.at(motion.t0), (after.wx * size, after.wy * size, after.wz * size))


def speed(ball: Ball) -> float:
    return math.hypot(ball.vx, ball.vy)


def way(ball: Ball) -> float:
    return math.degrees(math.atan2(-ball.vy, ball.vx))


def snooker(given: Mapping[str, Any]) -> Table:
    """The table of Mathavan's papers."""
    return open_table(
        ball__mass=given["M"], ball__radius=given["R"], cushion__nose_height=given["h"],
        cushion__restitution=given["e"], cushion__friction=given["mu_w"], cloth__mu_slide=given["mu_s"],
        cushion__law="mathavan2010",
    )  # fmt: skip


def han(e: float, mu: float) -> Table:
    """A pool ball under Han's law."""
    nose = 0.635 * 2.0 * BallKnobs().radius
    return open_table(
        cushion__law="han2005", cushion__restitution=e, cushion__friction=mu, cushion__nose_height=nose
    )  # fmt: skip


@cases("C01")
def test_where_the_nose_is_met(case: Case) -> None:
    given, expected = case["inputs"], case["expected"]
    radius = given["R_m"]
    table = open_table(ball__radius=radius, cushion__nose_height=given["h_over_D"] * 2.0 * radius)
    roll = simulate(table, Layout([Ball("cue", 1.5, 3.9, 0.0, 1.0)]), events=1)
    assert 4.0 - roll.events[0].after["cue"].y == near(case, expected["center_to_nose_m"])
    theta = math.acos(table.reach(radius) / radius)
    assert math.sin(theta) == near(case, expected["sin_theta"])
    # Given to four digits.
    assert math.degrees(theta) == pytest.approx(expected["theta_deg"], abs=6e-5)


@cases("C02")
def test_height_of_the_default_nose(case: Case) -> None:
    knobs = load_table("pool-9ft").knobs
    ratio = knobs.cushion.nose_height / (2.0 * knobs.ball.radius)
    for name, value in (("pool_h_over_D", ratio), ("pool_sin", 2.0 * ratio - 1.0)):
        low, high = case["expected"][name]
        assert low <= value <= high


@cases("C03")
def test_rolling_ball_square_into_the_cushion(case: Case) -> None:
    expected = case["expected"]
    for v in (0.1, 1.0, 5.0):
        found = bounce(snooker(case["inputs"]), v=v, topspin=1.0)
        assert speed(found.ball) / v == near(case, expected["v_out_over_v_in"])
        assert found.spin[0] == near(case, expected["R_omega_after_over_v"])
        assert speed(found.settled) / v == near(case, expected["settled_over_v_in"])


@cases("C04")
def test_rebound_by_topspin(case: Case) -> None:
    given, expected, tolerance = case["inputs"], case["expected"], case["tolerance"]
    k = float(case["id"].removeprefix("C04_k"))
    found = [bounce(snooker(given), angle, topspin=k) for angle in given["incident_deg"]]
    for name, balls in (("rebound", [one.ball for one in found]), ("settled", [one.settled for one in found])):
        assert [speed(ball) for ball in balls] == pytest.approx(expected[f"{name}_speed"], abs=tolerance["speed_abs"])
        assert [way(ball) for ball in balls] == pytest.approx(expected[f"{name}_angle_deg"], abs=tolerance["angle_abs"])


@cases("C05")
def test_rebound_by_english(case: Case) -> None:
    given, expected, tolerance = case["inputs"], case["expected"], case["tolerance"]
    k = float(case["id"].removeprefix("C05_k"))
    found = [bounce(snooker(given), angle, topspin=1.0, english=k).ball for angle in given["incident_deg"]]
    assert [speed(ball) for ball in found] == pytest.approx(expected["rebound_speed"], abs=tolerance["speed_abs"])
    assert [way(ball) for ball in found] == pytest.approx(expected["rebound_angle_deg"], abs=tolerance["angle_abs"])


@cases("C08")
def test_cushion_without_friction(case: Case) -> None:
    given = case["inputs"]
    table = open_table(cushion__law="impulse", cushion__restitution=given["e"], cushion__friction=0.0)
    found = [90.0 - way(bounce(table, 90.0 - angle, 2.0).ball) for angle in given["incidence_from_normal_deg"]]
    assert found == near(case, case["expected"]["rebound_from_normal_deg"])


@cases("C09")
def test_han_2005(case: Case) -> None:
    expected, table = case["expected"], han(0.85, 0.2)
    (vx, vy), spins = case["inputs"]["v_XY"], case["inputs"]["R_omega"]
    wx, wy, wz = (value / table.knobs.ball.radius for value in spins)
    found = meet(table, vx, vy, wx, wy, wz)
    assert [found.ball.vx, found.ball.vy] == near(case, expected["v_out_XY"])
    assert list(found.spin) == near(case, expected["R_omega_out"])


@cases("C10")
def test_han_2005_drops_what_goes_up(case: Case) -> None:
    for e, expected in ((0.85, case["expected"]["e_0p85"]), (1.0, case["expected"]["e_1"])):
        assert speed(bounce(han(e, 0.0)).ball) == near(case, expected)


@cases("C15")
def test_default_cushion_takes_half_the_speed(case: Case) -> None:
    table = open_table()
    low, high = case["expected"]["settled_over_in"]
    for v in (0.5, 1.0, 2.0, 4.0):
        assert low <= speed(bounce(table, v=v, topspin=1.0).settled) / v <= high
    # "Nearly none at a shallow angle."
    assert speed(bounce(table, 10.0, topspin=1.0).settled) > 0.9


@cases("C16")
def test_default_cushion_restitution(case: Case) -> None:
    low, high = case["expected"]["e"]
    for topspin in (0.0, 1.0):
        assert low <= speed(bounce(open_table(), topspin=topspin).ball) <= high


@cases("C17")
def test_default_cushions_are_lively(case: Case) -> None:
    table = load_table("pool-9ft")
    roll = simulate(table, Layout([Ball("cue", 0.635, 0.635, 7.0)]))
    far = sum(abs(b[1] - a[1]) for a, b in pairwise(roll.path("cue", 0.001)))
    assert far / case["inputs"]["table_m"][0] >= case["expected"]["table_lengths"][0]


@cases("C19")
@pytest.mark.parametrize("law", CUSHION_LAWS)
def test_cushions_know_no_left_or_right_and_add_nothing(case: Case, law: str) -> None:
    rng, expected = random.Random(19), case["expected"]
    gain, apart = 0.0, 0.0
    # A fiftieth of the number in the case: all of it was tried once, and holds.
    for _ in range(case["inputs"]["random"] // 50):
        vx, vy, wx, wy, wz = rng.uniform(-5.0, 5.0), rng.uniform(0.0, 5.0), *(rng.gauss(0.0, 100.0) for _ in range(3))
        one, two = touching(vx, vy, wx, wy, wz), touching(-vx, vy, wx, -wy, -wz)
        old = one.energy()
        for ball in (one, two):
            collide_cushion(law, ball, 0.0, 1.0, Physics())
        gain = max(gain, one.energy() - old)
        mirrored = (-two.vx, two.vy, two.wx, -two.wy, -two.wz)
        apart = max(apart, *(abs(a - b) for a, b in zip(one.velocity(), mirrored, strict=True)))
        square = touching(0.0, vy, wx, 0.0, 0.0)
        collide_cushion(law, square, 0.0, 1.0, Physics())
        assert (square.vx, square.wy, square.wz) == (0.0, 0.0, 0.0)
    assert gain <= expected["max_energy_gain_J"]
    assert apart <= expected["mirror_error"]


def touching(vx: float, vy: float, wx: float, wy: float, wz: float) -> Body:
    return Body(Ball("cue", 0.0, 0.0, vx, vy, wx, wy, wz), 0, BallKnobs().radius, BallKnobs().mass)


@cases("C21")
def test_order_of_english(case: Case) -> None:
    table = open_table(ball__mass=case["inputs"]["M"], ball__radius=case["inputs"]["R"], cushion__nose_height=0.03675)
    running, none, reverse = (bounce(table, 45.0, topspin=1.0, english=k).ball for k in (1.0, 0.0, -1.0))
    assert way(running) < way(none) < way(reverse)
    assert speed(running) > speed(none) > speed(reverse)
