"""A ball and a cushion under the impulse law, and through the engine."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pool2d import Ball, Layout, Table, load_table, simulate
from pool2d.physics.detect import Jaw

RADIUS = 0.028575


def rebound(table: Table, speed: float, from_normal: float, wx: float = 0.0, wy: float = 0.0, wz: float = 0.0) -> Ball:
    """The ball as it leaves the right-hand cushion, which it meets at an angle from its normal, in degrees."""
    turn = math.radians(from_normal)
    touch = table.knobs.table.length - table.reach(RADIUS)
    # From so near that the cloth has no time to act.
    vx, vy = speed * math.cos(turn), speed * math.sin(turn)
    ball = Ball("cue", touch - 1e-9, 0.6, vx, vy, wx, wy, wz)
    (event,) = simulate(table, Layout([ball]), events=1).events
    assert (event.kind, event.where) == ("ball_cushion", "right")
    return event.after["cue"]


def table(e: float = 0.85, mu: float = 0.14) -> Table:
    as_cushions = {"facing.restitution": 1.0, "facing.friction": 1.0, "facing.tangential": 0.0}
    cushion = {"cushion.restitution": e, "cushion.friction": mu, "cushion.law": "impulse"}
    return load_table("pool-9ft", cushion | as_cushions)


@pytest.mark.parametrize(("before", "after"), [(30.0, 35.8175), (60.0, 65.2087), (0.0, 0.0)])
def test_without_friction_only_the_normal_speed_changes(before: float, after: float) -> None:
    """Reference case C08 (Alciatore TP 6.3): e = 0.8."""
    ball = rebound(table(0.8, 0.0), 2.0, before)
    assert math.degrees(math.atan2(ball.vy, -ball.vx)) == pytest.approx(after, abs=1e-3)
    assert ball.vx == pytest.approx(-0.8 * 2.0 * math.cos(math.radians(before)), rel=1e-6)
    assert ball.vy == pytest.approx(2.0 * math.sin(math.radians(before)), rel=1e-6)


def test_running_english_widens_and_reverse_narrows() -> None:
    # The cushion is to the right of a ball that goes up along it, and clockwise spin rolls along it.
    angles = []
    for wz in (-50.0, 0.0, 50.0):
        ball = rebound(table(mu=1.0), 2.0, 45.0, wz=wz)
        angles.append(math.degrees(math.atan2(ball.vy, -ball.vx)))
    running, plain, reverse = angles
    assert running > plain + 5.0 > reverse + 10.0


def test_english_kicks_a_square_hit_aside() -> None:
    left = rebound(table(), 2.0, 0.0, wz=50.0)
    right = rebound(table(), 2.0, 0.0, wz=-50.0)
    assert left.vy == pytest.approx(-right.vy)
    assert left.vy < -0.1
    assert 0.0 < left.wz < 50.0


@given(st.floats(0.1, 6.0), st.floats(-80.0, 80.0), st.floats(-200.0, 200.0), st.floats(0.0, 1.0))
def test_friction_acts_against_the_slip_and_no_more_than_stops_it(
    speed: float, from_normal: float, wz: float, mu: float
) -> None:
    # Without slip up and down, the surface slides along the cushion at vy + R wz.
    before = speed * math.sin(math.radians(from_normal)) + RADIUS * wz
    push = 1.85 * speed * math.cos(math.radians(from_normal))
    ball = rebound(table(0.85, mu), speed, from_normal, wz=wz, wy=0.0)
    after = ball.vy + RADIUS * ball.wz
    assert abs(after) == pytest.approx(max(abs(before) - 3.5 * mu * push, 0.0), abs=1e-6)
    assert after * before >= -1e-6


def test_ball_square_onto_a_rounded_jaw_comes_straight_back() -> None:
    smooth = table(0.85, 0.0)
    jaw = next(element for element in smooth.elements if isinstance(element, Jaw) and "bottom-side" in element.name)
    dx, dy = math.cos(math.radians(50.0)), math.sin(math.radians(50.0))
    ball = Ball("cue", jaw.x + 0.3 * dx, jaw.y + 0.3 * dy, -2.0 * dx, -2.0 * dy)
    (event,) = simulate(smooth, Layout([ball]), events=1).events
    assert event.where == "bottom-side jaw"
    before, after = event.before["cue"], event.after["cue"]
    assert math.hypot(before.x - jaw.x, before.y - jaw.y) == pytest.approx(jaw.radius + smooth.reach(RADIUS), abs=1e-9)
    assert (after.vx, after.vy) == pytest.approx((-0.85 * before.vx, -0.85 * before.vy))
