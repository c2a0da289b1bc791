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
from pool2d.game.rules import AIM, CHOOSE, Ruling
from pool2d.game.rules.report import Call
from pool2d.game.session import Session
from pool2d.physics.values import POCKETED
from pool2d.ui.play import play_view
from pool2d.ui.play.call_words import off_target, verdict
from pool2d.ui.widgets.widget import Button
from pool2d.ui.wording import ruling_text

from ...game.rules.notation import report
from ..at_match import begin, in_hand, place
from ..conftest import FRAME, Hand


def test_a_choice_is_offered_as_buttons_and_taken_by_digit(hand: Hand) -> None:
    session = begin(hand)
    # A break that is too soft: the opponent may choose.
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(1.0).toward(1.0, 0.0)
    hand.strike()
    assert session.ask.kind == CHOOSE
    assert len(hand.play.controller.call_strip.form.widgets) == len(session.ask.options) > 1
    strokes = session.strokes
    hand.key(pygame.K_SPACE, 0)
    hand.key(pygame.K_1)
    assert session.ask.kind != CHOOSE
    assert session.strokes <= strokes


def test_a_button_of_the_strip_is_pressed_by_mouse_and_moves_no_aim(hand: Hand) -> None:
    session = begin(hand)
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(1.0).toward(1.0, 0.0)
    hand.strike()
    hand.app.step(0.0)
    button = hand.play.controller.call_strip.form.widgets[1]
    aim = hand.play.state.hands.aim
    hand.move(button.rect.center)
    hand.press()
    assert hand.play.state.hands.pull is None
    hand.release()
    assert session.ask.kind != CHOOSE
    assert hand.play.state.hands.aim == aim


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


def test_a_strike_key_that_is_hit_on_and_on_plays_no_shot_for_the_other(hand: Hand) -> None:
    session = begin(hand, "nine-ball")
    for _ in range(6):
        hand.key(pygame.K_SPACE)
    assert session.strokes == 1 and session.ask.kind == AIM
    # A window that were still would sleep, and never come to the end of that.
    assert not hand.play.still
    for _ in range(30):
        hand.app.step(FRAME)
    hand.key(pygame.K_SPACE)
    assert session.strokes == 1 and "Once more" in hand.play.state.messages.text
    hand.key(pygame.K_SPACE)
    assert session.strokes == 2


def test_nor_does_it_choose(hand: Hand) -> None:
    session = begin(hand)
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(1.0).toward(1.0, 0.0)
    for _ in range(6):
        hand.key(pygame.K_SPACE)
    assert session.ask.kind == CHOOSE and session.strokes == 1
    hand.app.step(0.5)
    hand.key(pygame.K_SPACE)
    assert session.ask.kind != CHOOSE


def test_a_push_out_is_told_of(hand: Hand) -> None:
    session = begin(hand, "nine-ball")
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(9.0).toward(1.0, 0.02)
    hand.strike()
    while session.ask.kind == CHOOSE or session.ask.where:
        session.place(0.5, 0.5) if session.ask.where else session.choose(session.ask.options[0])
        hand.app.redraw()
        hand.app.step(0.0)
        if session.ask.kind == AIM:
            break
    assert "push" in session.ask.may and "A push out may be called." in verdict(hand.play.state.calls, session)
    hand.play.state.calls.push = True
    assert off_target(hand.play.state.calls, session, "9") == ""
    name = session.match.names[session.ask.player]
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(0.4).turned(90.0)
    hand.strike()
    assert f"{name} pushes out." in hand.play.state.messages.text


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
    assert off_target(hand.play.state.calls, session, "yellow2") == ""
    assert ruling_text.ball("yellow2") == "yellow" and ruling_text.ball("9") == "9"


def lined_up(hand: Hand, game: str = "ten-ball") -> Session:
    """A match whose break is over, with the 1 on, and the 9 lined up behind it for a corner pocket."""
    session = begin(hand, game)
    layout, table = session.layout, session.table
    corner = next(pocket for pocket in table.geometry.pockets if pocket.name == "top-right")
    nine = (corner.x - 0.20, corner.y - 0.20)
    two_r = 2.0 * table.knobs.ball.radius / math.sqrt(2.0)
    one = (nine[0] - two_r - 0.02, nine[1] - two_r - 0.02)
    places = {"cue": (one[0] - 0.4, one[1] - 0.4), "1": one, "9": nine, "10": (0.3, 0.3)}
    layout = Layout(
        ball._replace(x=places[ball.id][0], y=places[ball.id][1])
        if ball.id in places
        else ball._replace(phase=POCKETED)
        for ball in layout.values()
    )
    rules: Any = session.match.rules
    state = replace(session.match.state, shots=3, turn=0)
    if game == "ten-ball":
        state = replace(state, ask=replace(state.ask, kind=AIM, where="", on=("1",), call="pocket", options=()))
    else:
        state = rules.next(state, layout, 0)
    now = session.match.now
    session.match._past[-1] = replace(now, ruling=Ruling(state, layout))
    hand.app.redraw()
    hand.app.step(0.0)
    return session


def click(hand: Hand, x: float, y: float) -> None:
    hand.point(x, y)
    hand.press()
    hand.release()


def at(session: Session, name: str) -> tuple[float, float]:
    """Where a ball or a pocket is."""
    pockets = {pocket.name: (pocket.x, pocket.y) for pocket in session.table.geometry.pockets}
    return pockets.get(name) or (session.layout[name].x, session.layout[name].y)


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


def test_shift_and_the_key_go_back(hand: Hand) -> None:
    session = lined_up(hand)
    calls = hand.play.state.calls
    hand.key(pygame.K_F9)
    assert calls.ball == "1"
    hand.key(pygame.K_F9, pygame.KMOD_SHIFT)
    assert calls.ball == ""
    hand.key(pygame.K_F9, pygame.KMOD_SHIFT)
    assert calls.ball == calls.balls(session)[-1]


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
    assert "click the ball and then its pocket" in verdict(hand.play.state.calls, session)
    click(hand, *at(session, "9"))
    assert "click the ball" not in verdict(hand.play.state.calls, session)
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


def test_a_safety_is_said_in_place_of_a_call_and_the_other_way_round(hand: Hand) -> None:
    session = lined_up(hand, "eight-ball")
    calls = hand.play.state.calls
    click(hand, *at(session, "9"))
    hand.key(pygame.K_2)
    assert calls.safety and calls.ball == ""
    click(hand, *at(session, "9"))
    assert calls.ball == "9" and not calls.safety


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
