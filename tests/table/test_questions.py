"""What a table answers: what is near, whether there is room, what is under a point, what a ball would meet."""

from __future__ import annotations

import math
import random

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from pool2d import Ball, Layout, load_table
from pool2d.physics.body import Body
from pool2d.physics.detect import SKIN, Rail
from pool2d.physics.motion import Motion
from pool2d.physics.values import POCKETED, RESTING, ROLLING

TABLE = load_table("pool-9ft")
RADIUS = TABLE.knobs.ball.radius
REACH = TABLE.reach(RADIUS)
TOUCH = 2.0 * RADIUS - SKIN
ALONG = st.floats(-0.1, 2.64)
ACROSS = st.floats(-0.1, 1.37)


def points_of(index: int) -> list[tuple[float, float]]:
    """Points on an element, some of them its outermost."""
    shape = TABLE.elements[index]
    if isinstance(shape, Rail):
        steps = (shape.length * i / 40 for i in range(41))
        return [(shape.ax + shape.dx * step, shape.ay + shape.dy * step) for step in steps]
    x, y, radius = (getattr(shape, name) for name in ("x", "y", "radius"))
    return [(x + radius * math.cos(i * math.pi / 8), y + radius * math.sin(i * math.pi / 8)) for i in range(16)]


POINTS = [(index, points_of(index)) for index in range(len(TABLE.elements))]


@given(ALONG, ACROSS, st.floats(0.0, 3.0), st.floats(0.0, 2.0))
def test_near_finds_all_that_is_in_a_box(x: float, y: float, width: float, height: float) -> None:
    found = TABLE.near(x, y, x + width, y + height)
    assert found == sorted(set(found))
    for index, points in POINTS:
        if any(x <= px <= x + width and y <= py <= y + height for px, py in points):
            assert index in found, TABLE.elements[index].name


def test_near_leaves_out_what_is_far() -> None:
    assert TABLE.near(0.6, 0.5, 0.7, 0.6) == []
    assert {TABLE.elements[i].name for i in TABLE.near(0.6, -0.1, 0.7, 0.1)} == {"bottom-left"}


@given(st.floats(0.0, 2.54), st.floats(0.0, 1.27), st.floats(0.0, 360.0) | st.sampled_from([0.0, 90.0, 180.0, 270.0]))
def test_cast_meets_what_a_look_at_everything_meets(x: float, y: float, angle: float) -> None:
    balls = Layout([Ball("1", 0.6, 0.3), Ball("2", 1.9, 0.9)])
    assume(TABLE.has_room(x, y, RADIUS, balls))
    dx, dy = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    way = Motion(Body(Ball("", x, y, dx, dy), 0, RADIUS, 0.17), ROLLING, 0.0, 8.0)
    first = min(element.time(way, REACH, 8.0) for element in TABLE.elements)
    for ball in balls.values():
        # The foot of the perpendicular from the ball, then back along the way to where the two touch.
        along, off = (ball.x - x) * dx + (ball.y - y) * dy, (ball.x - x) * dy - (ball.y - y) * dx
        if along > 0.0 and abs(off) < TOUCH:
            first = min(first, along - math.sqrt(TOUCH**2 - off**2))
    distance, what = TABLE.cast(x, y, dx, dy, balls)
    assert what is not None
    assert distance == pytest.approx(first, abs=1e-7)


@pytest.mark.parametrize(
    ("x", "y", "dx", "dy", "distance", "what"),
    [
        (0.6, 0.6, 0.0, -3.0, 0.6 - REACH, "bottom-left"),
        (0.6, 0.6, 1.0, 0.0, 0.4 - 2.0 * RADIUS, "1"),
        (1.9, 0.6, -2.0, 0.0, 0.9 - 2.0 * RADIUS, "1"),
        (1.9, 0.6, 1.0, 0.0, 0.64 - REACH, "right"),
    ],
)
def test_cast_along_an_axis(x: float, y: float, dx: float, dy: float, distance: float, what: str) -> None:
    layout = Layout([Ball("1", 1.0, 0.6), Ball("2", 0.6, 0.3, phase=POCKETED)])
    found, name = TABLE.cast(x, y, dx, dy, layout)
    assert found == pytest.approx(distance, abs=1e-8)
    assert name == what


def test_cast_does_not_count_the_ball_that_is_moved() -> None:
    layout = Layout([Ball("1", 1.0, 0.6)])
    assert TABLE.cast(0.6, 0.6, 1.0, 0.0, layout, ignore="1")[1] == "right"


def test_room() -> None:
    layout = Layout([Ball("1", 1.0, 0.6), Ball("2", 2.0, 0.6, phase=POCKETED)])
    assert TABLE.has_room(0.6, 0.6, RADIUS, layout)
    assert TABLE.has_room(0.6, REACH, RADIUS, layout)
    assert not TABLE.has_room(0.6, REACH - 1e-6, RADIUS, layout)
    assert TABLE.has_room(1.0 + 2.0 * RADIUS + 1e-9, 0.6, RADIUS, layout)
    assert not TABLE.has_room(1.0 + 2.0 * RADIUS - 1e-6, 0.6, RADIUS, layout)
    assert TABLE.has_room(1.01, 0.6, RADIUS, layout, ignore="1")
    assert TABLE.has_room(2.0, 0.6, RADIUS, layout)
    assert not TABLE.has_room(0.0, 0.0, RADIUS, layout)
    assert not TABLE.has_room(0.6, 3.0, RADIUS, layout)
    assert not TABLE.has_room(0.6, 1.0, 0.06, Layout([Ball("1", 0.6 + 2.0 * math.sqrt(0.06 * RADIUS) - 1e-6, 1.0)]))


def test_room_is_where_a_ball_may_be_set_down() -> None:
    """`has_room` and `settle` agree."""
    rng = random.Random(1)
    layout = TABLE.rack("eight-ball")
    places = [(rng.uniform(1.8, 2.6), rng.uniform(-0.05, 1.3)) for _ in range(400)]
    free = [place for place in places if TABLE.has_room(*place, RADIUS, layout)]
    # A third of where they lie is the rack or outside.
    assert 200 < len(free) < 330
    for x, y in free:
        ball = TABLE.settle(layout.put(Ball("new", x, y)))["new"]
        assert (ball.x, ball.y) == (x, y)


@pytest.mark.parametrize(
    ("x", "y", "what"),
    [
        (1.0, 0.6, "1"),
        (1.0, 0.6 + 0.99 * RADIUS, "1"),
        (1.0, 0.6 + 1.01 * RADIUS, None),
        (-0.01, -0.01, "bottom-left"),
        (1.27, 1.3, "top-side"),
        (0.6, -0.01, "bottom-left"),
        (0.6, 0.01, None),
        (2.55, 0.6, "right"),
        (1.9, 1.28, "top-right"),
    ],
)
def test_under(x: float, y: float, what: str | None) -> None:
    layout = Layout([Ball("1", 1.0, 0.6), Ball("2", 0.6, 0.01, phase=POCKETED)])
    assert TABLE.under(x, y, layout) == what


def test_ball_of_another_size_touches_elsewhere() -> None:
    big = Ball("1", 1.0, 0.6, radius=0.05, mass=0.3)
    assert TABLE.body_of(big) == (0.05, 0.3)
    assert TABLE.body_of(Ball("2", 1.0, 0.6)) == (RADIUS, 0.17)
    assert TABLE.touch(big, Ball("2", 0.0, 0.0)) == pytest.approx(2.0 * math.sqrt(0.05 * RADIUS))
    # The nose meets a ball where it is as high as the nose: R cos th from its centre in plan.
    tilt = math.asin(TABLE.knobs.cushion.nose_height / 0.05 - 1.0)
    assert TABLE.reach(0.05) == pytest.approx(0.05 * math.cos(tilt))
    assert TABLE.cast(0.6, 0.6, 0.0, -1.0, Layout(), radius=0.05)[0] == pytest.approx(0.6 - TABLE.reach(0.05))
    assert TABLE.settle(Layout([big]))["1"].phase == RESTING
