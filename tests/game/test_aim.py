"""The aim: its limits, and how far a cue is drawn back for a speed."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from pool2d import Shot
from pool2d.game.aim import (
    FREE_PULL,
    FULL_PULL,
    MAX_ELEVATION,
    MAX_OFFSET,
    MAX_SPEED,
    MIN_SPEED,
    Aim,
    drawn_back,
    pulled_speed,
)


def test_a_shot_and_the_aim_that_makes_it() -> None:
    shot = Shot(33.0, 2.5, 0.1, -0.2, 7.0, "3")
    assert Aim.of(shot).shot("3") == shot
    assert Aim.of(replace(shot, angle=-30.0)).angle == 330.0
    assert Aim.of(shot).shot("3", 4.0) == replace(shot, speed=4.0)
    assert Aim.of(shot).shot("3", 0.0).speed == 0.0


@pytest.mark.parametrize(("dx", "dy", "angle"), [(1, 0, 0), (0, 2, 90), (-1, 0, 180), (0, -3, 270), (1, -1, 315)])
def test_toward(dx: float, dy: float, angle: float) -> None:
    assert Aim(10.0).toward(dx, dy).angle == pytest.approx(angle)


def test_turning_goes_round() -> None:
    assert Aim(350.0).turned(20.0).angle == pytest.approx(10.0)
    assert Aim(10.0).turned(-20.0).angle == pytest.approx(350.0)


def test_the_tip_stays_on_the_ball_on_its_own_side() -> None:
    assert (Aim().with_spin(0.1, -0.7).side, Aim().with_spin(0.42, 0.56).height) == (0.099, 0.56)
    far = Aim().with_spin(-3.0, 4.0)
    assert (far.side, far.height) == pytest.approx((-0.6 * MAX_OFFSET, 0.8 * MAX_OFFSET))


@pytest.mark.parametrize(("given", "taken"), [(-5.0, 0.0), (12.34, 12.3), (MAX_ELEVATION + 1.0, MAX_ELEVATION)])
def test_the_butt(given: float, taken: float) -> None:
    assert Aim().with_elevation(given).elevation == taken


@pytest.mark.parametrize(("given", "taken"), [(-5.0, MIN_SPEED), (1.234, 1.23), (99.0, MAX_SPEED)])
def test_the_speed(given: float, taken: float) -> None:
    assert Aim().with_speed(given).speed == taken


def test_a_pull_grows_from_nothing_to_full_and_back() -> None:
    assert pulled_speed(-0.1) == pulled_speed(0.0) == pulled_speed(FREE_PULL) == 0.0
    assert pulled_speed(FULL_PULL) == pulled_speed(2.0) == MAX_SPEED
    # Half of the way gives less than half of the speed: soft strokes get room.
    half = pulled_speed((FREE_PULL + FULL_PULL) / 2.0)
    assert half == pytest.approx(MAX_SPEED * 0.5**1.6)
    for speed in (0.11, 0.5, 2.0, 7.0, MAX_SPEED):
        assert pulled_speed(FULL_PULL * drawn_back(speed)) == pytest.approx(speed)
    assert drawn_back(0.0) == drawn_back(-1.0) == pytest.approx(FREE_PULL / FULL_PULL)
    assert drawn_back(50.0) == 1.0
    pulls = [pulled_speed(FULL_PULL * i / 200.0) for i in range(201)]
    assert pulls == sorted(pulls)
    assert min(speed for speed in pulls if speed) >= MIN_SPEED
    assert math.isclose(pulls[-1], MAX_SPEED)
