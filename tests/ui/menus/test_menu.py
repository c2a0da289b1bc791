"""The menu at the start, and what it leads to: by posted events."""

from __future__ import annotations

import pygame
import pytest

from pool2d import cli, load_table
from pool2d.config.folders import data_folder
from pool2d.draw import theme
from pool2d.game.records.record import matches_folder
from pool2d.ui import start
from pool2d.ui.app import App
from pool2d.ui.dialogs.help import Help
from pool2d.ui.dialogs.options import OptionsPage
from pool2d.ui.menus.drill_list import DrillList
from pool2d.ui.menus.match_draft import TUNED
from pool2d.ui.menus.menu import Menu
from pool2d.ui.menus.new_match import NewMatch
from pool2d.ui.menus.table_list import TableList
from pool2d.ui.play.play import Play
from pool2d.ui.widgets.list_row import ListRow

from ..conftest import Hand
from .at_menu import choose, labels, shown


def test_the_menu_offers_what_there_is(guest: Hand) -> None:
    assert labels(guest) == ["New match", "Practice", "Practice tables", "Drills", "Replays", "Options", "Help", "Quit"]


@pytest.mark.parametrize("by_mouse", [False, True])
def test_every_entry_leads_on_and_esc_back(guest: Hand, by_mouse: bool) -> None:
    menu = guest.app.scene
    for label, kind in (("New match", NewMatch), ("Drills", DrillList), ("Options", OptionsPage), ("Help", Help)):
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
    guest.play.state.change_table(load_table("pool-9ft", {"cloth.mu_slide": 0.3}))
    for choice, tuned in (("pool-9ft", False), (TUNED, True)):
        guest.app.scene = guest.app.lobby.menu()
        choose(guest, "New match")
        scene = guest.app.scene
        assert isinstance(scene, NewMatch) and scene.draft.preset == "pool-9ft"
        assert scene._title(TUNED) == "Pool, 9 ft, as tuned in practice"
        scene._take_table(choice)
        scene.start()
        guest.app.step(0.0)
        assert (guest.play.state.session.table.set != {}) == tuned
        assert not guest.play.state.session.is_practice
        guest.app.lobby.leave()
        # Practice goes on where it was.
        assert guest.play.state.session.table.set == {"cloth.mu_slide": 0.3}


def test_pages_open_over_the_menu_by_their_keys(guest: Hand) -> None:
    for key, kind in ((pygame.K_F1, Help), (pygame.K_o, OptionsPage), (pygame.K_F2, DrillList)):
        guest.key(key)
        assert shown(guest) is kind
        guest.key(pygame.K_ESCAPE)
        assert shown(guest) is Menu


def test_a_table_is_chosen_for_practice(guest: Hand) -> None:
    odd = data_folder() / "tables" / "odd.toml"
    odd.parent.mkdir(parents=True)
    odd.write_text("nothing = 3\n")
    choose(guest, "Practice tables")
    shelf = guest.app.scene
    assert isinstance(shelf, TableList)
    entries = {line.label: line for line in shelf.form.widgets if isinstance(line, ListRow)}
    assert entries["Snooker, 12 ft"].below == "Snooker, Six-red snooker"
    assert entries["Pyramid, 12 ft"].below == "Free pyramid"
    assert "nothing" in entries["odd"].below
    shelf.form.focus = entries["odd"]
    guest.key(pygame.K_RETURN)
    assert shown(guest) is TableList and "nothing" in shelf.wrong
    shelf.form.focus = next(line for line in shelf.form.widgets if getattr(line, "label", "") == "Snooker, 12 ft")
    guest.key(pygame.K_RETURN)
    assert shown(guest) is Play
    assert guest.play.state.session.is_practice and guest.play.state.session.table.source == "snooker-12ft"


def test_an_entry_looks_pressed_while_a_release_would_choose_it(guest: Hand) -> None:
    menu = guest.app.scene
    assert isinstance(menu, Menu)
    item, other = menu.items[1], menu.items[3]

    def color() -> tuple[int, ...]:
        shade = guest.app.window.surface.get_at((item.rect.right - item.rect.height // 2, item.rect.centery))
        return tuple(shade)[:3]

    guest.move(item.rect.center)
    lit = color()
    guest.press()
    pressed = color()
    guest.move(other.rect.center)
    assert color() != pressed
    guest.move(item.rect.center)
    assert color() == pressed
    assert lit == theme.FACE_LIT and pressed == theme.FACE_DOWN
