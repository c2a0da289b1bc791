"""Notes: they come, stay as long as one reads them, and go."""

from __future__ import annotations

from pathlib import Path

import pygame
import pytest

from pool2d import load_table
from pool2d.config.settings import Store
from pool2d.draw import text
from pool2d.ui.app import App
from pool2d.ui.toasts import Toasts

from .conftest import Hand


def bounds(toasts: Toasts, size: tuple[int, int] = (1280, 720)) -> pygame.Rect:
    """What the notes cover."""
    surface = pygame.Surface(size, pygame.SRCALPHA)
    toasts.draw(surface)
    return surface.get_bounding_rect()


def test_a_note_slides_in_stays_and_slides_out() -> None:
    toasts = Toasts()
    toasts.say("A picture was saved")
    assert bounds(toasts).width == 0
    toasts.update(0.09)
    half = bounds(toasts)
    toasts.update(1.0)
    whole = bounds(toasts)
    assert 0 < half.width < whole.width
    assert half.left > whole.left
    toasts.update(10.0)
    assert toasts.notes == []
    assert bounds(toasts).width == 0


def test_with_reduced_motion_it_is_there_at_once() -> None:
    toasts = Toasts()
    toasts.still = True
    toasts.say("A picture was saved")
    here = bounds(toasts)
    toasts.update(1.0)
    assert here == bounds(toasts)


def test_a_longer_note_stays_longer() -> None:
    toasts = Toasts()
    toasts.say("Short")
    toasts.say("A note that takes so long to read that it would be a pity if it went as fast as the other one does")
    toasts.update(4.0)
    assert [note.words[:6] for note in toasts.notes] == ["A note"]


def test_the_same_note_twice_is_one_that_stays_longer() -> None:
    toasts = Toasts()
    toasts.say("Saved")
    toasts.update(2.0)
    toasts.say("Saved")
    toasts.update(2.0)
    assert len(toasts.notes) == 1


def test_notes_stack_and_the_rest_wait() -> None:
    toasts = Toasts()
    for i in range(6):
        toasts.say(f"Note {i}")
    toasts.update(1.0)
    four = bounds(toasts)
    assert [note.age > 0.0 for note in toasts.notes] == [True] * 4 + [False] * 2
    toasts.update(3.0)
    assert [note.words for note in toasts.notes] == ["Note 4", "Note 5"]
    toasts.update(1.0)
    assert 0 < bounds(toasts).height < four.height


@pytest.mark.parametrize("size", [(640, 360), (960, 540), (1920, 1080), (3840, 2160)])
def test_a_long_path_is_wrapped_into_the_window(size: tuple[int, int]) -> None:
    toasts = Toasts()
    toasts.say("Saved /home/somebody/" + "a-folder-with-a-long-name/" * 8 + "picture.png", wrong=True)
    toasts.update(1.0)
    unit = size[1] // 90
    box = bounds(toasts, size)
    assert 4 * unit < box.left and box.right <= size[0] - unit + 1


def test_the_app_shows_notes_over_any_scene(hand: Hand) -> None:
    hand.key(pygame.K_F1)
    before = pygame.image.tobytes(hand.app.window.surface, "RGB")
    hand.app.toast("Hello")
    hand.app.step(0.5)
    assert pygame.image.tobytes(hand.app.window.surface, "RGB") != before


def test_a_damaged_settings_file_is_told_once(tmp_path: Path) -> None:
    path = tmp_path / "settings.toml"
    path.write_text('[sound]\nvolume = 7\n[keys]\nguide = ["nokey"]\n')
    for expected in (2, 0):
        app = App(load_table("pool-9ft"), seed=3, store=Store(path))
        app.step(0.0)
        told = [note.words for note in app.toasts.notes]
        assert len(told) == expected
        if told:
            assert "sound.volume = 7" in told[0] and "from 0 to 1" in told[0] and str(path) in told[0]
            assert "keys.guide = ['nokey']" in told[1]
        app.close()
    assert path.with_name("settings.toml.bad").read_text().startswith("[sound]\nvolume = 7")


def test_keys_that_are_wrong_alone_are_put_aside_too(tmp_path: Path) -> None:
    path = tmp_path / "settings.toml"
    path.write_text('[keys]\nguide = ["nokey"]\n')
    for expected in (1, 0):
        app = App(load_table("pool-9ft"), seed=3, store=Store(path))
        assert len(app.toasts.notes) == expected
        app.close()
    assert "nokey" in path.with_name("settings.toml.bad").read_text()


def test_a_font_that_cannot_be_read_is_told_once(hand: Hand, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    broken = tmp_path / "none.ttf"
    broken.write_bytes(b"not a font")
    monkeypatch.setattr(text, "asset", lambda *_: broken)
    text.font.cache_clear()
    text.picture.cache_clear()
    hand.app.step(0.0)
    hand.app.window.surface = pygame.display.set_mode((960, 540))
    hand.app.step(0.0)
    hand.app.step(0.0)
    assert [str(broken) in note.words for note in hand.app.toasts.notes] == [True]
    text.font.cache_clear()
    text.picture.cache_clear()
