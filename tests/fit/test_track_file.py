"""Files of tracked shots: what they say is read, and what is wrong with them is told in a line."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from pool2d import InputError
from pool2d.fit import track_file
from pool2d.fit.track_file import read_tracks

ROWS = "shot,time,ball,x,y\n1,0.02,cue,0.5,0.4\n1,0.0,cue,0.51,0.4\n1,0.0,red,1,0.7\n2,-1,cue,0.5,0.5\n"
JSON = {
    "table": "carom-10ft",
    "radius": 0.0305,
    "shots": [{"shot": 7, "tracks": {"cue": [[0, 0.5, 0.4], [0.02, 1, 1]]}}],
}


def written(folder: Path, text: str, name: str = "shots.csv") -> Path:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def complaint(folder: Path, text: str, name: str = "shots.csv") -> str:
    path = written(folder, text, name)
    with pytest.raises(InputError) as found:
        read_tracks(path)
    assert str(found.value).startswith(str(path))
    return str(found.value).removeprefix(str(path))


def test_rows_are_shots_of_balls_in_order_of_time(tmp_path: Path) -> None:
    found = read_tracks(written(tmp_path, ROWS))
    first, second = found.shots
    assert (first.name, second.name) == ("1", "2")
    assert first.tracks["cue"].t.tolist() == [0.0, 0.02]
    assert first.tracks["cue"].x.tolist() == [0.51, 0.5]
    assert (first.points, first.start, first.end, second.start) == (3, 0.0, 0.02, -1.0)
    assert (found.table, found.radius) == (None, None)


@pytest.mark.parametrize(
    "text",
    [
        ROWS.replace("\n", "\r\n"),
        "\ufeff" + ROWS,
        ROWS.replace("\n", "\n\n"),
        ROWS.replace(",", " , "),
        "note," + ROWS.replace("\n", "\nfine,").removesuffix("fine,"),
    ],
    ids=["dos", "mark", "empty lines", "blanks", "another column"],
)
def test_rows_may_be_written_in_several_ways(tmp_path: Path, text: str) -> None:
    path = tmp_path / "shots.csv"
    path.write_bytes(text.encode())
    assert [list(shot.tracks) for shot in read_tracks(path).shots] == [["cue", "red"], ["cue"]]


def test_json_names_its_table_too(tmp_path: Path) -> None:
    found = read_tracks(written(tmp_path, json.dumps(JSON), "shots.json"))
    assert (found.table, found.radius) == ("carom-10ft", 0.0305)
    assert [shot.name for shot in found.shots] == ["7"]
    assert found.shots[0].tracks["cue"].y.tolist() == [0.4, 1.0]


def test_one_shot_needs_no_name_and_time_may_be_t(tmp_path: Path) -> None:
    rows = "t,ball,x,y\n0.02,cue,0.5,0.4\n0,cue,0.51,0.4\n0,red,1,0.7\n"
    (shot,) = read_tracks(written(tmp_path, rows)).shots
    assert (shot.name, list(shot.tracks), shot.tracks["cue"].x.tolist()) == ("1", ["cue", "red"], [0.51, 0.5])


def test_json_may_be_a_list_of_points(tmp_path: Path) -> None:
    points = [
        {"time": 0.02, "ball": "cue", "x": 0.5, "y": 0.4},
        {"t": 0, "ball": "cue", "x": 0.51, "y": 0.4},
        {"t": 0, "ball": "cue", "x": 0.51, "y": 0.4, "shot": "b"},
    ]
    found = read_tracks(written(tmp_path, json.dumps(points), "shots.json"))
    assert [(shot.name, shot.points) for shot in found.shots] == [("1", 2), ("b", 1)]


@pytest.mark.parametrize(
    ("point", "told"),
    [
        (7, ": [1] = 7: allowed is an object with shot, time, ball, x, y"),
        ({"t": 0, "ball": "cue", "x": 1, "y": 1, "z": 1}, ": [1].z = 1: unknown"),
        ({"t": 0, "ball": "cue", "x": 1}, ": [1].y = None: allowed is a number"),
        ({"t": 0, "ball": 3, "x": 1, "y": 1}, ": [1].ball = 3: allowed is a text"),
    ],
)
def test_wrong_points_are_told(tmp_path: Path, point: Any, told: str) -> None:
    good = {"t": 0.1, "ball": "cue", "x": 1.0, "y": 1.0}
    assert complaint(tmp_path, json.dumps([good, point]), "shots.json").startswith(told)


def test_many_points_are_read(tmp_path: Path) -> None:
    """More than other files may hold."""
    points = [[i / 50, 0.5, 0.4] for i in range(30_000)]
    data = {"shots": [{"shot": "a", "tracks": {"cue": points}}]}
    assert read_tracks(written(tmp_path, json.dumps(data), "shots.json")).shots[0].points == 30_000


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", ", line 1: time = None: missing; the first line has to name shot, time, ball, x, y"),
        ("shot,time,ball,x\n", ", line 1: y = None: missing; the first line has to name shot, time, ball, x, y"),
        ("shot,time,ball,x,y,x\n", ", line 1: x = None: is there twice"),
        ("shot,time,ball,x,y\n", ": has 0 shots; allowed are 1 to 10000"),
        (ROWS + "3,0,cue\n", ", line 6: has 3 values; needed are shot, time, ball, x, y"),
        (ROWS + "3,soon,cue,1,1\n", ", line 6: time = 'soon': allowed is a number from -1e+06 to 1e+06 s"),
        (ROWS + "3,0,cue,nan,1\n", ", line 6: x = nan: allowed is a number from -100 to 100 m"),
        (ROWS + "3,0,cue,1,700\n", ", line 6: y = 700.0: allowed is a number from -100 to 100 m"),
        (ROWS + ",0,cue,1,1\n", ", line 6: shot = '': allowed is a name or number of up to 60 characters"),
        (ROWS + "3,0,,1,1\n", ", line 6: ball = '': allowed is a text of printable characters"),
        (ROWS + "1,0.02,cue,1,1\n", ": shot 1, ball cue, time = 0.02: the ball was seen twice at this time"),
        (ROWS + '3,0,"cue,1,1\n', ": not a CSV file"),
        ("\x00" * 50, ", line 1: time = None: missing"),
    ],
)  # fmt: skip
def test_wrong_rows_are_told(tmp_path: Path, text: str, told: str) -> None:
    assert complaint(tmp_path, text).startswith(told)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"tables": 1}, ": tables = 1: unknown; did you mean table?"),
        ({"table": 3}, ": table = 3: allowed is a preset's name"),
        ({"radius": 3.0}, ": radius = 3.0: allowed is a number from 0.01 to 0.06 m"),
        ({"shots": {}}, ": shots = {}: allowed is a list of shots"),
        ({"shots": []}, ": has 0 shots"),
        ({"shots": [1]}, ": shots[0] = 1: allowed is a shot: shot, tracks"),
        ({"shots": [{"shot": "a", "tracks": []}]}, ": shots[0].tracks = []: allowed are lists of [time, x, y]"),
        ({"shots": [{"tracks": {"cue": [[0, 1, 1]]}}]}, ": shots[0].shot = None: allowed is a name"),
        ({"shots": [{"shot": True, "tracks": {"cue": [[0, 1, 1]]}}]}, ": shots[0].shot = True: allowed is a name"),
        ({"shots": [{"shot": "a", "tracks": {"cue": []}}]}, ": shot a, ball cue = []: needed is one place"),
        ({"shots": [{"shot": "a", "tracks": {"cue": [[0, 1]]}}]}, ": shots[0].tracks.cue[0] = [0, 1]: allowed is ["),
        ({"shots": [{"shot": "a", "tracks": {"cue": [[0, 1, "1"]]}}]}, ": shots[0].tracks.cue[0] = '1': allowed is"),
        ({"shots": [{"shot": 1, "tracks": {"a": [[0, 1, 1]]}}] * 2}, ": shots[1].shot = '1': another shot has this"),
    ],
)  # fmt: skip
def test_wrong_json_is_told(tmp_path: Path, change: dict[str, Any], told: str) -> None:
    assert complaint(tmp_path, json.dumps({**JSON, **change}), "shots.json").startswith(told)


def test_other_files_are_refused(tmp_path: Path) -> None:
    assert "ends in .csv or .json" in complaint(tmp_path, ROWS, "shots.txt")
    assert "not a JSON file" in complaint(tmp_path, "[", "shots.json")
    assert "allowed is an object with table" in complaint(tmp_path, "3", "shots.json")
    with pytest.raises(InputError, match="cannot be read"):
        read_tracks(tmp_path / "none.csv")


def test_too_much_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(track_file, "_MOST_POINTS", 3)
    assert complaint(tmp_path, ROWS) == ": too many rows; allowed are 3"
    monkeypatch.undo()
    monkeypatch.setattr(track_file, "_MOST_SHOTS", 1)
    assert complaint(tmp_path, ROWS) == ": has 2 shots; allowed are 1 to 1"
    monkeypatch.setattr(track_file, "_LARGEST", 1 << 10)
    assert complaint(tmp_path, ROWS * 20) == ": too large; allowed are 1 KiB"
