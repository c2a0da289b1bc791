"""Misses and their slopes: none where a launch is the true one, and as they change for a launch beside it."""

from __future__ import annotations

import numpy as np
import pytest

from pool2d import Ball, InputError, Layout, Shot, simulate
from pool2d.fit import launch
from pool2d.fit.miss import launch_slopes, misses, places, standing
from pool2d.fit.shot_fit import COARSE, approached, knob_slopes, launched, refine, setting_of, table_of, width_of

from .known_shots import CUE, NOISE, RED, TABLE, alone, numbers, stretch

SHOT = Shot(13.0, 2.5, 0.2, 0.1)
SETTING = setting_of(
    TABLE,
    {"cloth.mu_slide": TABLE.knobs.cloth.mu_slide, "cushion.restitution": TABLE.knobs.cushion.restitution},
)


def test_places_are_those_of_the_rollout() -> None:
    rollout = simulate(TABLE, Layout([CUE, RED]), SHOT)
    times = np.linspace(-0.5, rollout.duration + 1.0, 200)
    for ball in ("cue", "red"):
        x, y = places(rollout, ball, times)
        there = [rollout.ball_at(ball, min(max(t, 0.0), rollout.duration)) for t in times.tolist()]
        assert x.tolist() == pytest.approx([one.x for one in there], abs=1e-12)
        assert y.tolist() == pytest.approx([one.y for one in there], abs=1e-12)


def test_a_launch_is_found_to_what_noise_allows() -> None:
    for noise in (0.0, NOISE):
        seen = stretch(SHOT, (CUE, RED), 3, noise)
        found = launched(SETTING, seen, COARSE)
        assert found.size == pytest.approx(noise, rel=0.1, abs=2e-6)
        assert found.numbers[:4].tolist() == pytest.approx([13.0, 2.5, 0.2, 0.1], abs=1e-3 + 20.0 * noise)


def test_another_moment_or_clock_is_the_same_shot() -> None:
    seen = stretch(SHOT, (CUE, RED), 3, 0.0)
    found = launched(SETTING, seen, COARSE)
    moment = float(found.numbers[launch.MOMENT])
    true = numbers(SHOT, moment, {"cue": CUE, "red": RED})
    assert np.abs(misses(TABLE, seen, true)).max() < 1e-4


@pytest.mark.parametrize("column", range(9))
def test_slopes_are_what_misses_change_by(column: int) -> None:
    seen = stretch(SHOT, (CUE, RED), 3, 0.0)
    at = numbers(SHOT, 0.41, {"cue": CUE, "red": RED})
    step = np.zeros(9)
    step[column] = 20.0 * launch.steps(seen.seen)[column]
    change = (misses(TABLE, seen, at + step) - misses(TABLE, seen, at - step)) / (2.0 * step[column])
    slope = launch_slopes(TABLE, seen, at)[:, column]
    # A point just before a contact may be just after it.
    near = np.abs(slope - change) <= 1e-3 * np.abs(change).max() + 1e-6
    assert near.mean() > 0.99
    assert np.abs(change).max() > 0.0


def test_knobs_change_misses_as_their_slopes_say_with_the_launch_that_follows() -> None:
    seen = stretch(SHOT, (CUE, RED), 3, NOISE)
    at = launched(SETTING, seen, COARSE)
    widths = np.array([width_of(name, value) for name, value in zip(SETTING.names, SETTING.values, strict=True)])
    slopes = knob_slopes(SETTING, seen, at.numbers, widths, 3.0 * NOISE)
    for turn in (np.array([0.02, 0.0]), np.array([0.0, -0.02])):
        turned = SETTING.turned(np.array(SETTING.values) + widths * turn)
        there = refine(turned, seen, at.numbers + slopes.numbers @ turn, 3.0 * NOISE)
        change = there.misses - at.misses
        assert np.linalg.norm(change - slopes.misses @ turn) < 0.15 * np.linalg.norm(change) + 1e-5


def test_balls_seen_in_each_other_are_set_apart() -> None:
    radius = TABLE.knobs.ball.radius
    layout = standing(TABLE, Layout([Ball("cue", 1.0, 0.5), Ball("red", 1.0 + 2.0 * radius - 0.0006, 0.5)]))
    assert layout["red"].x - layout["cue"].x == pytest.approx(2.0 * radius, abs=1e-6)
    edge = TABLE.reach(radius)
    layout = standing(TABLE, Layout([Ball("cue", 1.0, edge - 0.0005), Ball("red", edge - 0.0003, 0.7)]))
    assert (layout["cue"].y, layout["red"].x) == pytest.approx((edge, edge), abs=1e-6)
    with pytest.raises(InputError):
        standing(TABLE, Layout([Ball("cue", 9.0, 9.0)]))


def test_what_no_cue_can_do_is_taken_as_what_it_can() -> None:
    seen = stretch(SHOT, (CUE, RED), 3, 0.0)
    wild = numbers(Shot(0.0, 5.0), 0.4, {"cue": CUE, "red": RED})
    wild[:4] = 1e5, -3.0, 4.0, -4.0
    wild[5:] += 7.0
    begun = launch.launch_of(seen.seen, wild, 0.0)
    begun.shot.check()
    assert begun.layout["red"].x == pytest.approx(RED.x, abs=0.031)
    assert np.isfinite(misses(TABLE, seen, wild)).all()
    assert table_of(SETTING.turned(np.array([0.21, 0.9]))).knobs.cloth.mu_slide == 0.21


def test_a_launch_that_is_near_is_found_however_far_off_its_end_is() -> None:
    """With a small clip alone the search stops where most points lie well and the rest far away."""
    far = setting_of(TABLE, {"cushion.restitution": 0.83})
    near = far.turned(np.array([TABLE.knobs.cushion.restitution]))
    (seen,) = alone(TABLE, 1)
    began = launched(far, seen, COARSE)
    assert began.size > 2.0 * NOISE
    assert approached(near, seen, began.numbers, 3.0 * NOISE).size == pytest.approx(NOISE, rel=0.15)
