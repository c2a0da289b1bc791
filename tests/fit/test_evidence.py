"""What tracks tell by themselves: the struck ball, its moment, where balls stood, when they met."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pool2d import Ball, Layout, Shot, simulate
from pool2d.fit.evidence import evidence
from pool2d.fit.made_tracks import RATE, watched
from pool2d.fit.tracks import Track, TrackedShot

from .known_shots import CUE, LONGEST, NOISE, RED, TABLE, seen

YELLOW = Ball("yellow", 2.3, 0.3)
SHOT = Shot(math.degrees(math.atan2(RED.y - CUE.y, RED.x - CUE.x)) + 1.0, 2.5)


def test_the_struck_ball_is_the_one_that_moves_first() -> None:
    rollout = simulate(TABLE, Layout([CUE, RED, YELLOW]), SHOT)
    # A camera's list of balls may begin with any.
    tracked = watched("a", rollout, 3, NOISE, LONGEST)
    found = seen(evidence(TrackedShot("a", dict(reversed(list(tracked.tracks.items())))), TABLE, NOISE))
    meetings = [event.t for event in rollout.events if event.kind == "ball_ball"]
    assert (found.struck, found.moved) == ("cue", ("cue", "red"))
    # The camera had run for 0.4 s, and for up to a picture more.
    assert 0.4 <= found.moment <= 0.4 + 2.0 / RATE
    assert found.meeting(1) - found.moment == pytest.approx(meetings[0], abs=1.5 / RATE)
    assert found.meeting(9) == tracked.end


def test_places_are_means_of_what_was_seen_before_the_strike() -> None:
    found = seen(evidence(watched("a", simulate(TABLE, Layout([CUE, RED]), SHOT), 5, NOISE, LONGEST), TABLE, NOISE))
    # Some twenty pictures.
    assert found.places["cue"] == pytest.approx((CUE.x, CUE.y), abs=NOISE)
    assert found.places["red"] == pytest.approx((RED.x, RED.y), abs=NOISE)


def test_balls_that_meet_on_the_way_are_seen() -> None:
    t = np.arange(100) / RATE
    cue = Track(t, 0.5 + 1.0 * t, np.full(100, 0.7))
    red = Track(t, np.where(t < 0.1, 2.0, 2.1 - t), np.full(100, 0.7))
    found = seen(evidence(TrackedShot("a", {"cue": cue, "red": red}), TABLE, NOISE))
    # They start 0.06 s apart, then come together with 2 m/s.
    assert found.meetings[-1] == pytest.approx((2.1 - 0.5 - 2.0 * TABLE.knobs.ball.radius) / 2.0, abs=0.02)


def test_without_a_ball_that_moves_there_is_no_shot() -> None:
    t = np.arange(50) / RATE
    still = Track(t, np.random.default_rng(1).normal(1.0, NOISE, 50), np.full(50, 0.7))
    assert evidence(TrackedShot("a", {"cue": still}), TABLE, NOISE) is None


def test_one_wild_point_moves_no_ball() -> None:
    t = np.arange(50) / RATE
    x = np.full(50, 1.0)
    x[20] = 1.3
    assert evidence(TrackedShot("a", {"cue": Track(t, x, np.full(50, 0.7))}), TABLE, NOISE) is None
