"""How balls part in the air and from the ground: what ends their bounces."""

from __future__ import annotations

import pytest

from pool2d import Ball, load_table
from pool2d.physics.body import Body
from pool2d.physics.flight.impact import GENTLE, LEAST, Surface, against, collide, glance, land, nearing

TABLE = load_table("pool-9ft")
R, MASS = 0.028575, 0.17


def body(**ball: float) -> Body:
    made = Body(Ball("cue", 0.5, 0.5), 0, R, MASS)
    for name, value in ball.items():
        setattr(made, name, value)
    return made


@pytest.mark.parametrize(("speed", "after"), [(0.25 * GENTLE, 0.25 * GENTLE), (GENTLE, GENTLE), (1.0, 0.5)])
def test_what_nears_gently_parts_as_it_met(speed: float, after: float) -> None:
    ball = body(vx=speed)
    against(ball, (1.0, 0.0, 0.0), Surface(0.5, 0.0))
    assert ball.vx == pytest.approx(-after, rel=1e-12)
    one, two = body(z=0.1, vx=speed), body(z=0.1, x=0.5 + 2.0 * R)
    numbers = TABLE.with_knobs({"ball.restitution": 0.5, "ball.law": "frictionless"}).bed.materials.ball
    collide(one, two, numbers)
    assert nearing(one, two) == pytest.approx(-after, rel=1e-12)


def test_the_ground_ends_low_hops_and_all_that_was_held_up() -> None:
    ball = body(vz=-1.9 * LEAST, held=7)
    land(ball, 0.0, Surface(0.5, 0.2))
    assert (ball.vz, ball.z, ball.held) == (0.0, 0.0, 0)
    land(higher := body(vz=-2.1 * LEAST), 0.0, Surface(0.5, 0.2))
    assert higher.vz == pytest.approx(1.05 * LEAST)


@pytest.mark.parametrize(("up", "after"), [(0.5 * LEAST, 0.0), (2.0 * LEAST, 2.0 * LEAST), (-1.0, 0.5)])
def test_a_ball_that_lay_is_lifted_only_by_what_makes_a_hop(up: float, after: float) -> None:
    ball = body(vz=up)
    TABLE.bed.answer(ball)
    assert ball.vz == pytest.approx(after)


def test_a_ball_that_leaves_the_cloth_owes_it_no_friction() -> None:
    ball = body(vz=1.0, paid=9.0)
    TABLE.bed.fall(ball, 0.0)
    assert ball.paid == 0.0


def test_a_glance_takes_what_it_needs_from_the_slide() -> None:
    ball = body(vy=1.0)
    before = ball.energy()
    glance(ball, (1.0, 0.0, 0.0), 0.1)
    assert ball.vx == pytest.approx(-0.1)
    assert before * (1.0 - 1e-12) < ball.energy() <= before
    slow = body(vy=0.1)
    glance(slow, (1.0, 0.0, 0.0), 0.1)
    assert slow.vx == pytest.approx(-0.03)
