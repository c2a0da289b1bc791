"""The last stroke of a match in play, and why it was played."""

from __future__ import annotations

import pygame
import pytest

from pool2d.game.actions import Stroke
from pool2d.ui.frame import Frame
from pool2d.ui.stage import why_panel

from ..conftest import Hand
from .at_opponent import frames, play_against, sit_down, until_played


@pytest.fixture(autouse=True)
def quick(data: None, monkeypatch: pytest.MonkeyPatch) -> None:
    sit_down(monkeypatch)


def picture(hand: Hand) -> bytes:
    hand.play.draw(Frame(hand.app.window.surface))
    return pygame.image.tobytes(hand.app.window.surface, "RGB")


def test_the_last_stroke_is_held_at_its_beginning_and_says_why(hand: Hand) -> None:
    hand.app.store.turn("screen.instant_players", True)
    session = play_against(hand, "", "quick")
    until_played(hand, 0)
    state = hand.play.state
    hand.key(pygame.K_h)
    shown = state.playback
    assert shown is not None and state.show.why is shown
    assert shown.paused and shown.time == 0.0
    assert session.last is not None and session.before is not None
    action = session.last.action
    assert isinstance(action, Stroke) and action.why is not None and action.why.meant.kind == "break"
    screen = hand.play.stage.screen
    lines = why_panel.lines(state.words, screen, session.match, session.before, action)
    assert lines[0][2].startswith("Break, the 1")
    told = picture(hand)
    hand.key(pygame.K_h)
    assert state.show.why is None and state.playback is shown
    assert picture(hand) != told
    # What is seen again another time is seen without.
    hand.key(pygame.K_h)
    hand.key(pygame.K_ESCAPE)
    frames(hand, 0.1)
    assert state.playback is None
    hand.key(pygame.K_r)
    assert state.playback is not None and state.show.why is not state.playback


def test_a_record_keeps_the_reasons_of_a_player_in_the_window(hand: Hand) -> None:
    hand.app.store.turn("screen.instant_players", True)
    session = play_against(hand, "quick", "quick", breaker=0)
    until_played(hand, 2)
    strokes = [moment.action for moment in session.match.history if isinstance(moment.action, Stroke)]
    assert all(stroke.why is not None for stroke in strokes) and len(strokes) >= 2


def test_of_a_persons_stroke_nobody_has_told_why(hand: Hand) -> None:
    hand.key(pygame.K_h)
    state = hand.play.state
    assert state.playback is None and state.show.why is None
    assert state.session.before is None
    state.strike(1.0)
    hand.key(pygame.K_h)
    session = state.session
    assert session.before is session.match.history[-2] and session.last is session.match.now
    action = session.match.now.action
    assert action is not None
    lines = why_panel.lines(state.words, hand.play.stage.screen, session.match, session.before, action)
    assert [line for _, _, line in lines] == ["Nobody has told why."]
    picture(hand)
