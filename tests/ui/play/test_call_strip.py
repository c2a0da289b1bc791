"""The strip of buttons: choices after a ruling, and calls by button and key."""

from __future__ import annotations

import pygame

from pool2d.game.rules import AIM, CHOOSE
from pool2d.ui.play.call_words import off_target, verdict

from ..at_match import begin
from ..conftest import FRAME, Hand
from .called_shots import at, click, lined_up


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
    assert "push" in session.ask.may and "A push out may be called." in verdict(
        hand.app.words, hand.play.state.calls, session
    )
    hand.play.state.calls.push = True
    assert off_target(hand.app.words, hand.play.state.calls, session, "9") == ""
    name = session.match.names[session.ask.player]
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(0.4).turned(90.0)
    hand.strike()
    assert f"{name} pushes out." in hand.play.state.messages.text


def test_shift_and_the_key_go_back(hand: Hand) -> None:
    session = lined_up(hand)
    calls = hand.play.state.calls
    hand.key(pygame.K_F9)
    assert calls.ball == "1"
    hand.key(pygame.K_F9, pygame.KMOD_SHIFT)
    assert calls.ball == ""
    hand.key(pygame.K_F9, pygame.KMOD_SHIFT)
    assert calls.ball == calls.balls(session)[-1]


def test_a_safety_is_said_in_place_of_a_call_and_the_other_way_round(hand: Hand) -> None:
    session = lined_up(hand, "eight-ball")
    calls = hand.play.state.calls
    click(hand, *at(session, "9"))
    hand.key(pygame.K_2)
    assert calls.safety and calls.ball == ""
    click(hand, *at(session, "9"))
    assert calls.ball == "9" and not calls.safety
