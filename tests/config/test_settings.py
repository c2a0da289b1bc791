"""Settings: what is kept, what is refused, and that a mistake in the file loses nothing."""

from __future__ import annotations

import os
import sys
import tomllib
from pathlib import Path

import pytest

from pool2d import InputError
from pool2d.config.folders import config_folder, pictures_folder
from pool2d.config.knobs import walk
from pool2d.config.settings import Settings, Store


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "pool2d" / "settings.toml"


def test_every_setting_describes_itself() -> None:
    settings = list(walk(Settings()))
    assert settings
    for name, described, value in settings:
        assert described.doc
        assert described.check(value, "", name) == described.default


def test_what_holds_until_something_is_set() -> None:
    settings = Settings()
    assert settings.match.race == 1 and not settings.match.game and not settings.match.table
    # A coin says who breaks.
    assert settings.match.breaker == -1
    assert settings.players.names == ("", "")
    # The screen says how large the window is, the system what it speaks.
    assert (settings.screen.width, settings.screen.height, settings.screen.full) == (0, 0, False)
    assert (settings.screen.language, settings.screen.reduced_motion) == ("auto", False)
    assert (settings.balls.palette, settings.balls.patterned, settings.balls.trails) == ("standard", False, True)
    assert settings.sound.volume > 0.5 and not settings.sound.mute


def test_what_is_turned_is_there_the_next_time(path: Path) -> None:
    store = Store(path)
    store.turn("sound.volume", 0.25)
    store.turn("sound.mute", True)
    store.turn("balls.palette", "colour-blind")
    store.bind({"guide": ["H", "Ctrl+G"]})
    store.save()
    again = Store(path)
    assert again.values == store.values
    assert again.values.sound.volume == 0.25
    assert again.keys == {"guide": ("H", "Ctrl+G")}
    assert again.complaints == []


def test_only_what_differs_from_the_defaults_is_written(path: Path) -> None:
    store = Store(path)
    store.turn("sound.mute", True)
    store.turn("aiming.guide", "line")
    store.turn("sound.mute", False)
    store.save()
    assert tomllib.loads(path.read_text()) == {"aiming": {"guide": "line"}}


def test_nothing_is_written_where_nothing_has_changed(path: Path) -> None:
    store = Store(path)
    store.turn("sound.volume", 0.8)
    store.save()
    assert not path.exists()


@pytest.mark.parametrize(
    ("name", "value"),
    [("sound.volume", 1.5), ("sound.mute", 1), ("aiming.guide", "all"), ("balls.palette", "x" * 41), ("sound.loud", 1)],
)
def test_a_value_that_is_not_allowed_changes_nothing(path: Path, name: str, value: object) -> None:
    store = Store(path)
    with pytest.raises(InputError) as caught:
        store.turn(name, value)
    assert (caught.value.key, caught.value.value) == (name, value)
    assert store.values == Settings() and not store.changed


def test_what_is_not_known_is_kept(path: Path) -> None:
    path.parent.mkdir()
    theirs = 'later = 1979-05-27T07:32:00Z\n[sound]\nreverb = inf\n[players]\nnames = ["A", { b = [1, 2] }]\n'
    path.write_text(theirs)
    store = Store(path)
    assert store.complaints == []
    store.turn("sound.volume", 0.5)
    store.save()
    held = tomllib.loads(path.read_text())
    assert held["sound"].pop("volume") == 0.5
    assert held == tomllib.loads(theirs)


def test_a_bad_value_is_the_default_and_the_file_is_kept_beside(path: Path) -> None:
    path.parent.mkdir()
    theirs = '[sound]\nvolume = "loud"\nmute = true\n[keys]\nguide = 3\nundo = ["Z"]\n[aiming]\nguide = "none"\n'
    path.write_text(theirs)
    store = Store(path)
    assert store.values.sound.volume == 0.8
    assert store.values.sound.mute
    assert store.keys == {"undo": ("Z",)}
    assert [(error.key, error.line) for error in store.complaints] == [
        ("sound.volume", 2), ("keys.guide", 5), ("aiming.guide", 8),
    ]  # fmt: skip
    assert "a number from 0 to 1" in str(store.complaints[0]) and str(path) in str(store.complaints[0])
    assert path.with_name("settings.toml.bad").read_text() == theirs
    store.save()
    # It is said once.
    assert Store(path).complaints == []
    assert Store(path).values.sound.mute


@pytest.mark.parametrize("content", [b"[sound\n", b"\xff\xfe", b"sound = 3\n", b"[sound]\nvolume = 1\n[sound]\n"])
def test_a_damaged_file_is_kept_and_does_not_stop_the_game(path: Path, content: bytes) -> None:
    path.parent.mkdir()
    path.with_name("settings.toml.bad").write_text("an older one")
    path.write_bytes(content)
    store = Store(path)
    assert len(store.complaints) == 1
    assert store.values == Settings()
    assert path.with_name("settings.toml.bad").read_text() == "an older one"
    assert path.with_name("settings.toml.bad2").read_bytes() == content


def test_a_text_that_cannot_be_shown_costs_that_text_alone(path: Path) -> None:
    path.parent.mkdir()
    path.write_text(
        'later.x = "a\\u202e"\n[sound]\nvolume = 0.5\nwide = 0xfffffffffffffffffff\n[keys]\nguide = ["\\u0000"]\n'
        '[players]\nfirst = "\\u200b"\n'
    )
    store = Store(path)
    assert (store.values.sound.volume, store.values.players.first, store.keys) == (0.5, "", {})
    assert [error.key for error in store.complaints] == ["later.x", "wide", "keys.guide", "players.first"]
    store.save()
    assert tomllib.loads(path.read_text()) == {"sound": {"volume": 0.5}}


def test_a_folder_that_cannot_be_written_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    store = Store(tmp_path / "file" / "settings.toml")
    store.turn("sound.mute", True)
    with pytest.raises(InputError, match="cannot be written"):
        store.save()
    # Once for each change.
    store.save()


def test_listeners_hear_each_change_once() -> None:
    store = Store()
    heard: list[float] = []
    store.listeners.append(lambda: heard.append(store.values.sound.volume))
    store.turn("sound.volume", 0.5)
    store.turn("sound.volume", 0.5)
    assert heard == [0.5]


@pytest.mark.parametrize(
    ("platform", "variables", "expected"),
    [
        ("linux", {"XDG_CONFIG_HOME": "/c"}, "/c/pool2d"),
        ("linux", {"HOME": "/h"}, "/h/.config/pool2d"),
        ("darwin", {"HOME": "/h"}, "/h/Library/Application Support/pool2d"),
        ("win32", {"APPDATA": "/a"}, "/a/pool2d"),
        ("win32", {"HOME": "/h", "USERPROFILE": "/h"}, "/h/AppData/Roaming/pool2d"),
        ("win32", {"APPDATA": "/a", "POOL2D_CONFIG": "/mine"}, "/mine"),
    ],
)
def test_the_platforms_place(
    monkeypatch: pytest.MonkeyPatch, platform: str, variables: dict[str, str], expected: str
) -> None:
    for name in ("XDG_CONFIG_HOME", "APPDATA", "POOL2D_CONFIG"):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(sys, "platform", platform)
    assert config_folder() == Path(expected)


def test_pictures_go_where_the_users_pictures_are(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.delenv("POOL2D_PICTURES")
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path / "data"))
    assert pictures_folder() == tmp_path / "data" / "pictures"
    (tmp_path / "Pictures").mkdir()
    assert pictures_folder() == tmp_path / "Pictures" / "pool2d"
    (tmp_path / "Bilder").mkdir()
    (tmp_path / "config").mkdir()
    (tmp_path / "config" / "user-dirs.dirs").write_text('# xdg\nXDG_PICTURES_DIR="$HOME/Bilder"\n')
    assert pictures_folder() == tmp_path / "Bilder" / "pool2d"


@pytest.mark.parametrize("platform", ["darwin", "win32"])
def test_off_linux_pictures_go_below_the_home(platform: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Where Linux keeps the name of the folder is not asked: it is `Pictures`, whatever stands there."""
    monkeypatch.delenv("POOL2D_PICTURES", raising=False)
    monkeypatch.setattr(sys, "platform", platform)
    for variable in ("HOME", "USERPROFILE"):
        monkeypatch.setenv(variable, str(tmp_path))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    (tmp_path / "config").mkdir()
    (tmp_path / "Bilder").mkdir()
    (tmp_path / "config" / "user-dirs.dirs").write_text('XDG_PICTURES_DIR="$HOME/Bilder"\n')
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path / "data"))
    assert pictures_folder() == tmp_path / "data" / "pictures"
    (tmp_path / "Pictures").mkdir()
    assert pictures_folder() == tmp_path / "Pictures" / "pool2d"


def test_a_pipe_where_linux_keeps_the_name_of_the_folder_is_passed_over(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.delenv("POOL2D_PICTURES", raising=False)
    monkeypatch.setattr(sys, "platform", "linux")
    for variable, value in (("HOME", tmp_path), ("XDG_CONFIG_HOME", tmp_path), ("POOL2D_DATA", tmp_path / "data")):
        monkeypatch.setenv(variable, str(value))
    os.mkfifo(tmp_path / "user-dirs.dirs")
    assert pictures_folder() == tmp_path / "data" / "pictures"
