"""The options page by mouse and keyboard: settings apply at once and are kept, and keys are bound anew."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pygame
import pytest

from pool2d import load_table
from pool2d.config.settings import Store
from pool2d.draw import guide, text, theme
from pool2d.game.drills.drill_file import load
from pool2d.ui.app import App
from pool2d.ui.dialogs.help import keys
from pool2d.ui.dialogs.options import PAGES, KeyRow, OptionsPage
from pool2d.ui.play.play import Play
from pool2d.ui.widgets.ball_row import BallRow
from pool2d.ui.widgets.inputs import Selector, Slider
from pool2d.ui.widgets.widget import Button, Tabs, Toggle, Widget
from pool2d.ui.wording.keys import DEFAULTS

from ..conftest import Hand


@pytest.fixture
def store(tmp_path: Path) -> Store:
    return Store(tmp_path / "settings.toml")


@pytest.fixture
def mine(store: Store) -> Iterator[Hand]:
    """A hand at a window whose settings are kept."""
    app = App(load_table("pool-9ft"), seed=3, store=store)
    pygame.event.clear()
    yield Hand(app)
    app.close()


def options(hand: Hand, page: str = PAGES[0]) -> OptionsPage:
    """Open the options by key, at a page."""
    if not isinstance(hand.app.scene, OptionsPage):
        hand.key(pygame.K_o)
    scene = hand.app.scene
    assert isinstance(scene, OptionsPage)
    for _ in range(PAGES.index(page)):
        hand.key(pygame.K_RIGHT)
    assert scene.page == page
    return scene


def widget(scene: OptionsPage, kind: type[Widget], label: str) -> Widget:
    return next(w for w in scene.form.widgets if isinstance(w, kind) and getattr(w, "label", label) == label)


def click(hand: Hand, pos: tuple[float, float]) -> None:
    hand.move(pos)
    hand.press()
    hand.release()


def row(scene: OptionsPage, action: str) -> KeyRow:
    return next(w for w in scene.form.widgets if isinstance(w, KeyRow) and w.action == action)


def test_a_key_opens_the_options_and_esc_closes_them(mine: Hand) -> None:
    options(mine)
    mine.key(pygame.K_ESCAPE)
    assert isinstance(mine.app.scene, Play)


def test_opening_them_puts_the_cue_down(mine: Hand) -> None:
    mine.point(1.2, 0.7)
    mine.press()
    mine.pull(60)
    assert mine.play.state.hands.busy
    options(mine)
    mine.release()
    mine.key(pygame.K_ESCAPE)
    assert not mine.play.state.hands.busy
    assert mine.play.state.rollout is None


def test_a_slider_is_dragged_and_the_file_holds_it(mine: Hand, store: Store) -> None:
    scene = options(mine, "sound")
    slider = widget(scene, Slider, "Volume")
    mine.move((slider.rect.centerx, slider.rect.bottom - 10))
    mine.press()
    mine.move((slider.rect.left, slider.rect.bottom - 10))
    mine.release()
    assert store.values.sound.volume == 0.0
    mine.app.step(2.0)
    assert store.path is not None
    assert Store(store.path).values.sound.volume == 0.0


def test_everything_on_the_screen_page_by_keyboard(mine: Hand, store: Store) -> None:
    scene = options(mine, "screen")
    mine.key(pygame.K_TAB)
    mine.key(pygame.K_TAB)
    assert scene.form.focus is widget(scene, Toggle, "Reduced motion")
    mine.key(pygame.K_SPACE)
    assert store.values.screen.reduced_motion
    assert mine.app.toasts.still
    mine.key(pygame.K_TAB)
    mine.key(pygame.K_RETURN)
    assert store.values.screen.full
    assert mine.app.window.surface.get_flags() & pygame.FULLSCREEN
    mine.key(pygame.K_RETURN)
    assert not mine.app.window.surface.get_flags() & pygame.FULLSCREEN


def test_the_guide_is_the_same_setting_in_play_and_here(mine: Hand, store: Store) -> None:
    mine.key(pygame.K_g)
    assert store.values.aiming.guide == "whole shot"
    scene = options(mine)
    box = widget(scene, Selector, "Guide").rect
    click(mine, (box.right - 5, box.centery))
    assert store.values.aiming.guide == "off"
    assert mine.play.state.show.level == guide.NONE


def test_another_language_is_spoken_at_once(mine: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    said: list[str] = []
    real = text.draw

    def spy(surface: pygame.Surface, line: str, *rest: object) -> pygame.Rect:
        said.append(line)
        return real(surface, line, *rest)  # type: ignore[arg-type]

    scene = options(mine, "screen")
    choice = widget(scene, Selector, "Language")
    assert isinstance(choice, Selector)
    monkeypatch.setattr(text, "draw", spy)
    while mine.app.store.values.screen.language != "de":
        choice.turn(1)
    mine.app.step(0.0)
    assert {"Einstellungen", "Sprache", "Deutsch", "Schließen"} <= set(said)


def test_the_window_opens_in_the_language_and_at_the_guide_set_before(store: Store) -> None:
    store.turn("screen.language", "de")
    store.turn("aiming.guide", "line")
    app = App(load_table("pool-9ft"), seed=3, store=store)
    assert app.words.say("form.cancel") == "Abbrechen"
    assert app.play.state.show.level == guide.LINE
    app.close()


def test_reset_and_close_by_mouse(mine: Hand, store: Store) -> None:
    store.turn("sound.volume", 0.1)
    store.turn("aiming.guide", "line")
    scene = options(mine, "sound")
    click(mine, widget(scene, Button, "Reset this page").rect.center)
    assert store.values.sound.volume == 0.8
    assert store.values.aiming.guide == "line"
    click(mine, widget(scene, Button, "Close").rect.center)
    assert isinstance(mine.app.scene, Play)


def test_what_is_reset_is_told_in_the_language_that_it_was_reset_to(
    mine: Hand, store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("LC_ALL", "en_GB.UTF-8")
    store.turn("screen.language", "de")
    scene = options(mine, "screen")
    click(mine, widget(scene, Button, "Seite zurücksetzen").rect.center)
    assert store.values.screen.language == "auto"
    assert {"Reset this page", "Close"} <= {w.label for w in scene.form.widgets if isinstance(w, Button)}


def test_pages_by_mouse(mine: Hand) -> None:
    scene = options(mine)
    tabs = next(w for w in scene.form.widgets if isinstance(w, Tabs))
    click(mine, (tabs.rect.right - 10, tabs.rect.centery))
    assert scene.page == "keys"


def test_a_key_is_bound_anew_and_the_help_shows_it(mine: Hand, store: Store) -> None:
    scene = options(mine, "keys")
    click(mine, row(scene, "guide").rect.center)
    assert "press a key" in row(scene, "guide").message
    mine.key(pygame.K_F10)
    assert mine.app.words.keys.action_of(pygame.K_F10, 0) == "guide"
    assert mine.app.words.keys.action_of(pygame.K_g, 0) is None
    mine.key(pygame.K_ESCAPE)
    assert isinstance(mine.app.scene, Play)
    level = mine.play.state.show.level
    mine.key(pygame.K_F10)
    assert mine.play.state.show.level != level
    assert ("F10", mine.app.words.say("help.guide")) in keys(mine.app.words)
    store.save()
    assert store.path is not None
    assert Store(store.path).keys == {"guide": ("f10",)}


def test_a_row_that_waits_for_a_key_looks_pressed(mine: Hand) -> None:
    one = KeyRow(mine.app.words, "guide", lambda: None)
    one.rect = pygame.Rect(0, 0, 400, 40)

    def ground() -> tuple[int, ...]:
        surface = pygame.Surface(one.rect.size)
        one.draw(surface, 8, False, False)
        return tuple(surface.get_at((one.rect.right - 10, one.rect.centery)))[:3]

    assert ground() == theme.FACE
    one.key(pygame.K_RETURN, 0)
    assert ground() == theme.FACE_DOWN
    one.key(pygame.K_ESCAPE, 0)
    one.held, one.pointer = True, one.rect.center
    assert ground() == theme.FACE_DOWN


def test_a_key_that_another_action_has_is_told_and_taken_on_the_second_press(mine: Hand) -> None:
    scene = options(mine, "keys")
    click(mine, row(scene, "guide").rect.center)
    mine.key(pygame.K_n)
    assert mine.app.words.keys.action_of(pygame.K_n, 0) == "rack"
    assert "New rack" in row(scene, "guide").message
    mine.key(pygame.K_n)
    assert mine.app.words.keys.action_of(pygame.K_n, 0) == "guide"
    assert mine.app.words.key("rack") == "no key"


def test_while_a_row_waits_it_gets_tab_and_esc_and_the_windows_keys(mine: Hand) -> None:
    scene = options(mine, "keys")
    click(mine, row(scene, "guide").rect.center)
    mine.key(pygame.K_F11)
    assert not mine.app.window.surface.get_flags() & pygame.FULLSCREEN
    assert "Full screen" in row(scene, "guide").message
    mine.key(pygame.K_TAB)
    assert "Fast-forward" in row(scene, "guide").message
    mine.key(pygame.K_LSHIFT)
    mine.key(pygame.K_ESCAPE)
    assert mine.app.scene is scene
    assert mine.app.words.keys.chords == DEFAULTS
    click(mine, row(scene, "guide").rect.center)
    click(mine, row(scene, "undo").rect.center)
    assert not row(scene, "guide").greedy and row(scene, "undo").greedy


def test_delete_sets_a_key_back_and_reset_all_of_them(mine: Hand, store: Store) -> None:
    scene = options(mine, "keys")
    for action, key in (("guide", pygame.K_h), ("replay", pygame.K_z)):
        click(mine, row(scene, action).rect.center)
        mine.key(key)
    click(mine, row(scene, "guide").rect.center)
    mine.key(pygame.K_ESCAPE)
    mine.key(pygame.K_DELETE)
    assert mine.app.words.key("guide") == "G"
    assert set(store.keys) == {"replay"}
    scene._reset()
    assert mine.app.words.keys.chords == DEFAULTS
    assert store.keys == {}


@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (1920, 1080), (3840, 2160), (480, 270), (320, 600)])
@pytest.mark.parametrize("language", ["en", "de"])
def test_every_page_stays_inside_the_window(size: tuple[int, int], language: str, store: Store) -> None:
    store.turn("screen.language", language)
    app = App(load_table("pool-9ft"), seed=3, size=size, store=store)
    hand = Hand(app)
    for page in PAGES:
        app.scene = app.play
        scene = options(hand, page)
        app.step(0.0)
        assert pygame.Rect(0, 0, *size).contains(scene.form.rect)
        if page != "keys":
            assert all(scene.form.rect.contains(w.rect) for w in scene.form.widgets)
    app.close()


def test_balls_are_shown_as_their_options_make_them(hand: Hand) -> None:
    options(hand, "balls")

    def row() -> bytes:
        hand.app.redraw()
        hand.app.step(0.0)
        scene = hand.app.scene
        assert isinstance(scene, OptionsPage)
        samples = next(widget for widget in scene.form.widgets if isinstance(widget, BallRow))
        return pygame.image.tobytes(hand.app.window.surface.subsurface(samples.rect), "RGB")

    seen = {row()}
    for name, value in (("balls.palette", "colour-blind"), ("balls.patterned", True)):
        hand.app.store.turn(name, value)
        seen.add(row())
    assert len(seen) == 3


def test_an_easy_stroke_is_one_that_the_option_makes_so_in_drills_too(mine: Hand, store: Store) -> None:
    mine.set_balls(*mine.play.state.session.layout.values())
    mine.strike()
    assert mine.play.state.session.shot is not None and not mine.play.state.session.shot.easy
    click(mine, widget(options(mine, "aiming"), Toggle, "Easy stroke").rect.center)
    assert store.values.aiming.easy_stroke
    mine.key(pygame.K_ESCAPE)
    mine.strike()
    assert mine.play.state.session.shot is not None and mine.play.state.session.shot.easy
    mine.app.play.drill(load("stop-shot"), mine.app.play)
    mine.key(pygame.K_o)
    mine.key(pygame.K_ESCAPE)
    mine.strike()
    assert mine.play.state.session.shot is not None and mine.play.state.session.shot.easy
