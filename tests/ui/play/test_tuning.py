"""Tuning a table: what a turned knob does to the last shot, and what another table would."""

from __future__ import annotations

import pygame

from pool2d import load_table
from pool2d.table.preset import presets
from pool2d.ui.play.tuning import NOTHING
from pool2d.ui.widgets.inputs import Selector

from ..conftest import Hand
from .tuned import opened, shot


def test_a_shot_from_the_aim_is_shown_where_none_was_played(hand: Hand) -> None:
    hand.point(1.9, 0.64)
    tuning = opened(hand).tuning
    assert tuning.new is not None
    assert tuning.new.events[0].kind == "cue_ball"


def test_what_does_not_fit_is_told_and_nothing_changes(hand: Hand) -> None:
    tuning = opened(hand).tuning
    before = hand.play.state.session.table
    tuning.turn("table.length", 1.0)
    assert hand.play.state.session.table is before
    assert tuning.error
    tuning.turn("cloth.mu_roll", 0.011)
    assert tuning.error == ""


def test_comparing_two_presets_on_the_same_shot(hand: Hand) -> None:
    shot(hand)
    tuning = opened(hand).tuning
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
    tuning = opened(hand).tuning
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


def test_conditions_lie_under_the_knobs(hand: Hand) -> None:
    tuning = opened(hand).tuning
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
    tuning = opened(hand).tuning
    hand.play.state.change_table(load_table("pool-9ft", {"cloth.mu_slide": 0.3}))
    hand.app.step(0.0)
    assert tuning.new is not None and tuning.old is not None
    assert tuning.new.digest() != tuning.old.digest()


def test_a_table_is_compared_only_where_the_balls_have_room(hand: Hand) -> None:
    shot(hand)
    panel = opened(hand)
    tuning = panel.tuning
    compare = next(one for one in panel.form.widgets if getattr(one, "label", "") == "Compare with")
    assert isinstance(compare, Selector)
    offered = set(compare.options())
    assert {NOTHING, "pool-9ft"} <= offered
    for name in offered - {NOTHING}:
        tuning.compare(name)
        assert tuning.error == "" and tuning.other is not None, name
    for name in set(presets()) - offered:
        tuning.compare(name)
        assert tuning.error, name
