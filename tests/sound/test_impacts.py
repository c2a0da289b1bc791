"""What is heard of a shot: each contact once, as hard as it was, where it was."""

from __future__ import annotations

import math

import pytest

from pool2d import Ball, Layout, Rollout, Shot, load_table, simulate
from pool2d.sound.impacts import Impact, impacts

TABLE = load_table("pool-9ft")
CUE = Ball("cue", 0.6, 0.635)


def roll(*balls: Ball, shot: Shot | None = None) -> Rollout:
    return simulate(TABLE, Layout(balls), shot)


def whole(rollout: Rollout) -> list[Impact]:
    """All that is heard, in steps of a frame, as the screen asks."""
    frames = math.ceil(rollout.duration * 60.0)
    return [sound for frame in range(-1, frames) for sound in impacts(rollout, frame / 60.0, (frame + 1) / 60.0)]


def test_the_cue_and_then_the_balls() -> None:
    rollout = roll(CUE, Ball("1", 1.2, 0.635), shot=Shot(speed=2.0))
    cue, ball, *_ = whole(rollout)
    struck, met = (next(event for event in rollout.events if event.kind == kind) for kind in ("cue_ball", "ball_ball"))
    assert (cue.kind, cue.x) == ("cue", 0.6)
    assert cue.speed == pytest.approx(struck.after["cue"].vx)
    assert ball.kind == "ball"
    assert (ball.speed, ball.x) == pytest.approx((met.before["cue"].vx, 1.2 - 0.028575))


def test_a_cut_is_as_hard_as_its_approach_along_the_centres() -> None:
    # A half-ball hit: the line of centres lies 30 degrees off the way.
    rollout = roll(Ball("cue", 0.6, 0.635, vx=2.0), Ball("1", 1.0, 0.635 + 0.028575))
    met = next(event for event in rollout.events if event.kind == "ball_ball")
    sound = next(sound for sound in whole(rollout) if sound.kind == "ball")
    assert sound.speed == pytest.approx(met.before["cue"].vx * math.cos(math.radians(30.0)), rel=1e-3)


@pytest.mark.parametrize(("vx", "vy"), [(0.0, 2.0), (1.5, 1.5), (3.0, 0.5)])
def test_a_cushion_is_as_hard_as_the_speed_across(vx: float, vy: float) -> None:
    rollout = roll(Ball("cue", 0.5, 1.1, vx=vx, vy=vy, wx=-vy / 0.028575, wy=vx / 0.028575))
    met = next(event for event in rollout.events if event.kind == "ball_cushion")
    sound = next(sound for sound in whole(rollout) if sound.kind == "cushion")
    before = met.before["cue"]
    assert sound.speed == pytest.approx(before.vy, rel=0.2)
    assert sound.x == pytest.approx(before.x)


def test_a_ball_drops_and_rolls_back() -> None:
    rollout = roll(Ball("1", 0.3, 0.3, vx=-1.0, vy=-1.0))
    assert [sound.kind for sound in whole(rollout)] == ["drop", "back"]


def test_a_miscue() -> None:
    assert whole(roll(CUE, shot=Shot(speed=2.0, side=0.9)))[0].kind == "miscue"


def test_of_a_cluster_a_few_pairs_are_heard_the_hardest_first() -> None:
    rollout = simulate(TABLE, TABLE.rack("eight-ball", 3), Shot(speed=9.0, angle=0.1))
    cluster = max((event for event in rollout.events if event.kind == "cluster"), key=lambda event: len(event.pairs))
    assert len(cluster.pairs) > 4
    sounds = impacts(rollout, cluster.t - 1e-9, cluster.t)
    assert len(sounds) == 4
    assert [sound.speed for sound in sounds] == sorted((sound.speed for sound in sounds), reverse=True)
    cue = cluster.before["cue"]
    assert sounds[0].speed == pytest.approx(math.hypot(cue.vx, cue.vy), rel=0.1)


def test_a_frozen_ball_that_takes_the_blow_is_heard() -> None:
    rollout = roll(Ball("cue", 0.6, 0.635, vx=2.0), Ball("1", 1.0, 0.635), Ball("2", 1.05715, 0.635))
    first = next(event for event in rollout.events if event.kind == "cluster")
    assert all(sound.speed > 0.4 for sound in impacts(rollout, first.t - 1e-9, first.t))


def test_each_event_is_heard_once_however_time_is_cut() -> None:
    rollout = simulate(TABLE, TABLE.rack("eight-ball", 3), Shot(speed=7.0))
    contacts = sum(event.kind in ("cue_ball", "ball_cushion") for event in rollout.events)
    sounds = whole(rollout)
    assert sum(sound.kind in ("cue", "cushion") for sound in sounds) == contacts
    halves = [
        impacts(rollout, start / 2.0, (start + 1) / 2.0) for start in range(-2, math.ceil(2.0 * rollout.duration))
    ]
    assert [sound for half in halves for sound in half] == sounds


def test_nothing_is_heard_where_time_stands_runs_backward_or_jumps() -> None:
    rollout = roll(CUE, Ball("1", 1.2, 0.635), shot=Shot(speed=2.0))
    assert impacts(rollout, -0.5, 0.5) == impacts(rollout, -math.inf, 0.5) != []
    assert not impacts(rollout, 0.0, 0.0)
    assert not impacts(rollout, 0.5, -0.5)
    assert not impacts(rollout, -0.5, rollout.duration)
