"""What is heard of a shot: each contact once, as hard as it was, where it was."""

from __future__ import annotations

import math

import pytest

from pool2d import Ball, Layout, Rollout, Shot, load_table, simulate
from pool2d.physics.body import Body
from pool2d.physics.event import Event
from pool2d.physics.motion import Motion
from pool2d.physics.values import EventKind
from pool2d.sound.impacts import Impact, impacts
from pool2d.table import leaving

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


def lasting(ball: Ball) -> Motion:
    """A motion that says of a ball just this, after 1 s."""
    return Motion(Body(ball, 0, 0.028575, 0.17), ball.phase, 1.0, 1.0)


def one(kind: EventKind, before: Ball, where: str | None = None, after: Ball | None = None) -> Rollout:
    """A shot in which nothing else happens than this, after 1 s."""
    old, new = lasting(before), lasting(after or before)
    event = Event(1.0, kind, where, [old], [new])
    rest = Motion(Body(before, 0, 0.028575, 0.17), "resting", 0.0, math.inf)
    return Rollout(Layout([before]), {before.id: [rest]}, [event], truncated=False)


@pytest.mark.parametrize(("where", "kind"), [(None, "slate"), ("top-left", "rail")])
def test_a_ball_that_comes_down_is_as_hard_as_it_falls(where: str | None, kind: str) -> None:
    (sound,) = impacts(one("ball_slate", Ball("3", 1.5, 0.6, vx=3.0, vz=-0.8), where), 0.9, 1.1)
    assert sound == (kind, 0.8, 1.5)


def test_a_stroke_that_makes_a_ball_hop_is_heard_on_the_slate() -> None:
    struck = Ball("cue", 0.6, 0.6, vx=2.0, vz=0.9)
    assert [sound.kind for sound in impacts(one("cue_ball", CUE, None, struck), 0.9, 1.1)] == ["cue", "slate"]
    level = struck._replace(vz=0.0)
    assert [sound.kind for sound in impacts(one("cue_ball", CUE, None, level), 0.9, 1.1)] == ["cue"]


def test_a_ball_off_the_table_is_heard_once_it_has_fallen_to_the_floor() -> None:
    edge = Ball("8", 2.6, 0.6, vx=2.0, vz=0.5, z=0.1)
    rollout = one("ball_off", edge, "right")
    after = (0.5 + math.sqrt(0.25 + 2.0 * 9.81 * (0.1 + leaving.BED))) / 9.81
    assert impacts(rollout, 0.9, 1.0 + after - 1e-6) == []
    (sound,) = impacts(rollout, 1.0 + after - 1e-6, 1.0 + after + 1e-6)
    assert (sound.kind, sound.x) == ("floor", 2.6)
    assert sound.speed == pytest.approx(math.sqrt(0.25 + 2.0 * 9.81 * (0.1 + leaving.BED)))
    # The moon has more patience, but the window not: it is heard while the ball is followed.
    assert impacts(rollout, 1.5, 1.7, gravity=1.6)[0].kind == "floor"


def test_a_ball_that_a_hand_takes_off_a_rail_falls_on_no_floor() -> None:
    assert impacts(one("ball_off", Ball("8", 2.6, 0.6, z=0.0363), "right"), 0.9, 1.9) == []


def test_balls_that_meet_in_the_air_are_as_hard_as_their_approach_there() -> None:
    high = Ball("cue", 0.6, 0.6, vz=-2.0, z=0.057)
    event = Event(1.0, "ball_ball", None, [lasting(high), lasting(Ball("1", 0.6, 0.6))],
                  [lasting(high._replace(vz=0.9)), lasting(Ball("1", 0.6, 0.6))], (("cue", "1"),))  # fmt: skip
    (sound,) = impacts(Rollout(Layout([high]), {}, [event], truncated=False), 0.9, 1.1)
    assert sound.kind == "ball"
    assert sound.speed == pytest.approx(2.0)
