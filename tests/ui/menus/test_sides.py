"""Who plays a new match: people, or players who are none, on either side."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pygame
import pytest

from pool2d import load_table
from pool2d.config.settings import Store
from pool2d.opponent.player_file import player_names
from pool2d.ui.app import App
from pool2d.ui.menus.match_draft import PERSON, MatchDraft
from pool2d.ui.menus.new_match import NewMatch
from pool2d.ui.play.modes.opponent_mode import OpponentMode

from ..conftest import Hand
from ..play.at_opponent import Here, frames, sit_down
from .test_new_match import click, dialog, turn, widget


@pytest.fixture
def guest(tmp_path: Path, data: None, monkeypatch: pytest.MonkeyPatch) -> Iterator[Hand]:
    sit_down(monkeypatch)
    app = App(load_table("pool-9ft"), seed=3, store=Store(tmp_path / "settings.toml"), menu=True)
    pygame.event.clear()
    hand = Hand(app)
    hand.key(pygame.K_RETURN)
    yield hand
    app.close()


def labels(hand: Hand) -> set[str]:
    return {getattr(widget, "label", "") for widget in dialog(hand).form.widgets}


def test_a_person_plays_against_a_player_first(guest: Hand) -> None:
    draft = dialog(guest).draft
    assert draft.sides[0] == PERSON and draft.sides[1] in player_names()
    assert "First player" in labels(guest) and "Second player" not in labels(guest)
    click(guest, widget(guest, "Start").rect.center)
    session = guest.play.state.session
    assert session.match.setup.players == ("", draft.sides[1])
    assert session.match.names == ("Player 1", "Greta")
    assert isinstance(guest.play.state.mode, OpponentMode)


def test_every_player_is_offered_the_weakest_first_after_a_person(guest: Hand) -> None:
    draft = dialog(guest).draft
    assert draft.offered == (PERSON, *player_names())
    seen = []
    for _ in draft.offered:
        turn(guest, "First side")
        seen.append(draft.sides[0])
    assert seen == [*player_names(), PERSON]
    # Turned back, one who plays is a person again, who has a name.
    scene = guest.app.scene
    assert isinstance(scene, NewMatch)
    scene._take_side(1, PERSON)
    guest.app.step(0.0)
    assert scene.names == ("Player 1", "Player 2") and "Second player" in labels(guest)


def test_two_players_are_watched_and_stand_there_the_next_time(guest: Hand) -> None:
    for side in range(2):
        dialog(guest)._take_side(side, "quick")
    guest.app.step(0.0)
    assert dialog(guest).names == ("Quick", "Quick 2")
    assert "Start" not in labels(guest)
    click(guest, widget(guest, "Watch").rect.center)
    assert guest.play.state.session.match.setup.watched
    frames(guest, 0.1)
    assert len(Here.made) == 1 and Here.made[0].asked
    kept = MatchDraft(guest.app.store, load_table("pool-9ft"))
    assert kept.sides == ["quick", "quick"]
    # In a match of players there is nothing to give up.
    guest.key(pygame.K_ESCAPE)
    items = [item.entry.label() for item in guest.app.scene.items]  # type: ignore[union-attr]
    assert "Concede the frame" not in items


def test_a_player_who_is_gone_leaves_a_person(tmp_path: Path) -> None:
    store = Store(tmp_path / "settings.toml")
    store.turn("players.second_by", "nobody")
    assert MatchDraft(store, load_table("pool-9ft")).sides == [PERSON, PERSON]
