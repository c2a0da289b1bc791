"""A ball on the cloth between two events: against the equations of motion, stepped by brute force."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from pool2d import Ball
from pool2d.physics.body import Body
from pool2d.physics.motion import ClothNumbers, Motion, finish, pocketed, start, toward_zero
from pool2d.physics.values import POCKETED, RESTING, ROLLING, SLIDING, SPINNING

RADIUS, GRAVITY = 0.028575, 9.81
CLOTH = ClothNumbers(mu_slide=0.2, mu_roll=0.01, mu_spin=0.0127, gravity=GRAVITY)
SPEED = st.floats(-8.0, 8.0)
SPIN = st.floats(-300.0, 300.0)


def begin(vx: float = 0.0, vy: float = 0.0, wx: float = 0.0, wy: float = 0.0, wz: float = 0.0) -> tuple[Body, Motion]:
    body = Body(Ball("cue", 1.0, 0.5, vx, vy, wx, wy, wz), 0, RADIUS, 0.17)
    return body, start(body, 0.0, CLOTH)


def phases(body: Body, motion: Motion) -> list[Motion]:
    """Every motion until the ball rests."""
    found = [motion]
    while found[-1].t1 < math.inf:
        assert len(found) < 5
        found.append(finish(found[-1], body, CLOTH))
    return found


def slip(ball: Ball) -> tuple[float, float]:
    return ball.vx - RADIUS * ball.wy, ball.vy + RADIUS * ball.wx


@pytest.mark.parametrize(
    ("state", "phase"),
    [
        ({}, RESTING),
        ({"wz": 1.0}, SPINNING),
        ({"wz": -1e-6}, SPINNING),
        ({"vx": 1.0}, SLIDING),
        ({"wx": 1.0}, SLIDING),
        ({"vx": 1.0, "wy": 1.0 / RADIUS}, ROLLING),
        ({"vy": -2.0, "wx": 2.0 / RADIUS, "wz": 5.0}, ROLLING),
        ({"vx": 1.0, "wy": 1.0 / RADIUS, "wx": 1e-3}, SLIDING),
    ],
)
def test_phase_follows_from_velocity_and_spin(state: dict[str, float], phase: str) -> None:
    assert begin(**state)[1].phase == phase


def test_phases_follow_each_other() -> None:
    kinds = [motion.phase for motion in phases(*begin(vx=1.0, wz=200.0))]
    assert kinds == [SLIDING, ROLLING, SPINNING, RESTING]
    assert [motion.phase for motion in phases(*begin(vx=1.0, wz=1.0))] == [SLIDING, ROLLING, RESTING]
    # Draw that takes the speed exactly: it slides to a stop and never rolls.
    assert [motion.phase for motion in phases(*begin(vx=1.0, wy=-2.5 / RADIUS))] == [SLIDING, RESTING]


@given(SPEED, SPEED, SPIN, SPIN, SPIN)
def test_each_phase_begins_where_the_last_ended(vx: float, vy: float, wx: float, wy: float, wz: float) -> None:
    motions = phases(*begin(vx, vy, wx, wy, wz))
    assert motions[-1].phase == RESTING
    for before, after in pairwise(motions):
        old, new = before.at(before.t1), after.at(after.t0)
        assert before.t1 == after.t0
        assert (old.x, old.y) == (new.x, new.y)
        assert (new.vx, new.vy) == pytest.approx((old.vx, old.vy), abs=1e-8)
        assert (new.wx, new.wy, new.wz) == pytest.approx((old.wx, old.wy, old.wz), abs=1e-6)


@given(SPEED, SPEED, SPIN, SPIN, SPIN)
def test_obeys_the_equations_of_motion(vx: float, vy: float, wx: float, wy: float, wz: float) -> None:
    """Force and moment of the friction at the cloth, in small steps, lead to the same place."""
    *moving, _ = phases(*begin(vx, vy, wx, wy, wz))
    assume(moving)
    for motion in moving:
        span, steps = motion.t1 - motion.t0, 64
        h, ball = span / steps, motion.at(motion.t0)
        x, y, ux, uy = ball.x, ball.y, ball.vx, ball.vy
        ox, oy, oz = ball.wx, ball.wy, ball.wz
        for _ in range(steps):
            sx, sy = ux - RADIUS * oy, uy + RADIUS * ox
            speed = math.hypot(sx, sy)
            ax = ay = mx = my = 0.0
            if motion.phase == SLIDING and speed > 1e-9:
                ax, ay = (-CLOTH.mu_slide * GRAVITY * s / speed for s in (sx, sy))
                # The moment of the friction about the centre: (-R k) x F, over I = 2/5 m R^2.
                mx, my = 2.5 / RADIUS * ay, -2.5 / RADIUS * ax
            elif motion.phase == ROLLING and (speed := math.hypot(ux, uy)) > 1e-9:
                ax, ay = (-CLOTH.mu_roll * GRAVITY * u / speed for u in (ux, uy))
                mx, my = -ay / RADIUS, ax / RADIUS
            x, y = x + ux * h + 0.5 * ax * h * h, y + uy * h + 0.5 * ay * h * h
            ux, uy, ox, oy = ux + ax * h, uy + ay * h, ox + mx * h, oy + my * h
            oz -= math.copysign(min(abs(oz), 2.5 * CLOTH.mu_spin * GRAVITY / RADIUS * h), oz)
        end = motion.at(motion.t1)
        assert (end.x, end.y) == pytest.approx((x, y), abs=1e-6)
        assert (end.vx, end.vy) == pytest.approx((ux, uy), abs=1e-6)
        assert (end.wx, end.wy, end.wz) == pytest.approx((ox, oy, oz), abs=1e-4)


@given(SPEED, SPEED, SPIN, SPIN)
def test_slide_keeps_the_direction_of_its_slip_and_ends_in_a_roll(vx: float, vy: float, wx: float, wy: float) -> None:
    body, motion = begin(vx, vy, wx, wy)
    assume(motion.phase == SLIDING)
    sx, sy = slip(motion.at(0.0))
    for part in (0.25, 0.5, 0.9):
        left = slip(motion.at(part * motion.t1))
        assert left == pytest.approx(((1.0 - part) * sx, (1.0 - part) * sy), abs=1e-9)
    after = finish(motion, body, CLOTH).at(motion.t1)
    assert slip(after) == pytest.approx((0.0, 0.0), abs=1e-15)
    assert after.vx == pytest.approx(vx - 2.0 / 7.0 * sx, abs=1e-9)
    assert after.vy == pytest.approx(vy - 2.0 / 7.0 * sy, abs=1e-9)


@given(SPEED, SPEED, SPIN, SPIN, SPIN)
def test_energy_falls_along_a_motion(vx: float, vy: float, wx: float, wy: float, wz: float) -> None:
    body, motion = begin(vx, vy, wx, wy, wz)
    *moving, _ = phases(body, motion)
    assume(moving)
    for now in moving:
        left = math.inf
        for i in range(9):
            now.move(body, now.t0 + (now.t1 - now.t0) * i / 8.0)
            assert body.energy() <= left * (1.0 + 1e-12)
            left = body.energy()


@pytest.mark.parametrize(
    ("value", "by", "left"), [(3.0, 1.0, 2.0), (-3.0, 1.0, -2.0), (1.0, 2.0, 0.0), (-1.0, 2.0, 0.0)]
)
def test_toward_zero(value: float, by: float, left: float) -> None:
    assert toward_zero(value, by) == left


def test_pocketed_ball_stays() -> None:
    body, _ = begin(vx=1.0, wz=3.0)
    motion = pocketed(body, 2.0)
    assert motion.at(2.0) == motion.at(9.0)
    assert motion.at(9.0) == Ball("cue", 1.0, 0.5, phase=POCKETED)


@pytest.mark.parametrize("spin", [1e-20, -8e-9, 3e-8])
def test_a_spin_of_dust_is_none(spin: float) -> None:
    """What rounding leaves of a spin must not be a phase with an end of its own: a mirrored ball may lack it."""
    body, motion = begin(wz=spin)
    assert (motion.phase, motion.t1, body.wz) == (RESTING, math.inf, 0.0)


def test_a_small_spin_is_one() -> None:
    assert begin(wz=1e-6)[1].phase == SPINNING
