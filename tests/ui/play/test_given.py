"""A cue ball that a foul has given while it lies on the table is in hand, as one that fell is, until it is put down."""

from __future__ import annotations

from dataclasses import replace

import pygame
import pytest

from pool2d.game.rules import AIM
from pool2d.game.session import Session, placing
from pool2d.ui.play.play_view import notes

from ..at_match import in_hand
from ..conftest import Hand

Point = tuple[float, float]


@pytest.fixture
def given(hand: Hand) -> Hand:
    """Bob has fouled, and Ann has the cue ball, which lies on the table."""
    session = in_hand(hand)
    assert session.ask.kind == AIM and session.in_hand_by_foul
    return hand


def lies(hand: Hand) -> Point:
    return hand.play.state.session.cue.x, hand.play.state.session.cue.y


def held(hand: Hand) -> Point | None:
    ball = hand.play.state.in_hand.held(hand.play.state.session)
    return None if ball is None else (ball.x, ball.y)


def placed(session: Session) -> bool:
    return placing(session.match.now)


def test_it_lies_where_it_lay_until_the_pointer_moves_and_then_follows_it(given: Hand) -> None:
    assert held(given) == lies(given)
    for to in ((0.5, 0.4), (0.7, 0.9)):
        given.point(*to)
        assert held(given) == pytest.approx(to, abs=0.003)
    assert "Click where the cue ball shall stand. Esc leaves it where it lies." in given.play.state.messages.text
    given.press()
    given.release()
    assert lies(given) == pytest.approx((0.7, 0.9), abs=0.003) and held(given) is None
    # From now on the pointer aims.
    given.point(1.5, 0.9)
    assert held(given) is None and given.play.state.hands.aim.angle == pytest.approx(0.0, abs=0.5)
    assert "may be dragged anywhere" in given.play.state.messages.text and "Esc" not in given.play.state.messages.text
    given.press()
    given.pull(100)
    given.release()
    assert given.play.state.session.match.now.action is not None and not placed(given.play.state.session)


def test_of_the_stroke_nothing_is_told_until_the_ball_is_put_down(given: Hand) -> None:
    """Where it lay it was said to need a raised butt, though nobody would strike it there."""
    state = given.play.state
    given.point(0.04, 0.5)
    state.hands.aim = replace(state.hands.aim, angle=0.0)
    assert state.clearance.over == "15" and "degrees" not in notes(state, 3.0)
    given.press()
    given.release()
    state.hands.aim = replace(state.hands.aim, angle=0.0)
    assert "degrees, over the left cushion" in notes(state, 3.0)


def test_esc_leaves_it_where_it_lies_and_it_does_not_come_back(given: Hand) -> None:
    before = lies(given)
    given.point(0.7, 0.9)
    given.key(pygame.K_ESCAPE)
    given.app.step(0.1)
    assert held(given) is None and lies(given) == before and not placed(given.play.state.session)
    given.app.step(5.0)
    assert "may be dragged anywhere" in given.play.state.messages.text


def test_put_down_unmoved_it_is_played_from_where_it_lies(given: Hand) -> None:
    session, before, strokes = given.play.state.session, lies(given), given.play.state.session.strokes
    given.app.step(1.0)
    for _ in range(2):
        given.key(pygame.K_SPACE)
        given.app.step(0.1)
    assert held(given) is None and lies(given) == before and not placed(session)
    given.key(pygame.K_SPACE)
    assert session.strokes == strokes + 1
    assert session.match.history[-2].action is not None and not placing(session.match.history[-2])


def test_the_arrows_move_it(given: Hand) -> None:
    x, y = lies(given)
    given.key(pygame.K_LEFT)
    assert held(given) == pytest.approx((x - 0.01, y))


def test_left_and_come_back_to_it_is_still_in_hand(given: Hand) -> None:
    given.point(0.7, 0.9)
    given.post(pygame.WINDOWFOCUSLOST)
    given.app.step(0.1)
    assert held(given) == lies(given)
    given.point(0.5, 0.4)
    assert held(given) == pytest.approx((0.5, 0.4), abs=0.003)


def test_taken_back_to_before_the_break_it_is_not_in_hand_though_it_may_be_moved(given: Hand) -> None:
    session = given.play.state.session
    given.point(0.7, 0.9)
    while session.undo():
        pass
    given.play.state.drop()
    given.app.step(0.1)
    assert session.movable and not session.in_hand_by_foul and held(given) is None
