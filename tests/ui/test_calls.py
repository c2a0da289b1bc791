"""What a player says to the referee: calls and choices, by mouse and key."""

from __future__ import annotations

import pygame

from pool2d.game.rules import AIM, CHOOSE
from pool2d.ui import rulings

from .at_match import begin, in_hand, place
from .conftest import FRAME, Hand


def test_a_choice_is_offered_as_buttons_and_taken_by_digit(hand: Hand) -> None:
    session = begin(hand)
    # A break that is too soft: the opponent may choose.
    hand.play.hands.aim = hand.play.hands.aim.with_speed(1.0).toward(1.0, 0.0)
    hand.strike()
    assert session.ask.kind == CHOOSE
    assert len(hand.play.referee.form.widgets) == len(session.ask.options) > 1
    strokes = session.strokes
    hand.key(pygame.K_SPACE, 0)
    hand.key(pygame.K_1)
    assert session.ask.kind != CHOOSE
    assert session.strokes <= strokes


def test_a_button_of_the_strip_is_pressed_by_mouse_and_moves_no_aim(hand: Hand) -> None:
    session = begin(hand)
    hand.play.hands.aim = hand.play.hands.aim.with_speed(1.0).toward(1.0, 0.0)
    hand.strike()
    hand.app.step(0.0)
    button = hand.play.referee.form.widgets[1]
    aim = hand.play.hands.aim
    hand.move(button.rect.center)
    hand.press()
    assert hand.play.hands.pull is None
    hand.release()
    assert session.ask.kind != CHOOSE
    assert hand.play.hands.aim == aim


def test_a_pocket_is_called_by_a_click_and_by_key(hand: Hand) -> None:
    session = begin(hand, "straight")
    hand.play.hands.aim = hand.play.hands.aim.with_speed(8.0).toward(1.0, 0.01)
    pocket = session.table.geometry.pockets[3]
    assert session.ask.call == "pocket"
    hand.point(pocket.x, pocket.y)
    hand.press()
    hand.release()
    assert hand.play.referee.pocket == pocket.name
    assert session.strokes == 0
    hand.key(pygame.K_y)
    called = hand.play.referee.pocket
    assert called == session.table.geometry.pockets[4].name
    one = session.layout["1"]
    hand.point(one.x, one.y)
    hand.key(pygame.K_SPACE)
    action = session.match.now.action
    assert action is not None
    assert action.call.pocket == called  # type: ignore[union-attr]
    assert action.call.ball  # type: ignore[union-attr]
    hand.wait_for_rest()
    assert hand.play.referee.pocket == ""


def test_what_was_called_for_a_shot_that_is_taken_back_is_forgotten(hand: Hand) -> None:
    session = in_hand(hand)
    place(hand)
    hand.key(pygame.K_2)
    assert hand.play.referee.safety
    hand.key(pygame.K_u)
    assert not hand.play.referee.safety
    assert hand.play.referee.said(session, "1").safety is False


def test_a_call_outlives_the_placing_of_the_cue_ball(hand: Hand) -> None:
    in_hand(hand)
    place(hand)
    hand.key(pygame.K_2)
    place(hand, 0.5)
    assert hand.play.referee.safety


def test_what_was_called_in_one_match_is_not_said_in_the_next(hand: Hand) -> None:
    in_hand(hand)
    place(hand)
    hand.key(pygame.K_2)
    assert hand.play.referee.safety
    hand.app.scene = hand.app.lobby.leave()
    hand.app.scene = hand.play
    hand.strike()
    assert hand.play.session.strokes == 1


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
    assert session.strokes == 2


def test_nor_does_it_choose(hand: Hand) -> None:
    session = begin(hand)
    hand.play.hands.aim = hand.play.hands.aim.with_speed(1.0).toward(1.0, 0.0)
    for _ in range(6):
        hand.key(pygame.K_SPACE)
    assert session.ask.kind == CHOOSE and session.strokes == 1
    hand.app.step(0.5)
    hand.key(pygame.K_SPACE)
    assert session.ask.kind != CHOOSE


def test_a_push_out_is_told_of(hand: Hand) -> None:
    session = begin(hand, "nine-ball")
    hand.play.hands.aim = hand.play.hands.aim.with_speed(9.0).toward(1.0, 0.02)
    hand.strike()
    while session.ask.kind == CHOOSE or session.ask.where:
        session.place(0.5, 0.5) if session.ask.where else session.choose(session.ask.options[0])
        hand.app.redraw()
        hand.app.step(0.0)
        if session.ask.kind == AIM:
            break
    assert "push" in session.ask.may and "A push out may be called." in hand.play.referee.verdict(session)
    hand.play.referee.push = True
    assert hand.play.referee.warning(session, "9") == ""
    name = session.match.names[session.ask.who]
    hand.play.hands.aim = hand.play.hands.aim.with_speed(0.4).turned(90.0)
    hand.strike()
    assert f"{name} pushes out." in hand.play.message


def test_a_stroke_may_begin_on_a_pocket(hand: Hand) -> None:
    session = begin(hand, "straight")
    pocket = session.table.geometry.pockets[0]
    hand.play.hands.aim = hand.play.hands.aim.with_speed(8.0).toward(1.0, 0.0)
    hand.point(pocket.x, pocket.y)
    hand.press()
    hand.pull(80.0)
    hand.release()
    assert session.strokes == 1
    assert hand.play.referee.pocket == ""


def test_a_ball_of_many_alike_is_called_without_its_number(hand: Hand) -> None:
    session = begin(hand, "english-eight-ball", "english-7ft")
    assert hand.play.referee.warning(session, "yellow2") == ""
    assert rulings.ball("yellow2") == "yellow" and rulings.ball("9") == "9"
