"""A new match by mouse and by keyboard: only what can be played is offered, and it begins as agreed."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pygame
import pytest

from pool2d import load_table
from pool2d.config.settings import Store
from pool2d.draw import theme
from pool2d.game.records.record import load
from pool2d.game.records.replaying import restored, verify
from pool2d.game.rules import GAMES, games_for
from pool2d.game.session import PRACTICE
from pool2d.table.preset import presets
from pool2d.ui.app import App
from pool2d.ui.menus.new_match import NewMatch
from pool2d.ui.widgets.inputs import Selector
from pool2d.ui.widgets.widget import Button, Toggle, Widget
from pool2d.ui.wording.words import languages

from ..conftest import Hand


@pytest.fixture(autouse=True)
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))


def people(store: Store) -> Store:
    """Settings by which people play."""
    store.turn("players.second_by", "")
    return store


@pytest.fixture
def guest(tmp_path: Path) -> Iterator[Hand]:
    app = App(load_table("pool-9ft"), seed=3, store=people(Store(tmp_path / "settings.toml")), menu=True)
    pygame.event.clear()
    hand = Hand(app)
    hand.key(pygame.K_RETURN)
    yield hand
    app.close()


def dialog(hand: Hand) -> NewMatch:
    scene = hand.app.scene
    assert isinstance(scene, NewMatch)
    return scene


def widget(hand: Hand, label: str) -> Widget:
    return next(widget for widget in dialog(hand).form.widgets if getattr(widget, "label", "") == label)


def click(hand: Hand, pos: tuple[int, int]) -> None:
    hand.move(pos)
    hand.press()
    hand.release()


def turn(hand: Hand, label: str, times: int = 1) -> None:
    """Click a choice on."""
    for _ in range(times):
        place = widget(hand, label)
        assert isinstance(place, Selector)
        click(hand, (place.rect.right - 10, place.rect.centery))


def test_it_begins_as_agreed(guest: Hand) -> None:
    turn(guest, "Game")
    turn(guest, "Race to", 2)
    turn(guest, "Breaks first", 3)
    turn(guest, "Breaks then")
    turn(guest, "The nine on the break")
    push = widget(guest, "Push out")
    assert isinstance(push, Toggle)
    click(guest, push.rect.center)
    click(guest, widget(guest, "Start").rect.center)
    assert guest.app.scene is guest.play
    match = guest.play.state.session.match
    assert match.setup.game == "nine-ball"
    assert match.setup.options == {"nine_on_break": "spotted", "push_out": "no"}
    assert (match.setup.race, match.setup.breaker, match.setup.breaks) == (3, 1, "winner")
    assert match.names == ("Player 1", "Player 2")
    assert guest.play.state.session.recorder is not None


def test_a_lag_decides_who_breaks_and_is_on_the_record(guest: Hand) -> None:
    turn(guest, "Breaks first")
    click(guest, widget(guest, "Start").rect.center)
    session = guest.play.state.session
    first = session.ask.player
    assert f"Player {first + 1} lags" in guest.play.state.messages.text
    for speed in (1.4, 1.6):
        # To the foot cushion, which is on the right.
        guest.point(2.0, session.cue.y)
        guest.play.state.hands.aim = guest.play.state.hands.aim.with_speed(speed)
        guest.strike()
    assert f"Player {first + 1} wins the lag" in guest.play.state.messages.text
    assert session.ask.options == ("break", "give-break")
    guest.key(pygame.K_2)
    assert session.ask.player == 1 - first and session.cue.id == "cue"
    # The shots of the lag are none of the frame's.
    guest.key(pygame.K_r)
    assert guest.play.state.playback is None
    recorder = session.recorder
    assert recorder is not None
    session.leave()
    kept = load(recorder.path)
    assert verify(kept) is None
    assert restored(kept).match.now.ruling == session.ruling


def test_a_table_without_a_head_cushion_offers_no_lag(guest: Hand) -> None:
    turn(guest, "Breaks first")
    scene = guest.app.scene
    assert isinstance(scene, NewMatch) and scene.draft.breaker == -2
    scene._take_table("l-shape")
    guest.app.step(0.0)
    assert scene.draft.breaker == -1
    turn(guest, "Breaks first")
    assert scene.draft.breaker == 0


def test_by_keys_alone(guest: Hand) -> None:
    guest.key(pygame.K_RIGHT)
    assert dialog(guest).draft.game == "nine-ball"
    while not isinstance(dialog(guest).form.focus, Button):
        guest.key(pygame.K_TAB)
    guest.key(pygame.K_TAB)
    guest.key(pygame.K_RETURN)
    assert guest.app.scene is guest.play and not guest.play.state.session.is_practice


def test_names_are_typed_and_kept(guest: Hand) -> None:
    click(guest, dialog(guest).fields[0].rect.center)
    for char in "Zoë":
        guest.post(pygame.TEXTINPUT, text=char)
    # A letter that is a key elsewhere is only a letter here.
    guest.key(pygame.K_o)
    assert dialog(guest).names == ("Zoë", "Player 2")
    click(guest, widget(guest, "Start").rect.center)
    assert guest.play.state.session.match.names == ("Zoë", "Player 2")
    assert guest.app.store.values.players.names == ("Zoë", "")
    guest.app._save()
    path = guest.app.store.path
    assert Store(path).values.players.first == "Zoë"


def test_a_game_is_offered_the_tables_that_it_can_be_played_on_alone(guest: Hand) -> None:
    games = [name for name in GAMES if name != PRACTICE]
    assert dialog(guest).draft.games == games
    for _ in games:
        chosen = dialog(guest)
        assert chosen.draft.tables == [name for name in presets() if chosen.draft.game in games_for(load_table(name))]
        assert chosen.draft.preset in chosen.draft.tables and not chosen.barred
        before = chosen.draft.preset
        turn(guest, "Table")
        assert chosen.draft.preset in chosen.draft.tables and (
            chosen.draft.preset != before or len(chosen.draft.tables) == 1
        )
        turn(guest, "Game")
    assert dialog(guest).draft.game == games[0]


def test_a_game_that_the_table_is_none_for_does_not_start_and_it_is_told(guest: Hand) -> None:
    dialog(guest)._take_table("l-shape")
    dialog(guest).draft.game = "snooker"
    start = widget(guest, "Start")
    assert isinstance(start, Button) and start.barred()
    assert dialog(guest).barred.startswith("An L has not the balls and the rack for Snooker.")
    click(guest, start.rect.center)
    assert isinstance(guest.app.scene, NewMatch) and guest.play.state.session.is_practice
    dialog(guest).form.focus = start
    guest.key(pygame.K_RETURN)
    assert isinstance(guest.app.scene, NewMatch)


def test_a_table_without_balls_has_no_game_and_it_is_told(guest: Hand, tmp_path: Path) -> None:
    bare = tmp_path / "bare.toml"
    bare.write_text('name = "Bare"\n')
    assert games_for(load_table(str(bare))) == [PRACTICE]
    opened = NewMatch(guest.play, Store(), load_table(str(bare)), lambda session: guest.play)
    assert opened.barred == "Bare has not the balls and the rack of any game. Choose another table."
    opened.start()
    assert opened.update(0.0) is opened


def test_a_button_that_is_barred_is_grey(guest: Hand) -> None:
    start = widget(guest, "Start")

    def colors() -> set[tuple[int, ...]]:
        guest.app.redraw()
        guest.app.step(0.0)
        box = guest.app.window.surface.subsurface(start.rect)
        return {tuple(box.get_at((x, 4 + box.get_height() // 2))) for x in range(4, box.get_width() - 4)}

    assert theme.ACCENT in {color[:3] for color in colors()}
    dialog(guest).draft.game = "snooker"
    assert theme.ACCENT not in {color[:3] for color in colors()}


def test_it_opens_as_last_set(guest: Hand) -> None:
    turn(guest, "Game")
    turn(guest, "Table")
    turn(guest, "Race to", 2)
    turn(guest, "Breaks then")
    turn(guest, "The nine on the break")
    turn(guest, "Breaks first", 3)
    chosen = dialog(guest)
    click(guest, widget(guest, "Start").rect.center)
    agreed = guest.play.state.session.match.setup
    guest.app._save()
    again = NewMatch(guest.play, Store(guest.app.store.path), load_table("carom-10ft"), lambda session: guest.play)
    for name in ("game", "preset", "race", "breaks", "breaker", "options"):
        assert getattr(again.draft, name) == getattr(chosen.draft, name), name
    assert again.draft.options == agreed.options != {} and not again.barred


@pytest.mark.parametrize(
    "kept",
    [
        {"game": "tiddlywinks"},
        {"game": "snooker", "table": "gone"},
        {"game": "nine-ball push_out=maybe fly=yes nine_on_break nine_on_break=wins"},
        {"game": "straight target=1e9 innings=nan"},
        {"game": "eight-ball", "table": "snooker-12ft", "race": 98.0, "breaker": 0.5, "breaks": "nobody"},
    ],
)
def test_what_was_kept_and_stands_for_nothing_is_passed_over(guest: Hand, kept: dict[str, float | str]) -> None:
    store = Store()
    for name, value in kept.items():
        store.turn(f"match.{name}", value)
    opened = NewMatch(guest.play, store, load_table("pool-9ft"), lambda session: guest.play)
    assert opened.draft.game in opened.draft.games
    if kept.get("table") != "gone":
        assert not opened.barred
        opened.start()
        assert not opened.wrong


def test_a_game_is_kept_where_the_next_table_has_it_too(guest: Hand) -> None:
    turn(guest, "Game")
    dialog(guest)._take_table("pool-7ft")
    assert dialog(guest).draft.game == "nine-ball"
    dialog(guest)._take_table("snooker-12ft")
    assert dialog(guest).draft.game == "snooker"


def test_a_damaged_table_is_told_and_another_can_be_chosen(guest: Hand, tmp_path: Path) -> None:
    (tmp_path / "tables").mkdir()
    (tmp_path / "tables" / "zz.toml").write_text('base = "pool-9ft"\n[table]\nlength = -1\n')
    while dialog(guest).draft.preset != "zz":
        turn(guest, "Table")
    assert "zz" in dialog(guest).barred
    click(guest, widget(guest, "Start").rect.center)
    assert guest.play.state.session.is_practice
    turn(guest, "Table")
    assert dialog(guest).barred == ""


def test_a_match_that_cannot_be_recorded_is_told(guest: Hand, tmp_path: Path) -> None:
    (tmp_path / "matches").write_text("in the way")
    click(guest, widget(guest, "Start").rect.center)
    assert "cannot be written" in dialog(guest).wrong
    assert guest.play.state.session.is_practice


def test_options_are_those_of_the_game(guest: Hand) -> None:
    def told() -> list[str]:
        return [getattr(widget, "label", "") for widget in dialog(guest).form.widgets]

    assert "Push out" not in told()
    while dialog(guest).draft.game != "straight":
        turn(guest, "Game")
    assert "Push out" not in told()
    turn(guest, "Target")
    click(guest, widget(guest, "Start").rect.center)
    assert guest.play.state.session.match.setup.options == {"target": 125.0}


def test_a_number_that_stands_for_none_is_told_in_words(guest: Hand) -> None:
    while dialog(guest).draft.game != "three-cushion":
        turn(guest, "Game")
    assert dialog(guest).draft.preset == "carom-10ft"
    innings = widget(guest, "Innings")
    assert isinstance(innings, Selector)
    assert (innings.get(), innings.shown(innings.get())) == ("0", "no limit")
    turn(guest, "Innings")
    assert innings.shown(innings.get()) == "1"


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("size", [(640, 360), (960, 540), (1920, 1080)])
def test_it_can_be_drawn_in_every_game(language: str, size: tuple[int, int]) -> None:
    app = App(load_table("pool-9ft"), seed=3, size=size, menu=True)
    hand = Hand(app)
    app.store.turn("screen.language", language)
    hand.key(pygame.K_RETURN)
    games = dialog(hand).draft.games
    assert games
    for name in games:
        dialog(hand)._take_game(name)
        assert app.step(0.01)
        assert dialog(hand).form.rect.bottom <= size[1]
    app.close()
