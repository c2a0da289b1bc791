"""Contacts at speeds that a motion takes for rest: they end, whatever pushes, and nothing is moved by them."""

from __future__ import annotations

import math

import pytest

from pool2d import Ball, load_table
from pool2d.physics.body import Body
from pool2d.physics.contact import Contacts
from pool2d.physics.crowd import Crowd
from pool2d.physics.detect import NOISE
from pool2d.physics.motion import STILL, start

TABLE = load_table("pool-9ft")
RADIUS = TABLE.knobs.ball.radius
LOW = TABLE.reach(RADIUS)


def contacts(*balls: Ball, masses: tuple[float, ...]) -> tuple[Contacts, list[Body]]:
    """Balls that have had the cloth's friction for the next second, and what they meet."""
    bodies = [Body(ball, i, RADIUS, mass, LOW) for i, (ball, mass) in enumerate(zip(balls, masses, strict=True))]
    for body in bodies:
        body.paid = 1.0
    crowd = Crowd(bodies, [start(body, 0.0, TABLE.bed.materials.cloth) for body in bodies])
    return Contacts(crowd, list(TABLE.elements), TABLE.bed), bodies


def closing(a: Body, b: Body) -> float:
    turn = math.atan2(b.y - a.y, b.x - a.x)
    return (a.vx - b.vx) * math.cos(turn) + (a.vy - b.vy) * math.sin(turn)


@pytest.mark.parametrize("turn", [0.0, 0.7, 2.0, -2.9])
@pytest.mark.parametrize("masses", [(2.0, 0.01), (0.17, 0.17), (0.01, 2.0)])
@pytest.mark.parametrize("speed", [STILL, 3e-10, 2e-12])
def test_a_ball_that_creeps_against_one_at_rest_stops_before_it(
    turn: float, masses: tuple[float, float], speed: float
) -> None:
    """Once the lighter one was given a speed that its motion rounded away, and was met again thousands of times."""
    x, y = math.cos(turn), math.sin(turn)
    spinning = Ball("1", 1.0, 0.6, 0.99 * speed * x, 0.99 * speed * y, wy=150.0)
    other = Ball("2", 1.0 + 2.0 * RADIUS * x, 0.6 + 2.0 * RADIUS * y)
    for order in ((spinning, other), (other, spinning)):
        heavy_first = masses if order[0] is spinning else masses[::-1]
        meet, (a, b) = contacts(*order, masses=heavy_first)
        met = meet.balls(a, b, 0.0)
        assert [(one.id, two.id) for one, two in met.pairs] == [(a.id, b.id)]
        for body in (a, b):
            start(body, 0.0, TABLE.bed.materials.cloth)
        assert closing(a, b) <= NOISE
        by_name = {body.id: body for body in (a, b)}
        assert by_name["1"].wy == 150.0
        assert by_name["2"].velocity() == (0.0, 0.0, 0.0, 0.0, 0.0)


def test_a_ball_that_goes_by_loses_only_what_it_has_toward_the_other() -> None:
    meet, (a, b) = contacts(Ball("1", 1.0, 0.6, 5e-10, 2.0), Ball("2", 1.0 + 2.0 * RADIUS, 0.6), masses=(0.17, 0.17))
    meet.balls(a, b, 0.0)
    assert (a.vx, a.vy) == (0.0, 2.0)
    assert (b.vx, b.vy) == (0.0, 0.0)


def test_two_that_go_together_still_push_each_other() -> None:
    """One that catches up by less than rounding: what they have in common they keep."""
    meet, (a, b) = contacts(
        Ball("1", 1.0, 0.6, 0.5 + 5e-10), Ball("2", 1.0 + 2.0 * RADIUS, 0.6, 0.5), masses=(0.17, 0.17)
    )
    meet.balls(a, b, 0.0)
    assert closing(a, b) <= 0.0
    assert a.vx == pytest.approx(0.5, abs=1e-9) and b.vx == pytest.approx(0.5, abs=1e-9)
    assert a.vx + b.vx == pytest.approx(1.0 + 5e-10, abs=1e-15)


@pytest.mark.parametrize("speed", [STILL, 2e-12])
def test_a_ball_that_creeps_into_a_rail_stops_before_it(speed: float) -> None:
    rail = next(element for element in TABLE.elements if element.name == "bottom-left")
    meet, (ball,) = contacts(Ball("1", 0.8, LOW, 0.3, -speed, wx=50.0), masses=(0.17,))
    met = meet.cushion(ball, rail, 0.0)
    assert [(body.id, name) for body, name in met.rails] == [("1", "bottom-left")]
    assert (ball.vx, ball.vy, ball.wx) == (0.3, 0.0, 50.0)
