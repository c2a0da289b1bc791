"""Files of the player's with names and contents that no screen can show: told or shown safely, never in the way."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pygame
import pytest

from pool2d import load_table
from pool2d.draw import text
from pool2d.draw.text import fitted, picture, wrap
from pool2d.ui.app import App
from pool2d.ui.dialogs.dialog import Dialog
from pool2d.ui.dialogs.position_list import PositionList
from pool2d.ui.menus.drill_list import DrillList
from pool2d.ui.menus.table_list import TableList
from pool2d.ui.replay.record_list import open_replays
from pool2d.ui.widgets.list_row import ListRow

from .conftest import Hand

NASTY = ["a\0b", "\x1b[2J", "\u202eabc", "\u200b\u200b", "\ud800", "\udcff", "x" * 50_000, "a\nb", "球" * 5000, ""]


@pytest.mark.parametrize("words", NASTY)
def test_any_text_can_be_drawn(words: str) -> None:
    for size in (8, 20):
        assert picture(words, size, (255, 255, 255)).get_width() < 2000 * 40
        short = fitted(words, size, 200)
        assert text.font(size).size(short)[0] <= 200
        lines = wrap(words, size, 200)
        assert all(text.font(size).size(line)[0] <= 200 for line in lines)
        assert all(line.isprintable() for line in (short, *lines))


def test_as_much_is_shown_as_fits() -> None:
    words = "The quick brown fox jumps over the lazy dog"
    for width in range(20, 400, 13):
        short = fitted(words, 15, width)
        whole = words[: len(short)] + "\N{HORIZONTAL ELLIPSIS}"
        assert short == words or text.font(15).size(whole)[0] > width >= text.font(15).size(short)[0]
    assert wrap("x" * 100, 15, 100) == tuple(piece for piece in wrap("x" * 100, 15, 100) if piece)
    assert "".join(wrap("x" * 100, 15, 100)) == "x" * 100


@pytest.fixture
def data(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The player's folders, in each a file that is wrong, a pipe, a folder, and odd names."""
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))
    contents = {
        "tables": ('base="pool-9ft"\nname="a\\u0000b"', ".toml"),
        "drills": ('name = "a\\u202eb"\nposition = "cue@1,1"\nsteps = [{}]', ".toml"),
        "positions": ('position = "cue@1,1 \\u0007@1,0.5"', ".toml"),
        "matches": ('{"n":0,"pool2d":1,"setup":{"names":["a\\u0000","b"]}}\n', ".jsonl"),
    }
    for folder, (content, ending) in contents.items():
        (tmp_path / folder).mkdir()
        for name in (b"\xff\xfe", b"\x1b[31m", b"a\nb", "\u202eabc".encode(), b"x" * 200, b"50%{s}"):
            Path(os.fsdecode(os.path.join(os.fsencode(tmp_path / folder), name + ending.encode()))).write_text(content)
        os.mkfifo(tmp_path / folder / f"pipe{ending}")
        (tmp_path / folder / f"folder{ending}").mkdir()
    os.utime(tmp_path / "matches" / "50%{s}.jsonl", (2.0**40, 2.0**40))
    return tmp_path


@pytest.mark.parametrize(
    "open_shelf",
    [
        lambda hand: TableList(hand.app.play, hand.app.play),
        lambda hand: DrillList(hand.app.play, hand.app.play),
        lambda hand: PositionList(hand.app.play, lambda name: "wrong\0"),
        lambda hand: open_replays(hand.app.play),
    ],
    ids=["tables", "drills", "positions", "matches"],
)
def test_shelves_show_whatever_lies_there(data: Path, guest: Hand, open_shelf: Callable[[Hand], Dialog]) -> None:
    shelf = guest.app.scene = open_shelf(guest)
    guest.app.step(0.5)
    for row in list(shelf.form.rows):
        for widget in row:
            if isinstance(widget, ListRow):
                widget.do()
                guest.app.step(0.1)
                guest.app.scene, shelf.done = shelf, False


def test_the_menu_opens_beside_damaged_records(data: Path) -> None:
    app = App(load_table("pool-9ft"), seed=3, menu=True)
    app.step(0.5)
    app.close()


def test_the_caption_and_notes_take_any_title(guest: Hand) -> None:
    table = load_table("pool-9ft", {"cloth.mu_roll": 0.011})
    table.title, table.source = "a\0\x1b" + "x" * 50_000, "mine.toml"
    guest.app.play.state.change_table(table)
    guest.app.step(0.1)
    assert pygame.display.get_caption()[0].isprintable()
    for words in NASTY:
        guest.app.toast(words, wrong=True)
        guest.app.step(0.3)
    assert all(note.life < 60.0 for note in guest.app.toasts.notes)
