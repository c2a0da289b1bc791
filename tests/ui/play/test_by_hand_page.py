"""Measurements made by hand, typed into the tuning panel."""

from __future__ import annotations

from pathlib import Path

import pygame
import pytest

from pool2d import load_table
from pool2d.draw import text
from pool2d.ui.play.by_hand_page import ROWS
from pool2d.ui.play.tuning_panel import TuningPanel
from pool2d.ui.wording.words import languages

from ..conftest import Hand
from .tuned import opened, press, widget

# A ball that comes off square at this part of its speed: more than the preset's cushions give back.
KEPT = "0.59"


def at_page(hand: Hand) -> TuningPanel:
    panel = opened(hand)
    panel._open("by_hand")
    hand.app.step(0.0)
    return panel


def put(hand: Hand, panel: TuningPanel, name: str, words: str) -> None:
    """Click on a field and type."""
    press(hand, panel.by_hand.entries[name].rect.center)
    hand.post(pygame.TEXTINPUT, text=words)


def lines(panel: TuningPanel) -> list[str]:
    """Everything that is told on the panel."""
    return [one.words() for one in panel.form.widgets if hasattr(one, "words") and callable(one.words)]


def test_what_is_typed_in_sets_the_knobs_and_says_how_sure_they_are(hand: Hand) -> None:
    panel = at_page(hand)
    put(hand, panel, "rebound.kept", KEPT)
    put(hand, panel, "spin.turns", "9")
    put(hand, panel, "spin.seconds", "4,1 4.3 +-0.1")
    before = hand.play.state.session.table.knobs
    press(hand, widget(panel, "Set the knobs").rect.center)
    table = hand.play.state.session.table
    assert panel.tuning.error == ""
    assert set(table.set) == {"cushion.restitution", "cloth.mu_spin"}
    assert table.knobs.cushion.restitution > before.cushion.restitution
    told = [line for line in lines(panel) if "±" in line and "was" in line]
    assert [line.split(":")[0] for line in told] == ["Cloth", "Cushion"]
    assert f" {table.knobs.cushion.restitution:.3f} ± 0.0" in told[1] and "(was 0.92)" in told[1]
    assert panel.tuning.new is not None and panel.tuning.old is not None
    assert panel.tuning.new.digest() != panel.tuning.old.digest(), "the last shot is shown again"


def test_enter_works_them_out_and_strikes_no_ball(hand: Hand) -> None:
    panel = at_page(hand)
    put(hand, panel, "rebound.kept", KEPT)
    hand.key(pygame.K_RETURN)
    hand.key(pygame.K_RETURN)
    assert "cushion.restitution" in hand.play.state.session.table.set
    assert hand.play.state.session.strokes == 0 and not hand.play.state.rollout


def test_putting_back_gives_the_table_as_it_was(hand: Hand) -> None:
    panel = at_page(hand)
    panel.tuning.turn("cushion.friction", 0.2)
    before = hand.play.state.session.table
    button = widget(panel, "Put back")
    press(hand, button.rect.center)
    assert hand.play.state.session.table is before, "nothing to put back"
    put(hand, panel, "rebound.kept", KEPT)
    hand.key(pygame.K_RETURN)
    assert hand.play.state.session.table is not before
    press(hand, widget(panel, "Put back").rect.center)
    assert hand.play.state.session.table is before
    assert not [line for line in lines(panel) if "(was" in line]


def test_a_knob_that_was_measured_is_one_like_any_other(
    hand: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is set back with all others, and saved with the table."""
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))
    panel = at_page(hand)
    put(hand, panel, "rebound.kept", KEPT)
    hand.key(pygame.K_RETURN)
    found = hand.play.state.session.table.knobs.cushion.restitution
    panel.save()
    hand.app.step(0.0)
    hand.key(pygame.K_RETURN)
    assert load_table("my-pool-9ft").knobs.cushion.restitution == found
    panel.tuning.reset()
    assert hand.play.state.session.table.set == {}


@pytest.mark.parametrize(
    ("name", "words", "told"),
    [
        ("rebound.kept", "0.9", "measured: rebound.kept = 0.9: allowed is 0 to 0."),
        ("rebound.kept", "bouncy", "measured: rebound.kept = 'bouncy': allowed are numbers"),
        ("hard.lengths", "4", "measured: hard.first = None: missing; hard.lengths tells nothing without it"),
    ],
)
def test_what_cannot_be_is_told_and_changes_nothing(hand: Hand, name: str, words: str, told: str) -> None:
    panel = at_page(hand)
    before = hand.play.state.session.table
    put(hand, panel, name, words)
    hand.key(pygame.K_RETURN)
    assert panel.tuning.error.startswith(told)
    assert hand.play.state.session.table is before


def test_empty_fields_measure_nothing(hand: Hand) -> None:
    panel = at_page(hand)
    press(hand, widget(panel, "Set the knobs").rect.center)
    assert "nothing was measured" in panel.tuning.error


def test_measurements_that_contradict_each_other_are_told(hand: Hand) -> None:
    panel = at_page(hand)
    for name, words in (("rebound.kept", "0.46"), ("hard.lengths", "3.4"), ("hard.first", "0.5")):
        put(hand, panel, name, words)
    hand.key(pygame.K_RETURN)
    assert any("times as far apart" in line for line in lines(panel))


def test_letters_are_typed_and_mean_no_key_of_the_table(hand: Hand) -> None:
    panel = at_page(hand)
    entry = panel.by_hand.entries["lag.seconds"]
    press(hand, entry.rect.center)
    level = hand.play.state.show.level
    for key in (pygame.K_g, pygame.K_o, pygame.K_m, pygame.K_t):
        hand.key(key)
    hand.post(pygame.TEXTINPUT, text="8.5")
    assert hand.app.scene is hand.play and hand.play.state.show.level == level
    assert not hand.app.store.values.sound.mute
    assert hand.play.controller.tuning_panel is panel and entry.value == "8.5"
    messages = hand.play.state.messages.text
    hand.key(pygame.K_z, pygame.KMOD_CTRL)
    assert hand.play.state.messages.text == messages, "nothing is taken back on the table"


def test_after_a_press_on_the_table_keys_mean_what_they_always_do(hand: Hand) -> None:
    panel = at_page(hand)
    press(hand, panel.by_hand.entries["lag.seconds"].rect.center)
    assert hand.play.takes_text
    hand.point(1.2, 1.0)
    hand.press(button=3)
    hand.release(button=3)
    assert not hand.play.takes_text
    hand.key(pygame.K_t)
    assert hand.play.controller.tuning is None


def test_what_was_typed_in_is_there_again(hand: Hand) -> None:
    panel = at_page(hand)
    put(hand, panel, "lag.seconds", "8.5 8.7")
    hand.key(pygame.K_ESCAPE)
    assert hand.play.controller.tuning_panel is None
    hand.app.store.turn("screen.language", "de")
    panel = at_page(hand)
    assert panel.by_hand.entries["lag.seconds"].value == "8.5 8.7"
    assert panel.by_hand.entries["lag.seconds"].label == "Ausstoßen, s"


@pytest.mark.parametrize("language", languages())
def test_labels_have_room(hand: Hand, language: str) -> None:
    hand.app.store.turn("screen.language", language)
    panel = at_page(hand)
    for name in (name for row in ROWS for name in row):
        entry = panel.by_hand.entries[name]
        assert text.font(hand.play.stage.screen.unit * 7 // 4).size(entry.label)[0] <= entry.rect.width, entry.label
