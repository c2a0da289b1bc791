"""`pool2d tables`, presets of one's own, and that saving one survives a kill."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
import tomllib
from pathlib import Path
from typing import Any

import pytest

from pool2d import InputError, load_table
from pool2d.cli import main
from pool2d.config.folders import data_folder
from pool2d.config.knobs import walk
from pool2d.table.preset import conditions, presets, save_preset
from pool2d.table.table_knobs import Knobs


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path / "data"))
    return tmp_path / "data"


def said(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    assert main(["tables", *words]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    return out


def refused(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    assert main(list(words)) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    return err


# Listing and showing.


def test_all_presets_and_conditions_are_listed(capsys: pytest.CaptureFixture[str]) -> None:
    save_preset("mine", "pool-9ft", {}, "My table")
    out = said(capsys)
    for name in (*presets(), *conditions()):
        assert f"  {name} " in out
    assert "My table  (yours)" in out
    assert presets()[-1] == "mine"


def test_a_broken_preset_does_not_hide_the_others(capsys: pytest.CaptureFixture[str], home: Path) -> None:
    (home / "tables").mkdir(parents=True)
    (home / "tables" / "broken.toml").write_text("gravity = -1")
    out = said(capsys)
    assert "broken: gravity = -1" in out
    assert "Snooker" in out


def test_a_preset_is_shown_with_where_its_values_come_from(capsys: pytest.CaptureFixture[str]) -> None:
    out = said(capsys, "pool-7ft", "--conditions", "heated", "--set", "cue.mass=0.5")
    lines = {line.partition(" = ")[0]: line for line in out.splitlines() if " = " in line}
    assert set(lines) == {name for name, _, _ in walk(Knobs())}
    for name, value, origin in (
        ("table.length", "1.9812 m", "pool-7ft"),
        ("ball.radius", "0.028575 m", "base pool-9ft"),
        ("cloth.mu_slide", "0.2", "base pool-9ft"),
        ("cloth.bounce", "0.5", "default"),
        ("cloth.mu_roll", "0.0044", "conditions heated"),
        ("cue.mass", "0.5 kg", "set"),
    ):
        assert lines[name].split("#")[0].rstrip() == f"{name} = {value}"
        assert lines[name].split("# ")[1] == origin


def test_knobs_are_listed(capsys: pytest.CaptureFixture[str]) -> None:
    lines = said(capsys, "--knobs").splitlines()
    assert lines
    for line, (name, knob, default) in zip(lines, walk(Knobs()), strict=True):
        assert line.startswith(name)
        assert str(default) in line or f"{default:g}" in line
        assert line.endswith(knob.doc)
        assert knob.unit in line


def test_unknown_names_are_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert "did you mean pool-9ft?" in refused(capsys, "tables", "pool-9f")
    assert "did you mean heated?" in refused(capsys, "tables", "pool-9ft", "--conditions", "heatd")


# Checking.


def test_check_tells_good_from_bad(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    good, bad, worse = (tmp_path / f"{name}.toml" for name in ("good", "bad", "worse"))
    good.write_text("base = 'pool-7ft'")
    bad.write_text("gravity = 1000")
    worse.write_text("=")
    assert main(["tables", "--check", str(bad), str(good), str(worse)]) == 2
    out, err = capsys.readouterr()
    assert out == f"{good}: good, good\n"
    assert [line.split(": ")[1] for line in err.splitlines()] == [f"{bad}, line 1", str(worse)]
    assert main(["tables", "--check", str(good)]) == 0


# Starting a new one.


def test_new_writes_a_preset_like_its_base(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "mine.toml"
    said(capsys, "--new", str(path), "--base", "english-7ft")
    table, base = load_table(path), load_table("english-7ft")
    assert (table.title, table.knobs, table.furniture) == ("mine", base.knobs, base.furniture)
    # Every line uncommented, it is the same table still.
    text = path.read_text()
    lines = [line[2:] if line.startswith("# ") and " = " in line else line for line in text.splitlines()]
    path.write_text("\n".join(lines))
    values = tomllib.loads(path.read_text())
    assert all(name.partition(".")[0] in values for name, _, _ in walk(Knobs()))
    assert load_table(path).knobs == base.knobs


def test_new_replaces_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "mine.toml"
    path.write_text("# mine")
    assert "is there already" in refused(capsys, "tables", "--new", str(path))
    assert path.read_text() == "# mine"
    assert list(tmp_path.iterdir()) == [path]


def test_new_refuses_what_is_no_preset(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert "ends in .toml" in refused(capsys, "tables", "--new", str(tmp_path / "mine.txt"))
    assert "did you mean" in refused(capsys, "tables", "--new", str(tmp_path / "mine.toml"), "--base", "pool9ft")
    (tmp_path / "file").write_text("")
    assert "cannot be written" in refused(capsys, "tables", "--new", str(tmp_path / "file" / "mine.toml"))
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


# Saving.


def test_a_saved_preset_is_found_by_name(home: Path) -> None:
    path = save_preset(
        "my table", "pool-8ft", {"gravity": 9.8, "cloth.mu_roll": 1e-3, "ball.law": "impulse"}, 'Ä "b\\c"'
    )
    assert path == home / "tables" / "my table.toml"
    table = load_table("my table")
    assert table.title == 'Ä "b\\c"'
    assert (table.knobs.gravity, table.knobs.cloth.mu_roll, table.knobs.ball.law) == (9.8, 1e-3, "impulse")
    assert table.knobs.table == load_table("pool-8ft").knobs.table
    assert [file.name for file in path.parent.iterdir()] == ["my table.toml"]


def test_saving_over_itself_keeps_what_it_had() -> None:
    save_preset("mine", "snooker-12ft", {"cloth.mu_roll": 0.02}, "One")
    save_preset("mine", "mine", {"cloth.mu_slide": 0.3}, "Two")
    table = load_table("mine")
    assert (table.title, table.knobs.cloth.mu_roll, table.knobs.cloth.mu_slide) == ("Two", 0.02, 0.3)
    assert "snooker" in table.furniture.racks


def test_saving_what_has_an_outline_and_racks_keeps_them(home: Path) -> None:
    text = Path(load_path("l-shape")).read_text()
    (home / "tables").mkdir(parents=True)
    (home / "tables" / "ell.toml").write_text(text + '\n[racks."odd one"]\nplaced = { 8 = [0.5, 0.5] }\n')
    before = load_table("ell")
    save_preset("ell", "ell", {"table.nose_radius": 0.05}, "Ell")
    after = load_table("ell")
    assert after.furniture == before.furniture
    assert after.knobs.table.nose_radius == 0.05


def load_path(name: str) -> str:
    from pool2d.table.preset import preset_path

    return str(preset_path(name))


def test_saving_a_table_of_a_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "own.toml").write_text("base = 'pool-7ft'\n[cloth]\nmu_roll = 0.013\n")
    monkeypatch.chdir(tmp_path)
    save_preset("mine", "own.toml", {"cloth.mu_slide": 0.3}, "Mine")
    monkeypatch.chdir("/")
    assert load_table("mine").knobs.cloth.mu_roll == 0.013


@pytest.mark.parametrize(
    ("name", "base", "overrides", "title", "words"),
    [
        ("", "pool-9ft", {}, "T", "plain file name"),
        ("../x", "pool-9ft", {}, "T", "plain file name"),
        ("a/b", "pool-9ft", {}, "T", "plain file name"),
        ("a\\b", "pool-9ft", {}, "T", "plain file name"),
        ("/etc/x", "pool-9ft", {}, "T", "plain file name"),
        (".hidden", "pool-9ft", {}, "T", "plain file name"),
        ("x.toml", "pool-9ft", {}, "T", "plain file name"),
        ("x.", "pool-9ft", {}, "T", "plain file name"),
        ("a\0b", "pool-9ft", {}, "T", "plain file name"),
        ("a\nb", "pool-9ft", {}, "T", "plain file name"),
        ("NUL", "pool-9ft", {}, "T", "plain file name"),
        ("x" * 65, "pool-9ft", {}, "T", "plain file name"),
        ("pool-9ft", "pool-9ft", {}, "T", "another name"),
        ("Pool-9FT", "pool-9ft", {}, "T", "another name"),
        ("mine", "pool-9f", {}, "T", "did you mean pool-9ft?"),
        ("mine", "pool-9ft", {"cloth.mu_slid": 1.0}, "T", "did you mean cloth.mu_slide?"),
        ("mine", "pool-9ft", {"cloth.mu_slide": float("nan")}, "T", "allowed is a number"),
        ("mine", "pool-9ft", {"corner.drop_radius": 0.02}, "T", "beside the hole"),
        ("mine", "pool-9ft", {}, "a\nb", "printable"),
        ("mine", "pool-9ft", {}, "\ud800", "printable"),
    ],
)
def test_what_is_not_saved(home: Path, name: str, base: str, overrides: dict[str, Any], title: str, words: str) -> None:
    with pytest.raises(InputError, match=words.replace(".", r"\.").replace("?", r"\?")):
        save_preset(name, base, overrides, title)
    assert not home.exists()


def test_no_ring_is_saved() -> None:
    save_preset("one", "pool-9ft", {}, "One")
    save_preset("two", "one", {}, "Two")
    with pytest.raises(InputError, match="two builds on this one"):
        save_preset("one", "two", {}, "One")
    assert load_table("two").title == "Two"


SAVER = """
import sys
from pool2d.table.preset import save_preset
print("ready", flush=True)
for number in range(1_000_000):
    save_preset("mine", "pool-9ft", {"cloth.mu_slide": 0.1 + number % 800 / 1000}, "x" * (number % 3000))
"""


def test_a_kill_while_saving_leaves_a_whole_preset(home: Path) -> None:
    save_preset("mine", "pool-9ft", {}, "")
    for delay in (0.0, 0.003, 0.01, 0.02, 0.031, 0.05):
        with subprocess.Popen([sys.executable, "-c", SAVER], stdout=subprocess.PIPE, env=os.environ) as saver:
            assert saver.stdout is not None
            saver.stdout.readline()
            time.sleep(delay)
            saver.send_signal(signal.SIGKILL if hasattr(signal, "SIGKILL") else signal.SIGTERM)
        table = load_table("mine")
        assert set(table.title) <= {"x"}
        # What the kill left half written is no preset.
        assert presets()[-1] == "mine"
        assert {path.suffix for path in (home / "tables").iterdir()} <= {".toml", ".part"}


@pytest.mark.parametrize(
    ("platform", "env", "place"),
    [
        ("linux", {"XDG_DATA_HOME": "/x/data"}, "/x/data/pool2d"),
        ("linux", {"HOME": "/home/me"}, "/home/me/.local/share/pool2d"),
        ("darwin", {"HOME": "/Users/me"}, "/Users/me/Library/Application Support/pool2d"),
        ("win32", {"APPDATA": "/app"}, "/app/pool2d"),
        ("linux", {"POOL2D_DATA": "/over", "XDG_DATA_HOME": "/x"}, "/over"),
    ],
)
@pytest.mark.skipif(sys.platform == "win32", reason="paths as on Unix")
def test_where_own_presets_are(monkeypatch: pytest.MonkeyPatch, platform: str, env: dict[str, str], place: str) -> None:
    for name in ("POOL2D_DATA", "XDG_DATA_HOME", "APPDATA"):
        monkeypatch.delenv(name, raising=False)
    for name, value in env.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr("sys.platform", platform)
    assert data_folder() == Path(place)


# Conditions elsewhere.


def test_conditions_in_a_scenario_and_on_the_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "s.toml"

    def duration(conditions: str, *words: str) -> float:
        path.write_text(conditions + '\n[[balls]]\nid = "cue"\nx = 1.0\ny = 0.6\nvx = 0.5\n')
        assert main(["simulate", str(path), "--json", *words]) == 0
        return float(json.loads(capsys.readouterr().out)["duration"])

    plain = duration("")
    heated = duration('conditions = ["heated"]')
    assert heated > 1.5 * plain
    assert duration("", "--conditions", "heated") == heated
    assert duration('conditions = ["worn-cloth"]', "--conditions", "heated,dirty-balls") > plain
    assert duration('conditions = ["heated"]\nset = { "cloth.mu_roll" = 0.01 }') == plain


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("conditions = 'heated'", "conditions = 'heated': allowed is a list of names"),
        ("conditions = [1]", "conditions = [1]: allowed is a list of names"),
        ("conditions = ['heatd']", "conditions = 'heatd': unknown; did you mean heated?"),
    ],
)
def test_conditions_that_are_none(tmp_path: Path, capsys: pytest.CaptureFixture[str], line: str, words: str) -> None:
    path = tmp_path / "s.toml"
    path.write_text(line)
    assert words in refused(capsys, "simulate", str(path))


def test_conditions_hold_nothing_but_cloth_balls_and_cushions(home: Path) -> None:
    (home / "conditions").mkdir(parents=True)
    (home / "conditions" / "odd.toml").write_text("[table]\nlength = 2")
    with pytest.raises(InputError, match=r"table = .*unknown"):
        load_table("pool-9ft", conditions=["odd"])
