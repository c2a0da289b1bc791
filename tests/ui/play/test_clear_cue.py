"""The butt rises by itself over what is behind the ball, says so, and comes down again; what cannot be is refused."""

from __future__ import annotations

import math
from dataclasses import replace

import pygame
import pytest

from pool2d import Ball, Layout, Shot, least_elevation
from pool2d.ui.play.play_view import notes

from ..conftest import Hand

CUE = Ball("cue", 1.8, 0.635)


def frozen(hand: Hand, speed: float = 3.0) -> None:
    """A cue ball on the left cushion, aimed square away from it."""
    table = hand.play.state.session.table
    hand.set_balls(Ball("cue", table.reach(table.knobs.ball.radius), 0.5), Ball("1", 1.9, 0.9))
    hand.play.state.hands.aim = replace(hand.play.state.hands.aim, angle=0.0, speed=speed)


def test_at_the_rail_it_rises_and_is_struck_so(hand: Hand) -> None:
    frozen(hand)
    state = hand.play.state
    least = least_elevation(state.session.table, state.session.layout, Shot(0.0))
    assert state.aimed().elevation == least.elevation == pytest.approx(28.6, abs=0.1)
    assert notes(state, 0.6).startswith("29 degrees, over the left cushion.")
    assert state.hands.aim.elevation == 0.0, "what the player chose is kept"
    state.hands.aim = state.hands.aim.with_speed(0.6)
    hand.strike()
    assert state.session.shot is not None and state.session.shot.elevation == least.elevation


def test_it_comes_down_to_what_was_chosen_where_that_is_possible(hand: Hand) -> None:
    hand.set_balls(CUE, Ball("7", 1.68, 0.635), Ball("1", 2.2, 0.9))
    state = hand.play.state
    state.hands.aim = replace(state.hands.aim, angle=0.0, elevation=4.0)
    assert notes(state, 0.6).startswith("17 degrees, over the 7.")
    assert state.aimed().elevation == pytest.approx(17.2, abs=0.2)
    state.hands.aim = replace(state.hands.aim, angle=90.0)
    assert state.aimed().elevation == 4.0 and "over" not in notes(state, 0.6)
    state.hands.aim = replace(state.hands.aim, angle=0.0, elevation=40.0)
    assert state.aimed().elevation == 40.0 and "over" not in notes(state, 0.6)


def test_it_is_told_in_german_too(hand: Hand) -> None:
    frozen(hand)
    hand.app.store.turn("screen.language", "de")
    assert notes(hand.play.state, 0.6).startswith("29 Grad, über Bande links.")


def test_the_key_raises_it_from_where_it_has_to_be(hand: Hand) -> None:
    frozen(hand)
    before = hand.play.state.aimed().elevation
    hand.key(pygame.K_e)
    assert hand.play.state.aimed().elevation == pytest.approx(before + 1.0, abs=0.06)


def test_in_an_easy_stroke_it_stays_as_chosen(hand: Hand) -> None:
    frozen(hand)
    hand.app.store.turn("aiming.easy_stroke", True)
    assert hand.play.state.aimed() == replace(hand.play.state.hands.aim.shot("cue"), easy=True)
    assert notes(hand.play.state, 0.6) == ""


def test_a_tip_that_cannot_be_reached_is_refused_with_its_reason(hand: Hand) -> None:
    radius = hand.play.state.session.table.knobs.ball.radius
    hand.set_balls(CUE, Ball("7", 1.8 - 2.0 * math.sqrt(radius * 0.06), 0.635, radius=0.06))
    state = hand.play.state
    state.hands.aim = replace(state.hands.aim, angle=0.0, height=-0.6)
    told = "This tip cannot be reached: the 7 is in the way at any elevation."
    assert notes(state, 2.0) == told
    strokes = state.session.strokes
    hand.strike()
    assert state.session.strokes == strokes and state.rollout is None and notes(state, 2.0) == told
    state.hands.aim = replace(state.hands.aim, height=0.3)
    hand.strike()
    assert state.session.strokes == strokes + 1


def test_where_no_stroke_is_possible_it_says_so(hand: Hand) -> None:
    # Between two balls so large that they meet over the one between them.
    small, giant = 0.0165, 0.06
    far = 2.0 * math.sqrt(small * giant)
    balls = [Ball("cue", 1.8, 0.635, radius=small)]
    balls += [Ball(ball, 1.8 + x, 0.635, radius=giant) for ball, x in (("7", -far), ("8", far))]
    state = hand.play.state
    state.take_table(state.session.table.with_knobs({"cushion.nose_height": 0.03}), Layout(balls))
    state.hands.aim = replace(state.hands.aim, angle=0.0)
    assert notes(state, 2.0).startswith("No stroke is possible along this aim: the ")
    hand.strike()
    assert state.session.strokes == 0


def test_the_same_shot_again_is_aimed_as_it_was_chosen(hand: Hand) -> None:
    frozen(hand, speed=0.6)
    hand.strike()
    hand.key(pygame.K_F5)
    state = hand.play.state
    assert state.hands.aim.elevation == 0.0 and state.aimed().elevation == pytest.approx(28.6, abs=0.1)
