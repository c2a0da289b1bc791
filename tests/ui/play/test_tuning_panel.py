"""The tuning panel, by mouse and by keyboard."""

from __future__ import annotations

from pathlib import Path

import pygame
import pytest

from pool2d import load_table
from pool2d.config.knobs import walk
from pool2d.ui.dialogs.dialog import TextPrompt
from pool2d.ui.play.tuning_panel import PAGES
from pool2d.ui.widgets.inputs import Selector, Slider
from pool2d.ui.widgets.widget import Button, Tabs

from ..conftest import Hand
from .tuned import opened, press, shot, widget


def test_every_knob_is_on_one_page() -> None:
    knobs = [name for name, _, _ in walk(load_table("pool-9ft").knobs)]
    assert knobs
    for name in knobs:
        assert sum(name.startswith(beginnings) for beginnings in PAGES.values()) == 1, name


def test_dragging_a_slider_changes_the_table_and_shows_the_last_shot_again(hand: Hand) -> None:
    shot(hand)
    played = hand.play.state.session.rollout
    after = hand.play.state.session.layout
    panel = opened(hand)
    tuning = panel.tuning
    assert tuning.old is not None and played is not None
    assert tuning.old.digest() == played.digest()
    slider = widget(panel, "Rolling resistance")
    assert isinstance(slider, Slider)
    track = slider._track()
    hand.move((track.left, track.centery))
    hand.press()
    hand.move((track.left + track.width * 3 // 4, track.centery + 40))
    hand.release()
    knobs = hand.play.state.session.table.knobs
    assert knobs.cloth.mu_roll == slider.value(0.75)
    assert tuning.new is not None
    assert tuning.new.digest() != tuning.old.digest()
    assert tuning.new.start == tuning.old.start
    assert hand.play.state.session.layout == after, "looking at the shot again does not move the balls"


def test_the_panel_by_keyboard_alone(hand: Hand) -> None:
    panel = opened(hand)
    hand.key(pygame.K_RIGHT)
    assert panel.page == "balls"
    assert isinstance(panel.form.focus, Tabs)
    hand.key(pygame.K_LEFT)
    hand.key(pygame.K_TAB)
    hand.key(pygame.K_LEFT, pygame.KMOD_CTRL)
    assert list(hand.play.state.session.table.set) == ["gravity"]
    hand.key(pygame.K_DELETE)
    assert not hand.play.state.session.table.set
    hand.key(pygame.K_t)
    assert hand.play.controller.tuning is None


def test_escape_closes_the_panel(hand: Hand) -> None:
    opened(hand)
    hand.key(pygame.K_ESCAPE)
    assert hand.play.controller.tuning is None


@pytest.mark.parametrize("page", PAGES)
def test_every_widget_of_every_page_does_something(hand: Hand, page: str) -> None:
    panel = opened(hand)
    tuning = panel.tuning
    panel._open(page)
    hand.app.step(0.0)
    knobs = [one for one in panel.form.widgets if isinstance(one, Slider | Selector) and one.label != "Compare with"]
    assert knobs
    for one in knobs:
        before = hand.play.state.session.table
        if isinstance(one, Slider):
            one.put(one.value(one.part(one.get()) + (0.02 if one.part(one.get()) < 0.9 else -0.02)))
        else:
            one.turn(1)
        assert hand.play.state.session.table is not before or tuning.error, one.label
        tuning.reset()


def test_a_law_is_chosen_by_name(hand: Hand) -> None:
    panel = opened(hand)
    panel._open("balls")
    choice = widget(panel, "Law")
    assert isinstance(choice, Selector)
    before = choice.get()
    choice.turn(1)
    assert hand.play.state.session.table.knobs.ball.law != before


def test_reset_all(hand: Hand) -> None:
    panel = opened(hand)
    tuning = panel.tuning
    tuning.turn("cloth.mu_roll", 0.02)
    tuning.turn("ball.restitution", 0.9)
    hand.app.step(0.0)
    press(hand, widget(panel, "Reset all").rect.center)
    assert not hand.play.state.session.table.set


def test_a_click_on_a_page_leaves_the_aim_alone(hand: Hand) -> None:
    panel = opened(hand)
    hand.app.step(0.0)
    tabs = next(one for one in panel.form.widgets if isinstance(one, Tabs))
    hand.move((tabs.rect.right - 8, tabs.rect.centery))
    angle = hand.play.state.hands.aim.angle
    hand.press()
    hand.release()
    assert panel.page == list(PAGES)[-1]
    assert hand.play.state.hands.aim.angle == angle


def test_a_table_has_to_be_chosen_before_playing_on_it(hand: Hand) -> None:
    panel = opened(hand)
    tuning = panel.tuning
    panel.chosen = "nowhere"
    before = hand.play.state.session
    panel.go()
    assert hand.play.state.session is before
    assert "Choose" in tuning.error


def test_going_over_to_another_table(hand: Hand) -> None:
    panel = opened(hand)
    panel._open("table")
    hand.app.step(0.0)
    panel.chosen = "snooker-12ft"
    press(hand, widget(panel, "Play on this table").rect.center)
    assert hand.play.state.session.table.source == "snooker-12ft"
    assert hand.play.controller.tuning is None
    hand.point(2.0, 0.9)
    hand.key(pygame.K_SPACE)
    assert hand.play.state.session.strokes == 1


def test_aiming_goes_on_beside_the_panel(hand: Hand) -> None:
    opened(hand)
    hand.app.step(0.0)
    hand.point(1.2, 1.0)
    aim = hand.play.state.hands.aim.angle
    hand.point(1.2, 0.3)
    assert hand.play.state.hands.aim.angle != aim
    hand.press()
    hand.pull(150)
    hand.release()
    assert hand.play.state.session.strokes == 1


def test_the_table_makes_room_for_the_panel(hand: Hand) -> None:
    panel = opened(hand)
    hand.app.step(0.0)
    right, _ = hand.play.stage.view.to_screen(2.54, 0.0)
    assert right < panel.form.rect.left


def test_saving_as_a_preset_of_ones_own(hand: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))
    panel = opened(hand)
    tuning = panel.tuning
    tuning.condition("dirty-balls")
    tuning.turn("cloth.mu_roll", 0.02)
    hand.app.step(0.0)
    button = widget(panel, "Save as")
    assert isinstance(button, Button)
    press(hand, button.rect.center)
    ask = hand.app.scene
    assert isinstance(ask, TextPrompt)
    for words, wrong in (("pool-9ft", True), ("a/b", True), ("", True), ("mine", False)):
        ask.field.value = words
        hand.key(pygame.K_RETURN)
        assert (hand.app.scene is ask) is wrong, words
        assert bool(ask.wrong) is wrong
    assert load_table("mine").knobs == hand.play.state.session.table.knobs
    assert "mine" in hand.play.state.messages.text


def test_leaving_the_question_saves_nothing(hand: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))
    panel = opened(hand)
    press(hand, widget(panel, "Save as").rect.center)
    hand.key(pygame.K_ESCAPE)
    assert not isinstance(hand.app.scene, TextPrompt)
    assert not list(tmp_path.rglob("*.toml"))


def test_the_panel_and_the_message_follow_the_language_and_the_keys(hand: Hand) -> None:
    panel = opened(hand)
    panel.form.focus = widget(panel, "Rolling resistance")
    hand.app.store.turn("screen.language", "de")
    assert panel.form.focus is widget(panel, "Rollwiderstand")
    assert "kein Regler" in panel._summary()
    assert hand.play.state.messages.text.startswith("Mit der Maus zielen")
    hand.app.words.keys.bind("help", pygame.K_h)
    assert "H zeigt alle Tasten" in hand.play.state.messages.text


def test_saving_leaves_no_error_that_is_over(hand: Hand) -> None:
    panel = opened(hand)
    tuning = panel.tuning
    tuning.turn("table.length", 1.0)
    assert tuning.error
    save = next(one for one in panel.form.widgets if getattr(one, "label", "").startswith("Save"))
    assert isinstance(save, Button)
    save.do()
    assert tuning.error == ""
