"""The line of text: cursor, selection, clipboard."""

from __future__ import annotations

import pygame
import pytest

from pool2d.draw import text
from pool2d.ui.dialogs.dialog import TextPrompt
from pool2d.ui.widgets import clipboard
from pool2d.ui.widgets.field import TextField

from ..conftest import Hand

SHIFT, CTRL = pygame.KMOD_SHIFT, pygame.KMOD_CTRL


def drawn(value: str, width: int = 300, limit: int = 40) -> TextField:
    made = TextField("Name", value, limit)
    made.rect = pygame.Rect(10, 10, width, 58)
    made.draw(pygame.Surface((400, 100)), 8, True, False)
    return made


def test_the_cursor_goes_by_letters_words_and_to_the_ends() -> None:
    made = drawn("tight and fast")
    made.key(pygame.K_HOME, 0)
    assert made.cursor == 0
    made.key(pygame.K_RIGHT, 0)
    made.key(pygame.K_RIGHT, CTRL)
    assert made.cursor == len("tight ")
    made.key(pygame.K_END, 0)
    made.key(pygame.K_LEFT, CTRL)
    assert made.cursor == len("tight and ")
    made.type("very ")
    assert made.value == "tight and very fast"


def test_typing_replaces_what_is_selected() -> None:
    made = drawn("one two")
    made.key(pygame.K_LEFT, SHIFT | CTRL)
    assert made.value[slice(*made.selected)] == "two"
    made.type("three")
    assert made.value == "one three"
    made.key(pygame.K_a, CTRL)
    made.type("x")
    assert made.value == "x"


def test_an_arrow_leaves_the_selection_on_its_own_side() -> None:
    made = drawn("abc")
    made.select_all()
    made.key(pygame.K_LEFT, 0)
    assert made.selected == (0, 0)
    made.select_all()
    made.key(pygame.K_RIGHT, 0)
    assert made.selected == (3, 3)


def test_deleting_takes_a_letter_a_word_or_the_selection() -> None:
    made = drawn("one two three")
    made.key(pygame.K_BACKSPACE, CTRL)
    assert made.value == "one two "
    made.key(pygame.K_HOME, 0)
    made.key(pygame.K_DELETE, 0)
    assert made.value == "ne two "
    made.key(pygame.K_END, SHIFT)
    made.key(pygame.K_BACKSPACE, 0)
    assert made.value == ""
    made.key(pygame.K_BACKSPACE, 0)
    made.key(pygame.K_DELETE, 0)
    assert made.value == ""


def test_a_selection_makes_room_for_what_replaces_it() -> None:
    made = drawn("abcde", limit=5)
    made.type("f")
    assert made.value == "abcde"
    made.select_all()
    made.type("vwxyz!")
    assert made.value == "vwxyz"


def test_copy_cut_and_paste(monkeypatch: pytest.MonkeyPatch) -> None:
    held = [""]
    monkeypatch.setattr(pygame.scrap, "put_text", lambda words: held.__setitem__(0, words))
    monkeypatch.setattr(pygame.scrap, "get_text", lambda: held[0])
    made = drawn("copy me")
    made.key(pygame.K_a, CTRL)
    made.key(pygame.K_c, CTRL)
    assert held == ["copy me"] and made.value == "copy me"
    made.key(pygame.K_x, CTRL)
    assert made.value == ""
    made.key(pygame.K_v, CTRL)
    made.key(pygame.K_v, CTRL)
    assert made.value == "copy mecopy me"


def test_without_a_clipboard_nothing_happens(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object) -> str:
        raise pygame.error("no clipboard")

    monkeypatch.setattr(pygame.scrap, "put_text", fail)
    monkeypatch.setattr(pygame.scrap, "get_text", fail)
    made = drawn("abc")
    made.select_all()
    made.key(pygame.K_x, CTRL)
    made.type("def")
    made.key(pygame.K_v, CTRL)
    assert made.value == "def"
    assert clipboard.get() is None
    assert not clipboard.put("abc")


def test_the_pointer_sets_the_cursor_and_drags_a_selection() -> None:
    made = drawn("abcdef")
    width = text.font(14).size
    made.press((18 + width("ab")[0], 50))
    assert made.selected == (2, 2)
    made.drag((18 + width("abcde")[0], 50))
    assert made.value[slice(*made.selected)] == "cde"
    made.drag((0, 50))
    assert made.selected == (0, 2)


def test_a_long_text_moves_to_keep_the_cursor_in_sight() -> None:
    made = drawn("w" * 40, width=120)
    assert made._shift > 0
    made.key(pygame.K_HOME, 0)
    made.draw(pygame.Surface((400, 100)), 8, True, False)
    assert made._shift == 0


def test_save_as_opens_with_its_text_selected_and_letters_are_only_letters(hand: Hand) -> None:
    hand.key(pygame.K_t)
    assert hand.play.controller.tuning_panel is not None
    hand.play.controller.tuning_panel.save()
    asked = hand.play.state.wish
    assert isinstance(asked, TextPrompt)
    hand.app.scene = asked
    assert asked.field.selected == (0, len("my-pool-9ft"))
    # F is full screen, and O the options, but not while one is typing.
    for key, letter in ((pygame.K_f, "f"), (pygame.K_o, "o")):
        hand.key(key)
        hand.post(pygame.TEXTINPUT, text=letter)
    assert asked.field.value == "fo"
    assert hand.app.scene is asked
    assert not hand.app.window.surface.get_flags() & pygame.FULLSCREEN
