"""Independent numbers for two balls that meet, each with its source in contacts.json, through the engine."""

from __future__ import annotations

import math
import random

import pytest

from pool2d import Ball, Layout, Table, load_table, simulate
from pool2d.physics.body import Body
from pool2d.physics.laws.pair import normal
from pool2d.physics.laws.registry import BALL_LAWS
from pool2d.physics.params import Physics
from pool2d.physics.springs import depth, duration, stiffness

from ...casebook import CONTACTS, Case, near
from ...hits import collide_balls, greatest, hit, smooth, speed, touching, way
from ...scenes import open_table

cases = CONTACTS.run


@cases("B01")
def test_ninety_degree_rule(case: Case) -> None:
    given, expected = case["inputs"], case["expected"]
    for i, cut in enumerate(given["cut_deg"]):
        shot = hit(smooth(given["e"]), cut, given["v_mps"])
        assert way(shot.other) - way(shot.cue) == near(case, expected["angle_between_deg"])
        # The speeds are given to six digits.
        assert speed(shot.cue) == pytest.approx(expected["v_CB"][i], abs=6e-7)
        assert speed(shot.other) == pytest.approx(expected["v_OB"][i], abs=6e-7)


@cases("B02")
def test_restitution_closes_the_angle(case: Case) -> None:
    shots = [hit(smooth(case["inputs"]["e"]), cut) for cut in case["inputs"]["cut_deg"]]
    assert [way(shot.other) - way(shot.cue) for shot in shots] == near(case, case["expected"]["separation_deg"])


@cases("B03")
def test_thirty_degree_rule(case: Case) -> None:
    given, expected = case["inputs"], case["expected"]
    shots = [hit(smooth(given["e"]), cut, given["v_mps"], topspin=1.0) for cut in given["cut_deg"]]
    assert [-way(shot.cue_rolls) for shot in shots] == near(case, expected["deflection_deg"])
    assert [speed(shot.cue_rolls) for shot in shots] == near(case, expected["v_CB_final"])
    assert [speed(shot.other_rolls) for shot in shots] == near(case, expected["v_OB_final"])


def deflection(table: Table, cut: float) -> float:
    return -way(hit(table, cut, topspin=1.0).cue_rolls)


@cases("B04")
def test_most_that_a_rolling_ball_turns(case: Case) -> None:
    expected, table = case["expected"], smooth(1.0)
    cut = greatest(lambda angle: deflection(table, angle), 10.0, 60.0)
    assert cut == near(case, expected["at_cut_deg"])
    assert math.sin(math.radians(cut)) ** 2 == near(case, expected["sin2_cut"])
    assert deflection(table, cut) == near(case, expected["max_deflection_deg"])


@cases("B05")
def test_thirty_degree_rule_with_restitution(case: Case) -> None:
    expected, table = case["expected"], smooth(case["inputs"]["e"])
    assert [deflection(table, cut) for cut in case["inputs"]["cut_deg"]] == near(case, expected["deflection_deg"])
    cut = greatest(lambda angle: deflection(table, angle), 10.0, 60.0)
    assert [cut, deflection(table, cut)] == near(case, [expected["at_cut_deg"], expected["max_deflection_deg"]])


@cases("B06")
def test_fraction_of_the_ball_that_is_hit(case: Case) -> None:
    table = smooth(1.0)
    for key, cut in case["expected"].items():
        over, under = map(int, key.removeprefix("f=").split("/"))
        aside = (1.0 - over / under) * 2.0 * table.knobs.ball.radius
        roll = simulate(table, Layout([Ball("cue", 2.9, 2.0 - aside, 1.0), Ball("1", 3.0, 2.0)]), events=1)
        assert way(roll.events[0].after["1"]) == near(case, cut)


@cases("B07")
def test_rolling_ball_full_on_another(case: Case) -> None:
    for key, speeds in case["expected"].items():
        shot = hit(smooth(float(key.removeprefix("e="))), 0.0, topspin=1.0)
        found = [speed(ball) for ball in (shot.cue, shot.cue_rolls, shot.other, shot.other_rolls)]
        # Given to six digits.
        assert found == pytest.approx(list(speeds.values()), rel=case["tolerance"]["rel"], abs=6e-7)


@cases("B08")
def test_stop_shot(case: Case) -> None:
    for key, speeds in case["expected"].items():
        shot = hit(smooth(float(key.removeprefix("e="))), 0.0)
        found = [speed(shot.cue), speed(shot.cue_rolls)]
        assert found == pytest.approx(list(speeds.values()), rel=case["tolerance"]["rel"], abs=6e-7)


@cases("B10")
def test_trisect_rule_of_draw(case: Case) -> None:
    given, expected, tolerance = case["inputs"], case["expected"], case["tolerance"]
    shots = [hit(smooth(given["e"]), cut, topspin=given["k"]) for cut in given["cut_deg"]]
    back = [180.0 + way(shot.cue_rolls) for shot in shots]
    model = expected["model_angle_from_reversed_line_deg"]
    assert back == pytest.approx(model, abs=tolerance["model_abs_deg"])
    # The rule is said of up to 40 degrees, where it is 11.67 off; to 35 it is as near as it is said to be.
    assert back[:-1] == pytest.approx(expected["rule_3x_deg"][:-1], abs=tolerance["rule_abs_deg"])


@cases("B11")
def test_speed_shifts_the_bend(case: Case) -> None:
    given, expected = case["inputs"], case["expected"]
    table = open_table(
        ball__law="frictionless", ball__restitution=given["e"], ball__radius=given["R_m"], ball__mass=given["m_kg"],
        cloth__mu_slide=given["mu_slide"], cloth__mu_roll=given["mu_roll"], gravity=given["g"],
    )  # fmt: skip
    shot = hit(table, given["cut_deg"], given["v_mps"], topspin=1.0)
    end = shot.cue_rolls
    x, y = end.x - shot.ghost[0], end.y - shot.ghost[1]
    assert shot.slide == near(case, expected["t_slide_s"])
    assert [x, y] == near(case, expected["slide_end_xy_m"])
    # How far the final line passes from where the balls met.
    assert abs(x * end.vy - y * end.vx) / speed(end) == near(case, expected["final_line_offset_m"])


@cases("B20")
def test_what_two_balls_keep(case: Case) -> None:
    rng, laws = random.Random(20), [law for law in BALL_LAWS if law != "mathavan2014"]
    momentum, gain = 0.0, 0.0
    for number in range(case["inputs"]["random_pairs"]):
        cue, other = touching(rng.uniform(-180.0, 180.0), 0.0, 0.0)
        for ball in (cue, other):
            ball.set_velocity((*(rng.uniform(-8.0, 8.0) for _ in range(2)), *(rng.gauss(0.0, 100.0) for _ in range(3))))  # type: ignore[arg-type]
        before, old = invariants(cue, other), cue.energy() + other.energy()
        collide_balls(laws[number % len(laws)], cue, other, Physics())
        after = invariants(cue, other)
        momentum = max(momentum, *(abs(a - b) for a, b in zip(before, after, strict=True)))
        gain = max(gain, cue.energy() + other.energy() - old)
    assert momentum <= case["expected"]["max_momentum_error"]
    assert gain <= case["expected"]["max_energy_gain_J"]


def invariants(a: Body, b: Body) -> tuple[float, ...]:
    """Momentum in plan, angular momentum about the vertical, the difference of the spins, the spin of each about n."""
    nx, ny, _ = normal(a, b)
    about = sum(p.x * p.vy - p.y * p.vx + 0.4 * p.radius**2 * p.wz for p in (a, b))
    unit = a.mass * a.radius**2
    apart = (a.wx - b.wx, a.wy - b.wy, a.wz - b.wz)
    along = (p.wx * nx + p.wy * ny for p in (a, b))
    return (
        a.mass * (a.vx + b.vx), a.mass * (a.vy + b.vy), a.mass * about,
        *(unit * value for value in apart), *(unit * value for value in along),
    )  # fmt: skip


@cases("B21")
def test_mathavan_2014_and_the_camera(case: Case) -> None:
    given, tolerance = case["inputs"], case["tolerance"]
    table = open_table(
        ball__law="mathavan2014", ball__radius=given["R_m"], ball__mass=given["m_kg"], ball__restitution=given["e"],
        ball__friction=given["mu_bb"], cloth__mu_slide=given["mu_slide"],
    )  # fmt: skip
    v = given["v_CB_mps"]
    shot = hit(table, given["cut_deg"], v, topspin=given["topspin_radps"] * given["R_m"] / v)
    found = {
        "v_CB": speed(shot.cue_rolls), "v_OB": speed(shot.other_rolls),
        "CB_angle_deg": -way(shot.cue_rolls), "OB_angle_from_incoming_deg": way(shot.other_rolls),
    }  # fmt: skip
    published, measured = case["expected"]["published_model"], case["expected"]["measured"]
    assert found == pytest.approx(published, rel=tolerance["vs_published_model_rel"])
    for name in ("v_CB", "v_OB"):
        # Of the model's speed: shot 1's cue ball, of the published model too, is 10.7 % of that off the
        # camera's, which is 12.02 % of the camera's.
        assert measured[name] == pytest.approx(found[name], rel=tolerance["vs_measured_speed_rel"])
    assert found["CB_angle_deg"] == pytest.approx(measured["CB_angle_deg"], abs=tolerance["vs_measured_angle_deg"])


@cases("B22")
def test_defaults_are_within_what_is_measured(case: Case) -> None:
    knobs = load_table("pool-9ft").knobs.ball
    for name, value in (("e", knobs.restitution), ("mu", knobs.friction)):
        low, high = case["expected"][name]
        assert low <= value <= high


@cases("B23")
def test_thin_and_full_hits(case: Case) -> None:
    expected, table = case["expected"], smooth(1.0)
    for cut in (89.0, 80.0):
        assert deflection(table, cut) / (90.0 - cut) == near(case, expected[f"ratio_at_cut_{cut:g}"])
    assert deflection(table, 0.1) / 0.1 == near(case, expected["deflection_over_cut_at_0.1deg"])


@cases("B28")
def test_time_and_force_of_an_impact(case: Case) -> None:
    a, b = touching(0.0, 0.0, 0.0)
    for key, time in case["expected"]["T_us"].items():
        assert 1e6 * duration(a, b, float(key)) == near(case, time)
    for key, force in case["expected"]["F_peak_N"].items():
        assert stiffness(a, b) * depth(a, b, float(key)) ** 1.5 == near(case, force)
