"""How exact the integration of a cushion is; the comment above `cushions.STEPS` tells what is found here."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import product

import pytest

from pool2d import Ball
from pool2d.physics.body import Body
from pool2d.physics.laws import cushion_mathavan2010
from pool2d.physics.materials import materials
from pool2d.physics.params import BallKnobs, Cloth, CushionKnobs, Physics

from ...hits import collide_cushion

State = tuple[float, float, float, float, float]
RADIUS = BallKnobs().radius
POOL = Physics()
SNOOKER = Physics(
    cloth=Cloth(mu_slide=0.212),
    cushion=CushionKnobs(restitution=0.98, friction=0.14, nose_height=1.4 * RADIUS),
)


def impacts() -> Iterator[State]:
    """At 1 m/s: from grazing to square, from draw to more than rolling, english of either hand."""
    for incidence, topspin, english in product((5, 25, 45, 65, 90), (-1.0, 0.0, 0.5, 1.0, 1.5), (-2, -0.7, 0, 0.3, 1)):
        turn = math.radians(incidence)
        vx, vy = math.cos(turn), math.sin(turn)
        yield vx, vy, -topspin * vy / RADIUS, topspin * vx / RADIUS, english / RADIUS


def rebounds(physics: Physics, steps: int) -> list[State]:
    """Velocities and spins times the radius."""
    found = []
    for motion in impacts():
        ball = Body(Ball("1", 0.0, 0.0, *motion), 0, RADIUS, BallKnobs().mass)
        cushion_mathavan2010.collide(ball, 0.0, 1.0, materials(physics).cushion, steps)
        found.append((ball.vx, ball.vy, RADIUS * ball.wx, RADIUS * ball.wy, RADIUS * ball.wz))
    return found


@pytest.mark.parametrize(
    ("physics", "speed", "spin"), [(POOL, 1.1e-3, 1.0e-2), (SNOOKER, 2.2e-3, 1.9e-2)], ids=["pool", "snooker"]
)
def test_steps_are_as_exact_as_they_are_said_to_be(physics: Physics, speed: float, spin: float) -> None:
    found, exact = rebounds(physics, cushion_mathavan2010.STEPS), rebounds(physics, 2000)
    errors = [[abs(a - b) for a, b in zip(*pair, strict=True)] for pair in zip(found, exact, strict=True)]
    speeds = [max(error[:2]) for error in errors]
    assert 0.9 * speed < max(speeds) < speed
    assert 0.9 * spin < max(max(error[2:]) for error in errors) < spin
    assert sum(speeds) / len(speeds) < 2e-4


@pytest.mark.parametrize("topspin", [-1.0, -0.5, 0.0, 0.3, 0.8, 1.0, 1.2])
def test_what_is_a_little_off_square_stays_so(topspin: float) -> None:
    """A slip that ends and turns must not lift what is rounding into something to be seen."""
    for aside in (1e-15, 1e-9, 1e-5):
        ball = Body(Ball("1", 0.0, 0.0, aside, 1.0, -topspin / RADIUS), 0, RADIUS, BallKnobs().mass)
        collide_cushion("mathavan2010", ball, 0.0, 1.0, POOL)
        assert 0.0 < ball.vx < aside
