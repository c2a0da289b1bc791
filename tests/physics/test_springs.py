"""One contact at a time: what a spring says of an approach and takes off it, and how long an impact is and how deep."""

from __future__ import annotations

import math
from collections.abc import Iterator

import pytest

from pool2d import Ball, Shot
from pool2d.physics.body import Body
from pool2d.physics.detect import Rail
from pool2d.physics.materials import materials
from pool2d.physics.params import Cue, Physics
from pool2d.physics.springs import BallSpring, NoseSpring, depth, duration, pace, stay, stiffness, yielding
from pool2d.physics.strike import TipSpring, strike

MATERIALS = materials(Physics())
SIZES = [(0.028575, 0.17, 0.028575, 0.17), (0.02, 0.1, 0.05, 1.2), (0.06, 0.3, 0.015, 0.05)]


def pair(turn: float, sizes: tuple[float, float, float, float]) -> tuple[Body, Body]:
    """Two balls that touch, the second in the direction `turn`, in any motion."""
    ra, ma, rb, mb = sizes
    apart = 2.0 * math.sqrt(ra * rb)
    a = Ball("a", 1.0, 0.5, 0.7, -0.4, 3.0, -5.0, 11.0)
    b = Ball("b", 1.0 + apart * math.cos(turn), 0.5 + apart * math.sin(turn), -0.2, 0.9, -7.0, 2.0, 4.0)
    return Body(a, 0, ra, ma), Body(b, 1, rb, mb)


def momentum(*balls: Body) -> tuple[float, float]:
    return math.fsum(ball.mass * ball.vx for ball in balls), math.fsum(ball.mass * ball.vy for ball in balls)


def across(ball: Body, a: Body, b: Body) -> float:
    """How fast a ball goes across the line of centres of two."""
    return (ball.vy * (b.x - a.x) - ball.vx * (b.y - a.y)) / math.hypot(b.x - a.x, b.y - a.y)


def spins(*balls: Body) -> list[float]:
    return [spin for ball in balls for spin in (ball.wx, ball.wy, ball.wz)]


def pairs() -> Iterator[tuple[Body, Body]]:
    for i in range(12):
        for sizes in SIZES:
            yield pair(math.tau * i / 12.0, sizes)


def test_what_is_taken_off_an_approach_is_what_was_asked_for_and_without_friction() -> None:
    for a, b in pairs():
        spring = BallSpring(a, b, 0.0, 1.0, 0.1, MATERIALS)
        closing, before, turning = spring.closing(), momentum(a, b), spins(a, b)
        sliding = across(a, a, b), across(b, a, b)
        spring.part(0.25)
        assert spring.closing() == pytest.approx(closing - 0.25, abs=1e-14)
        assert momentum(a, b) == pytest.approx(before, abs=1e-15)
        assert spins(a, b) == turning
        assert (across(a, a, b), across(b, a, b)) == pytest.approx(sliding, abs=1e-14)


def test_a_ball_that_goes_into_one_that_cannot_move_stops_before_it_and_only_that_ball() -> None:
    for fixed in (0, 1):
        for a, b in pairs():
            spring = BallSpring(a, b, 0.0, 1.0, 0.1, MATERIALS)
            still, free = ((b, a), (a, b))[1 - fixed]
            kept, closing, turning = still.velocity(), spring.closing(), spins(a, b)
            sliding = across(free, a, b)
            still.mass = math.inf
            spring.part(closing)
            assert spring.closing() == pytest.approx(0.0, abs=1e-14)
            assert still.velocity() == kept
            assert spins(a, b) == turning
            # Along the other one it slides on.
            assert across(free, a, b) == pytest.approx(sliding, abs=1e-14)


def test_an_approach_to_a_cushion_is_the_speed_across_and_can_be_taken_off() -> None:
    for i in range(12):
        turn = math.tau * i / 12.0
        rail = Rail("rail", 0.0, 0.0, math.cos(turn), math.sin(turn))
        ball = Body(Ball("a", 0.1, 0.2, 0.7, -0.4, 3.0, -5.0, 11.0), 0, 0.028575, 0.17, 0.027)
        spring = NoseSpring(ball, rail, 0.0, 1, MATERIALS)
        # The table is on the left of a rail: into it is to the right of its way.
        into = math.sin(turn) * ball.vx - math.cos(turn) * ball.vy
        along = math.cos(turn) * ball.vx + math.sin(turn) * ball.vy
        turning = spins(ball)
        assert spring.closing() == pytest.approx(into, abs=1e-15)
        spring.part(0.3)
        assert spring.closing() == pytest.approx(into - 0.3, abs=1e-14)
        assert math.cos(turn) * ball.vx + math.sin(turn) * ball.vy == pytest.approx(along, abs=1e-14)
        assert spins(ball) == turning


def tip_on(shot: Shot, restitution: float = 0.73, mass: float = 0.54) -> tuple[Body, TipSpring]:
    """A ball that lies still, and the tip that has just come to it."""
    ball = Body(Ball("cue", 0.5, 0.5), 0, 0.028575, 0.17)
    stroke = strike(ball, shot, Cue(tip_restitution=restitution, mass=mass))
    tip = TipSpring(ball, stroke)
    ball.set_velocity((0.0, 0.0, 0.0, 0.0, 0.0))
    ball.vz = 0.0
    return ball, tip


SHOTS = [
    Shot(speed=2.0),
    Shot(angle=40.0, speed=3.0, side=0.3, height=-0.2),
    Shot(angle=-110.0, speed=1.0, side=-0.2, height=0.4, elevation=35.0),
]


@pytest.mark.parametrize("shot", SHOTS)
def test_an_approach_to_the_tip_is_the_cues_speed_and_what_is_taken_off_it_cue_and_ball_share(shot: Shot) -> None:
    ball, tip = tip_on(shot)
    assert tip.closing() == pytest.approx(shot.speed)
    before, cue = momentum(ball), tip.speed
    tip.part(0.4)
    assert tip.closing() == pytest.approx(shot.speed - 0.4)
    # What the ball has got along the table the cue has lost along itself, but for what the slate and squirt take.
    gained = math.hypot(*(new - old for new, old in zip(momentum(ball), before, strict=True)))
    lost = 0.54 * (cue - tip.speed)
    assert lost > 0.0 and gained == pytest.approx(lost * math.cos(math.radians(shot.elevation)), rel=1e-2)
    # To take all of it is an impact that gives nothing back: tip and ball go on together.
    tip.part(tip.closing())
    assert tip.closing() == pytest.approx(0.0, abs=1e-12)
    alone = Body(Ball("cue", 0.5, 0.5), 0, 0.028575, 0.17)
    strike(alone, shot, Cue(tip_restitution=0.0, mass=0.54))
    assert ball.velocity() == pytest.approx(alone.velocity(), abs=1e-9)


def test_a_tip_that_has_relaxed_lets_go_and_pushes_anew_when_it_comes_again() -> None:
    """One that gives little back has lost its push long before the ball has come all the way out of it."""
    ball, tip = tip_on(Shot(speed=2.0), restitution=0.1)
    dt, deepest = 0.1 * tip.step, 0.0
    while tip.closing() > 0.0:
        assert tip.press(dt)
        tip.act()
        deepest = tip.depth
    # It is drawn back slowly.
    tip.speed, steps = ball.vx - 0.01, 0
    while tip.press(dt):
        steps += 1
        assert steps * 0.01 * dt < 0.2 * deepest
    assert tip.depth == 0.0 and not tip.press(dt)
    tip.speed = ball.vx + 1.0
    gone = ball.vx
    assert tip.press(dt)
    tip.act()
    assert ball.vx > gone and tip.depth == pytest.approx(dt, rel=0.02)


def test_an_impact_lasts_and_is_as_deep_as_hertz_has_it() -> None:
    """Balls alone, without a loss, integrated here in small steps: m x'' = -K x^1.5."""
    for sizes in SIZES:
        a, b = pair(0.7, sizes)
        mass = 1.0 / (1.0 / a.mass + 1.0 / b.mass)
        for speed in (0.1, 2.0):
            x, v, t = 0.0, speed, 0.0
            dt, deepest = duration(a, b, speed) / 4000.0, 0.0
            while x >= 0.0 and t < 2.0 * duration(a, b, speed):
                v -= 0.5 * dt * stiffness(a, b) * x**1.5 / mass
                x += dt * v
                v -= 0.5 * dt * stiffness(a, b) * max(x, 0.0) ** 1.5 / mass
                t += dt
                deepest = max(deepest, x)
            assert t == pytest.approx(duration(a, b, speed), rel=1e-3)
            assert deepest == pytest.approx(depth(a, b, speed), rel=1e-3)


def test_contacts_of_hertz_scale() -> None:
    """Four times the effective radius is twice as stiff; time goes as v^-0.2, depth as v^0.8."""
    a, b = pair(0.3, SIZES[0])
    assert stiffness(a, b) == pytest.approx(8.06e8)
    for a, b in pairs():
        assert duration(a, b, 32.0) == pytest.approx(0.5 * duration(a, b, 1.0))
        assert depth(a, b, 32.0) == pytest.approx(16.0 * depth(a, b, 1.0))
        assert stiffness(a, b) == stiffness(b, a)
        large = (
            Body(Ball("a", 0.0, 0.0), 0, 4.0 * a.radius, a.mass),
            Body(Ball("b", 0.0, 0.0), 1, 4.0 * b.radius, b.mass),
        )
        assert stiffness(*large) == pytest.approx(2.0 * stiffness(a, b))


def test_a_cushion_swings_as_a_mass_on_a_spring_does() -> None:
    for mass in (0.05, 0.17, 1.2):
        ball = Body(Ball("a", 0.0, 0.0), 0, 0.03, mass)
        # Half a period, and a quarter of one deep in: the way is v / omega.
        assert yielding(ball, 3.0) == pytest.approx(3.0 * stay(ball) / math.pi)
        assert yielding(ball, 6.0) == pytest.approx(2.0 * yielding(ball, 3.0))
    # Four milliseconds for a pool ball.
    assert stay(Body(Ball("a", 0.0, 0.0), 0, 0.028575, 0.17)) == pytest.approx(4e-3, rel=0.02)


def test_a_step_goes_into_a_contact_and_not_past_it() -> None:
    a, b = pair(0.0, SIZES[0])
    gap = 1e-4
    spring = BallSpring(a, b, gap, 1.0, 0.1, MATERIALS)
    closing = spring.closing()
    assert closing > 0.0
    step = pace(spring, 1.0)
    assert step == pytest.approx(gap / closing + 0.5 * spring.step)
    assert pace(spring, 0.5 * step) == 0.5 * step
    assert spring.press(step) and spring.depth > 0.0 and pace(spring, 1.0) == spring.step
    a.vx, b.vx = -1.0, 1.0
    apart = BallSpring(a, b, gap, 1.0, 0.1, MATERIALS)
    assert pace(apart, 1.0) == 1.0 and not apart.press(1e-3)
