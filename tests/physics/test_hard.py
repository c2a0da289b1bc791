"""Shots that once were too hard: balls frozen in grids, numbers at their ends, contacts of numerical dust."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest

from benchmarks.fuzz import faults
from pool2d import Ball, Layout, Rollout, Scenario, Shot, Table, load_scenario, load_table, simulate
from pool2d.physics.roots import first_root

FILES = sorted((Path(__file__).parent / "hard").glob("*.json"))
# From balls at rest with the preset's own knobs, and with any.
MOST, MOST_AT_ALL = 3_000, 20_000
EVERY = pytest.mark.parametrize("path", FILES, ids=[path.stem for path in FILES])


@EVERY
def test_it_ends_and_is_sound(path: Path) -> None:
    scenario = load_scenario(path)
    roll = scenario.simulate()
    still = all(ball == ball.still() for ball in scenario.layout.values())
    assert len(roll.events) < (MOST if still and not scenario.table.set else MOST_AT_ALL)
    assert list(faults(scenario.table, roll)) == []


@EVERY
def test_order_is_of_no_consequence(path: Path) -> None:
    scenario = load_scenario(path)
    backward = replace(scenario, layout=Layout(reversed(list(scenario.layout.values()))))
    assert scenario.simulate(events=300).digest() == backward.simulate(events=300).digest()


def mirrored(scenario: Scenario) -> Scenario:
    """The scenario seen in a mirror along the table."""
    width = scenario.table.knobs.table.width
    layout = Layout(
        ball._replace(y=width - ball.y, vy=-ball.vy, wx=-ball.wx, wz=-ball.wz) for ball in scenario.layout.values()
    )
    shot = scenario.shot
    return replace(scenario, layout=layout, shot=shot and replace(shot, angle=-shot.angle, side=-shot.side))


@pytest.mark.parametrize("name", ["mirror-spin", "mirror-frozen"])
def test_dust_of_spin_does_not_break_the_symmetry(name: str) -> None:
    """Once 1e-20 rad/s that rounding had left in one of the two was a spin, with an end of its own."""
    scenario = load_scenario(FILES[0].with_name(f"{name}.json"))
    ways = [[(event.kind, event.balls) for event in one.simulate().events] for one in (scenario, mirrored(scenario))]
    assert ways[0] == ways[1]


def pushed(table: Table, spin: float) -> Rollout:
    """A ball that spins against another, head-on, until the first no longer slides."""
    radius = table.knobs.ball.radius
    return simulate(table, Layout([Ball("a", 0.5, 0.9, wy=spin), Ball("b", 0.5 + 2.0 * radius, 0.9)]))


# The less balls give back, the further they go too far.
@pytest.mark.parametrize(("restitution", "off"), [(0.95, 0.06), (0.89, 0.075)])
@pytest.mark.parametrize("spin", [20.0, 100.0, 400.0])
def test_a_ball_that_pushes_another_goes_as_far_as_it_should(spin: float, restitution: float, off: float) -> None:
    """Both go at 5/12 mu g while the first slides and the second rolls, so the slip falls at 35/12 mu g."""
    settings = {"ball.law": "frictionless", "ball.restitution": restitution, "cloth.mu_roll": 0.001}
    table = load_table("snooker-12ft", settings)
    drive = table.knobs.cloth.mu_slide * table.knobs.gravity
    end = table.knobs.ball.radius * spin / (35.0 / 12.0 * drive)
    way, speed = 5.0 / 24.0 * drive * end * end, 5.0 / 12.0 * drive * end
    roll = pushed(table, spin)
    after = roll.at(end)
    radius = table.knobs.ball.radius
    assert after["a"].x - 0.5 == pytest.approx(way, rel=0.08)
    assert after["b"].x - 0.5 - 2.0 * radius == pytest.approx(way, rel=0.08)
    assert 0.5 * (after["a"].vx + after["b"].vx) == pytest.approx(speed, rel=off)
    for i in range(200):
        balls = roll.at(end * i / 200)
        assert balls["b"].x - balls["a"].x - 2.0 * radius < max(5e-5, 0.003 * way)
    assert sum(event.t <= end for event in roll.events) < 100


def test_a_ball_slides_along_a_rail_that_it_leans_on() -> None:
    """As the slip under it says that may only turn: its part along the rail falls 7/2, that across 5/2 times mu g."""
    table = load_table("snooker-12ft", {"cushion.law": "impulse", "cushion.friction": 0.0})
    radius, drive = table.knobs.ball.radius, table.knobs.cloth.mu_slide * table.knobs.gravity
    low = table.reach(radius)
    roll = simulate(table, Layout([Ball("1", 0.8, low, vx=1.0, wx=70.0)]))
    # Slip along and across, speed and place, in small steps of the same law.
    along, across, speed, x, t, step = 1.0, 70.0 * radius, 1.0, 0.8, 0.0, 1e-5
    while (size := math.hypot(along, across)) > 2e-4:
        along, across = along - 3.5 * drive * along / size * step, across - 2.5 * drive * across / size * step
        x, t = x + speed * step, t + step
        speed -= drive * along / size * step
    ball = roll.at(t)["1"]
    assert ball.x == pytest.approx(x, abs=4e-3)
    assert ball.vx == pytest.approx(speed, abs=4e-3)
    # A hop at the end of it leaves the rail at a thousandth of the speed along it, no more.
    assert max(y for moment, _, y in roll.path("1", 0.001) if moment <= t) < low + 1e-4
    assert roll.at(t + 0.01)["1"].vy < 2e-3
    assert len(roll.events) < 150


def test_a_root_is_found_however_long_is_looked() -> None:
    for end in (1e3, 1e12, 1e20, 1e60):
        assert first_root(1.0, -1.0, 0.0, 0.0, 0.0, end) == 1.0
        assert first_root(1e-9, -1e-3, 1e-9, 0.0, 0.0, end) == pytest.approx(1e-6, rel=1e-9)


def test_approaches_of_dust_are_none() -> None:
    """Nothing happens to balls that meet at less than what rounding makes of a speed."""
    table = load_table("pool-9ft")
    radius = table.knobs.ball.radius
    layout = Layout([Ball("cue", 1.0, 0.6, vx=1e-13), Ball("1", 1.0 + 2.0 * radius, 0.6)])
    roll = simulate(table, layout, Shot(speed=0.0))
    assert roll.layout()["1"] == layout["1"]
