"""Whole positions: mirrored, as text, by name, and the last one again."""

from __future__ import annotations

from pathlib import Path

import pygame
import pytest

from pool2d import Layout
from pool2d.game import saved_positions
from pool2d.table.position_text import read
from pool2d.ui.dialogs.dialog import TextPrompt
from pool2d.ui.dialogs.position_list import PositionList

from ..conftest import CUE, ONE, Hand

CTRL = pygame.KMOD_CTRL


@pytest.fixture
def copied(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The clipboard: what has been copied is its only item."""
    held = [""]
    monkeypatch.setattr(pygame.scrap, "put_text", lambda words: held.__setitem__(0, words))
    monkeypatch.setattr(pygame.scrap, "get_text", lambda: held[0])
    return held


def shown(hand: Hand) -> object:
    return hand.app.scene


def place(hand: Hand, ball: str) -> tuple[float, float]:
    at = hand.play.state.session.layout[ball]
    return at.x, at.y


def test_copy_and_paste_give_the_same_position_and_aim(two: Hand, copied: list[str]) -> None:
    for key in (pygame.K_UP, pygame.K_d, pygame.K_e):
        two.key(key)
    aim = two.play.state.hands.aim
    two.key(pygame.K_c, CTRL)
    told = read(copied[0])
    assert (told.layout, told.table, told.shot) == (two.play.state.session.layout, "pool-9ft", aim.shot("cue"))
    two.key(pygame.K_n)
    two.key(pygame.K_BACKSPACE)
    two.key(pygame.K_v, CTRL)
    assert two.play.state.messages.text == "The position is set up."
    assert two.play.state.session.layout == Layout([CUE, ONE])
    assert two.play.state.hands.aim == aim


def test_a_position_on_another_table_goes_over_to_it(two: Hand, copied: list[str]) -> None:
    copied[0] = "snooker-12ft cue@0.7,0.7 red1@2,0.9 cue:30,2"
    two.key(pygame.K_v, CTRL)
    session = two.play.state.session
    assert session.table.source == "snooker-12ft"
    assert set(session.layout) == {"cue", "red1"}
    assert two.play.state.hands.aim.angle == 30.0


def test_a_position_without_a_table_stays_on_this_one(two: Hand, copied: list[str]) -> None:
    table = two.play.state.session.table
    copied[0] = "cue@0.7,0.7 9@2,0.9"
    two.key(pygame.K_v, CTRL)
    assert two.play.state.session.table is table
    assert set(two.play.state.session.layout) == {"cue", "9"}
    copied[0] = "cue:45,2.5"
    two.key(pygame.K_v, CTRL)
    assert set(two.play.state.session.layout) == {"cue", "9"}
    assert (two.play.state.hands.aim.angle, two.play.state.hands.aim.speed) == (45.0, 2.5)


@pytest.mark.parametrize(
    "text", ["hello world", "no-such-table cue@1,1", "cue@9,9", "cue@1,0.6 1@1,0.6", "snooker-12ft cue@9,9", " "]
)
def test_a_wrong_position_is_told_and_nothing_is_lost(two: Hand, copied: list[str], text: str) -> None:
    session, layout, aim = two.play.state.session, two.play.state.session.layout, two.play.state.hands.aim
    copied[0] = text
    two.key(pygame.K_v, CTRL)
    assert two.play.state.session is session and session.layout is layout and two.play.state.hands.aim == aim
    assert two.play.state.messages.text not in ("", "The position is set up.")


def test_without_a_clipboard_that_is_told(two: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pygame, "scrap", None)
    for key in (pygame.K_c, pygame.K_v):
        two.play.state.messages.say("")
        two.key(key, CTRL)
        assert "no clipboard" in two.play.state.messages.text


def test_the_same_shot_again_from_the_same_balls(two: Hand) -> None:
    two.key(pygame.K_F5)
    assert "no shot" in two.play.state.messages.text
    two.key(pygame.K_d)
    before, aim = two.play.state.session.layout, two.play.state.hands.aim
    two.key(pygame.K_SPACE)
    rollout = two.play.state.session.rollout
    two.key(pygame.K_SPACE)
    two.point(2.0, 1.0)
    two.key(pygame.K_BACKSPACE)
    two.key(pygame.K_F5)
    two.app.step(0.5)
    assert two.play.state.session.layout == before
    assert two.play.state.hands.aim == aim
    two.key(pygame.K_SPACE)
    again = two.play.state.session.rollout
    assert rollout is not None and again is not None
    assert again.digest() == rollout.digest()


@pytest.mark.parametrize(("key", "x", "y"), [(pygame.K_F6, ONE.x, 1.27 - ONE.y), (pygame.K_F7, 2.54 - ONE.x, ONE.y)])
def test_mirrored_twice_it_is_as_before(two: Hand, key: int, x: float, y: float) -> None:
    layout, aim = two.play.state.session.layout, two.play.state.hands.aim
    two.key(key)
    assert place(two, "1") == pytest.approx((x, y), abs=1e-6)
    assert two.play.state.hands.aim.angle != aim.angle
    two.key(key)
    assert place(two, "1") == pytest.approx((ONE.x, ONE.y), abs=1e-6)
    assert two.play.state.hands.aim.angle == pytest.approx(aim.angle)
    assert set(two.play.state.session.layout) == set(layout)


def test_a_position_is_kept_by_name_opened_and_deleted(
    two: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))
    aim = two.play.state.hands.aim
    two.key(pygame.K_s, CTRL)
    assert isinstance(shown(two), TextPrompt)
    two.key(pygame.K_RETURN)
    assert shown(two) is two.play
    assert saved_positions.positions() == ["Position 1"]
    two.key(pygame.K_n)
    two.key(pygame.K_o, CTRL)
    assert isinstance(shown(two), PositionList)
    two.key(pygame.K_RETURN)
    assert shown(two) is two.play
    assert two.play.state.session.layout == Layout([CUE, ONE])
    assert two.play.state.hands.aim == aim
    two.key(pygame.K_o, CTRL)
    two.key(pygame.K_DELETE)
    assert saved_positions.positions() == ["Position 1"], "asked for once"
    two.key(pygame.K_DELETE)
    assert saved_positions.positions() == []
    two.key(pygame.K_ESCAPE)
    assert shown(two) is two.play


def test_a_name_that_is_taken_is_asked_for_twice(two: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))
    saved_positions.save("mine", two.play.state.session.table, Layout([CUE]))
    two.key(pygame.K_s, CTRL)
    asked = two.app.scene
    assert isinstance(asked, TextPrompt)
    two.post(pygame.TEXTINPUT, text="mine")
    two.key(pygame.K_RETURN)
    assert two.app.scene is asked and asked.wrong
    assert set(saved_positions.load("mine").layout) == {"cue"}
    two.key(pygame.K_RETURN)
    assert set(saved_positions.load("mine").layout) == {"cue", "1"}


def test_a_damaged_position_is_told_in_the_list(two: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))
    path = saved_positions.save("mine", two.play.state.session.table, Layout([CUE]))
    path.write_text('position = "nothing here"')
    two.key(pygame.K_o, CTRL)
    listed = two.app.scene
    assert isinstance(listed, PositionList)
    two.key(pygame.K_RETURN)
    assert two.app.scene is listed and "mine" in listed.wrong
    assert set(two.play.state.session.layout) == {"cue", "1"}
