"""Arranging the table by mouse and keyboard, and positions as text and by name."""

from __future__ import annotations

from pathlib import Path

import pygame
import pytest

from pool2d import Ball, Layout, load_table
from pool2d.game import shelf
from pool2d.game.match import Match
from pool2d.game.session import Session
from pool2d.game.setup import Setup
from pool2d.physics.values import POCKETED
from pool2d.position import read
from pool2d.ui.dialog import Ask
from pool2d.ui.position_shelf import PositionShelf

from .conftest import Hand

CTRL = pygame.KMOD_CTRL
CUE, ONE = Ball("cue", 0.6, 0.6), Ball("1", 1.4, 0.7)


@pytest.fixture
def two(hand: Hand) -> Hand:
    """A hand at a table with two balls."""
    hand.set_balls(CUE, ONE)
    hand.point(1.0, 0.3)
    return hand


@pytest.fixture
def copied(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The clipboard: what has been copied is its only item."""
    held = [""]
    monkeypatch.setattr(pygame.scrap, "put_text", lambda words: held.__setitem__(0, words))
    monkeypatch.setattr(pygame.scrap, "get_text", lambda: held[0])
    return held


def drag(hand: Hand, start: tuple[float, float], end: tuple[float, float], button: int) -> None:
    hand.point(*start)
    hand.press(button)
    hand.point((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    hand.point(*end)
    hand.release(button)


def shown(hand: Hand) -> object:
    return hand.app.scene


def place(hand: Hand, ball: str) -> tuple[float, float]:
    at = hand.play.session.layout[ball]
    return at.x, at.y


@pytest.mark.parametrize(("ball", "button"), [("cue", 1), ("cue", 3), ("1", 3)])
def test_a_ball_is_dragged_and_that_can_be_taken_back(two: Hand, ball: str, button: int) -> None:
    held = two.play.session.layout[ball]
    drag(two, (held.x, held.y), (1.0, 1.0), button)
    assert place(two, ball) == pytest.approx((1.0, 1.0), abs=0.003)
    assert two.play.session.strokes == 0
    two.key(pygame.K_u)
    assert two.play.session.layout[ball] == held


def test_the_aim_does_not_move_while_a_ball_is_dragged(two: Hand) -> None:
    two.point(ONE.x, ONE.y)
    aim = two.play.hands.aim
    two.press(3)
    two.point(1.0, 1.0)
    two.point(2.0, 0.2)
    two.release(3)
    assert two.play.hands.aim == aim


def test_with_the_left_button_on_an_object_ball_one_strikes(two: Hand) -> None:
    two.point(ONE.x, ONE.y)
    two.press()
    two.pull(150)
    two.release()
    assert two.play.session.strokes == 1


def test_a_ball_dropped_where_it_has_no_room_is_back(two: Hand) -> None:
    for spot in ((CUE.x + 0.02, CUE.y), (-0.1, 0.5)):
        drag(two, (ONE.x, ONE.y), spot, 3)
        assert place(two, "1") == (ONE.x, ONE.y)
        assert "no room" in two.play.message


def test_escape_puts_a_dragged_ball_back(two: Hand) -> None:
    two.point(ONE.x, ONE.y)
    two.press(3)
    two.point(1.0, 1.0)
    assert two.play.in_hand.ball == "1"
    two.key(pygame.K_ESCAPE)
    two.release(3)
    assert place(two, "1") == (ONE.x, ONE.y)
    assert two.play.in_hand.ball == ""


def test_losing_the_window_puts_a_dragged_ball_back(two: Hand) -> None:
    two.point(ONE.x, ONE.y)
    two.press(3)
    two.point(1.0, 1.0)
    two.post(pygame.WINDOWFOCUSLOST)
    two.release(3)
    assert place(two, "1") == (ONE.x, ONE.y)
    assert set(two.play.session.layout) == {"cue", "1"}


def test_a_right_click_takes_a_ball_off_and_adds_one(two: Hand) -> None:
    two.point(ONE.x, ONE.y)
    two.press(3)
    two.release(3)
    assert "1" not in two.play.session.layout
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
    assert "1" not in two.play.session.layout


def test_everything_by_keyboard_alone(hand: Hand) -> None:
    hand.set_balls(CUE, ONE)
    hand.key(pygame.K_x)
    hand.key(pygame.K_x)
    assert hand.play.in_hand.ball == "1"
    hand.key(pygame.K_RIGHT)
    hand.key(pygame.K_UP, pygame.KMOD_SHIFT)
    hand.key(pygame.K_DOWN, CTRL)
    assert place(hand, "1") == (ONE.x, ONE.y), "not yet put down"
    hand.key(pygame.K_RETURN)
    assert place(hand, "1") == pytest.approx((ONE.x + 0.01, ONE.y + 0.002 - 0.2))
    hand.key(pygame.K_INSERT)
    hand.key(pygame.K_INSERT)
    assert hand.play.in_hand.ball == "3"
    hand.key(pygame.K_SPACE)
    assert set(hand.play.session.layout) == {"cue", "1", "3"}
    hand.key(pygame.K_DELETE)
    assert "pick a ball up" in hand.play.message
    for _ in range(3):
        hand.key(pygame.K_x)
    hand.key(pygame.K_DELETE)
    assert set(hand.play.session.layout) == {"cue", "1"}
    hand.key(pygame.K_u)
    assert set(hand.play.session.layout) == {"cue", "1", "3"}


def test_a_ball_picked_up_by_key_waits_for_the_pointer_to_move(two: Hand) -> None:
    two.key(pygame.K_x)
    two.move((two.at[0] + 2, two.at[1]))
    assert two.play.in_hand.at is None
    two.point(1.8, 0.9)
    assert two.play.in_hand.at == pytest.approx((1.8, 0.9), abs=0.003)
    two.key(pygame.K_ESCAPE)
    assert place(two, "cue") == (CUE.x, CUE.y)


def test_the_cue_ball_taken_off_is_in_hand(two: Hand) -> None:
    two.key(pygame.K_x)
    two.key(pygame.K_DELETE)
    assert two.play.session.in_hand
    two.point(0.4, 0.4)
    two.press()
    two.release()
    assert place(two, "cue") == pytest.approx((0.4, 0.4), abs=0.003)


def test_a_full_table_has_no_ball_to_add(hand: Hand) -> None:
    hand.key(pygame.K_c)
    assert hand.play.in_hand.ball == ""
    assert "All balls" in hand.play.message


def test_in_a_match_only_the_cue_ball_in_hand_moves_and_only_where_it_may(hand: Hand) -> None:
    table = load_table("pool-9ft")
    hand.play.session = session = Session(Match(table, Setup("eight-ball", seed=1)))
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
        assert "Only in practice" in hand.play.message
        assert session.layout == session.match.layout


def test_copy_and_paste_give_the_same_position_and_aim(two: Hand, copied: list[str]) -> None:
    for key in (pygame.K_UP, pygame.K_d, pygame.K_e):
        two.key(key)
    aim = two.play.hands.aim
    two.key(pygame.K_c, CTRL)
    told = read(copied[0])
    assert (told.layout, told.table, told.shot) == (two.play.session.layout, "pool-9ft", aim.shot("cue"))
    two.key(pygame.K_n)
    two.key(pygame.K_BACKSPACE)
    two.key(pygame.K_v, CTRL)
    assert two.play.session.layout == Layout([CUE, ONE])
    assert two.play.hands.aim == aim


def test_a_position_on_another_table_goes_over_to_it(two: Hand, copied: list[str]) -> None:
    copied[0] = "snooker-12ft cue@0.7,0.7 red1@2,0.9 cue:30,2"
    two.key(pygame.K_v, CTRL)
    session = two.play.session
    assert session.table.source == "snooker-12ft"
    assert set(session.layout) == {"cue", "red1"}
    assert two.play.hands.aim.angle == 30.0


def test_a_position_without_a_table_stays_on_this_one(two: Hand, copied: list[str]) -> None:
    table = two.play.session.table
    copied[0] = "cue@0.7,0.7 9@2,0.9"
    two.key(pygame.K_v, CTRL)
    assert two.play.session.table is table
    assert set(two.play.session.layout) == {"cue", "9"}
    copied[0] = "cue:45,2.5"
    two.key(pygame.K_v, CTRL)
    assert set(two.play.session.layout) == {"cue", "9"}
    assert (two.play.hands.aim.angle, two.play.hands.aim.speed) == (45.0, 2.5)


@pytest.mark.parametrize(
    "text", ["hello world", "no-such-table cue@1,1", "cue@9,9", "cue@1,0.6 1@1,0.6", "snooker-12ft cue@9,9", " "]
)
def test_a_wrong_position_is_told_and_nothing_is_lost(two: Hand, copied: list[str], text: str) -> None:
    session, layout, aim = two.play.session, two.play.session.layout, two.play.hands.aim
    copied[0] = text
    two.key(pygame.K_v, CTRL)
    assert two.play.session is session and session.layout is layout and two.play.hands.aim == aim
    assert two.play.message not in ("", "The position is set up.")


def test_without_a_clipboard_that_is_told(two: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pygame, "scrap", None)
    for key in (pygame.K_c, pygame.K_v):
        two.play.tell("")
        two.key(key, CTRL)
        assert "no clipboard" in two.play.message


def test_the_same_shot_again_from_the_same_balls(two: Hand) -> None:
    two.key(pygame.K_F5)
    assert "no shot" in two.play.message
    two.key(pygame.K_d)
    before, aim = two.play.session.layout, two.play.hands.aim
    two.key(pygame.K_SPACE)
    rollout = two.play.session.rollout
    two.key(pygame.K_SPACE)
    two.point(2.0, 1.0)
    two.key(pygame.K_BACKSPACE)
    two.key(pygame.K_F5)
    two.app.step(0.5)
    assert two.play.session.layout == before
    assert two.play.hands.aim == aim
    two.key(pygame.K_SPACE)
    again = two.play.session.rollout
    assert rollout is not None and again is not None
    assert again.digest() == rollout.digest()


@pytest.mark.parametrize(("key", "x", "y"), [(pygame.K_F6, ONE.x, 1.27 - ONE.y), (pygame.K_F7, 2.54 - ONE.x, ONE.y)])
def test_mirrored_twice_it_is_as_before(two: Hand, key: int, x: float, y: float) -> None:
    layout, aim = two.play.session.layout, two.play.hands.aim
    two.key(key)
    assert place(two, "1") == pytest.approx((x, y), abs=1e-6)
    assert two.play.hands.aim.angle != aim.angle
    two.key(key)
    assert place(two, "1") == pytest.approx((ONE.x, ONE.y), abs=1e-6)
    assert two.play.hands.aim.angle == pytest.approx(aim.angle)
    assert set(two.play.session.layout) == set(layout)


def test_a_position_is_kept_by_name_opened_and_deleted(
    two: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))
    aim = two.play.hands.aim
    two.key(pygame.K_s, CTRL)
    assert isinstance(shown(two), Ask)
    two.key(pygame.K_RETURN)
    assert shown(two) is two.play
    assert shelf.positions() == ["Position 1"]
    two.key(pygame.K_n)
    two.key(pygame.K_o, CTRL)
    assert isinstance(shown(two), PositionShelf)
    two.key(pygame.K_RETURN)
    assert shown(two) is two.play
    assert two.play.session.layout == Layout([CUE, ONE])
    assert two.play.hands.aim == aim
    two.key(pygame.K_o, CTRL)
    two.key(pygame.K_DELETE)
    assert shelf.positions() == ["Position 1"], "asked for once"
    two.key(pygame.K_DELETE)
    assert shelf.positions() == []
    two.key(pygame.K_ESCAPE)
    assert shown(two) is two.play


def test_a_name_that_is_taken_is_asked_for_twice(two: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))
    shelf.save("mine", two.play.session.table, Layout([CUE]))
    two.key(pygame.K_s, CTRL)
    asked = two.app.scene
    assert isinstance(asked, Ask)
    two.post(pygame.TEXTINPUT, text="mine")
    two.key(pygame.K_RETURN)
    assert two.app.scene is asked and asked.wrong
    assert set(shelf.load("mine").layout) == {"cue"}
    two.key(pygame.K_RETURN)
    assert set(shelf.load("mine").layout) == {"cue", "1"}


def test_a_damaged_position_is_told_in_the_list(two: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))
    path = shelf.save("mine", two.play.session.table, Layout([CUE]))
    path.write_text('position = "nothing here"')
    two.key(pygame.K_o, CTRL)
    listed = two.app.scene
    assert isinstance(listed, PositionShelf)
    two.key(pygame.K_RETURN)
    assert two.app.scene is listed and "mine" in listed.wrong
    assert set(two.play.session.layout) == {"cue", "1"}


def test_balls_that_fell_come_back_when_they_are_added(hand: Hand) -> None:
    hand.set_balls(CUE, ONE._replace(phase=POCKETED))
    hand.key(pygame.K_c)
    hand.key(pygame.K_SPACE)
    assert hand.play.session.layout["1"].phase != POCKETED
