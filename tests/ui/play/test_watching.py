"""Players against each other in every kind of game; how frames follow each other, and who gives up."""

from __future__ import annotations

import pygame
import pytest

from pool2d.ui.menus.ended import FrameOver, MatchOver

from ..conftest import Hand
from .at_opponent import frames, mode, play_against, sit_down, until_played


@pytest.fixture(autouse=True)
def quick(data: None, monkeypatch: pytest.MonkeyPatch) -> None:
    sit_down(monkeypatch)


@pytest.mark.parametrize(
    ("game", "table"),
    [
        ("eight-ball", "pool-9ft"),
        ("straight", "pool-9ft"),
        ("one-pocket", "pool-9ft"),
        ("snooker", "snooker-12ft"),
        ("english-eight-ball", "english-7ft"),
        ("three-cushion", "carom-10ft"),
        ("free-pyramid", "pyramid-12ft"),
    ],
)
def test_two_players_are_watched_in_every_kind_of_game(hand: Hand, game: str, table: str) -> None:
    hand.app.store.turn("screen.instant_players", True)
    session = play_against(hand, "quick", "quick", game=game, table=table, breaker=-2 if game == "eight-ball" else 0)
    until_played(hand, 4)
    assert {moment.shooter for moment in session.match.history} - {-1} and mode(hand).session is session
    assert session.recorder is not None and session.recorder.fault is None


def test_giving_up_is_the_persons(hand: Hand) -> None:
    session = play_against(hand, "", "quick", race=2)
    hand.key(pygame.K_ESCAPE)
    hand.key(pygame.K_DOWN)
    hand.key(pygame.K_RETURN)
    hand.key(pygame.K_TAB)
    hand.key(pygame.K_RETURN)
    assert session.match.frames == (0, 1)
    assert isinstance(hand.app.scene, FrameOver)


def test_between_players_frames_follow_by_themselves_until_the_match_is_over(hand: Hand) -> None:
    session = play_against(hand, "quick", "quick", race=2)
    for frame in (1, 2):
        session.concede(0)
        hand.app.scene = hand.app.lobby.ended()
        assert isinstance(hand.app.scene, FrameOver if frame == 1 else MatchOver)
        frames(hand, 5.0)
    assert session.match.now.frame == 1
    assert isinstance(hand.app.scene, MatchOver), "the match is left to be read"


def test_against_a_person_the_next_frame_waits(hand: Hand) -> None:
    session = play_against(hand, "", "quick", race=2)
    session.concede(0)
    hand.app.scene = hand.app.lobby.ended()
    frames(hand, 6.0)
    assert session.match.now.frame == 0
