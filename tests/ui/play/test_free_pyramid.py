"""Free pyramid in the window: the ball that strikes is the one that is clicked."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pygame
import pytest

from pool2d import Ball, InputError, Layout
from pool2d.game.actions import Stroke
from pool2d.game.records.record import load
from pool2d.game.records.recorded_shots import RecordedShots
from pool2d.game.records.recorder import Recorder
from pool2d.game.rules import Ruling
from pool2d.game.session import Session
from pool2d.physics.values import POCKETED
from pool2d.ui.play import play_view
from pool2d.ui.replay.replay_scene import Replay
from pool2d.ui.stage.shown_balls import BallHistory

from ..at_match import begin
from ..conftest import FRAME, Hand


def under_way(hand: Hand) -> Session:
    """A match of free pyramid after a break that scattered nothing."""
    session = begin(hand, "free-pyramid", "pyramid-12ft")
    rules: Any = session.match.rules
    before: Any = session.match.state
    state = rules._aiming(replace(before, shots=1), session.layout, 0)
    session.match._past[-1] = replace(session.match.now, ruling=Ruling(state, session.layout))
    hand.app.redraw()
    hand.app.step(0.0)
    return session


def click(hand: Hand, ball: str) -> None:
    place = hand.play.state.session.layout[ball]
    hand.point(place.x, place.y)
    hand.press()
    hand.release()


def test_a_click_takes_the_ball_that_strikes_and_another_takes_it_back(hand: Hand) -> None:
    session = under_way(hand)
    assert session.cue.id == "cue"
    click(hand, "5")
    assert session.cue.id == "5" and session.strokes == 1
    hand.app.step(FRAME)
    assert any(getattr(widget, "label", "") == "Strikes: 5" for widget in hand.play.controller.call_strip.form.widgets)
    click(hand, "7")
    assert session.cue.id == "7"
    click(hand, "7")
    assert session.cue.id == "cue"


def test_the_key_goes_through_the_balls(hand: Hand) -> None:
    session = under_way(hand)
    seen = []
    for _ in range(len(session.ask.cues)):
        hand.key(pygame.K_F9)
        seen.append(session.cue.id)
    assert set(seen) == set(session.ask.cues)
    hand.key(pygame.K_F9, pygame.KMOD_SHIFT)
    assert session.cue.id != seen[-1]


def test_the_ball_taken_is_aimed_struck_and_recorded(hand: Hand) -> None:
    session = under_way(hand)
    click(hand, "5")
    ball = session.layout["5"]
    hand.point(ball.x - 0.6, ball.y + 0.5)
    assert hand.play.state.hands.aim.angle == pytest.approx(140.2, abs=1.0)
    assert "35 degrees, over the 1." in play_view.notes(hand.play.state, 2.0)
    assert "call" not in play_view.notes(hand.play.state, 2.0)
    hand.press()
    hand.pull(100.0)
    hand.release()
    action, report = session.match.now.action, session.match.now.report
    assert isinstance(action, Stroke) and action.shot.ball == "5"
    assert report is not None and report.cue == "5"
    assert isinstance(session.recorder, Recorder)
    hand.wait_for_rest()
    assert session.cue.id == session.ask.ball


def test_the_ball_without_a_number_is_seen_in_the_tray_once_it_has_scored(hand: Hand) -> None:
    session = under_way(hand)
    corner = next(pocket for pocket in session.table.geometry.pockets if pocket.name == "top-right")
    on_the_way = (Ball(ball, corner.x - far, corner.y - far) for ball, far in (("cue", 0.12), ("5", 0.3)))
    balls = Layout((*on_the_way, Ball("7", 1.0, 0.5)))
    rules: Any = session.match.rules
    state = rules._aiming(session.match.state, balls, 0)
    session.match._past[-1] = replace(session.match.now, ruling=Ruling(state, balls))
    click(hand, "5")
    hand.play.state.hands.aim = replace(hand.play.state.hands.aim, angle=45.0, speed=2.0)
    hand.strike()
    hand.app.step(FRAME)
    assert session.layout["cue"].phase == POCKETED and not session.ruling.foul
    assert "cue" in hand.play.state.gone
    # At a game in which it comes back it is none of those that are down.
    begin(hand)
    hand.app.step(FRAME)
    begun = hand.play.state.session
    gone = begun.layout.without("cue").put(Ball("cue", 0.0, 0.0, phase=POCKETED))
    assert not BallHistory().at_rest(gone).gone(begun.match)


def test_so_it_is_where_a_record_is_shown(hand: Hand) -> None:
    session = begin(hand, "free-pyramid", "pyramid-12ft")
    hand.strike()
    session.leave()
    assert isinstance(session.recorder, Recorder)
    replay = Replay(RecordedShots(load(session.recorder.path)), hand.app.words)
    gone = session.layout.without("cue").put(Ball("cue", 0.0, 0.0, phase=POCKETED))
    assert BallHistory().at_rest(gone).gone(replay.state.shots[0].match) == ("cue",)


def test_taking_back_goes_back_to_the_ball_that_was_struck_before(hand: Hand) -> None:
    session = under_way(hand)
    click(hand, "5")
    hand.key(pygame.K_SPACE)
    hand.key(pygame.K_SPACE)
    hand.wait_for_rest()
    hand.key(pygame.K_u)
    assert session.cue.id == session.ask.ball == "cue"


def test_no_other_ball_may_be_taken_where_the_rules_leave_no_choice(hand: Hand) -> None:
    session = begin(hand, "nine-ball")
    with pytest.raises(InputError, match="allowed is cue"):
        session.take_cue("1")
