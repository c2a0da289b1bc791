"""What a player says to the referee: calls and choices, by mouse and key."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pygame
import pytest

from pool2d import Ball, Layout
from pool2d.draw import theme
from pool2d.game.actions import Stroke
from pool2d.game.rules import Ruling
from pool2d.game.rules.report import Call
from pool2d.ui.play import play_view
from pool2d.ui.play.call_words import off_target, verdict
from pool2d.ui.widgets.widget import Button
from pool2d.ui.wording import ruling_text

from ...game.rules.notation import report
from ..at_match import begin, in_hand, place
from ..conftest import FRAME, Hand
from .called_shots import at, click, lined_up


def test_a_pocket_is_called_by_a_click_and_by_key(hand: Hand) -> None:
    session = begin(hand, "straight")
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(8.0).toward(1.0, 0.01)
    pocket = session.table.geometry.pockets[3]
    assert session.ask.call == "pocket"
    hand.point(pocket.x, pocket.y)
    hand.press()
    hand.release()
    assert hand.play.state.calls.pocket == pocket.name
    assert session.strokes == 0
    hand.key(pygame.K_y)
    called = hand.play.state.calls.pocket
    assert called == session.table.geometry.pockets[4].name
    one = session.layout["1"]
    hand.point(one.x, one.y)
    hand.key(pygame.K_SPACE)
    action = session.match.now.action
    assert action is not None
    assert action.call.pocket == called  # type: ignore[union-attr]
    assert action.call.ball  # type: ignore[union-attr]
    hand.wait_for_rest()
    assert hand.play.state.calls.pocket == ""


def test_what_was_called_for_a_shot_that_is_taken_back_is_forgotten(hand: Hand) -> None:
    session = in_hand(hand)
    place(hand)
    hand.key(pygame.K_2)
    assert hand.play.state.calls.safety
    hand.key(pygame.K_u)
    assert not hand.play.state.calls.safety
    assert hand.play.state.calls.said(session, "1").safety is False


def test_a_call_outlives_the_placing_of_the_cue_ball(hand: Hand) -> None:
    in_hand(hand)
    place(hand)
    hand.key(pygame.K_2)
    place(hand, 0.5)
    assert hand.play.state.calls.safety


def test_what_was_called_in_one_match_is_not_said_in_the_next(hand: Hand) -> None:
    in_hand(hand)
    place(hand)
    hand.key(pygame.K_2)
    assert hand.play.state.calls.safety
    hand.app.scene = hand.app.lobby.leave()
    hand.app.scene = hand.play
    hand.strike()
    assert hand.play.state.session.strokes == 1


def test_a_stroke_may_begin_on_a_pocket(hand: Hand) -> None:
    session = begin(hand, "straight")
    pocket = session.table.geometry.pockets[0]
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(8.0).toward(1.0, 0.0)
    hand.point(pocket.x, pocket.y)
    hand.press()
    hand.pull(80.0)
    hand.release()
    assert session.strokes == 1
    assert hand.play.state.calls.pocket == ""


def test_a_ball_of_many_alike_is_called_without_its_number(hand: Hand) -> None:
    session = begin(hand, "english-eight-ball", "english-7ft")
    assert off_target(hand.app.words, hand.play.state.calls, session, "yellow2") == ""
    assert ruling_text.ball(hand.app.words, "yellow2") == "yellow" and ruling_text.ball(hand.app.words, "9") == "9"


@pytest.mark.parametrize("by", ["mouse", "keys"])
@pytest.mark.parametrize("game", ["ten-ball", "eight-ball", "straight"])
def test_a_combination_is_called_made_and_goes_on(hand: Hand, game: str, by: str) -> None:
    session = lined_up(hand, game)
    calls = hand.play.state.calls
    if by == "mouse":
        click(hand, *at(session, "9"))
        click(hand, *at(session, "top-right"))
    else:
        while calls.ball != "9":
            hand.key(pygame.K_F9)
        while calls.pocket != "top-right":
            hand.key(pygame.K_y)
    assert (calls.ball, calls.pocket) == ("9", "top-right")
    assert session.strokes == 3
    hand.point(*at(session, "1"))
    hand.play.state.hands.aim = replace(hand.play.state.hands.aim, angle=45.0, speed=3.0)
    hand.key(pygame.K_SPACE)
    hand.wait_for_rest()
    action, now = session.match.now.action, session.match.now
    assert isinstance(action, Stroke) and action.call == Call("9", "top-right")
    assert now.report is not None and now.report.first == ("1",) and "9" in now.report.potted
    assert session.ask.player == 0 and not now.ruling.foul


def test_the_same_combination_uncalled_loses_the_turn(hand: Hand) -> None:
    session = lined_up(hand)
    hand.point(*at(session, "1"))
    hand.play.state.hands.aim = replace(hand.play.state.hands.aim, angle=45.0, speed=3.0)
    hand.key(pygame.K_SPACE)
    hand.wait_for_rest()
    assert session.match.now.report is not None and "9" in session.match.now.report.potted
    assert session.ask.player == 1


@pytest.mark.parametrize("name", ["9", "top-right"])
def test_the_same_click_takes_a_call_back(hand: Hand, name: str) -> None:
    session = lined_up(hand)
    calls = hand.play.state.calls
    click(hand, *at(session, name))
    assert name in (calls.ball, calls.pocket)
    click(hand, *at(session, name))
    assert (calls.ball, calls.pocket) == ("", "")
    assert hand.play.state.session.strokes == 3


def test_a_call_is_said_in_the_bar_and_seen_on_the_table(hand: Hand) -> None:
    session = lined_up(hand)
    hand.point(0.1, 0.1)
    hand.app.step(FRAME)
    view, window = hand.play.stage.view, pygame.display.get_surface()
    assert window is not None

    def ringed(name: str, radius: float) -> int:
        """How many points of a circle round a ball or a pocket have the colour of a call."""
        x, y = view.to_screen(*at(session, name))
        turns = [math.tau * i / 60 for i in range(60)]
        points = [(round(x + radius * math.cos(turn)), round(y + radius * math.sin(turn))) for turn in turns]
        return sum(
            window.get_at(point)[:3] == theme.ACCENT for point in points if window.get_rect().collidepoint(point)
        )

    ball = session.table.knobs.ball.radius * view.scale + 3.0
    pocket = session.table.geometry.pockets[0].radius * view.scale
    assert ringed("9", ball) == ringed("top-right", pocket) == 0
    assert "click the ball and then its pocket" in verdict(hand.app.words, hand.play.state.calls, session)
    click(hand, *at(session, "9"))
    assert "click the ball" not in verdict(hand.app.words, hand.play.state.calls, session)
    assert "Called: 9. Now its pocket" in play_view.notes(hand.play.state, 2.0)
    click(hand, *at(session, "top-right"))
    hand.point(0.1, 0.1)
    assert "Called: 9, top right." in play_view.notes(hand.play.state, 2.0)
    strip = hand.play.controller.call_strip.form
    assert any("9, top right" in widget.label for widget in strip.widgets if isinstance(widget, Button))
    hand.app.redraw()
    hand.app.step(FRAME)
    assert ringed("9", ball) > 30 and ringed("top-right", pocket) > 15


def test_a_pull_that_is_eased_back_calls_nothing(hand: Hand) -> None:
    session = lined_up(hand)
    hand.point(*at(session, "9"))
    hand.press()
    hand.pull(60.0)
    hand.pull(-60.0)
    hand.release()
    assert session.strokes == 3 and hand.play.state.calls.ball == ""


def test_a_stroke_may_be_pulled_from_a_ball(hand: Hand) -> None:
    session = lined_up(hand)
    hand.point(*at(session, "1"))
    hand.press()
    hand.pull(60.0)
    hand.release()
    assert session.strokes == 4 and isinstance(session.match.now.action, Stroke)


def test_a_click_moves_neither_aim_nor_cue_ball(hand: Hand) -> None:
    session = lined_up(hand)
    hand.point(*at(session, "1"))
    hand.wheel(1)
    layout = session.layout
    click(hand, *at(session, "9"))
    aim = hand.play.state.hands.aim
    hand.move((hand.at[0] + 2, hand.at[1]))
    assert hand.play.state.hands.aim == aim and session.layout is layout


def test_a_ball_without_its_pocket_counts_only_where_it_is_obvious() -> None:
    start = Layout([Ball("cue", 0.5, 0.5), Ball("1", 1.0, 0.5), Ball("2", 1.2, 0.5)])
    straight = report("cue-1 1>top-left", start=start)
    through = report("cue-1 1-2 2>top-left", start=start)
    assert replace(straight, call=Call("1")).called() == "1"
    assert replace(straight, call=Call("2")).called() == ""
    assert replace(through, call=Call("2")).called() == ""
    assert replace(through, call=Call("2", "top-left")).called() == "2"


def test_a_colour_is_nominated_by_a_click(hand: Hand) -> None:
    session = begin(hand, "snooker", "snooker-12ft")
    rules: Any = session.match.rules
    before: Any = session.match.state
    state = rules.aiming(replace(before, phase="color", shots=3), session.layout, 0)
    session.match._past[-1] = replace(session.match.now, ruling=Ruling(state, session.layout))
    hand.app.redraw()
    hand.app.step(0.0)
    calls = hand.play.state.calls
    click(hand, *at(session, "blue"))
    assert calls.said(session, "yellow") == Call("blue")
    assert "Named: blue." in play_view.notes(hand.play.state, 2.0)
    click(hand, *at(session, "red3"))
    assert calls.said(session, "yellow") == Call("blue")
    click(hand, *at(session, "blue"))
    assert calls.said(session, "yellow") == Call("yellow")


def test_where_nothing_is_called_a_click_means_nothing(hand: Hand) -> None:
    session = begin(hand, "nine-ball")
    click(hand, *at(session, "1"))
    hand.key(pygame.K_F9)
    calls = hand.play.state.calls
    assert (calls.ball, calls.pocket) == ("", "") and session.strokes == 0
