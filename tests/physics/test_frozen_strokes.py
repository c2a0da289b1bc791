"""The stroke of a ball that touches another: tip, ball and ball in one contact."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pool2d import Ball, Event, Layout, Shot, load_table, simulate
from pool2d.physics.body import Body
from pool2d.physics.cluster import Group, solve
from pool2d.physics.materials import materials
from pool2d.physics.strike import TipSpring, strike

TABLE = load_table("pool-9ft")
CUE = TABLE.knobs.cue
RADIUS, MASS = TABLE.knobs.ball.radius, TABLE.knobs.ball.mass
FROZEN = Layout([Ball("cue", 0.9, 0.6), Ball("1", 0.9 + 2.0 * RADIUS, 0.6)])


def stroke(shot: Shot, layout: Layout = FROZEN) -> Event:
    return simulate(TABLE, layout, shot, events=1).events[0]


def way(ball: Ball) -> float:
    return math.degrees(math.atan2(ball.vy, ball.vx))


@pytest.mark.parametrize("speed", [1.0, 3.0, 6.0])
@pytest.mark.parametrize(("aim", "measured"), [(8.0, 13.0), (34.0, 50.0), (57.0, 70.0)])
def test_the_cue_ball_leaves_where_high_speed_video_has_it(aim: float, measured: float, speed: float) -> None:
    """Alciatore TP A.15: the tip pushes both balls along the line of centres, and one across it."""
    event = stroke(Shot(aim, speed))
    assert (event.kind, event.balls, event.pairs) == ("cue_ball", ("cue", "1"), (("1", "cue"),))
    cue, other = event.after["cue"], event.after["1"]
    assert way(cue) == pytest.approx(measured, abs=4.0)
    # Slower along the line than alone, and never faster than the other.
    alone = stroke(Shot(aim, speed), FROZEN.without("1")).after["cue"]
    assert 0.4 * alone.vx < cue.vx <= other.vx < 0.9 * alone.vx


def test_aimed_straight_both_go_off_together() -> None:
    event = stroke(Shot(0.0, 3.0))
    cue, other = event.after["cue"], event.after["1"]
    assert cue.vx == pytest.approx(other.vx, rel=0.1)
    assert (cue.vy, other.vy) == (0.0, 0.0)
    # The tip gives two balls more than one, as it bounces off them more.
    alone = stroke(Shot(0.0, 3.0), FROZEN.without("1")).after["cue"]
    assert alone.vx < cue.vx + other.vx < 2.0 * alone.vx


@pytest.mark.parametrize("aim", [91.0, 120.0, 180.0, -100.0])
def test_away_from_the_other_it_is_the_stroke_of_a_ball_alone(aim: float) -> None:
    shot = Shot(aim, 3.0, side=0.2, height=-0.1, elevation=7.0)
    event = stroke(shot)
    assert (event.balls, event.pairs) == (("cue",), ())
    assert event.after == stroke(shot, FROZEN.without("1")).after


SHOTS = st.builds(
    Shot,
    st.floats(-89.0, 89.0),
    st.floats(0.05, 12.0),
    st.floats(-0.45, 0.45),
    st.floats(-0.3, 0.3),
    st.floats(0.0, 60.0),
)


@given(SHOTS)
def test_no_energy_comes_from_nowhere_and_left_is_as_right(shot: Shot) -> None:
    event = stroke(shot)
    after = [event.after[name] for name in event.balls]
    energy = sum(
        0.5 * MASS * (b.vx**2 + b.vy**2 + b.vz**2 + 0.4 * RADIUS**2 * (b.wx**2 + b.wy**2 + b.wz**2)) for b in after
    )
    assert energy <= 0.5 * CUE.mass * shot.speed**2 * (1.0 + 1e-12)
    other = stroke(Shot(-shot.angle, shot.speed, -shot.side, shot.height, shot.elevation))
    for name in event.balls:
        one, two = event.after[name], other.after[name]
        assert (two.vx, two.vy) == pytest.approx((one.vx, -one.vy), abs=1e-9)
        assert (two.wx, two.wy, two.wz) == pytest.approx((-one.wx, one.wy, -one.wz), abs=1e-6)


@pytest.mark.parametrize("shot", [Shot(20.0, 3.0), Shot(-70.0, 8.0, 0.3, -0.2, 30.0), Shot(0.0, 2.0, 0.7, 0.3)])
def test_the_spring_of_the_tip_strikes_a_ball_alone_as_the_stroke_does(shot: Shot) -> None:
    """Leather is taken as linear; its steps miss a thousandth."""
    one, two = (Body(Ball("cue", 1.0, 0.6), 0, RADIUS, MASS) for _ in range(2))
    strike(one, shot, CUE)
    tip = TipSpring(two, strike(two, shot, CUE))
    two.set_velocity((0.0, 0.0, 0.0, 0.0, 0.0))
    two.vz = 0.0
    solve(Group([], []), shot.speed, materials(TABLE.knobs), tip)
    assert (*two.velocity(), two.vz) == pytest.approx((*one.velocity(), one.vz), rel=5e-3, abs=1e-9)


@pytest.mark.parametrize("elevation", [0.01, 1.0, 3.0, 5.0])
@pytest.mark.parametrize("aim", [0.0, 8.0, 34.0, 57.0])
def test_with_the_butt_a_little_raised_it_is_nearly_the_level_stroke(aim: float, elevation: float) -> None:
    """A ball that is driven into the slate was taken to be above the other: then the tip was told to strike twice."""
    roll = simulate(TABLE, FROZEN, Shot(aim, 3.0, elevation=elevation))
    event, level = roll.events[0], stroke(Shot(aim, 3.0))
    assert (event.balls, event.pairs) == (("cue", "1"), (("1", "cue"),))
    assert sum(event.kind == "cue_ball" for event in roll.events) == 1
    # The slate, on which the ball slips, takes mu (1 + e) of what drives it down.
    slate = TABLE.knobs.cloth
    lost = slate.bounce_friction * (1.0 + slate.bounce) * 4.0 * math.sin(math.radians(elevation))
    for name in event.balls:
        one, other = event.after[name], level.after[name]
        assert math.dist((one.vx, one.vy), (other.vx, other.vy)) < 0.03 * 4.0 + lost


@pytest.mark.parametrize("elevation", [0.0, 10.0, 45.0])
def test_what_the_balls_are_called_is_of_no_consequence(elevation: float) -> None:
    ways = []
    for name in ("0", "9"):
        balls = FROZEN.without("cue").put(FROZEN["cue"]._replace(id=name))
        event = stroke(Shot(20.0, 3.0, elevation=elevation, ball=name), balls)
        ways.append([(ball.vx, ball.vy, ball.vz) for ball in (event.after[name], event.after["1"])])
    assert ways[0] == ways[1]


def test_a_ball_that_is_struck_in_the_air_drives_none_below_it() -> None:
    for name in ("0", "9"):
        above = Layout([FROZEN["1"], Ball(name, 0.9 + RADIUS, 0.6, z=0.2, phase="airborne")])
        event = stroke(Shot(0.0, 3.0, ball=name), above)
        assert (event.balls, event.pairs) == ((name,), ())


def test_one_that_rolls_against_it_is_struck_as_one_at_rest() -> None:
    for elevation in (0.0, 20.0):
        shot = Shot(34.0, 3.0, elevation=elevation)
        rest = stroke(shot)
        rolls = stroke(shot, FROZEN.put(FROZEN["1"]._replace(vx=-1e-6, phase="rolling")))
        assert rolls.pairs == rest.pairs
        for name in ("cue", "1"):
            one, two = rest.after[name], rolls.after[name]
            assert (one.vx, one.vy, one.vz) == pytest.approx((two.vx, two.vy, two.vz), abs=1e-3)


@given(st.floats(-40.0, 40.0), st.floats(-40.0, 40.0), st.floats(1e-6, 12.0), st.floats(0.0, 60.0))
def test_balls_that_move_are_no_faster_after_it_than_what_drives_them(
    near: float, far: float, speed: float, tilt: float
) -> None:
    """Springs with steps of the stroke's speed burst where a soft stroke met a ball at 40 m/s."""
    moving = FROZEN.put(
        FROZEN["1"]._replace(vx=near, phase="sliding"), Ball("2", 0.9 + 4.0 * RADIUS, 0.6, vx=far, phase="sliding")
    )
    event = stroke(Shot(0.0, speed, elevation=tilt), moving)

    def energy(ball: Ball) -> float:
        return 0.5 * MASS * (ball.vx**2 + ball.vy**2 + ball.vz**2 + 0.4 * RADIUS**2 * (ball.wx**2 + ball.wy**2))

    told = [moving[name] for name in event.balls]
    before = sum(map(energy, told)) + 0.5 * CUE.mass * speed**2
    assert sum(energy(event.after[name]) for name in event.balls) <= before * (1.0 + 1e-12)


def test_what_touches_the_other_goes_off_too() -> None:
    row = [Ball("cue", 0.9, 0.6), *(Ball(str(i), 0.9 + 2.0 * i * RADIUS, 0.6) for i in (1, 2))]
    event = stroke(Shot(0.0, 3.0), Layout(row))
    assert set(event.pairs) == {("1", "cue"), ("1", "2")}
    assert event.after["2"].vx > event.after["1"].vx > 0.0
    assert event.after["cue"].vx > 0.0
