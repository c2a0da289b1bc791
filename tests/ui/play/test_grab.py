"""What a press near the cue ball means: to take it where it may be taken, and never a stroke by mistake."""

from __future__ import annotations

import math

import pytest

from pool2d.game.aim import MIN_SPEED, Aim, pulled_speed
from pool2d.game.rules import AIM

from ..at_match import begin, in_hand, place
from ..conftest import CUE, ONE, Hand


def beside(hand: Hand, pixels: float, angle: float) -> None:
    """Point so many pixels beside the edge of the cue ball."""
    stage, cue = hand.play.stage, hand.play.state.session.cue
    x, y = stage.view.to_screen(cue.x, cue.y)
    out = stage.table.body_of(cue)[0] * stage.view.scale + pixels
    hand.move((x + out * math.cos(angle), y + out * math.sin(angle)))


def drag(hand: Hand, x: float, y: float) -> None:
    hand.press()
    hand.point(x, y)
    hand.release()


@pytest.mark.parametrize("angle", [0.3, 1.9, 3.5, 5.0])
def test_a_grab_that_just_misses_the_cue_ball_takes_it(two: Hand, angle: float) -> None:
    beside(two, 10.0, angle)
    drag(two, 0.3, 0.9)
    cue = two.play.state.session.cue
    assert two.play.state.session.strokes == 0 and two.play.state.playback is None
    # It is carried by where it was taken.
    assert math.hypot(cue.x - 0.3, cue.y - 0.9) == pytest.approx(0.05, abs=0.03)


def test_farther_off_a_press_is_a_pull(two: Hand) -> None:
    beside(two, 40.0, 0.3)
    two.press()
    two.pull(100)
    two.release()
    assert two.play.state.session.strokes == 1


def test_another_ball_under_the_pointer_is_not_the_cue_ball(two: Hand) -> None:
    two.set_balls(CUE, ONE._replace(x=CUE.x + 0.058, y=CUE.y))
    two.point(CUE.x + 0.04, CUE.y)
    two.press()
    two.pull(100)
    two.release()
    assert two.play.state.session.strokes == 1


def test_beside_the_cue_ball_the_right_button_means_the_cloth(two: Hand) -> None:
    beside(two, 6.0, 1.9)
    two.press(3)
    two.release(3)
    assert two.play.state.in_hand.ball not in ("", "cue") and "cue" in two.play.state.session.layout


def test_where_the_cue_ball_may_not_be_moved_a_press_beside_it_is_a_pull(hand: Hand) -> None:
    session = begin(hand, "straight-rail", "carom-10ft")
    assert session.ask.kind == AIM and not session.movable
    beside(hand, 10.0, 0.3)
    hand.press()
    hand.pull(100)
    hand.release()
    assert session.strokes == 1


def test_in_a_match_a_pull_begun_near_the_ball_that_was_placed_takes_it(hand: Hand) -> None:
    session = in_hand(hand)
    place(hand)
    assert session.ask.kind == AIM
    strokes, before = session.strokes, session.cue
    beside(hand, 10.0, 1.5)
    drag(hand, before.x + 0.2, before.y)
    assert session.strokes == strokes and session.cue.x > before.x + 0.1


def test_a_ball_in_hand_is_placed_by_a_press_and_carried_on_by_a_drag(two: Hand) -> None:
    two.set_balls(CUE, ONE, in_hand=True)
    two.point(0.4, 0.4)
    two.press()
    assert (two.play.state.session.cue.x, two.play.state.session.cue.y) == pytest.approx((0.4, 0.4), abs=0.003)
    two.point(0.7, 0.9)
    two.release()
    assert (two.play.state.session.cue.x, two.play.state.session.cue.y) == pytest.approx((0.7, 0.9), abs=0.003)
    assert two.play.state.session.strokes == 0


def test_a_ball_in_hand_without_room_is_carried_to_where_there_is(two: Hand) -> None:
    two.set_balls(CUE, ONE, in_hand=True)
    two.point(ONE.x, ONE.y)
    two.press()
    assert two.play.state.session.in_hand and "no room" in two.play.state.messages.text
    two.point(0.7, 0.9)
    two.release()
    assert not two.play.state.session.in_hand
    assert (two.play.state.session.cue.x, two.play.state.session.cue.y) == pytest.approx((0.7, 0.9), abs=0.003)


def test_let_go_without_room_it_stays_in_hand_where_it_is(two: Hand) -> None:
    two.set_balls(CUE, ONE, in_hand=True)
    two.point(ONE.x, ONE.y)
    drag(two, ONE.x + 0.02, ONE.y)
    assert two.play.state.session.in_hand and "no room" in two.play.state.messages.text
    assert two.play.state.in_hand.at == pytest.approx((ONE.x + 0.02, ONE.y), abs=0.003)


@pytest.mark.parametrize("pixels", [0, 3, 8, 15])
def test_a_short_press_is_no_stroke(two: Hand, pixels: int) -> None:
    two.point(1.4, 0.3)
    two.press()
    two.pull(pixels)
    two.release()
    assert two.play.state.session.strokes == 0


def test_the_softest_stroke_is_the_same_by_hand_and_by_key() -> None:
    speeds = [pulled_speed(pull / 10000) for pull in range(4000)]
    assert min(speed for speed in speeds if speed > 0.0) >= MIN_SPEED == Aim().with_speed(0.0).speed
    assert speeds == sorted(speeds) and speeds[-1] == 10.0
