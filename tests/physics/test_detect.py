"""When balls meet things: against a dense look at where they are."""

from __future__ import annotations

import math
import random

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from pool2d import Ball, load_table
from pool2d.physics.body import Body
from pool2d.physics.cluster import facing
from pool2d.physics.detect import SKIN, Jaw, Pocket, Rail, time_ball_ball
from pool2d.physics.motion import ClothNumbers, Motion, start

from ..plays import between

RADIUS, STEPS = 0.028575, 300
CLOTH = ClothNumbers(mu_slide=0.2, mu_roll=0.01, mu_spin=0.0127, gravity=9.81)
TOUCH = 2.0 * RADIUS
RAIL = Rail("rail", 0.2, 0.0, 0.8, 0.0)
PLACE, SPEED, SPIN = between(0.0, 1.0), between(-3.0, 3.0), between(-100.0, 100.0)
ANYWHERE = st.tuples(PLACE, PLACE, SPEED, SPEED, SPIN, SPIN)
# Few of these meet anything; so others are sent to where the jaw and the pocket are, or lie there, or come down on the
# rail.
MIDDLE = st.tuples(between(0.4, 0.6), between(0.4, 0.6), between(-0.2, 0.2), between(-0.2, 0.2), SPIN, SPIN)
SENT = st.builds(
    lambda x, y, aside, part, wx, wy: (x, y, part * (0.5 + aside - x), part * (0.5 - y), wx, wy),
    PLACE, PLACE, between(-0.1, 0.1), between(1.0, 6.0), SPIN, SPIN,
)  # fmt: skip
BALL = ANYWHERE | SENT
DOWN = st.tuples(PLACE, between(RADIUS, 0.2), between(-1.0, 1.0), between(-3.0, -0.5), SPIN, SPIN)


def move(x: float, y: float, vx: float = 0.0, vy: float = 0.0, wx: float = 0.0, wy: float = 0.0) -> Motion:
    return start(Body(Ball("", x, y, vx, vy, wx, wy), 0, RADIUS, 0.17), 0.0, CLOTH)


def places(motion: Motion, end: float) -> list[tuple[float, float, float]]:
    balls = ((end * i / STEPS, motion.at(end * i / STEPS)) for i in range(STEPS + 1))
    return [(t, ball.x, ball.y) for t, ball in balls]


def check(time: float, gaps: list[tuple[float, float]], gap_at: float) -> None:
    """`time` is the first at which the gap, sampled as (t, gap), falls to -SKIN."""
    first = next((t for t, gap in gaps if gap < -2.0 * SKIN), math.inf)
    assert time <= first
    if time < math.inf:
        assert gap_at == pytest.approx(-SKIN, abs=1e-13)
        # A dip between two samples is not seen by the scan, but they are as near as ten metres a second lets them.
        assert min(gap for _, gap in gaps) < 10.0 * gaps[1][0]


@given(BALL, BALL | MIDDLE)
def test_balls_meet_when_a_scan_says_so(one: tuple[float, ...], two: tuple[float, ...]) -> None:
    assume(math.hypot(one[0] - two[0], one[1] - two[1]) >= TOUCH)
    a, b = move(*one), move(*two)
    end = min(a.t1, b.t1, 5.0)
    time = time_ball_ball(a, b, 0.0, end, TOUCH)
    pairs = zip(places(a, end), places(b, end), strict=True)
    gaps = [(t, math.hypot(x - u, y - v) - TOUCH) for (t, x, y), (_, u, v) in pairs]
    at = min(time, end)
    check(time, gaps, math.hypot(a.at(at).x - b.at(at).x, a.at(at).y - b.at(at).y) - TOUCH)
    # The same, asked later and of the other.
    assert time_ball_ball(b, a, 0.0, end, TOUCH) == pytest.approx(time, rel=1e-12)
    if 0.0 < time < math.inf:
        assert time_ball_ball(a, b, 0.5 * time, end, TOUCH) == pytest.approx(time, rel=1e-9)


@given(BALL, between(0.0, 0.1))
def test_jaws_are_met_when_a_scan_says_so(one: tuple[float, ...], radius: float) -> None:
    jaw = Jaw("jaw", 0.5, 0.5, radius)
    assume(jaw.gap(one[0], one[1], RADIUS) >= 0.0)
    motion = move(*one)
    end = min(motion.t1, 5.0)
    time = jaw.time(motion, RADIUS, end)
    ball = motion.at(min(time, end))
    check(time, [(t, jaw.gap(x, y, RADIUS)) for t, x, y in places(motion, end)], jaw.gap(ball.x, ball.y, RADIUS))


def test_what_a_path_reaches_at_any_point_is_met() -> None:
    """However it bends: the ball is drawn back from a jaw, swerves into a pocket's rim, or passes by all but a hair."""
    rng, met = random.Random(1), 0
    for _ in range(2000):
        way = rng.uniform(0.0, 2.0 * math.pi)
        motion = move(0.5, 0.5, math.cos(way), math.sin(way), rng.uniform(-200.0, 200.0), rng.uniform(-200.0, 200.0))
        end, time, turn, radius = motion.t1, rng.uniform(0.0, motion.t1), rng.uniform(0.0, 6.3), rng.uniform(0.01, 0.1)
        ball = motion.at(time)
        for kind, reach in ((Jaw, radius + RADIUS), (Pocket, radius)):
            away = reach - 1e-4
            element = kind(kind.__name__, ball.x + away * math.cos(turn), ball.y + away * math.sin(turn), radius)
            if element.gap(0.5, 0.5, RADIUS) > 0.0:
                met += 1
                assert element.time(motion, RADIUS, end) <= time
    assert met > 2000


@given(BALL)
def test_pockets_are_met_at_their_rim(one: tuple[float, ...]) -> None:
    pocket = Pocket("pocket", 0.5, 0.5, 0.06)
    assume(pocket.gap(one[0], one[1], RADIUS) >= 0.0)
    motion = move(*one)
    end = min(motion.t1, 5.0)
    time = pocket.time(motion, RADIUS, end)
    first = next((t for t, x, y in places(motion, end) if pocket.gap(x, y, RADIUS) < -1e-12), math.inf)
    assert time <= first
    if time < math.inf:
        ball = motion.at(time)
        assert pocket.gap(ball.x, ball.y, RADIUS) == pytest.approx(0.0, abs=1e-13)


@given(DOWN)
def test_rails_are_met_between_their_ends(one: tuple[float, ...]) -> None:
    assume(one[1] >= RADIUS)
    motion = move(*one)
    end = min(motion.t1, 5.0)
    time = RAIL.time(motion, RADIUS, end)
    track = places(motion, end)
    low = next(((t, x) for t, x, y in track if y < RADIUS - 2.0 * SKIN), (math.inf, 0.0))
    on_it = 0.21 < low[1] < 0.79
    if on_it:
        # It comes down on the rail, clear of its ends by more than a sample's way.
        assert time <= low[0]
    if time < math.inf:
        ball = motion.at(time)
        assert ball.y == pytest.approx(RADIUS - SKIN, abs=1e-13)
        assert 0.2 - 1e-9 <= ball.x <= 0.8 + 1e-9
        assert ball.vy <= 1e-9


@pytest.mark.parametrize("off", [-1e-15, -1e-16, 0.0, 1e-16, 1e-15])
def test_touching_is_meeting_only_on_the_way_in(off: float) -> None:
    """Where rounding leaves a ball that was in contact, a hair to either side."""
    y = RADIUS - SKIN + off
    assert RAIL.time(move(0.5, y, 0.1, -1.0), RADIUS, 1.0) == 0.0
    assert RAIL.time(move(0.5, y, 0.1, 1.0), RADIUS, 1.0) == math.inf
    assert RAIL.time(move(0.5, y), RADIUS, 1.0) == math.inf
    # On its way out, and turned back by its spin.
    back = RAIL.time(move(0.5, y, 0.0, 0.01, 50.0), RADIUS, 0.1)
    assert back == pytest.approx(2.0 * 0.01 / (0.2 * 9.81), rel=1e-6)
    x = TOUCH - SKIN + off
    still = move(0.5, 0.5)
    assert time_ball_ball(move(0.5 - x, 0.5, 1.0), still, 0.0, 1.0, TOUCH) == 0.0
    assert time_ball_ball(move(0.5 - x, 0.5, -1.0), still, 0.0, 1.0, TOUCH) == math.inf
    again = time_ball_ball(move(0.5 - x, 0.5, -0.01, wy=50.0), still, 0.0, 0.1, TOUCH)
    assert again == pytest.approx(2.0 * 0.01 / (0.2 * 9.81), rel=1e-6)


@given(between(-0.1, 0.1))
def test_gap_is_negative_inside(off: float) -> None:
    assert RAIL.gap(0.5, RADIUS + off, RADIUS) == pytest.approx(off, abs=1e-12)
    assert RAIL.normal(0.5, 0.1) == (0.0, -1.0)
    assert RAIL.gap(0.9, 0.0, RADIUS) == pytest.approx(0.1 - RADIUS)
    jaw = Jaw("jaw", 0.5, 0.0, 0.02)
    assert jaw.gap(0.5, 0.02 + RADIUS + abs(off), RADIUS) == pytest.approx(abs(off), abs=1e-12)
    assert jaw.normal(0.5, 0.3) == (0.0, -1.0)


@pytest.mark.parametrize("deeper", [0.0, 3e-12, 1e-10, 4e-10])
def test_a_ball_that_has_drifted_a_hair_into_a_nose_still_meets_it(deeper: float) -> None:
    """Rolling along a rail for minutes it may come nearer by some picometres; then it must not pass through."""
    y = RADIUS - SKIN - deeper
    assert RAIL.time(move(0.5, y, 0.1, -1e-4), RADIUS, 10.0) == 0.0
    assert RAIL.time(move(0.5, y, 0.1, 1e-4), RADIUS, 0.01) == math.inf


@given(between(-0.3, 0.3), between(0.03, 0.3))
def test_the_point_touched_is_the_nearest_and_what_lies_behind_it_is_covered(x: float, y: float) -> None:
    jaw, rail = Jaw("jaw", 0.0, 0.0, 0.02), Rail("rail", -0.1, 0.0, 0.2, 0.0)
    for element in (jaw, rail):
        point = element.point(x, y)
        if element is rail and not -0.1 <= x <= 0.2:
            assert point is None
            continue
        assert point is not None
        (px, py), (nx, ny) = point, element.normal(x, y)
        assert math.hypot(px - x, py - y) - RADIUS == pytest.approx(element.gap(x, y, RADIUS), abs=1e-12)
        assert (px + 0.01 * nx, py + 0.01 * ny) == pytest.approx((x + (d := element.gap(x, y, -0.01)) * nx, y + d * ny))
        for depth in (1e-6, 0.01):
            assert element.covers(px + depth * nx, py + depth * ny)
            assert not element.covers(px - depth * nx, py - depth * ny)
    assert not rail.covers(-0.1 - y, -0.01)
    assert not rail.covers(0.2 + y, -0.01)


def test_beside_a_joint_a_ball_touches_what_it_is_across_from() -> None:
    """And has its gap from it: none where it has sunk in."""
    jaw = Jaw("jaw", 0.2, -0.02, 0.02)
    for x, off, met in ((0.201, 3e-5, RAIL), (0.199, 3e-5, jaw), (0.5, -1e-9, RAIL)):
        ball = Body(Ball("1", x, RADIUS + off), 0, RADIUS, 0.17)
        ((element, gap),) = facing(ball, [RAIL, jaw], RADIUS, 1e-3)
        assert element is met
        assert gap == pytest.approx(max(0.0, met.gap(ball.x, ball.y, RADIUS)), abs=1e-15)


def test_a_ball_where_a_rail_goes_on_as_another_touches_one_of_them() -> None:
    body = Body(Ball("1", 0.3, RADIUS), 0, RADIUS, 0.17)
    rails = [Rail("first", 0.0, 0.0, 0.3, 0.0), Rail("second", 0.3, 0.0, 0.7, 0.0)]
    assert [element.name for element, _ in facing(body, rails, RADIUS, 1e-4)] == ["first"]


@pytest.mark.parametrize("name", ["pool-9ft", "snooker-12ft"])
def test_a_ball_that_goes_round_a_jaw_touches_one_thing_at_a_time(name: str) -> None:
    """It goes over into its nose and its facing: where they join no contact is lost, and none counts twice."""
    table = load_table(name)
    radius = table.knobs.ball.radius
    reach, tried = table.reach(radius), 0
    elements = [element for element in table.geometry.elements if not isinstance(element, Pocket)]
    for jaw in (element for element in elements if isinstance(element, Jaw)):
        for turn in range(0, 360, 3):
            away = jaw.radius + reach
            x, y = jaw.x + away * math.cos(math.radians(turn)), jaw.y + away * math.sin(math.radians(turn))
            if all(element.gap(x, y, reach) > -1e-4 for element in elements if element is not jaw):
                tried += 1
                (one,) = facing(Body(Ball("1", x, y), 0, radius, 0.17), elements, reach, 1e-4)
                assert one[1] == pytest.approx(0.0, abs=1e-4)
    assert tried > 50
