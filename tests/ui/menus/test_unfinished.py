"""Matches that are left, and gone on with: by posted events."""

from __future__ import annotations

import os

import pygame
import pytest

from pool2d import Layout, Rollout, Shot, Table, load_table, simulate
from pool2d.config.folders import data_folder
from pool2d.game import judging
from pool2d.game.actions import NextFrame, Stalemate, Stroke
from pool2d.game.records import engine
from pool2d.game.records.record import load, matches_folder
from pool2d.game.records.recorded_shots import RecordedShots
from pool2d.game.records.recorder import records, resume, unfinished
from pool2d.game.records.replaying import restored
from pool2d.game.session import recorded
from pool2d.game.setup import Setup
from pool2d.ui.app import App
from pool2d.ui.dialogs.dialog import Confirm
from pool2d.ui.menus.ended import FrameOver
from pool2d.ui.menus.menu import Menu
from pool2d.ui.menus.new_match import NewMatch
from pool2d.ui.play.modes.drill_mode import DrillMode
from pool2d.ui.play.play import Play
from pool2d.ui.replay import replay_view
from pool2d.ui.replay.record_list import RecordList
from pool2d.ui.replay.replay_scene import Replay
from pool2d.ui.widgets.widget import Button, Heading

from ..conftest import Hand
from .at_menu import choose, labels, left_match, left_matches, playing, shown


def test_a_match_that_was_left_is_gone_on_with() -> None:
    path = left_match()
    app = App(load_table("pool-9ft"), seed=3, menu=True)
    guest = Hand(app)
    menu = app.scene
    assert isinstance(menu, Menu)
    told = menu.items[0].entry.details()
    assert told[0] == "Ann 0 : 0 Bo" and told[1].startswith("Nine-ball")
    choose(guest, "Continue")
    assert shown(guest) is Play
    assert guest.play.state.session.match.names == ("Ann", "Bo")
    assert guest.play.state.session.strokes == 1
    guest.play.state.session.concede(0)
    app.close()
    assert load(path).frames == (0, 1)


def test_the_menu_tells_the_frames_that_were_won(guest: Hand) -> None:
    session = playing(guest)
    session.concede(1)
    guest.app.scene = guest.app.lobby.leave()
    guest.app.step(0.0)
    menu = guest.app.scene
    assert isinstance(menu, Menu)
    assert menu.items[0].entry.details()[0] == "Ann 1 : 0 Bo"
    # It stands between two frames, and so it comes back.
    choose(guest, "Continue")
    assert shown(guest) is FrameOver
    guest.app.step(0.5)
    guest.key(pygame.K_RETURN)
    assert isinstance(guest.play.state.session.match.now.action, NextFrame)


def test_a_match_that_no_longer_plays_as_recorded_is_told_and_left_alone(
    guest: Hand, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = left_match()
    before = path.read_bytes()
    guest.app.scene = guest.app.lobby.menu()
    guest.app.step(0.0)
    path.write_bytes(before.replace(b"8", b"7", 1))
    damaged = path.read_bytes()
    choose(guest, "Continue")
    assert path.read_bytes() == damaged
    assert [note.wrong for note in guest.app.toasts.notes] == [True]
    assert "Continue" not in labels(guest)


def test_of_several_matches_that_were_left_any_is_gone_on_with() -> None:
    left_matches(2, 3)
    app = App(load_table("pool-9ft"), seed=3, menu=True)
    guest = Hand(app)
    assert labels(guest)[:2] == ["Continue", "Unfinished matches"]
    choose(guest, "Unfinished matches")
    assert shown(guest) is RecordList
    guest.key(pygame.K_ESCAPE)
    assert shown(guest) is Menu
    choose(guest, "Unfinished matches")
    # The list has them by age, as the menu has.
    guest.key(pygame.K_DOWN)
    guest.key(pygame.K_RETURN)
    assert shown(guest) is Play
    assert guest.play.state.session.match.setup.race == 3
    app.close()


def test_a_damaged_record_is_told_once_where_it_is_the_latest() -> None:
    left_match()
    noise = matches_folder() / "noise.jsonl"
    noise.write_text("noise\n")
    os.utime(noise, (1, 1))
    assert told_at_start() == []
    os.utime(noise)
    told = told_at_start()
    assert len(told) == 1 and told[0].startswith(str(noise))
    assert noise.read_text() == "noise\n"


def test_a_match_that_nobody_began_leaves_no_record() -> None:
    session = recorded(load_table("pool-9ft"), Setup("nine-ball", breaker=0))
    assert len(records()) == 1
    session.leave()
    assert records() == []


def test_an_unfinished_match_is_thrown_away_when_asked_twice() -> None:
    paths = left_matches(2, 3)
    app = App(load_table("pool-9ft"), seed=3, menu=True)
    guest = Hand(app)
    choose(guest, "Unfinished matches")
    guest.key(pygame.K_DELETE)
    assert unfinished() == paths
    guest.key(pygame.K_DELETE)
    assert unfinished() == paths[1:] and not paths[0].exists()
    assert shown(guest) is RecordList
    # The menu knows of it.
    guest.key(pygame.K_ESCAPE)
    assert labels(guest)[:2] == ["Continue", "New match"]
    guest.key(pygame.K_RETURN)
    assert guest.play.state.session.match.setup.race == 3
    app.close()


@pytest.mark.parametrize("lost", [True, False])
def test_a_match_on_a_preset_that_has_changed_or_gone_is_continued_as_it_was_and_says_so(lost: bool) -> None:
    preset = data_folder() / "tables" / "mine.toml"
    preset.parent.mkdir(parents=True)
    preset.write_text('name = "Mine"\nbase = "pool-8ft"\n[cloth]\nmu_roll = 0.012\n')
    app = App(load_table("mine"), seed=3)
    hand = Hand(app)
    app.scene = app.lobby.begin(recorded(load_table("mine"), Setup("nine-ball", names=("Ann", "Bo"), breaker=0)))
    hand.play.state.session.play(Shot(0.4, 8.0))
    table, layout = hand.play.state.session.table, hand.play.state.session.layout
    hand.post(pygame.QUIT)
    app.close()
    preset.unlink() if lost else preset.write_text('base = "pool-7ft"\n')

    app = App(load_table("pool-9ft"), seed=3, menu=True)
    guest = Hand(app)
    choose(guest, "Continue")
    assert [note.wrong for note in app.toasts.notes] == [False]
    assert ("not there any more" if lost else "has changed since") in app.toasts.notes[0].words
    session = guest.play.state.session
    assert (session.table.knobs, session.table.title) == (table.knobs, "Mine")
    assert session.layout == layout
    guest.strike()
    assert session.strokes == 2 or session.ask.kind == "place"
    choose_menu = app.lobby.leave()
    app.scene = choose_menu
    app.step(0.0)
    # The replay says so while its first shot runs.
    shown_replay = Replay(RecordedShots(load(records()[0])), app.words, app.scene)
    assert "The table is as it was" in replay_view.caption(app.words, shown_replay.state)[0]
    shown_replay.state.playback.leave()
    assert "The table is as it was" not in replay_view.caption(app.words, shown_replay.state)[0]
    app.close()


def test_a_match_that_another_engine_has_played_goes_on_as_it_stood_and_says_so(
    guest: Hand, monkeypatch: pytest.MonkeyPatch
) -> None:
    left_match()
    layout = restored(load(unfinished()[0])).match.layout
    now = engine.identity()._replace(engine="later")
    monkeypatch.setattr(engine, "identity", lambda: now)

    def roll(table: Table, start: Layout, shot: Shot) -> Rollout:
        return simulate(table.with_knobs({"cloth.mu_roll": 0.02}), start, shot)

    monkeypatch.setattr(judging, "simulate", roll)
    guest.app.scene = guest.app.lobby.menu()
    guest.app.step(0.0)
    choose(guest, "Continue")
    assert guest.play.state.session.layout == layout
    notes = guest.app.toasts.notes
    assert [note.wrong for note in notes] == [False] and "the engine has changed since" in notes[0].words
    # What is seen again are the balls before the shot and after it.
    guest.key(pygame.K_r)
    shown_again = guest.play.state.playback
    assert shown_again is not None and shown_again.rollout.layout() == layout
    guest.app.step(0.5)
    replay = Replay(RecordedShots(load(unfinished()[0])), guest.app.words, guest.play)
    assert replay_view.caption(guest.app.words, replay.state) == (
        "Today this shot would roll otherwise: the engine has changed since."
        " The balls are shown as recorded, before it and after it.",
        True,
    )
    guest.app.scene = replay
    while not replay.still:
        guest.app.step(0.1)
    assert replay.state.playback.ended


def told_at_start() -> list[str]:
    """What is told while the menu opens, twice."""
    app = App(load_table("pool-9ft"), seed=3, menu=True)
    guest = Hand(app)
    assert labels(guest)[0] == "Continue"
    app.lobby.menu()
    told = [note.words for note in app.toasts.notes]
    app.close()
    return told


def test_closing_the_window_lets_go_of_the_record() -> None:
    app = App(load_table("pool-9ft"), seed=3)
    hand = Hand(app)
    session = playing(hand)
    session.play(Shot(speed=8.0))
    hand.post(pygame.QUIT)
    app.close()
    again = App(load_table("pool-9ft"), seed=3, menu=True)
    guest = Hand(again)
    choose(guest, "Continue")
    assert guest.play.state.session.strokes == 1
    again.close()


@pytest.mark.parametrize("begun", [True, False])
def test_closing_the_window_in_a_drill_lets_go_of_the_record_of_the_match_below(begun: bool) -> None:
    app = App(load_table("pool-9ft"), seed=3)
    hand = Hand(app)
    session = playing(hand)
    if begun:
        session.play(Shot(speed=8.0))
    hand.key(pygame.K_F2)
    hand.key(pygame.K_RETURN)
    assert app.scene is app.play and isinstance(app.play.state.mode, DrillMode)
    hand.post(pygame.QUIT)
    app.close()
    assert len(records()) == begun
    for path in records():
        # Nobody holds it any more.
        resume(path).close()


def test_a_match_begun_on_a_full_disk_says_so_at_once(guest: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*args: object) -> int:
        raise OSError(28, "No space left on device")

    choose(guest, "New match")
    dialog = guest.app.scene
    assert isinstance(dialog, NewMatch)
    with monkeypatch.context() as patch:
        patch.setattr(os, "write", full)
        dialog.start()
    assert guest.app.scene is dialog and "No space left on device" in dialog.wrong
    assert records() == []


def test_a_record_that_cannot_be_written_is_told_once(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    session = playing(hand)
    assert session.recorder is not None

    def full(*args: object) -> int:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(os, "write", full)
        session.play(Shot(speed=8.0))
    hand.app.step(0.01)
    hand.app.step(0.01)
    assert [note.words.endswith("No space left on device") for note in hand.app.toasts.notes] == [True]


def test_a_frame_is_begun_again_once_both_have_said_so(hand: Hand) -> None:
    session = playing(hand)
    session.play(Shot(speed=8.0))
    racked = session.match.history[0].layout
    for answer in ("Cancel", "Start the frame again"):
        hand.app.scene = hand.app.lobby.pause()
        hand.app.step(0.0)
        choose(hand, "Start the frame again")
        asked = hand.app.scene
        assert isinstance(asked, Confirm)
        headings = [widget.words() for widget in asked.form.widgets if isinstance(widget, Heading)]
        assert headings == ["Do both players agree that the frame gets nowhere?"]
        buttons = {widget.label: widget for widget in asked.form.widgets if isinstance(widget, Button)}
        assert list(buttons) == ["Cancel", "Start the frame again"]
        assert isinstance(session.match.now.action, Stroke)
        hand.move(buttons[answer].rect.center)
        hand.press()
        hand.release()
    assert hand.app.scene is hand.play
    assert isinstance(session.match.now.action, Stalemate)
    assert len(session.layout.on_table()) == len(racked.on_table())
    assert "Ann" in hand.play.state.messages.text


def test_another_table_lets_go_of_the_record(hand: Hand) -> None:
    playing(hand).play(Shot(speed=8.0))
    hand.play.state.open_table("pool-7ft")
    assert hand.play.state.session.is_practice
    assert len(unfinished()) == 1
    hand.app.scene = hand.app.lobby.menu()
    hand.app.step(0.0)
    choose(hand, "Continue")
    assert hand.play.state.session.table.source == "pool-9ft"
