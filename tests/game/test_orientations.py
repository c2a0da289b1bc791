"""What goes on from shot to shot beside the layout: how balls lie, and the order of their fall."""

from __future__ import annotations

import math
import random
from itertools import pairwise

import pytest

from benchmarks.random_play import new_match, random_action
from pool2d import Ball, Layout, Rollout, Shot, load_table, simulate
from pool2d.game.actions import Arrange, Stroke
from pool2d.game.falling import DROP, ending, falling, gone
from pool2d.game.match import Match
from pool2d.game.orientations import OrientationTracker, racked_orientations
from pool2d.game.setup import Setup
from pool2d.physics.orientation import BallRotation, Quaternion, matrix, turn

TABLE = load_table("pool-9ft")
POCKETS = TABLE.geometry.pockets
HOLES = {pocket.name: pocket for pocket in POCKETS}


def toward(ball: str, pocket: str, away: float, speed: float) -> Ball:
    """A ball rolling straight toward a corner pocket, along its middle line."""
    hole = HOLES[pocket]
    way = math.atan2(math.copysign(1.0, 0.635 - hole.y), math.copysign(1.0, 1.27 - hole.x))
    x, y = hole.x + away * math.cos(way), hole.y + away * math.sin(way)
    vx, vy = -speed * math.cos(way), -speed * math.sin(way)
    radius = TABLE.knobs.ball.radius
    return Ball(ball, x, y, vx=vx, vy=vy, wx=-vy / radius, wy=vx / radius)


def two_fall() -> Rollout:
    corners = [name for name in HOLES if "side" not in name]
    return simulate(TABLE, Layout([toward("1", corners[0], 0.6, 1.0), toward("2", corners[-1], 0.3, 1.5), CUE]))


def near(a: dict[str, Quaternion], b: dict[str, Quaternion]) -> bool:
    return all(a[ball] == pytest.approx(b[ball], abs=1e-12) for ball in a.keys() | b.keys())


CUE = Ball("cue", 1.27, 0.5)


def test_balls_sink_into_the_pocket_they_fell_into_and_turn_on() -> None:
    rollout = two_fall()
    turning = BallRotation(rollout, {})
    drops = [event for event in rollout.events if event.kind == "ball_pocket"]
    assert [event.balls[0] for event in drops] == ["2", "1"]
    event = drops[0]
    hole, rim = HOLES[event.where or ""], event.before["2"]
    assert falling(rollout, turning, POCKETS, event.t - 1e-6) == []
    steps = [falling(rollout, turning, POCKETS, event.t + DROP * i / 20.0)[0] for i in range(20)]
    assert (steps[0].x, steps[0].y, steps[0].depth) == (rim.x, rim.y, 0.0)
    assert steps[0].orientation == turning.at("2", event.t) != steps[1].orientation
    depths = [fall.depth for fall in steps]
    far = [math.dist((fall.x, fall.y), (hole.x, hole.y)) for fall in steps]
    assert depths == sorted(depths)
    assert far == sorted(far, reverse=True)
    assert far[-1] < 1e-9
    # It does not leave the rim faster than it came.
    assert math.dist(steps[1][1:3], steps[0][1:3]) <= 1.05 * math.hypot(rim.vx, rim.vy) * DROP / 20.0


def test_a_fast_ball_is_over_the_middle_of_the_hole_sooner() -> None:
    corners = [name for name in HOLES if "side" not in name]
    reached = []
    for speed in (0.3, 0.9, 6.0):
        rollout = simulate(TABLE, Layout([toward("1", corners[0], 0.3, speed)]))
        event, turning = rollout.events[-1], BallRotation(rollout, {})
        hole = HOLES[event.where or ""]
        moments = [DROP * i / 100.0 for i in range(100)]
        falls = [falling(rollout, turning, POCKETS, event.t + s)[0] for s in moments]
        there = [
            s for s, fall in zip(moments, falls, strict=True) if math.dist((fall.x, fall.y), (hole.x, hole.y)) < 1e-9
        ]
        reached.append(there[0])
    slow, medium, fast = reached
    # At most a fifth of a second, at least some frames.
    assert slow == pytest.approx(0.2, abs=0.004) and fast == pytest.approx(0.06, abs=0.004)
    assert fast < medium < slow


def test_the_fallen_are_told_in_order_once_they_are_out_of_sight() -> None:
    rollout = two_fall()
    first, second = (event.t for event in rollout.events if event.kind == "ball_pocket")
    assert gone(rollout, first + DROP - 1e-6) == []
    assert gone(rollout, second) == ["2"]
    assert gone(rollout) == ["2", "1"]
    assert ending(rollout) == max(rollout.duration, second + DROP)


def test_a_rack_lies_askew_with_its_numbers_up_and_the_same_each_time() -> None:
    lies = racked_orientations(TABLE.rack("eight-ball", 7))
    assert lies == racked_orientations(TABLE.rack("eight-ball", 7))
    assert lies != racked_orientations(TABLE.rack("eight-ball", 8))
    assert len(set(lies.values())) == len(lies)
    tops = [matrix(orientation)[2][2] for orientation in lies.values()]
    assert min(tops) > 0.7
    assert sum(top > 0.8 for top in tops) >= len(tops) // 2


def test_a_shot_starts_as_the_one_before_it_ended() -> None:
    keeper = OrientationTracker()
    layout = Layout([Ball("cue", 0.6, 0.6), Ball("1", 1.2, 0.62)])
    start = keeper.states(layout).orientations
    first = simulate(TABLE, layout, Shot(speed=2.0))
    assert near(keeper.states(layout, first, 0.0).orientations, start)
    end = keeper.states(first.layout(), first).orientations
    assert end["cue"] != start["cue"]
    second = simulate(TABLE, first.layout(), Shot(angle=40.0, speed=1.0))
    assert near(keeper.states(first.layout(), second, 0.0).orientations, end)
    # Seen again, in any order, they are as they were.
    assert keeper.states(first.layout(), first).orientations == end
    assert near(keeper.states(layout, first, 0.0).orientations, start)


def test_a_shot_first_seen_in_its_middle_starts_where_the_last_ended() -> None:
    layout = Layout([Ball("cue", 0.6, 0.6), Ball("1", 1.2, 0.62)])
    first = simulate(TABLE, layout, Shot(speed=2.0))
    second = simulate(TABLE, first.layout(), Shot(angle=40.0, speed=1.0))

    def end(t: float, since: float) -> object:
        keeper = OrientationTracker()
        keeper.states(layout)
        keeper.states(layout, first, t)
        keeper.states(first.layout(), second, since)
        return keeper.states(second.layout(), second).orientations

    assert end(0.3, 0.5) == end(math.inf, 0.0)


def test_the_order_of_fall_goes_on_and_comes_back() -> None:
    keeper = OrientationTracker()
    first = two_fall()
    assert keeper.states(first.start).gone == []
    assert keeper.states(first.layout(), first).gone == ["2", "1"]
    corner = next(name for name in HOLES if "side" not in name)
    layout = first.layout().put(toward("3", corner, 0.4, 1.0))
    second = simulate(TABLE, layout)
    assert keeper.states(second.at(0.0), second, 0.0).gone == ["2", "1"]
    assert keeper.states(second.layout(), second).gone == ["2", "1", "3"]
    # A ball put back on the table is in the tray no more.
    back = second.layout().put(Ball("1", 1.0, 0.4))
    assert keeper.states(back, second).gone == ["2", "3"]
    assert keeper.states(first.layout(), first).gone == ["2", "1"]


def test_a_hand_that_moves_a_ball_does_not_turn_it() -> None:
    keeper = OrientationTracker()
    rack = TABLE.rack("eight-ball", 7)
    lies = keeper.states(rack).orientations
    assert keeper.states(rack.put(rack["cue"]._replace(x=0.3))).orientations == lies
    assert keeper.states(TABLE.rack("eight-ball", 8)).orientations != lies


def test_balls_whose_fall_was_not_seen_are_down_too() -> None:
    layout = Layout([CUE, Ball("4", 0.0, 0.0, phase="pocketed"), Ball("5", 0.3, 0.3)])
    assert OrientationTracker().states(layout).gone == ["4"]


def test_turns_compose() -> None:
    quarter = turn(0.0, 0.0, math.pi / 2.0)
    assert [row[0] for row in matrix(quarter)] == pytest.approx([0.0, 1.0, 0.0], abs=1e-12)


def test_a_match_seen_from_its_record_lies_as_it_did_when_it_was_played() -> None:
    match, rng = new_match("nine-ball", 5), random.Random(5)
    while sum(moment.rollout is not None for moment in match.history) < 8 and not match.over:
        match.play(random_action(match, rng))
    live, late = OrientationTracker(), OrientationTracker()
    last = None
    for before, moment in pairwise(match.history):
        if moment.rollout is not None:
            live.follow(before, moment.rollout, last)
            seen = live.states(moment.rollout.layout(), moment.rollout)
            late.follow(before, moment.rollout, last)
            # Somebody looks at an earlier shot in between.
            first = next(shot.rollout for shot in match.history if shot.rollout is not None)
            late.states(first.start, first)
            assert late.states(moment.rollout.layout(), moment.rollout) == seen
            last = moment
    assert seen.gone


def test_a_stroke_goes_on_from_the_last_whatever_was_shown_in_between() -> None:
    match = Match(TABLE, Setup("practice"))
    match.play(Arrange(Layout([Ball("cue", 0.6, 0.6), Ball("1", 1.2, 0.62)])))
    before, first = match.now, match.play(Stroke(Shot(0.0, 2.0)))
    second = match.play(Stroke(Shot(40.0, 1.0)))
    assert first.rollout is not None and second.rollout is not None
    keeper = OrientationTracker()
    keeper.follow(before, first.rollout, None)
    wanted = keeper.states(first.layout, first.rollout).orientations
    # Another shot is looked at before the next one is laid.
    keeper.states(simulate(TABLE, before.layout, Shot(90.0, 3.0)).start)
    keeper.states(before.layout, simulate(TABLE, before.layout, Shot(90.0, 3.0)))
    keeper.follow(first, second.rollout, first)
    assert near(keeper.states(first.layout, second.rollout, 0.0).orientations, wanted)
