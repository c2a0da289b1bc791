"""`pool2d players`: who there is, the weakest first, and what is measured of one."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from pool2d.cli import main
from pool2d.opponent.contests import rates
from pool2d.opponent.player import Player, Rates
from pool2d.opponent.player_file import load_player, player_names

from ..opponent.contests.quick_players import written
from .cli_runs import Capture, refusal

FOUND = Rates("2026-11-27", "by hand", 47.0, 62.0, 2.35, 5.0, 0.41, 24.0)


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of the user's own players."""
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path / "data"))
    (tmp_path / "data" / "players").mkdir(parents=True)
    return tmp_path / "data" / "players"


def said(capsys: Capture, *words: str) -> str:
    assert main(["players", *words]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    return out


def test_players_are_listed_the_weakest_first(home: Path, capsys: Capture) -> None:
    (home / "zoe.toml").write_text("name = 'Zoe'\ntitle = 'C'\nrank = 1")
    (home / "broken.toml").write_text("rank = 'low'")
    lines = said(capsys).splitlines()[1:]
    assert [line.split()[0] for line in lines[:-1]] == player_names()
    assert next(line for line in lines if line.startswith("zoe")).split(maxsplit=1)[1].startswith("Zoe, C (yours)")
    assert "rank = 'low': allowed is a number" in lines[-2]
    assert lines[-1] == f"Your own are kept in {home}"


def test_measured_rates_are_told(home: Path, capsys: Capture) -> None:
    table = "\n".join(f"{key} = {getattr(FOUND, key)!r}" for key in Rates.__slots__)
    (home / "zoe.toml").write_text(f"title = 'B'\n[measured]\n{table}")
    line = next(line for line in said(capsys).splitlines() if line.startswith("zoe"))
    assert line.split() == ["zoe", "zoe,", "B", "(yours)", "47", "B", "62", "%", "2.35", "5", "%", "0.41", "24"]


def test_json_has_all_of_it(home: Path, capsys: Capture) -> None:
    (home / "broken.toml").write_text("rank = 'low'")
    (line,) = said(capsys, "--json").splitlines()
    data = json.loads(line, parse_constant=pytest.fail)
    assert [one["file"] for one in data] == player_names()
    assert set(data[0]) == {"file", "name", "title", "rank", "words", "measured"}
    assert set(data[0]["words"]) == {"en", "de"}
    assert "allowed is a number" in data[-1]["error"]


def measuring(monkeypatch: pytest.MonkeyPatch, find: Callable[..., Rates]) -> None:
    def measured(player: Player, seed: int, crew: Any, how: str) -> Rates:
        return find(player, seed, how)

    monkeypatch.setattr(rates, "measured", measured)


def test_what_is_measured_is_told_with_its_grade_and_saved(
    tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = written(tmp_path, "ann", 1.0)
    measuring(monkeypatch, lambda player, seed, how: FOUND)
    assert said(capsys, "--measure", path).splitlines() == [
        "ann: 47 balls in ten racks, grade B",
        "  pots: 62 of 100",
        "  nine-ball: 2.35 balls a visit, 5 % of racks broken and run out",
        "  three-cushion: 0.41 points an inning",
        "  snooker: a highest break of 24",
    ]
    assert load_player(path).measured == Rates()
    assert said(capsys, "--measure", path, "--save").splitlines()[-1] == f"{path}: written"
    assert load_player(path).measured == FOUND
    answer = json.loads(said(capsys, "--measure", path, "--json"))
    assert (answer["grade"], answer["balls"]) == ("B", 47.0)


def test_how_it_was_measured_is_said(tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[tuple[str, int, str]] = []

    def find(player: Player, seed: int, how: str) -> Rates:
        asked.append((player.name, seed, how))
        return FOUND

    measuring(monkeypatch, find)
    said(capsys, "--measure", "ida", "--seed", "7", "--json")
    ((name, seed, how),) = asked
    assert (name, seed) == ("Ida", 7)
    assert how.startswith("pool2d players --measure ida --seed 7 (")


def test_a_long_path_is_saved_so_that_the_file_can_be_read(
    tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / ("long" * 30) / ("longer" * 30)
    folder.mkdir(parents=True)
    path = written(folder, "ann", 1.0)
    measuring(monkeypatch, lambda player, seed, how: replace(FOUND, how=how))
    said(capsys, "--measure", path, "--save")
    assert load_player(path).measured.how.startswith("pool2d players --measure ann --seed 0 (")


def test_an_interrupted_measuring_saves_nothing(
    tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    def stopped(*_: object) -> Rates:
        raise KeyboardInterrupt

    measuring(monkeypatch, stopped)
    path = written(tmp_path, "ann", 1.0)
    assert main(["players", "--measure", path, "--save"]) == 130
    assert capsys.readouterr().err == "pool2d: interrupted; nothing was saved\n"
    assert load_player(path).measured == Rates()


def test_one_process_measures(tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rates, "_done", lambda find, player, seed, number: rates.Piece(1.0, 1.0))
    assert "10 balls in ten racks, grade D" in said(capsys, "--measure", "ida", "--jobs", "1")


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["--measure", "idda"], "player = 'idda': unknown; did you mean ida?"),
        (["--measure", "ida", "--seed", "-1"], "--seed = -1.0: allowed is a number from 0"),
        (["--save"], "--save = True: allowed is only with --measure"),
        (["--seed", "3"], "--seed = '3': allowed is only with --measure"),
        (["--jobs", "3"], "--jobs = '3': allowed is only with --measure"),
        (["ida"], "unrecognized arguments: ida"),
    ],
)
def test_what_is_refused(capsys: Capture, words: list[str], told: str) -> None:
    assert told in refusal(capsys, "players", *words)
