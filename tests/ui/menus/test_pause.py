"""The pause: by posted events."""

from __future__ import annotations

import pygame

from pool2d import Shot
from pool2d.game.actions import Stalemate
from pool2d.ui.dialogs.dialog import Confirm
from pool2d.ui.menus.ended import FrameOver
from pool2d.ui.menus.menu import Menu
from pool2d.ui.play.play import Play

from ..conftest import Hand
from .at_menu import choose, labels, playing, shown


def test_esc_pauses_where_nothing_is_under_way(hand: Hand) -> None:
    hand.key(pygame.K_ESCAPE)
    assert labels(hand) == ["Resume", "Options", "Help", "Leave to the menu", "Quit"]
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is hand.play
    hand.key(pygame.K_ESCAPE)
    hand.key(pygame.K_RETURN)
    assert hand.app.scene is hand.play


def test_esc_first_puts_away_what_is_under_way(hand: Hand) -> None:
    hand.point(1.5, 0.6)
    hand.press()
    hand.pull(60)
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is hand.play and hand.play.state.hands.pull is None
    hand.release()
    hand.key(pygame.K_t)
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is hand.play and hand.play.controller.tuning is None
    hand.key(pygame.K_SPACE)
    assert hand.play.state.playback is not None
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is hand.play


def test_practice_is_left_for_the_menu_and_waits_there(hand: Hand) -> None:
    session = hand.play.state.session
    hand.key(pygame.K_ESCAPE)
    choose(hand, "Leave to the menu")
    assert "Practice" in labels(hand)
    choose(hand, "Practice")
    assert hand.app.scene is hand.play and hand.play.state.session is session


def test_a_match_is_left_for_the_menu_and_can_be_gone_on_with(hand: Hand) -> None:
    playing(hand).play(Shot(speed=8.0))
    hand.key(pygame.K_ESCAPE)
    choose(hand, "Leave to the menu")
    assert labels(hand)[0] == "Continue"
    assert hand.play.state.session.is_practice
    choose(hand, "Continue")
    assert not hand.play.state.session.is_practice and hand.play.state.session.strokes == 1


def test_to_concede_is_asked_first(hand: Hand) -> None:
    session = playing(hand)
    hand.key(pygame.K_ESCAPE)
    choose(hand, "Concede the frame")
    assert shown(hand) is Confirm
    hand.key(pygame.K_RETURN)
    assert shown(hand) is Menu and session.match.frames == (0, 0)
    choose(hand, "Concede the frame")
    hand.key(pygame.K_TAB)
    hand.key(pygame.K_RETURN)
    assert shown(hand) is FrameOver and session.match.frames == (0, 1)


def test_a_frame_that_gets_nowhere_is_begun_again_by_agreement(hand: Hand) -> None:
    session = playing(hand)
    start = session.layout
    session.play(Shot(speed=8.0))
    hand.key(pygame.K_ESCAPE)
    choose(hand, "Start the frame again")
    assert shown(hand) is Confirm
    hand.key(pygame.K_TAB)
    hand.key(pygame.K_RETURN)
    assert shown(hand) is Play
    assert isinstance(session.match.now.action, Stalemate)
    assert session.strokes == 0 and set(session.layout) == set(start)
    assert "Ann breaks" in hand.play.state.messages.text
