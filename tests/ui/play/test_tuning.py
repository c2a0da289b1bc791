"""The tuning panel, by mouse and by keyboard, and the geometry that B shows."""

from __future__ import annotations

from pathlib import Path

import pygame
import pytest

from pool2d import load_table
from pool2d.config.knobs import walk
from pool2d.draw.debug import draw_geometry
from pool2d.table.preset import presets
from pool2d.ui.dialogs.dialog import TextPrompt
from pool2d.ui.play.tuning import NOTHING, PAGES, Tuning
from pool2d.ui.widgets.inputs import Selector, Slider
from pool2d.ui.widgets.widget import Button, Tabs, Widget
from pool2d.ui.wording.keys import KEYS

from ..conftest import Hand


def panel(hand: Hand) -> Tuning:
    if hand.play.controller.tuning is None:
        hand.key(pygame.K_t)
    assert hand.play.controller.tuning is not None
    return hand.play.controller.tuning


def widget(tuning: Tuning, label: str) -> Widget:
    return next(one for one in tuning.form.widgets if getattr(one, "label", "") == label)


def press(hand: Hand, pos: tuple[int, int]) -> None:
    hand.move(pos)
    hand.press()
    hand.release()


def shot(hand: Hand) -> None:
    hand.point(1.7, 0.9)
    hand.key(pygame.K_SPACE)
    hand.key(pygame.K_SPACE)


def test_every_knob_is_on_one_page() -> None:
    knobs = [name for name, _, _ in walk(load_table("pool-9ft").knobs)]
    assert knobs
    for name in knobs:
        assert sum(name.startswith(beginnings) for beginnings in PAGES.values()) == 1, name


def test_dragging_a_slider_changes_the_table_and_shows_the_last_shot_again(hand: Hand) -> None:
    shot(hand)
    played = hand.play.state.session.rollout
    after = hand.play.state.session.layout
    tuning = panel(hand)
    assert tuning.old is not None and played is not None
    assert tuning.old.digest() == played.digest()
    slider = widget(tuning, "Rolling resistance")
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


def test_a_shot_from_the_aim_is_shown_where_none_was_played(hand: Hand) -> None:
    hand.point(1.9, 0.64)
    tuning = panel(hand)
    assert tuning.new is not None
    assert tuning.new.events[0].kind == "cue_ball"


def test_the_panel_by_keyboard_alone(hand: Hand) -> None:
    tuning = panel(hand)
    hand.key(pygame.K_RIGHT)
    assert tuning.page == "balls"
    assert isinstance(tuning.form.focus, Tabs)
    hand.key(pygame.K_LEFT)
    hand.key(pygame.K_TAB)
    hand.key(pygame.K_LEFT, pygame.KMOD_CTRL)
    assert list(hand.play.state.session.table.set) == ["gravity"]
    hand.key(pygame.K_DELETE)
    assert not hand.play.state.session.table.set
    hand.key(pygame.K_t)
    assert hand.play.controller.tuning is None


def test_escape_closes_the_panel(hand: Hand) -> None:
    panel(hand)
    hand.key(pygame.K_ESCAPE)
    assert hand.play.controller.tuning is None


@pytest.mark.parametrize("page", PAGES)
def test_every_widget_of_every_page_does_something(hand: Hand, page: str) -> None:
    tuning = panel(hand)
    tuning._open(page)
    hand.app.step(0.0)
    knobs = [one for one in tuning.form.widgets if isinstance(one, Slider | Selector) and one.label != "Compare with"]
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
    tuning = panel(hand)
    tuning._open("balls")
    choice = widget(tuning, "Law")
    assert isinstance(choice, Selector)
    before = choice.get()
    choice.turn(1)
    assert hand.play.state.session.table.knobs.ball.law != before


def test_reset_all(hand: Hand) -> None:
    tuning = panel(hand)
    tuning.turn("cloth.mu_roll", 0.02)
    tuning.turn("ball.restitution", 0.9)
    hand.app.step(0.0)
    press(hand, widget(tuning, "Reset all").rect.center)
    assert not hand.play.state.session.table.set


def test_what_does_not_fit_is_told_and_nothing_changes(hand: Hand) -> None:
    tuning = panel(hand)
    before = hand.play.state.session.table
    tuning.turn("table.length", 1.0)
    assert hand.play.state.session.table is before
    assert tuning.error
    tuning.turn("cloth.mu_roll", 0.011)
    assert tuning.error == ""


def test_comparing_two_presets_on_the_same_shot(hand: Hand) -> None:
    shot(hand)
    tuning = panel(hand)
    tuning.compare("pool-9ft")
    assert tuning.other is not None and tuning.old is not None
    assert tuning.other.digest() == tuning.old.digest()
    tuning.turn("cloth.mu_slide", 0.3)
    mine = hand.play.state.session.table
    tuning.swap()
    assert hand.play.state.session.table.knobs.cloth.mu_slide == 0.2
    assert tuning.compared is mine
    tuning.swap()
    assert hand.play.state.session.table is mine
    tuning.compare(NOTHING)
    assert tuning.other is None


def test_the_shot_shown_is_the_last_one_or_the_one_aimed(hand: Hand) -> None:
    hand.point(1.7, 0.9)
    tuning = panel(hand)
    hand.app.step(0.0)
    hand.point(1.2, 0.2)
    assert tuning.shot.angle == hand.play.state.hands.aim.angle
    hand.key(pygame.K_g)
    hand.play.controller._enter()
    hand.app.step(0.0)
    assert tuning.new is not None and hand.play.state.session.rollout is not None
    assert tuning.new.digest() == hand.play.state.session.rollout.digest()
    hand.key(pygame.K_n)
    hand.app.step(0.0)
    assert tuning.start == hand.play.state.session.layout


def test_a_click_on_a_page_leaves_the_aim_alone(hand: Hand) -> None:
    tuning = panel(hand)
    hand.app.step(0.0)
    tabs = next(one for one in tuning.form.widgets if isinstance(one, Tabs))
    hand.move((tabs.rect.right - 8, tabs.rect.centery))
    angle = hand.play.state.hands.aim.angle
    hand.press()
    hand.release()
    assert tuning.page == "table"
    assert hand.play.state.hands.aim.angle == angle


def test_a_table_has_to_be_chosen_before_playing_on_it(hand: Hand) -> None:
    tuning = panel(hand)
    tuning.chosen = "nowhere"
    before = hand.play.state.session
    tuning.go()
    assert hand.play.state.session is before
    assert "Choose" in tuning.error


def test_conditions_lie_under_the_knobs(hand: Hand) -> None:
    tuning = panel(hand)
    tuning.turn("ball.restitution", 0.9)
    tuning.condition("dirty-balls")
    knobs = hand.play.state.session.table.knobs
    assert knobs.ball.cling > 1.0
    assert knobs.ball.restitution == 0.9
    tuning.reset()
    assert hand.play.state.session.table.knobs.ball.cling > 1.0
    assert not hand.play.state.session.table.set
    tuning.condition(NOTHING)
    assert hand.play.state.session.table.knobs.ball.cling == 1.0


def test_a_saved_file_changes_what_the_panel_shows(hand: Hand) -> None:
    shot(hand)
    tuning = panel(hand)
    hand.play.state.change_table(load_table("pool-9ft", {"cloth.mu_slide": 0.3}))
    hand.app.step(0.0)
    assert tuning.new is not None and tuning.old is not None
    assert tuning.new.digest() != tuning.old.digest()


def test_going_over_to_another_table(hand: Hand) -> None:
    tuning = panel(hand)
    tuning._open("table")
    hand.app.step(0.0)
    tuning.chosen = "snooker-12ft"
    press(hand, widget(tuning, "Play on this table").rect.center)
    assert hand.play.state.session.table.source == "snooker-12ft"
    assert hand.play.controller.tuning is None
    hand.point(2.0, 0.9)
    hand.key(pygame.K_SPACE)
    assert hand.play.state.session.strokes == 1


def test_aiming_goes_on_beside_the_panel(hand: Hand) -> None:
    panel(hand)
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
    tuning = panel(hand)
    hand.app.step(0.0)
    right, _ = hand.play.stage.view.to_screen(2.54, 0.0)
    assert right < tuning.form.rect.left


def test_saving_as_a_preset_of_ones_own(hand: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))
    tuning = panel(hand)
    tuning.condition("dirty-balls")
    tuning.turn("cloth.mu_roll", 0.02)
    hand.app.step(0.0)
    button = widget(tuning, "Save as")
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
    tuning = panel(hand)
    press(hand, widget(tuning, "Save as").rect.center)
    hand.key(pygame.K_ESCAPE)
    assert not isinstance(hand.app.scene, TextPrompt)
    assert not list(tmp_path.rglob("*.toml"))


def test_the_panel_and_the_message_follow_the_language_and_the_keys(hand: Hand) -> None:
    tuning = panel(hand)
    tuning.form.focus = widget(tuning, "Rolling resistance")
    hand.app.store.turn("screen.language", "de")
    try:
        assert tuning.form.focus is widget(tuning, "Rollwiderstand")
        assert "kein Regler" in tuning._summary()
        assert hand.play.state.messages.text.startswith("Mit der Maus zielen")
        KEYS.bind("help", pygame.K_h)
        assert "H zeigt alle Tasten" in hand.play.state.messages.text
    finally:
        KEYS.reset()
        hand.app.store.turn("screen.language", "en")


class Recorder:
    """A pen that notes what it draws."""

    def __init__(self) -> None:
        self.drawn: list[tuple[str, tuple[float, ...]]] = []

    def line(self, what: str, ax: float, ay: float, bx: float, by: float) -> None:
        self.drawn.append((what, (ax, ay, bx, by)))

    def circle(self, what: str, x: float, y: float, radius: float) -> None:
        self.drawn.append((what, (x, y, radius)))

    def box(self, what: str, left: float, bottom: float, right: float, top: float) -> None:
        self.drawn.append((what, (left, bottom, right, top)))


def test_the_geometry_drawn_is_the_one_the_physics_sees(hand: Hand) -> None:
    table = load_table("pool-9ft")
    pen = Recorder()
    draw_geometry(pen, table)
    kinds = [what for what, _ in pen.drawn]
    assert kinds.count("drop") == 6
    assert kinds.count("jaw") == 12
    assert kinds.count("nose") == 6 + 12
    assert kinds.count("broad phase") == len(table.elements)
    bottom = [place for what, place in pen.drawn if what == "contact" and len(place) == 4]
    assert any(ay == pytest.approx(table.reach(0.028575)) and by == pytest.approx(ay) for _, ay, _, by in bottom)
    plain = pygame.image.tobytes(hand.app.window.surface, "RGB")
    hand.key(pygame.K_b)
    assert pygame.image.tobytes(hand.app.window.surface, "RGB") != plain
    hand.key(pygame.K_b)
    assert pygame.image.tobytes(hand.app.window.surface, "RGB") == plain


def test_a_table_is_compared_only_where_the_balls_have_room(hand: Hand) -> None:
    shot(hand)
    tuning = panel(hand)
    compare = next(one for one in tuning.form.widgets if getattr(one, "label", "") == "Compare with")
    assert isinstance(compare, Selector)
    offered = set(compare.options())
    assert {NOTHING, "pool-9ft"} <= offered
    for name in offered - {NOTHING}:
        tuning.compare(name)
        assert tuning.error == "" and tuning.other is not None, name
    for name in set(presets()) - offered:
        tuning.compare(name)
        assert tuning.error, name


def test_saving_leaves_no_error_that_is_over(hand: Hand) -> None:
    tuning = panel(hand)
    tuning.turn("table.length", 1.0)
    assert tuning.error
    save = next(one for one in tuning.form.widgets if getattr(one, "label", "").startswith("Save"))
    assert isinstance(save, Button)
    save.do()
    assert tuning.error == ""
