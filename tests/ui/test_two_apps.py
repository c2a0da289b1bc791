"""Two apps in one process: what each says and which keys it goes by is its own."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pygame
import pytest

from pool2d import load_table
from pool2d.config.settings import Store
from pool2d.draw import text
from pool2d.ui.app import App
from pool2d.ui.dialogs.help import Help
from pool2d.ui.window import open_window

from .conftest import FRAME, Hand

SIZE = (960, 540)
GERMAN = '[screen]\nlanguage = "de"\n[aiming]\nspeed_unit = "km/h"\n[keys]\nhelp = ["h"]\n'


@pytest.fixture(autouse=True)
def window() -> Iterator[None]:
    """What the system shows: apps that draw elsewhere take their events from it all the same."""
    open_window(SIZE)
    yield
    pygame.display.quit()


def english(folder: Path) -> Hand:
    return opened(folder, "")


def german(folder: Path) -> Hand:
    """A window in German, where H shows the help."""
    return opened(folder, GERMAN)


def opened(folder: Path, settings: str) -> Hand:
    path = folder / f"settings-{len(settings)}.toml"
    path.write_text(settings, encoding="utf-8")
    store = Store(path)
    app = App(load_table("pool-9ft"), seed=3, size=SIZE, store=store, surface=pygame.Surface(SIZE))
    assert store.complaints == []
    pygame.event.clear()
    return Hand(app)


def seen(hand: Hand) -> bytes:
    """What is on the window, drawn anew."""
    hand.app.redraw()
    hand.app.step(0.0)
    return pygame.image.tobytes(hand.app.window.surface, "RGB")


def settle(hand: Hand) -> None:
    """Wait until the table is drawn in full."""
    while not hand.play.stage.still:
        hand.app.redraw()
        hand.app.step(FRAME)


def test_each_draws_its_own_words(tmp_path: Path) -> None:
    alone = []
    for make in (german, english):
        one = make(tmp_path)
        settle(one)
        alone.append(seen(one))
        one.app.close()
    assert alone[0] != alone[1]
    pair = [german(tmp_path), english(tmp_path)]
    for hand in pair:
        settle(hand)
    assert [seen(hand) for hand in pair] == alone
    assert [seen(hand) for hand in reversed(pair)] == alone[::-1]
    told = [hand.play.state.messages.text for hand in pair]
    assert "H zeigt alle Tasten" in told[0] and "F1" in told[1]
    assert [hand.app.words.speed(1.0) for hand in pair] == ["3,6 km/h", "1.00 m/s"]


def test_each_goes_by_its_own_keys(tmp_path: Path) -> None:
    theirs, ours = german(tmp_path), english(tmp_path)
    for hand, own, other in ((theirs, pygame.K_h, pygame.K_F1), (ours, pygame.K_F1, pygame.K_h)):
        hand.key(other)
        assert hand.app.scene is hand.play
        hand.post(pygame.KEYDOWN, key=own, mod=0, unicode="")
        assert isinstance(hand.app.scene, Help)


def test_a_key_that_is_held_in_one_is_pressed_anew_in_the_other(tmp_path: Path) -> None:
    pair = german(tmp_path), english(tmp_path)
    for hand in pair:
        hand.post(pygame.KEYDOWN, key=pygame.K_v, mod=0, unicode="v")
    assert [hand.play.state.show.vectors for hand in pair] == [True, True]


@pytest.mark.parametrize("closed", [0, 1])
def test_one_that_is_closed_leaves_the_other_as_it_was(tmp_path: Path, closed: int) -> None:
    pair = [german(tmp_path), english(tmp_path)]
    left = pair[1 - closed]
    settle(left)
    before = seen(left)
    pair[closed].app.store.turn("screen.language", ("en", "de")[closed])
    pair[closed].app.close()
    assert seen(left) == before
    left.post(pygame.KEYDOWN, key=(pygame.K_F1, pygame.K_h)[closed], mod=0, unicode="")
    assert isinstance(left.app.scene, Help)


def test_each_tells_once_of_a_font_that_cannot_be_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(text, "unreadable", {Path("lost.ttf")})
    for hand in (german(tmp_path), english(tmp_path)):
        hand.app.step(FRAME)
        assert [note.words.count("lost.ttf") for note in hand.app.toasts.notes] == [1]
        hand.app.toasts.notes.clear()
        hand.app.step(FRAME)
        assert hand.app.toasts.notes == []
