"""Arranging the balls of a table by mouse and keyboard."""

from __future__ import annotations

import pygame
import pytest

from pool2d import load_table
from pool2d.game.match import Match
from pool2d.game.session import Session
from pool2d.game.setup import Setup
from pool2d.physics.values import POCKETED

from ..conftest import CUE, ONE, Hand

CTRL = pygame.KMOD_CTRL


def drag(hand: Hand, start: tuple[float, float], end: tuple[float, float], button: int) -> None:
    hand.point(*start)
    hand.press(button)
    hand.point((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    hand.point(*end)
    hand.release(button)


def place(hand: Hand, ball: str) -> tuple[float, float]:
    at = hand.play.state.session.layout[ball]
    return at.x, at.y


@pytest.mark.parametrize(("ball", "button"), [("cue", 1), ("cue", 3), ("1", 3)])
def test_a_ball_is_dragged_and_that_can_be_taken_back(two: Hand, ball: str, button: int) -> None:
    held = two.play.state.session.layout[ball]
    drag(two, (held.x, held.y), (1.0, 1.0), button)
    assert place(two, ball) == pytest.approx((1.0, 1.0), abs=0.003)
    assert two.play.state.session.strokes == 0
    two.key(pygame.K_u)
    assert two.play.state.session.layout[ball] == held


def test_the_aim_does_not_move_while_a_ball_is_dragged(two: Hand) -> None:
    two.point(ONE.x, ONE.y)
    aim = two.play.state.hands.aim
    two.press(3)
    two.point(1.0, 1.0)
    two.point(2.0, 0.2)
    two.release(3)
    assert two.play.state.hands.aim == aim


def test_with_the_left_button_on_an_object_ball_one_strikes(two: Hand) -> None:
    two.point(ONE.x, ONE.y)
    two.press()
    two.pull(150)
    two.release()
    assert two.play.state.session.strokes == 1


def test_a_ball_dropped_where_it_has_no_room_is_back(two: Hand) -> None:
    for spot in ((CUE.x + 0.02, CUE.y), (-0.1, 0.5)):
        drag(two, (ONE.x, ONE.y), spot, 3)
        assert place(two, "1") == (ONE.x, ONE.y)
        assert "no room" in two.play.state.messages.text


def test_escape_puts_a_dragged_ball_back(two: Hand) -> None:
    two.point(ONE.x, ONE.y)
    two.press(3)
    two.point(1.0, 1.0)
    assert two.play.state.in_hand.ball == "1"
    two.key(pygame.K_ESCAPE)
    two.release(3)
    assert place(two, "1") == (ONE.x, ONE.y)
    assert two.play.state.in_hand.ball == ""


def test_losing_the_window_puts_a_dragged_ball_back(two: Hand) -> None:
    two.point(ONE.x, ONE.y)
    two.press(3)
    two.point(1.0, 1.0)
    two.post(pygame.WINDOWFOCUSLOST)
    two.release(3)
    assert place(two, "1") == (ONE.x, ONE.y)
    assert set(two.play.state.session.layout) == {"cue", "1"}


def test_a_right_click_takes_a_ball_off_and_adds_one(two: Hand) -> None:
    two.point(ONE.x, ONE.y)
    two.press(3)
    two.release(3)
    assert "1" not in two.play.state.session.layout
    two.point(1.9, 0.4)
    two.press(3)
    two.release(3)
    two.press()
    two.release()
    assert place(two, "1") == pytest.approx((1.9, 0.4), abs=0.003)


def test_a_ball_dropped_on_the_upper_bar_is_taken_off(two: Hand) -> None:
    two.point(ONE.x, ONE.y)
    two.press(3)
    two.move((400, 5))
    two.release(3)
    assert "1" not in two.play.state.session.layout


def test_everything_by_keyboard_alone(hand: Hand) -> None:
    hand.set_balls(CUE, ONE)
    hand.key(pygame.K_x)
    hand.key(pygame.K_x)
    assert hand.play.state.in_hand.ball == "1"
    hand.key(pygame.K_RIGHT)
    hand.key(pygame.K_UP, pygame.KMOD_SHIFT)
    hand.key(pygame.K_DOWN, CTRL)
    assert place(hand, "1") == (ONE.x, ONE.y), "not yet put down"
    hand.key(pygame.K_RETURN)
    assert place(hand, "1") == pytest.approx((ONE.x + 0.01, ONE.y + 0.002 - 0.2))
    hand.key(pygame.K_INSERT)
    hand.key(pygame.K_INSERT)
    assert hand.play.state.in_hand.ball == "3"
    hand.key(pygame.K_SPACE)
    assert set(hand.play.state.session.layout) == {"cue", "1", "3"}
    hand.key(pygame.K_DELETE)
    assert "pick a ball up" in hand.play.state.messages.text
    for _ in range(3):
        hand.key(pygame.K_x)
    hand.key(pygame.K_DELETE)
    assert set(hand.play.state.session.layout) == {"cue", "1"}
    hand.key(pygame.K_u)
    assert set(hand.play.state.session.layout) == {"cue", "1", "3"}


def test_a_ball_picked_up_by_key_waits_for_the_pointer_to_move(two: Hand) -> None:
    two.key(pygame.K_x)
    two.move((two.at[0] + 2, two.at[1]))
    assert two.play.state.in_hand.at is None
    two.point(1.8, 0.9)
    assert two.play.state.in_hand.at == pytest.approx((1.8, 0.9), abs=0.003)
    two.key(pygame.K_ESCAPE)
    assert place(two, "cue") == (CUE.x, CUE.y)


def test_the_cue_ball_taken_off_is_in_hand(two: Hand) -> None:
    two.key(pygame.K_x)
    two.key(pygame.K_DELETE)
    assert two.play.state.session.in_hand
    two.point(0.4, 0.4)
    two.press()
    two.release()
    assert place(two, "cue") == pytest.approx((0.4, 0.4), abs=0.003)


def test_a_full_table_has_no_ball_to_add(hand: Hand) -> None:
    hand.key(pygame.K_c)
    assert hand.play.state.in_hand.ball == ""
    assert "All balls" in hand.play.state.messages.text


def test_in_a_match_only_the_cue_ball_in_hand_moves_and_only_where_it_may(hand: Hand) -> None:
    table = load_table("pool-9ft")
    session = Session(Match(table, Setup("eight-ball", seed=1)))
    hand.play.state.begin(session)
    hand.point(1.0, 0.3)
    before = session.layout
    if session.in_hand:
        session.place(0.4, 0.6)
    assert session.movable
    cue = session.cue
    drag(hand, (cue.x, cue.y), (0.3, 0.3), 1)
    assert place(hand, "cue") == pytest.approx((0.3, 0.3), abs=0.003)
    drag(hand, (0.3, 0.3), (1.6, 0.3), 1)
    assert place(hand, "cue") == pytest.approx((0.3, 0.3), abs=0.003)
    one = before["1"]
    drag(hand, (one.x, one.y), (1.0, 1.0), 3)
    assert place(hand, "1") == (one.x, one.y)
    for key, mod in ((pygame.K_F6, 0), (pygame.K_c, 0), (pygame.K_o, CTRL)):
        hand.key(key, mod)
        assert "Only in practice" in hand.play.state.messages.text
        assert session.layout == session.match.layout


def test_balls_that_fell_come_back_when_they_are_added(hand: Hand) -> None:
    hand.set_balls(CUE, ONE._replace(phase=POCKETED))
    hand.key(pygame.K_c)
    hand.key(pygame.K_SPACE)
    assert hand.play.state.session.layout["1"].phase != POCKETED
