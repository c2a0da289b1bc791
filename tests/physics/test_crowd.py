"""The broad phase of balls: whoever may be in a box is found, however the balls have moved meanwhile."""

from __future__ import annotations

import math
import random

import pytest

from benchmarks.speed_cases import crowd as many_balls
from pool2d import Ball, simulate
from pool2d.physics.body import Body
from pool2d.physics.crowd import FEW, Crowd
from pool2d.physics.motion import ClothNumbers, Motion, pocketed, start

from ..checks import assert_sound

CLOTH = ClothNumbers(mu_slide=0.2, mu_roll=0.01, mu_spin=0.0127, gravity=9.81)


def any_ball(index: int, size: float, rng: random.Random) -> Body:
    """A ball somewhere on a square of that size: at rest, spinning on the spot, or moving."""
    speed, spin = rng.choice(((0.0, 0.0), (0.0, 30.0), (rng.uniform(-3.0, 3.0), 5.0)))
    ball = Ball(str(index), rng.uniform(0.0, size), rng.uniform(0.0, size), speed, 0.5 * speed, wz=spin)
    return Body(ball, index, rng.choice((0.02, 0.03)), 0.17)


def bounded(body: Body, seconds: float) -> Motion:
    motion = start(body, 0.0, CLOTH)
    if not motion.stays():
        motion.bound(0.0, min(seconds, motion.t1))
    return motion


def among(motion: Motion, left: float, bottom: float, right: float, top: float, seconds: float) -> bool:
    """Whether a ball's centre is in a box at any of many moments."""
    times = [min(seconds, motion.t1) * i / 50 for i in range(51)] if not motion.stays() else [0.0]
    return any(left <= x <= right and bottom <= y <= top for x, y in (motion.place(t) for t in times))


@pytest.mark.parametrize(("count", "size"), [(3, 0.5), (16, 2.0), (200, 2.0), (200, 10.0)])
def test_whoever_is_in_a_box_is_found(count: int, size: float) -> None:
    rng = random.Random(f"{count} {size}")
    bodies = [any_ball(i, size, rng) for i in range(count)]
    crowd = Crowd(bodies, [bounded(body, 0.3) for body in bodies])
    for motion in crowd.motion:
        crowd.put(motion)
    asked = found = 0
    for _ in range(60):
        # Someone moves on, or is pocketed, and is in no box until it is put back.
        body = bodies[rng.randrange(count)]
        other = any_ball(body.index, size, rng)
        bodies[body.index] = crowd.bodies[body.index] = other
        motion = bounded(other, 0.3) if rng.random() < 0.9 else pocketed(other, 0.0)
        crowd.lift(motion)
        assert motion not in crowd.near(-99.0, -99.0, 99.0, 99.0)
        if motion.phase != "pocketed":
            crowd.put(motion)
        x, y, wide, high = (rng.uniform(0.0, size) for _ in range(4))
        box = (x - wide / 4, y - high / 4, x + wide / 4, y + high / 4)
        near = {motion.id for motion in crowd.near(*box)}
        there = {m.id for m in crowd.motion if m.phase != "pocketed" and among(m, *box, seconds=0.3)}
        assert there <= near
        asked, found = asked + count, found + len(near)
    # It spares work: not everybody is in every box.
    assert found < 0.5 * asked


def test_whoever_is_asked_for_is_brought_to_the_present() -> None:
    bodies = [
        Body(Ball("a", 0.0, 0.0), 0, 0.03, 0.17),
        Body(Ball("b", 0.5, 0.0, -1.0, wz=50.0), 1, 0.03, 0.17),
        Body(Ball("c", 0.1, 0.1, wz=40.0), 2, 0.03, 0.17),
        Body(Ball("d", 3.0, 0.0, 1.0), 3, 0.03, 0.17),
    ]
    crowd = Crowd(bodies, [bounded(body, 0.3) for body in bodies])
    for motion in crowd.motion:
        crowd.put(motion)
    near = crowd.around(bodies[0], 0.4, 0.25)
    assert sorted(body.id for body in near) == ["b", "c"]
    for body in near:
        ball = crowd.motion[body.index].at(0.25)
        assert (body.x, body.y, body.vx, body.wz) == (ball.x, ball.y, ball.vx, ball.wz)
        assert body.wz < 40.0 or body.id == "b"
    assert bodies[3].x == 3.0


@pytest.mark.parametrize("count", [FEW, FEW + 1, 200])
def test_none_of_many_on_the_move_passes_through_another(count: int) -> None:
    """Where they are many, each is followed from cell to cell: none may be overlooked on the way."""
    table, layout = many_balls(count, seed=3)
    roll = simulate(table, layout, events=5 * count)
    assert sum(len(event.pairs) for event in roll.events) > 0.5 * count
    assert_sound(table, roll)


def test_a_motion_is_followed_through_about_one_cell() -> None:
    """However it goes: fast, braking, or from rest by its spin."""
    rng = random.Random(2)
    bodies = [any_ball(i, 5.0, rng) for i in range(FEW + 1)]
    crowd = Crowd(bodies, [bounded(body, 0.3) for body in bodies])
    for ball in (Ball("a", 1.0, 1.0, 6.0), Ball("a", 1.0, 1.0, wx=900.0), Ball("a", 1.0, 1.0, 4.0, wy=-900.0)):
        motion = start(Body(ball, 0, 0.03, 0.17), 2.0, CLOTH)
        for now in (2.0, 2.1):
            x, y = motion.place(now)
            far = max(math.dist((x, y), motion.place(now + crowd.horizon(motion, now) * i / 20)) for i in range(21))
            assert 0.3 * crowd.size < far < 1.001 * crowd.size
    assert Crowd(bodies[:FEW], [bounded(body, 0.3) for body in bodies[:FEW]]).horizon(motion, 2.0) == math.inf
