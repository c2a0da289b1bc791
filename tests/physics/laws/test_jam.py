"""Cushions of any make: a ball always comes off, and never with more energy."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pool2d.config.knobs import apply
from pool2d.physics.body import Body
from pool2d.physics.laws.registry import CUSHION_LAWS
from pool2d.physics.params import Physics
from pool2d.physics.values import Ball

from ...hits import collide_cushion

RADIUS = 0.03
PART = st.floats(0.0, 1.0)
SPIN = st.floats(-400.0, 400.0)


@pytest.mark.parametrize("law", CUSHION_LAWS)
@given(
    restitution=PART, nose=PART, cloth=st.floats(0.01, 1.0), height=st.floats(0.4, 1.9),
    along=st.floats(-5.0, 5.0), into=st.floats(1e-6, 5.0), spin=st.tuples(SPIN, SPIN, SPIN),
)  # fmt: skip
def test_a_ball_comes_off_and_gains_nothing(
    law: str, restitution: float, nose: float, cloth: float, height: float, along: float, into: float,
    spin: tuple[float, float, float],
) -> None:  # fmt: skip
    knobs: dict[str, object] = {
        "cushion.restitution": restitution,
        "cushion.friction": nose,
        "cushion.nose_height": height * RADIUS,
        "cloth.mu_slide": cloth,
    }
    ball = Body(Ball("1", 0.0, 0.0, along, into, *spin), 0, RADIUS, 0.17)
    before = ball.energy()
    collide_cushion(law, ball, 0.0, 1.0, apply(Physics(), knobs, "test"))
    assert ball.vy < 0.0
    assert ball.energy() <= before * (1.0 + 1e-12)
