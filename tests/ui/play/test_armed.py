"""A press of the stroke's key never does what the one before it meant."""

from __future__ import annotations

from collections.abc import Callable

import pygame
import pytest

from pool2d.ui.scene import GUARD

from ..at_match import begin
from ..conftest import CUE, FRAME, ONE, Hand


def at_rest(hand: Hand) -> None:
    """A shot of Ann's has come to rest, and it is Bob's turn."""
    begin(hand, "nine-ball")
    hand.key(pygame.K_SPACE)
    hand.wait_for_rest()
    wait(hand)


def wait(hand: Hand) -> None:
    for _ in range(round(1.5 * GUARD / FRAME)):
        hand.app.step(FRAME)


@pytest.mark.parametrize("late", [0, 5, 21, 40, 120])
def test_a_press_that_came_too_late_to_skip_plays_nothing(hand: Hand, late: int) -> None:
    session = begin(hand, "nine-ball")
    hand.key(pygame.K_SPACE)
    hand.wait_for_rest()
    for _ in range(late):
        hand.app.step(FRAME)
    hand.key(pygame.K_SPACE)
    assert session.strokes == 1


ARMING: dict[str, Callable[[Hand], None]] = {
    "the mouse": lambda hand: hand.move((500, 300)),
    "the wheel": lambda hand: hand.wheel(1),
    "an arrow": lambda hand: hand.key(pygame.K_LEFT),
    "the force": lambda hand: hand.key(pygame.K_UP),
    "spin": lambda hand: hand.key(pygame.K_w),
    "a first press": lambda hand: hand.key(pygame.K_SPACE),
}


@pytest.mark.parametrize("what", ARMING)
def test_the_next_stroke_is_armed_by(hand: Hand, what: str) -> None:
    at_rest(hand)
    ARMING[what](hand)
    assert hand.play.state.session.strokes == 1
    hand.key(pygame.K_SPACE)
    assert hand.play.state.session.strokes == 2


@pytest.mark.parametrize("what", [key for key in ARMING if key != "a first press"])
def test_what_a_hand_does_while_the_balls_run_arms_nothing(hand: Hand, what: str) -> None:
    session = begin(hand, "nine-ball")
    hand.key(pygame.K_SPACE)
    ARMING[what](hand)
    hand.wait_for_rest()
    wait(hand)
    hand.key(pygame.K_SPACE)
    assert session.strokes == 1


def test_a_key_held_since_the_shot_neither_arms_nor_strikes(hand: Hand) -> None:
    session = begin(hand, "nine-ball")
    hand.key(pygame.K_SPACE)
    hand.post(pygame.KEYDOWN, key=pygame.K_SPACE, mod=0, unicode=" ")
    for _ in range(60):
        hand.post(pygame.KEYDOWN, key=pygame.K_SPACE, mod=0, unicode=" ")
    assert session.strokes == 1 and not hand.play.state.hands.armed


def test_to_place_the_ball_is_not_to_strike(hand: Hand) -> None:
    hand.set_balls(CUE, ONE, in_hand=True)
    hand.key(pygame.K_SPACE)
    assert not hand.play.state.session.in_hand
    hand.key(pygame.K_SPACE)
    assert hand.play.state.session.strokes == 0
    hand.key(pygame.K_SPACE)
    assert hand.play.state.session.strokes == 1


def test_the_key_that_resumes_does_not_strike(hand: Hand) -> None:
    hand.key(pygame.K_ESCAPE)
    hand.key(pygame.K_RETURN)
    assert hand.app.scene is hand.play
    hand.key(pygame.K_RETURN)
    assert hand.play.state.session.strokes == 0
