"""Arranging balls between shots, and a drill as a session."""

from __future__ import annotations

import math

import pytest

from pool2d import Ball, InputError, Layout, Shot, Table, load_table, simulate
from pool2d.game import saved_positions
from pool2d.game.arranging import latest, mirrored_shot, missing, room_near
from pool2d.game.drills.drill_file import load
from pool2d.game.drills.drill_session import DrillSession
from pool2d.game.session import practice
from pool2d.physics.values import POCKETED
from pool2d.table.placing import mirrored


def test_what_is_missing_is_told_the_lowest_first(table: Table) -> None:
    layout = table.rack("eight-ball", 3)
    assert missing(table, layout) == []
    fallen = layout["8"]._replace(phase=POCKETED)
    assert missing(table, layout.without("10", "2", "cue").put(fallen)) == ["cue", "2", "8", "10"]


@pytest.mark.parametrize("name", ["pool-9ft", "snooker-12ft", "carom-10ft", "pyramid-12ft"])
def test_every_ball_of_a_set_can_be_missing(name: str) -> None:
    table = load_table(name)
    whole = table.rack(next(iter(table.furniture.racks)), 1)
    assert set(missing(table, Layout())) >= set(whole)


def test_the_nearest_room_is_beside_the_balls_that_are_in_the_way(table: Table) -> None:
    layout = Layout([Ball("1", 1.0, 0.6)])
    assert room_near(table, layout, Ball("2", 2.0, 0.6)) == (2.0, 0.6)
    place = room_near(table, layout, Ball("2", 1.01, 0.6))
    assert place is not None
    radius = table.knobs.ball.radius
    assert 2.0 * radius <= math.dist(place, (1.0, 0.6)) < 3.2 * radius
    outside = room_near(table, layout, Ball("2", -0.3, 0.6))
    assert outside is not None and 0.0 < outside[0] < 0.1


@pytest.mark.parametrize("part", [0.2, 0.6, 0.9, 1.3, 1.7])
def test_a_ball_is_moved_half_a_radius_further_than_it_has_to_be_at_most(table: Table, part: float) -> None:
    radius = table.knobs.ball.radius
    ball = Ball("2", 1.0 + part * radius, 0.6)
    place = room_near(table, Layout([Ball("1", 1.0, 0.6)]), ball)
    assert place is not None
    assert 2.0 - part <= math.dist(place, (ball.x, ball.y)) / radius <= 2.5 - part + 1e-9


def test_the_latest_shot_is_known_after_balls_were_moved(table: Table) -> None:
    session = practice(table)
    assert latest(session) is None
    before, shot = session.layout, Shot(1.0, 3.0)
    session.play(shot)
    session.arrange(Layout([Ball("cue", 0.5, 0.5)]))
    assert latest(session) == (before, shot)


@pytest.mark.parametrize("ends", [False, True])
def test_a_mirrored_shot_does_on_mirrored_balls_what_it_did(table: Table, ends: bool) -> None:
    layout = Layout([Ball("cue", 0.6, 0.4), Ball("1", 1.4, 0.7)])
    shot = Shot(20.0, 3.0, 0.2, -0.1)
    end = simulate(table, layout, shot).layout()
    other = simulate(table, mirrored(table, layout, ends), mirrored_shot(shot, ends)).layout()
    expected = mirrored(table, end, ends)
    for name in layout:
        assert (other[name].x, other[name].y) == pytest.approx((expected[name].x, expected[name].y), abs=1e-4)


def test_a_position_that_is_removed_is_gone(table: Table) -> None:
    saved_positions.save("to go", table, Layout([Ball("cue", 0.5, 0.5)]))
    saved_positions.remove("to go")
    assert "to go" not in saved_positions.positions()
    with pytest.raises(InputError):
        saved_positions.remove("../settings")


def test_a_drill_judges_each_stroke_and_asks_for_none_between_attempts() -> None:
    drill = load("stop-shot")
    session = DrillSession(drill)
    assert session.layout == drill.layout
    assert not (session.is_practice or session.movable or session.in_hand)
    session.play(Shot(180.0, 1.0))
    assert session.run.standing.missed == "not_potted"
    assert list(session.run.results) == [0]
    assert session.ask.kind == "over"
    with pytest.raises(InputError):
        session.play(Shot(0.0, 1.0))
    session.again()
    assert session.layout == drill.layout
    session.play(drill.solution[0])
    assert list(session.run.results) == [0, 1]
    assert not session.undo()


def test_a_drill_of_several_steps_goes_on_with_the_balls_it_says() -> None:
    drill = load("cut-ladder-left")
    session = DrillSession(drill)
    for number, shot in enumerate(drill.solution, start=1):
        session.play(shot)
        assert session.run.standing.done == number
        assert number == len(drill.steps) or session.layout == session.run.standing.layout
    assert session.run.over
    session.again()
    assert session.run.results == ()


def test_a_cue_ball_that_falls_ends_the_attempt_and_is_not_in_hand() -> None:
    drill = load("safety")
    session = DrillSession(drill)
    cue = session.cue
    session.play(Shot(math.degrees(math.atan2(-cue.y, -cue.x)), 3.0))
    assert session.run.standing.missed == "cue_fell"
    assert not session.in_hand


def test_the_last_stroke_of_a_drill_is_of_this_attempt() -> None:
    drill = load("cut-ladder-left")
    session = DrillSession(drill)
    assert session.last is None
    rollout = session.play(drill.solution[0])
    # The balls are set up for the next step, and the stroke can still be seen again.
    assert session.rollout is rollout and session.shot == drill.solution[0]
    session.rack()
    assert (session.last, session.layout, session.run.results) == (None, drill.layout, ())
    assert not session.undo() and not session.redo()
