"""The menu at the start, the pause, and going on with a match: by posted events."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import pygame
import pytest

from pool2d import Shot, cli, load_table
from pool2d.game.actions import NextFrame, Stalemate
from pool2d.game.record import load, matches_folder
from pool2d.game.recorder import records, unfinished
from pool2d.game.session import Session, recorded
from pool2d.game.setup import Setup
from pool2d.ui import start, words
from pool2d.ui.app import App
from pool2d.ui.dialog import Confirm
from pool2d.ui.drill_shelf import DrillShelf
from pool2d.ui.ended import FrameOver
from pool2d.ui.entry import Entry
from pool2d.ui.help import Help
from pool2d.ui.menu import Menu
from pool2d.ui.new_match import TUNED, NewMatch
from pool2d.ui.options import Options
from pool2d.ui.play import Play
from pool2d.ui.replays import RecordShelf
from pool2d.ui.table_shelf import TableShelf

from .conftest import Hand


@pytest.fixture(autouse=True)
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))


@pytest.fixture
def guest() -> Iterator[Hand]:
    """A hand at a window that has opened with the menu."""
    app = App(load_table("pool-9ft"), seed=3, menu=True)
    pygame.event.clear()
    yield Hand(app)
    app.close()
    words.speak("en")


def left_match(race: int = 2) -> Path:
    """A match that has been begun and left: the first stroke was played."""
    session = recorded(load_table("pool-9ft"), Setup("nine-ball", names=("Ann", "Bo"), race=race, breaker=0))
    session.play(Shot(speed=8.0))
    session.leave()
    return unfinished()[0]


def playing(hand: Hand, race: int = 2) -> Session:
    """Begin a match in the window."""
    setup = Setup("nine-ball", names=("Ann", "Bo"), race=race, breaker=0)
    hand.app.scene = hand.app.lobby.begin(recorded(load_table("pool-9ft"), setup))
    return hand.play.session


def labels(hand: Hand) -> list[str]:
    scene = hand.app.scene
    assert isinstance(scene, Menu)
    return [item.entry.label() for item in scene.items]


def choose(hand: Hand, label: str, by_mouse: bool = False) -> None:
    """Choose an entry of the menu that is open."""
    scene = hand.app.scene
    assert isinstance(scene, Menu)
    item = scene.items[labels(hand).index(label)]
    if by_mouse:
        hand.move(item.rect.center)
        hand.press()
        hand.release()
        return
    for _ in scene.items:
        if scene.form.focus is not item:
            hand.key(pygame.K_DOWN)
    hand.key(pygame.K_RETURN)


def shown(hand: Hand) -> object:
    return type(hand.app.scene)


def test_the_menu_offers_what_there_is(guest: Hand) -> None:
    assert labels(guest) == ["New match", "Practice", "Practice tables", "Drills", "Replays", "Options", "Help", "Quit"]


@pytest.mark.parametrize("by_mouse", [False, True])
def test_every_entry_leads_on_and_esc_back(guest: Hand, by_mouse: bool) -> None:
    menu = guest.app.scene
    for label, kind in (("New match", NewMatch), ("Drills", DrillShelf), ("Options", Options), ("Help", Help)):
        choose(guest, label, by_mouse)
        assert shown(guest) is kind
        guest.key(pygame.K_ESCAPE)
        assert guest.app.scene is menu
    choose(guest, "Practice", by_mouse)
    assert guest.app.scene is guest.play


def test_quit_closes_the_window(guest: Hand) -> None:
    choose(guest, "Quit")
    assert not guest.open


def test_the_pointer_moves_the_mark_that_the_keys_move(guest: Hand) -> None:
    menu = guest.app.scene
    assert isinstance(menu, Menu)
    guest.move(menu.items[2].rect.center)
    assert menu.form.focus is menu.items[2]
    guest.key(pygame.K_UP)
    assert menu.form.focus is menu.items[1]
    guest.move((5, 5))
    assert menu.form.focus is menu.items[1]


def test_the_menu_speaks_another_language_at_once(guest: Hand) -> None:
    guest.app.store.turn("screen.language", "de")
    assert labels(guest)[0] == "Neue Partie"


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
    assert guest.play.session.match.names == ("Ann", "Bo")
    assert guest.play.session.strokes == 1
    guest.play.session.concede(0)
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
    assert isinstance(guest.play.session.match.now.action, NextFrame)


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
    paths = [left_match(race) for race in (2, 3)]
    for age, path in enumerate(paths):
        os.utime(path, (10 - age, 10 - age))
    app = App(load_table("pool-9ft"), seed=3, menu=True)
    guest = Hand(app)
    assert labels(guest)[:2] == ["Continue", "Unfinished matches"]
    choose(guest, "Unfinished matches")
    assert shown(guest) is RecordShelf
    guest.key(pygame.K_ESCAPE)
    assert shown(guest) is Menu
    choose(guest, "Unfinished matches")
    # The list has them by age, as the menu has.
    guest.key(pygame.K_DOWN)
    guest.key(pygame.K_RETURN)
    assert shown(guest) is Play
    assert guest.play.session.match.setup.race == 3
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
    paths = [left_match(race) for race in (2, 3)]
    for age, path in enumerate(paths):
        os.utime(path, (10 - age, 10 - age))
    app = App(load_table("pool-9ft"), seed=3, menu=True)
    guest = Hand(app)
    choose(guest, "Unfinished matches")
    guest.key(pygame.K_DELETE)
    assert unfinished() == paths
    guest.key(pygame.K_DELETE)
    assert unfinished() == paths[1:] and not paths[0].exists()
    assert shown(guest) is RecordShelf
    # The menu knows of it.
    guest.key(pygame.K_ESCAPE)
    assert labels(guest)[:2] == ["Continue", "New match"]
    guest.key(pygame.K_RETURN)
    assert guest.play.session.match.setup.race == 3
    app.close()


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
    assert guest.play.session.strokes == 1
    again.close()


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


# The pause.


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
    assert hand.app.scene is hand.play and hand.play.hands.pull is None
    hand.release()
    hand.key(pygame.K_t)
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is hand.play and hand.play.tuning is None
    hand.key(pygame.K_SPACE)
    assert hand.play.playback is not None
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is hand.play


def test_practice_is_left_for_the_menu_and_waits_there(hand: Hand) -> None:
    session = hand.play.session
    hand.key(pygame.K_ESCAPE)
    choose(hand, "Leave to the menu")
    assert "Practice" in labels(hand)
    choose(hand, "Practice")
    assert hand.app.scene is hand.play and hand.play.session is session


def test_a_match_is_left_for_the_menu_and_can_be_gone_on_with(hand: Hand) -> None:
    playing(hand).play(Shot(speed=8.0))
    hand.key(pygame.K_ESCAPE)
    choose(hand, "Leave to the menu")
    assert labels(hand)[0] == "Continue"
    assert hand.play.session.free
    choose(hand, "Continue")
    assert not hand.play.session.free and hand.play.session.strokes == 1


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
    assert "Ann breaks" in hand.play.message


def test_another_table_lets_go_of_the_record(hand: Hand) -> None:
    playing(hand).play(Shot(speed=8.0))
    hand.play.open_table("pool-7ft")
    assert hand.play.session.free
    assert len(unfinished()) == 1
    hand.app.scene = hand.app.lobby.menu()
    hand.app.step(0.0)
    choose(hand, "Continue")
    assert hand.play.session.table.source == "pool-9ft"


@pytest.mark.parametrize(("menu", "kind"), [(True, Menu), (False, Play)])
def test_the_window_opens_with_the_menu_or_with_practice(
    monkeypatch: pytest.MonkeyPatch, menu: bool, kind: type[object]
) -> None:
    seen: list[object] = []
    monkeypatch.setattr(App, "run", lambda app, frames: seen.append(app.scene))
    start.play(lambda: load_table("pool-9ft"), seed=1, menu=menu)
    assert isinstance(seen[0], kind)
    assert not matches_folder().exists()


@pytest.mark.parametrize(
    ("argv", "menu"),
    [([], True), (["--seed", "0"], False), (["--table", "pool-7ft"], False), (["--set", "cloth.mu_roll=0.02"], False)],
)
def test_who_says_what_to_play_on_plays_at_once(monkeypatch: pytest.MonkeyPatch, argv: list[str], menu: bool) -> None:
    asked: list[bool] = []

    def play(load: object, seed: int | None, frames: int | None, menu: bool) -> int:
        asked.append(menu)
        return 0

    monkeypatch.setattr(start, "play", play)
    assert cli.main(argv) == 0
    assert asked == [menu]


def test_a_table_tuned_in_practice_is_played_on_only_when_it_is_chosen(guest: Hand) -> None:
    guest.play.change_table(load_table("pool-9ft", {"cloth.mu_slide": 0.3}))
    for choice, tuned in (("pool-9ft", False), (TUNED, True)):
        guest.app.scene = guest.app.lobby.menu()
        choose(guest, "New match")
        scene = guest.app.scene
        assert isinstance(scene, NewMatch) and scene.table == "pool-9ft"
        assert scene._title(TUNED) == "Pool, 9 ft, as tuned in practice"
        scene._take_table(choice)
        scene.start()
        guest.app.step(0.0)
        assert (guest.play.session.table.set != {}) == tuned
        assert not guest.play.session.free
        guest.app.lobby.leave()
        # Practice goes on where it was.
        assert guest.play.session.table.set == {"cloth.mu_slide": 0.3}


def test_pages_open_over_the_menu_by_their_keys(guest: Hand) -> None:
    for key, kind in ((pygame.K_F1, Help), (pygame.K_o, Options), (pygame.K_F2, DrillShelf)):
        guest.key(key)
        assert shown(guest) is kind
        guest.key(pygame.K_ESCAPE)
        assert shown(guest) is Menu


def test_a_table_is_chosen_for_practice(guest: Hand, tmp_path: Path) -> None:
    (tmp_path / "tables").mkdir()
    (tmp_path / "tables" / "odd.toml").write_text("nothing = 3\n")
    choose(guest, "Practice tables")
    shelf = guest.app.scene
    assert isinstance(shelf, TableShelf)
    entries = {line.label: line for line in shelf.form.widgets if isinstance(line, Entry)}
    assert entries["Snooker, 12 ft"].below == "Snooker" and entries["Pyramid, 12 ft"].below == ""
    assert "nothing" in entries["odd"].below
    shelf.form.focus = entries["odd"]
    guest.key(pygame.K_RETURN)
    assert shown(guest) is TableShelf and "nothing" in shelf.wrong
    shelf.form.focus = next(line for line in shelf.form.widgets if getattr(line, "label", "") == "Snooker, 12 ft")
    guest.key(pygame.K_RETURN)
    assert shown(guest) is Play
    assert guest.play.session.free and guest.play.session.table.source == "snooker-12ft"
