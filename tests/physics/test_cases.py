"""Independent numbers for the cloth and the cue, through the engine; the JSON files tell their sources."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import pytest

from pool2d import Ball, Layout, Rollout, Shot, Table, simulate
from pool2d.physics.strike import hop, miscue_limit

from ..casebook import CONTACTS, MOTIONS, near
from ..checks import energy
from ..scenes import open_table

cases = MOTIONS.run


def table_of(inputs: Mapping[str, Any]) -> Table:
    """A table of the case's cloth and balls."""
    names = {
        "R_m": "ball.radius", "m_kg": "ball.mass",
        "mu_slide": "cloth.mu_slide", "mu_roll": "cloth.mu_roll", "g": "gravity",
    }  # fmt: skip
    return open_table(**{names[key]: value for key, value in inputs.items() if key in names})


def send(table: Table, vx: float, vy: float = 0.0, wx: float = 0.0, wy: float = 0.0, wz: float = 0.0) -> Rollout:
    """One ball's way; on a table that is too short for it, the motions still tell where it would end."""
    return simulate(table, Layout([Ball("cue", 0.5, 1.0, vx, vy, wx, wy, wz)]))


def strike(table: Table, shot: Shot) -> Ball:
    """The ball as it leaves the tip."""
    return simulate(table, Layout([Ball("cue", 3.0, 2.0)]), shot, events=1).events[0].after["cue"]


def first_time(holds: Callable[[float], bool], low: float, high: float) -> float:
    """Where in a range a condition begins to hold, by halving."""
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if holds(middle) else (middle, high)
    return high


@cases("A0")
def test_slides_then_rolls(case: dict[str, Any]) -> None:
    check_slide(case)


@cases("A12")
def test_snooker_ball_slides_then_rolls(case: dict[str, Any]) -> None:
    check_slide(case)


def check_slide(case: dict[str, Any]) -> None:
    given, expected = case["inputs"], case["expected"]
    vx, vy = given["v0_mps"]
    wx, wy = (value / given["R_m"] for value in given["R_times_omega_xy_mps"])
    roll = send(table_of(given), vx, vy, wx, wy, given["omega_z_radps"])
    slide, rolling = roll.tracks["cue"][:2]
    start, begin, end = slide.at(0.0), rolling.at(rolling.t0), rolling.at(rolling.t1)
    assert roll.events[0].kind == "sliding_rolling"
    assert roll.events[0].t == near(case, expected["t_slide_s"])
    assert [begin.x - start.x, begin.y - start.y] == near(case, expected["pos_end_slide_m"])
    assert [begin.vx, begin.vy] == near(case, expected["v_roll_mps"])
    assert rolling.t1 == near(case, expected["t_stop_s"])
    assert [end.x - start.x, end.y - start.y] == near(case, expected["pos_stop_m"])


@cases("A14")
def test_energy_left_when_a_stun_ball_rolls(case: dict[str, Any]) -> None:
    table = open_table()
    roll = send(table, case["inputs"]["v0_mps"])
    before, after = roll.start.values(), roll.events[0].after.values()
    assert energy(table, after) / energy(table, before) == near(case, case["expected"]["E_roll_over_E0"])


@cases("A15")
def test_rolls_to_rest(case: dict[str, Any]) -> None:
    given = case["inputs"]
    roll = send(table_of(given), given["v0_mps"], wy=given["v0_mps"] / given["R_m"])
    assert [event.kind for event in roll.events] == ["rolling_resting"]
    assert roll.duration == near(case, case["expected"]["time_s"])
    assert roll.layout()["cue"].x - 0.5 == near(case, case["expected"]["distance_m"])


@cases("A16")
def test_lag_rule(case: dict[str, Any]) -> None:
    given, expected = case["inputs"], case["expected"]
    table = table_of(given)
    roll = send(table, expected["v0_mps"], wy=expected["v0_mps"] / table.knobs.ball.radius)
    assert roll.duration == near(case, expected["time_s"])
    # The distance goes with the square of the rounded speed.
    assert roll.layout()["cue"].x - 0.5 == pytest.approx(given["L_m"], rel=2.0 * case["tolerance"]["rel"])


@cases("A18")
def test_drag_shot_becomes_a_stun(case: dict[str, Any]) -> None:
    given, expected = case["inputs"], case["expected"]
    roll = send(table_of(given), given["v0_mps"], wy=-given["k"] * given["v0_mps"] / given["R_m"])
    time = first_time(lambda t: roll.at(t)["cue"].wy >= 0.0, 0.0, roll.events[0].t)
    ball = roll.at(time)["cue"]
    assert time == near(case, expected["time_s"])
    assert ball.vx == near(case, expected["speed_mps"])
    assert ball.x - 0.5 == near(case, expected["distance_m"])


@cases("A19")
def test_slide_distance_over_speeds(case: dict[str, Any]) -> None:
    table = table_of(case["inputs"])
    for key, distance in case["expected"].items():
        slide = send(table, float(key.removeprefix("v=").removesuffix("_mps"))).tracks["cue"][0]
        # The numbers are given to a tenth of a millimetre.
        assert slide.at(slide.t1).x - 0.5 == pytest.approx(distance, rel=case["tolerance"]["rel"], abs=5e-5)


@cases("A26")
def test_swerve_ends_towards_the_english(case: dict[str, Any]) -> None:
    given = case["inputs"]
    shot = Shot(
        speed=1.0,
        side=given["side_offset_over_R"],
        height=given["vertical_offset_over_R"],
        elevation=given["cue_elevation_deg"],
    )
    for mu_slide in (0.2, 0.4):
        table = open_table(cue__end_mass=0.0, cloth__mu_slide=mu_slide)
        roll = simulate(table, Layout([Ball("cue", 3.0, 2.0)]), shot)
        # It hops first: what the slate takes of its slip does not change where it ends.
        ball = next(event.after["cue"] for event in roll.events if event.after["cue"].phase == "rolling")
        # To the right of the aim, for english to the right.
        turned = -math.degrees(math.atan2(ball.vy, ball.vx))
        assert turned == near(case, case["expected"]["final_direction_deg"])


@cases("D01")
def test_centre_hit_with_an_elastic_tip(case: dict[str, Any]) -> None:
    given = case["inputs"]
    for mass, ratio in zip(given["M_cue_kg"], case["expected"]["ratio"], strict=True):
        table = open_table(cue__tip_restitution=1.0, cue__mass=mass, ball__mass=given["m_kg"])
        assert strike(table, Shot(speed=2.0)).vx / 2.0 == near(case, ratio)


@cases("D02")
def test_offset_hit_with_an_elastic_tip(case: dict[str, Any]) -> None:
    given, expected = case["inputs"], case["expected"]
    table = open_table(cue__tip_restitution=1.0, cue__mass=0.17 / given["m_over_M"], ball__mass=0.17)
    for i, height in enumerate(given["b_over_R"]):
        ball = strike(table, Shot(speed=2.0, height=height))
        assert ball.vx / 2.0 == near(case, expected["v_over_V"][i])
        assert table.knobs.ball.radius * ball.wy / ball.vx == near(case, expected["Rw_over_v"][i])


@cases("D05")
def test_miscue_limit(case: dict[str, Any]) -> None:
    layout = Layout([Ball("cue", 3.0, 2.0)])
    for friction, limit in zip(case["inputs"]["mu_tip"], case["expected"]["b_max_over_R"], strict=True):
        assert miscue_limit(friction) == near(case, limit)
        table, step = open_table(cue__tip_friction=friction), case["tolerance"]["abs"]
        for offset, where in ((limit - step, None), (limit + step, "miscue")):
            for shot in (Shot(height=offset), Shot(side=-offset), Shot(side=0.6 * offset, height=-0.8 * offset)):
                assert simulate(table, layout, shot, events=1).events[0].where == where


@cases("D07")
def test_hit_that_rolls_at_once(case: dict[str, Any]) -> None:
    height = case["expected"]["b_over_R"]
    phases = [strike(open_table(), Shot(height=height + off)).phase for off in (-1e-6, 0.0, 1e-6)]
    assert phases == ["sliding", "rolling", "sliding"]


@cases("D08")
def test_offset_of_the_most_spin(case: dict[str, Any]) -> None:
    for ratio, height in zip(case["inputs"]["m_over_M"], case["expected"]["b_over_R"], strict=True):
        table = open_table(ball__mass=0.17, cue__mass=0.17 / ratio, cue__tip_friction=10.0)

        def falls(at: float, table: Table = table) -> bool:
            return strike(table, Shot(height=at + 1e-5)).wy < strike(table, Shot(height=at - 1e-5)).wy

        assert first_time(falls, 0.1, 0.9) == near(case, height)


@cases("D09")
def test_squirt(case: dict[str, Any]) -> None:
    given = case["inputs"]
    for ratio in given["m_ball_over_m_end"]:
        table = open_table(ball__mass=0.17, cue__end_mass=0.17 / ratio)
        for side, angle in zip(given["b_over_R"], case["expected"][f"m_r={ratio}"], strict=True):
            for hand in (1.0, -1.0):
                ball = strike(table, Shot(side=hand * side))
                # Away from the english: to the left, for english to the right.
                assert hand * math.degrees(math.atan2(ball.vy, ball.vx)) == near(case, angle)


@pytest.mark.parametrize(("side", "height"), [(0.3, 0.4), (0.3, -0.4), (0.5, 0.0), (0.2, 0.8)])
def test_squirt_by_the_depth_at_which_the_tip_meets_the_ball(side: float, height: float) -> None:
    """The angle of a rigid sphere, whose impulse has a part aside: at a 0.3, b 0.4 it is 1.59 degrees, not 1.75."""
    expected = 2.5 * side * math.sqrt(1.0 - side**2 - height**2) / (1.0 + 20.0 + 2.5 * (1.0 - side**2))
    ball = strike(
        open_table(ball__mass=0.17, cue__end_mass=0.17 / 20.0, cue__tip_friction=10.0), Shot(0.0, 2.0, side, height)
    )
    assert ball.vy / ball.vx == pytest.approx(expected)


@cases("D12")
def test_hop(case: dict[str, Any]) -> None:
    given, expected = case["inputs"], case["expected"]
    table = open_table(cloth__bounce=given["e_slate"])
    # The cue's speed that gives the ball this speed along the cue, as nothing holds it.
    unit = strike(table, Shot(speed=1.0)).vx
    shot = Shot(speed=given["v_ball_mps"] / unit, elevation=given["elevation_deg"])
    assert hop(shot, table.knobs.ball.mass, table.knobs) == near(case, tuple(expected.values()))


def test_a_tip_off_the_centre_turns_the_ball_and_it_hops_less() -> None:
    """The tip meets m / (1 + 5/2 (a^2 + b^2)) of the ball: its speed, hence the hop's, is less by that."""
    table = open_table()
    mass, cue = table.knobs.ball.mass, table.knobs.cue
    up = [
        hop(Shot(speed=3.0, side=a, height=b, elevation=30.0), mass, table.knobs)[0]
        for a, b in ((0.0, 0.0), (0.3, 0.4))
    ]
    inertia = [mass / cue.mass + 1.0 + offsets for offsets in (0.0, 2.5 * 0.25)]
    assert up[1] / up[0] == pytest.approx(inertia[0] / inertia[1])


@CONTACTS.run("D04")
def test_default_tip_is_within_what_is_measured(case: dict[str, Any]) -> None:
    expected, cue = case["expected"], open_table().knobs.cue
    assert expected["e_leather"][0] <= cue.tip_restitution <= expected["e_leather"][1]
    assert cue.tip_friction == expected["mu_tip"]


@CONTACTS.run("D06")
def test_default_miscue_limit_is_the_accepted_one(case: dict[str, Any]) -> None:
    low, high = case["expected"]["b_over_R"]
    assert low <= miscue_limit(open_table().knobs.cue.tip_friction) <= high


@CONTACTS.run("D10")
def test_measured_squirt(case: dict[str, Any]) -> None:
    for measured in case["expected"].values():
        table = open_table(ball__mass=0.17, cue__end_mass=0.17 / measured["m_r"])
        ball = strike(table, Shot(side=measured["b_over_R"]))
        angle = math.degrees(math.atan2(ball.vy, ball.vx))
        assert angle == pytest.approx(measured["deg"], abs=case["tolerance"]["abs_deg"])
