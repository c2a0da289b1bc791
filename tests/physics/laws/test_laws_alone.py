"""Laws against what they say, worked out here in another way."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from pool2d import Ball, Layout, load_table, simulate
from pool2d.physics.body import Body
from pool2d.physics.laws import law
from pool2d.physics.laws.law import BallLaw, CushionLaw, CushionNumbers
from pool2d.physics.laws.registry import BALL_LAWS, CUSHION_LAWS
from pool2d.physics.params import BallKnobs, Cloth

from ...hits import hit
from ...scenes import open_table

Vector = NDArray[np.float64]
RADIUS = BallKnobs().radius


@pytest.mark.parametrize("law", ["impulse", "han2005"])
@pytest.mark.parametrize("e", [0.1, 0.5, 0.92, 1.0])
def test_a_smooth_corner_gives_back_what_each_of_its_cushions_does(law: str, e: float) -> None:
    """Both are met at once. Han's nose pushes at cos th, and what that sends upward is lost: cos^2 th (1 + e) - 1."""
    table = load_table("carom-10ft", {"cushion.law": law, "cushion.friction": 0.0, "cushion.restitution": e})
    hit = next(event for event in simulate(table, Layout([Ball("white", 0.4, 0.4, -2.0, -2.0)])).events if event.rails)
    assert len(hit.rails) == 2
    sin = table.knobs.cushion.nose_height / table.knobs.ball.radius - 1.0 if law == "han2005" else 0.0
    kept = (1.0 - sin * sin) * (1.0 + e) - 1.0
    before, after = hit.before["white"], hit.after["white"]
    assert (-after.vx / before.vx, -after.vy / before.vy) == pytest.approx((kept, kept), abs=5e-3)


@pytest.mark.parametrize("law", CUSHION_LAWS)
@pytest.mark.parametrize("e", [0.1, 0.5, 0.92])
def test_a_smooth_corner_is_much_like_each_of_its_cushions_alone(law: str, e: float) -> None:
    """Whichever the law, and wherever the nose stands: only what the cloth takes meanwhile is another."""
    table = load_table("carom-10ft", {"cushion.law": law, "cushion.friction": 0.0, "cushion.restitution": e})
    kept = []
    for vy in (-2.0, 0.0):
        events = simulate(table, Layout([Ball("white", 0.4, 0.4, -2.0, vy)])).events
        hit = next(event for event in events if event.kind in ("ball_cushion", "cluster"))
        assert hit.kind == ("cluster" if vy else "ball_cushion")
        kept.append(-hit.after["white"].vx / hit.before["white"].vx)
    assert kept[0] == pytest.approx(kept[1], rel=0.06)


def test_a_dead_nose_that_lifts_gives_nothing_back() -> None:
    """Han's law would leave the ball in it: it parts with a breath of speed, from a corner as from one cushion."""
    table = load_table("carom-10ft", {"cushion.law": "han2005", "cushion.friction": 0.0, "cushion.restitution": 0.0})
    hit = next(event for event in simulate(table, Layout([Ball("white", 0.4, 0.4, -2.0, -2.0)])).events if event.rails)
    after = hit.after["white"]
    assert 0.0 < after.vx < 0.1
    assert after.vx == pytest.approx(after.vy, rel=1e-9)


def mathavan(cut: float, speed: float, topspin: float, english: float, e: float, mu: float) -> tuple[Vector, Vector]:
    """The paper's equations in vectors and small steps: velocity and R w of the cue ball and of the other."""
    turn, step = math.radians(cut), 5e-4 * speed
    n, up = np.array([math.cos(turn), math.sin(turn), 0.0]), np.array([0.0, 0.0, 1.0])
    v = np.array([[speed, 0.0, 0.0], [0.0, 0.0, 0.0]])
    q = np.array([[0.0, topspin * speed, english * speed], [0.0, 0.0, 0.0]])

    def near() -> float:
        return float((v[0] - v[1]) @ n)

    def press() -> float:
        """One step of the normal impulse, per mass; the work it takes."""
        before = near()
        slip = v[0] - v[1] + np.cross(q[0] + q[1], n)
        slip -= (slip @ n) * n
        size = float(np.linalg.norm(slip))
        # Seven halves of the friction on each of the two balls take the slip away.
        rub = -slip / size * min(mu * step, size / 7.0) if size > 0.0 else 0.0 * slip
        for i, part in enumerate((rub - step * n, step * n - rub)):
            v[i] += part - (part @ up) * up
            q[i] += 2.5 * np.cross(n, rub)
        down = 0 if rub[2] < 0.0 else 1
        drag = v[down] + np.cross(q[down], -up)
        size = float(np.linalg.norm(drag))
        if size > 0.0:
            force = -drag / size * min(Cloth().mu_slide * abs(rub[2]), 2.0 / 7.0 * size)
            v[down] += force
            q[down] += 2.5 * np.cross(-up, force)
        return 0.5 * (before + near()) * step

    work = 0.0
    while near() > 0.0:
        work += press()
    left = e * e * work
    while left > 0.0:
        left += press()
    return v, q


@pytest.mark.parametrize(
    ("cut", "topspin", "english"),
    [(0.0, 1.0, 0.0), (30.0, 1.0, 0.4), (45.0, -1.0, -0.8), (-60.0, 0.3, 1.2)],
)
def test_mathavan_2014_does_what_the_paper_says(cut: float, topspin: float, english: float) -> None:
    e, mu, speed = 0.89, 0.3, 1.5
    table = open_table(ball__law="mathavan2014", ball__restitution=e, ball__friction=mu)
    found = hit(table, cut, speed, topspin, english)
    v, q = mathavan(cut, speed, topspin, english, e, mu)
    for i, ball in enumerate((found.cue, found.other)):
        assert (ball.vx, ball.vy, 0.0) == pytest.approx(v[i].tolist(), abs=2e-3)
        assert (RADIUS * ball.wx, RADIUS * ball.wy, RADIUS * ball.wz) == pytest.approx(q[i].tolist(), abs=8e-3)


def test_a_law_that_lacks_a_part_fails_where_it_is_made() -> None:
    whole = BALL_LAWS["impulse"]
    with pytest.raises(ValueError, match="the law 'mine' has no friction"):
        BallLaw("mine", whole.collide, None)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="the law '' has no name"):
        CushionLaw("", CUSHION_LAWS["impulse"].collide, CUSHION_LAWS["impulse"].nose)


def test_every_law_is_found_by_its_file() -> None:
    files = {path.stem for path in Path(law.__file__).parent.glob("*_*.py") if not path.stem.startswith("_")}
    assert files == {f"ball_{name}" for name in BALL_LAWS} | {f"cushion_{name}" for name in CUSHION_LAWS}


def test_steps_add_nothing_to_a_gentle_elastic_rebound() -> None:
    """Once this one, at a jaw, gained 1e-14 J of 7e-8."""
    numbers = CushionNumbers(0.4052611097399126, 0.0, 0.3184086903752853, 0.03276996194417735, 0.4553129369500048)
    spins = (0.06042969971114378, -0.04321321743968966, 0.006152979195535952)
    ball = Body(Ball("1", 0.0, 0.0, -0.0011177623707158803, -0.0021093124804899346, *spins), 0, 0.06, 0.01)
    before = ball.energy()
    CUSHION_LAWS["mathavan2010"].collide(ball, 0.7880107536067235, -0.6156614753256563, numbers)
    assert ball.vx * 0.7880107536067235 < ball.vy * 0.6156614753256563
    assert ball.energy() <= before
