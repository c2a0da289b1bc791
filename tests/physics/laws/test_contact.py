"""The impulse laws of two balls, and of a ball and a cushion."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from pool2d import Ball
from pool2d.physics.body import Body
from pool2d.physics.laws.registry import BALL_LAWS, CUSHION_LAWS
from pool2d.physics.params import BallKnobs, CushionKnobs, Physics

from ...hits import collide_balls, collide_cushion

RADIUS, MASS = 0.028575, 0.17
Vector = tuple[float, float, float]
Motion = tuple[float, float, float, float, float]
SPEED = st.floats(-8.0, 8.0).map(lambda value: round(value, 6))
SPIN = st.floats(-300.0, 300.0).map(lambda value: round(value, 6))
MOTION = st.tuples(SPEED, SPEED, SPIN, SPIN, SPIN)
STILL = (0.0, 0.0, 0.0, 0.0, 0.0)
RADII = st.sampled_from([0.02, 0.0255, RADIUS, 0.035])
MASSES = st.sampled_from([0.1, MASS, 0.3])
LAWS = st.sampled_from(list(BALL_LAWS))
PART = st.sampled_from([0.0, 0.5, 0.95, 1.0])
FRICTION = st.sampled_from([0.0, 0.06, 0.3, 1.0])


def ball(motion: Motion = STILL, x: float = 0.0, y: float = 0.0, radius: float = RADIUS, mass: float = MASS) -> Body:
    return Body(Ball("", x, y, *motion), 0, radius, mass)


def facing(a: Body, turn: float, motion: Motion, radius: float = RADIUS, mass: float = MASS) -> Body:
    """A ball that touches `a`, in direction `turn`."""
    touch = 2.0 * math.sqrt(a.radius * radius)
    return ball(motion, a.x + touch * math.cos(turn), a.y + touch * math.sin(turn), radius, mass)


def state(body: Body) -> Motion:
    return body.vx, body.vy, body.wx, body.wy, body.wz


def physics(e: float = 0.95, mu: float = 0.06) -> Physics:
    return Physics(ball=BallKnobs(restitution=e, friction=mu), cushion=CushionKnobs(restitution=e, friction=mu))


def cross(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def dot(a: Vector, b: Vector) -> float:
    return sum(x * y for x, y in zip(a, b, strict=True))


def normal(a: Body, b: Body) -> Vector:
    """From centre to centre, as the balls lie on one cloth."""
    line = b.x - a.x, b.y - a.y, b.radius - a.radius
    size = math.hypot(*line)
    return line[0] / size, line[1] / size, line[2] / size


def closing(a: Body, b: Body) -> float:
    """How fast two balls approach along the line of centres."""
    return dot((a.vx - b.vx, a.vy - b.vy, 0.0), normal(a, b))


def slip(a: Body, b: Body) -> Vector:
    """How a's surface slides over b's where they touch."""
    n = normal(a, b)
    turn = cross(
        (a.radius * a.wx + b.radius * b.wx, a.radius * a.wy + b.radius * b.wy, a.radius * a.wz + b.radius * b.wz), n
    )
    s = a.vx - b.vx + turn[0], a.vy - b.vy + turn[1], turn[2]
    along = dot(s, n)
    return s[0] - along * n[0], s[1] - along * n[1], s[2] - along * n[2]


def impulse(before: Motion, after: Body) -> tuple[float, float]:
    return after.mass * (after.vx - before[0]), after.mass * (after.vy - before[1])


# Two balls.


# A small ball that climbs a large one: the push itself changes the slip.
@example("impulse", (2.1, 0.0, 0.0, 15.0, 0.0), STILL, 0.0, 0.02, 0.035, MASS, MASS, 1.0, 1.0)
@given(LAWS, MOTION, MOTION, st.floats(0.0, 6.3), RADII, RADII, MASSES, MASSES, PART, FRICTION)
def test_momentum_is_kept_and_energy_never_rises(
    law: str, one: Motion, two: Motion, turn: float, r1: float, r2: float, m1: float, m2: float, e: float, mu: float
) -> None:
    a = ball(one, 0.3, 0.4, r1, m1)
    b = facing(a, turn, two, r2, m2)
    energy, meets = a.energy() + b.energy(), closing(a, b) > 0.0
    old_a, old_b = state(a), state(b)
    collide_balls(law, a, b, physics(e, mu))
    assert a.energy() + b.energy() <= energy * (1.0 + 1e-12)
    if not meets:
        assert (state(a), state(b)) == (old_a, old_b)
    if law == "mathavan2014":
        return  # The cloth takes a part.
    for p, q in zip(impulse(old_a, a), impulse(old_b, b), strict=True):
        assert p == pytest.approx(-q, abs=1e-12)
    # Both arms point at the contact and the forces are opposite, so both turn alike.
    for i in (2, 3, 4):
        turned = [one.mass * one.radius * (state(one)[i] - old[i]) for one, old in ((a, old_a), (b, old_b))]
        assert turned[0] == pytest.approx(turned[1], abs=1e-11)


@pytest.mark.parametrize("law", ["impulse", "frictionless", "mathavan2014"])
@given(MOTION, MOTION, st.floats(0.0, 6.3), RADII, RADII, MASSES, MASSES, PART)
def test_without_friction_the_balls_part_at_e_times_the_speed_they_met(
    law: str, one: Motion, two: Motion, turn: float, r1: float, r2: float, m1: float, m2: float, e: float
) -> None:
    a = ball(one, 0.3, 0.4, r1, m1)
    b = facing(a, turn, two, r2, m2)
    met, spins = closing(a, b), (state(a)[2:], state(b)[2:])
    assume(met >= 0.1)
    knobs = physics(e, 0.0)
    collide_balls(law, a, b, replace(knobs, cloth=replace(knobs.cloth, mu_slide=0.0)))
    # A hair of speed is always left, so that no two balls stay in contact.
    assert -closing(a, b) == pytest.approx(max(e * met, 5e-3), rel=1e-9)
    assert (state(a)[2:], state(b)[2:]) == spins


@given(MOTION, MOTION, st.floats(0.0, 6.3), PART, FRICTION)
def test_friction_acts_against_the_slip_and_no_more_than_stops_it(
    one: Motion, two: Motion, turn: float, e: float, mu: float
) -> None:
    a = ball(one)
    b = facing(a, turn, two)
    assume(closing(a, b) > 0.0)
    n, before, old = normal(a, b), slip(a, b), state(a)
    collide_balls("impulse", a, b, physics(e, mu))
    px, py = impulse(old, a)
    push = -(px * n[0] + py * n[1])
    # The moment of the friction about the centre is R n x F, so F = (2/5) m R dw x n.
    spin = a.wx - old[2], a.wy - old[3], a.wz - old[4]
    rub = tuple(0.4 * MASS * RADIUS * part for part in cross(spin, n))
    size = math.hypot(*before)
    expected = min(mu * push, MASS * size / 7.0)
    for i in range(3):
        assert rub[i] == pytest.approx(-expected * before[i] / size if size else 0.0, abs=1e-9)
    # In plan the same force moves the ball; the slate takes the rest.
    assert (px + push * n[0], py + push * n[1]) == pytest.approx(rub[:2], abs=1e-9)


@given(MOTION, MOTION, st.floats(0.0, 6.3))
def test_rough_balls_leave_without_slip_in_plan(one: Motion, two: Motion, turn: float) -> None:
    a = ball((*one[:2], 0.0, 0.0, one[4]))
    b = facing(a, turn, (0.0, 0.0, 0.0, 0.0, two[4]))
    assume(closing(a, b) > 0.1)
    collide_balls("impulse", a, b, physics(0.95, 1e6))
    assert slip(a, b) == pytest.approx((0.0, 0.0, 0.0), abs=1e-9)


def test_head_on_stun_stops_the_cue_ball() -> None:
    a = ball((2.0, 0.0, 0.0, 0.0, 0.0))
    b = facing(a, 0.0, STILL)
    collide_balls("impulse", a, b, physics(1.0, 0.06))
    assert state(a) == pytest.approx(STILL, abs=1e-15)
    assert state(b) == pytest.approx((2.0, 0.0, 0.0, 0.0, 0.0), abs=1e-15)


@pytest.mark.parametrize("cut", [10.0, 30.0, 45.0, 70.0])
def test_ninety_degree_rule(cut: float) -> None:
    """Reference case B01: a stunned cue ball leaves along the tangent, at v sin(cut)."""
    a, turn = ball((2.0, 0.0, 0.0, 0.0, 0.0)), math.radians(cut)
    b = facing(a, turn, STILL)
    collide_balls("impulse", a, b, physics(1.0, 0.0))
    assert (b.vx, b.vy) == pytest.approx((2.0 * math.cos(turn) ** 2, 2.0 * math.cos(turn) * math.sin(turn)))
    assert math.hypot(a.vx, a.vy) == pytest.approx(2.0 * math.sin(turn))
    assert a.vx * b.vx + a.vy * b.vy == pytest.approx(0.0, abs=1e-12)


def test_gearing_english_throws_nothing() -> None:
    """Reference case B16: with R wz = v sin(cut) the surfaces do not slip."""
    turn, speed = math.radians(30.0), 1.5
    a = ball((speed, 0.0, 0.0, 0.0, speed * math.sin(turn) / RADIUS))
    b = facing(a, turn, STILL)
    collide_balls("impulse", a, b, physics(0.95, 0.3))
    assert math.atan2(b.vy, b.vx) == pytest.approx(turn)
    assert b.wz == pytest.approx(0.0, abs=1e-12)


def test_throw_is_towards_the_way_the_surface_moves() -> None:
    """A stun cut throws the object ball forward along the cue ball's slide; english turns it about."""
    turn = math.radians(30.0)
    thrown = []
    for wz in (0.0, 100.0, -100.0):
        a = ball((1.5, 0.0, 0.0, 0.0, wz))
        b = facing(a, turn, STILL)
        collide_balls("impulse", a, b, physics(0.95, 0.06))
        thrown.append(math.degrees(turn - math.atan2(b.vy, b.vx)))
    plain, outside, inside = thrown
    assert 1.0 < plain < 4.0
    assert inside > 1.0
    assert outside < -1.0


def test_heavy_ball_drives_a_light_one_on() -> None:
    a = ball((1.0, 0.0, 0.0, 0.0, 0.0), mass=0.3)
    b = facing(a, 0.0, STILL, mass=0.1)
    collide_balls("impulse", a, b, physics(1.0, 0.0))
    assert (a.vx, b.vx) == pytest.approx((0.5, 1.5))


# What holds of every law.


def mirrored(motion: Motion) -> Motion:
    """A motion in a mirror along x: velocity across turns about, and spin about what lies in the mirror."""
    vx, vy, wx, wy, wz = motion
    return vx, -vy, -wx, wy, -wz


def turned(motion: Motion, turn: float) -> Motion:
    vx, vy, wx, wy, wz = motion
    c, s = math.cos(turn), math.sin(turn)
    return c * vx - s * vy, s * vx + c * vy, c * wx - s * wy, s * wx + c * wy, wz


@pytest.mark.parametrize("law", BALL_LAWS)
@given(one=MOTION, two=MOTION, turn=st.floats(0.0, 6.3), e=PART, mu=FRICTION)
def test_ball_laws_lose_energy_and_know_no_left_or_right(
    law: str, one: Motion, two: Motion, turn: float, e: float, mu: float
) -> None:
    a, c = ball(one), ball(mirrored(one))
    b, d = facing(a, turn, two), facing(c, -turn, mirrored(two))
    energy = a.energy() + b.energy()
    collide_balls(law, a, b, physics(e, mu))
    collide_balls(law, c, d, physics(e, mu))
    assert a.energy() + b.energy() <= energy * (1.0 + 1e-9) + 1e-15
    assert mirrored(state(c)) == pytest.approx(state(a), abs=1e-9)
    assert mirrored(state(d)) == pytest.approx(state(b), abs=1e-9)
    # Nor first and second.
    p = ball(one)
    q = facing(p, turn, two)
    collide_balls(law, q, p, physics(e, mu))
    assert (*state(p), *state(q)) == pytest.approx((*state(a), *state(b)), abs=1e-9)


@pytest.mark.parametrize("law", CUSHION_LAWS)
@given(motion=MOTION, e=PART, along=PART, mu=FRICTION, turn=st.floats(0.0, 6.3))
def test_cushion_laws_lose_energy_and_know_no_left_or_right(
    law: str, motion: Motion, e: float, along: float, mu: float, turn: float
) -> None:
    a, b, c = ball(motion), ball(mirrored(motion)), ball(turned(motion, turn))
    energy, approach = a.energy(), a.vx
    knobs = physics(e, mu)
    knobs = replace(knobs, cushion=replace(knobs.cushion, tangential=along))
    collide_cushion(law, a, 1.0, 0.0, knobs)
    collide_cushion(law, b, 1.0, 0.0, knobs)
    collide_cushion(law, c, math.cos(turn), math.sin(turn), knobs)
    assert a.energy() <= energy * (1.0 + 1e-9) + 1e-15
    assert mirrored(state(b)) == pytest.approx(state(a), abs=1e-9)
    assert turned(state(c), -turn) == pytest.approx(state(a), abs=1e-6)
    if approach <= 0.0:
        assert state(a) == motion
    else:
        assert a.vx <= 0.0
