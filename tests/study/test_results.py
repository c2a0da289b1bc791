"""Results: a CSV file that goes on where it was, and what is made of it."""

from __future__ import annotations

import csv
import itertools
import json
import math
from concurrent.futures import Executor, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pool2d import InputError, Summaries, simulate_many
from pool2d.study.findings import MARGIN, cell_of, columns_of, findings
from pool2d.study.results import Results, header, rows
from pool2d.study.simulate_many import each_chunk
from pool2d.study.study_file import load_study

from .many import LAYOUT, MIXED, TABLE, WRONG, Here
from .studies import SCENARIO, SHOTS, SWEEP, written

MANY = simulate_many(TABLE, LAYOUT, MIXED, executor=Here())
COLUMNS = header(MANY)


def parts(chunk: int = 10, start: int = 0, executor: Executor | None = None) -> list[Summaries]:
    return list(each_chunk(TABLE, LAYOUT, MIXED[start:], executor=executor or Here(), chunk=chunk))


def file_of(path: Path, some: list[Summaries], stamp: str = "abc") -> bytes:
    """The file as it is once these parts are added to what is there."""
    with Results(path, COLUMNS, stamp) as results:
        for part in some:
            results.add(part)
    return path.read_bytes()


@pytest.fixture
def whole(tmp_path: Path) -> bytes:
    return file_of(tmp_path / "whole.csv", parts())


def test_rows_tell_everything_to_the_bit(whole: bytes) -> None:
    told = list(csv.DictReader(whole.decode().splitlines()))
    assert len(told) == len(MIXED)
    for number, row in enumerate(told):
        assert (row["study"], row["shot"]) == ("abc", str(number))
        assert float(row["angle"]) == MANY.angle[number]
        if number in WRONG:
            assert (row["error"], row["duration"], row["1.x"]) == (MANY.error[number], "", "")
            assert json.loads(row["scenario"]) == json.loads(json.dumps(MANY.scenarios[number]))
            continue
        assert (row["error"], row["scenario"]) == ("", "")
        assert (float(row["duration"]), int(row["events"])) == (MANY.duration[number], MANY.events[number])
        assert (row["scratch"], row["miscue"]) == (str(int(MANY.scratch[number])), str(int(MANY.miscue[number])))
        for i, ball in enumerate(MANY.balls):
            x = MANY.x[number, i]
            assert row[f"{ball}.x"] == ("" if math.isnan(x) else repr(float(x)))
            assert int(row[f"{ball}.cushions"]) == MANY.cushions[number, i]


def test_the_bytes_are_the_same_whoever_played(whole: bytes, tmp_path: Path) -> None:
    with ThreadPoolExecutor(2) as threads:
        assert file_of(tmp_path / "a.csv", parts(3, executor=threads)) == whole
    assert file_of(tmp_path / "b.csv", parts(1)) == whole


@pytest.mark.parametrize("left", [0, 3, 40, 0.3, 0.5, 0.77, 1.0])
def test_it_goes_on_after_any_kill(left: float, whole: bytes, tmp_path: Path) -> None:
    file = tmp_path / "killed.csv"
    file.write_bytes(whole[: int(left * len(whole)) if isinstance(left, float) else left])
    with Results(file, COLUMNS, "abc") as results:
        assert results.count == max(0, whole[: file.stat().st_size].count(b"\n") - 1)
        start = results.count
        for part in parts(7, start) if start < len(MIXED) else []:
            # Scenarios are told of by the rows of the part that they came in.
            results.add(part)
    assert file.read_bytes() == whole


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [(b"abc,7,", b"abd,7,", 9), (b"abc,7,", b"abc,8,", 9), (b"study,shot", b"study,shots", 1), (b"1.x", b"2.x", 1)],
)
def test_the_results_of_another_study_are_left_alone(
    old: bytes, new: bytes, line: int, whole: bytes, tmp_path: Path
) -> None:
    file = tmp_path / "other.csv"
    spoiled = whole.replace(old, new, 1)
    file.write_bytes(spoiled)
    with pytest.raises(InputError, match=rf"other\.csv, line {line}: belongs to another study") as told:
        Results(file, COLUMNS, "abc")
    assert told.value.line == line
    assert file.read_bytes() == spoiled


def test_what_cannot_be_written_is_told(tmp_path: Path) -> None:
    for path, said in ((tmp_path, "it is a folder"), (tmp_path / "gone" / "a.csv", "No such file or directory")):
        with pytest.raises(InputError, match=f"cannot be written: {said}"):
            Results(path, COLUMNS, "abc")


def found(tmp_path: Path, text: str) -> tuple[Any, Any, list[dict[str, str]]]:
    """A study, what it found, and its rows."""
    study = load_study(written(tmp_path, text), {}, [])
    file = tmp_path / "found.csv"
    with Results(file, header(simulate_many(study.table, study.layout, [])), "x") as results:
        for part in each_chunk(study.table, study.layout, study.sweep.shots(), executor=Here()):
            results.add(part)
    with open(file, newline="") as opened:
        told = list(csv.DictReader(opened))
    return study, findings(study, rows(file, columns_of(study))), told


def test_a_map_has_the_mean_of_its_cells(tmp_path: Path) -> None:
    text = SCENARIO + SWEEP.replace("side = [0.0, 0.9]", "speed = [3.0, 1.0]").replace("height = [-0.5, 0.0]", "")
    study, seen, told = found(tmp_path, text)
    assert study.axes == ("speed", "angle")
    assert (seen.heat.x.values, seen.heat.y.values) == ((1.0, 3.0), study.sweep.grid["angle"])
    expected: dict[tuple[float, float], list[float]] = {}
    for number, row in enumerate(told):
        speed, angle = (3.0, 1.0)[number // 15], study.sweep.grid["angle"][number // 3 % 5]
        expected.setdefault((angle, speed), []).append(float(row["1.pocket"] != ""))
    for y, angle in enumerate(seen.heat.y.values):
        for x, speed in enumerate(seen.heat.x.values):
            assert seen.heat.mean[y, x] == pytest.approx(sum(expected[angle, speed]) / 3.0)
    assert 0.0 < seen.heat.mean.mean() < 1.0
    assert (seen.shots, seen.failed) == (len(told), 0)


def test_what_only_errs_is_mapped_by_what_was_played(tmp_path: Path) -> None:
    text = SCENARIO + "[noise]\nangle = 0.5\nelevation = 1.0\n[study]\nshots = 300\noutcome = 'duration'\n"
    _, seen, told = found(tmp_path, text)
    across, up = seen.heat.x.values, seen.heat.y.values
    assert (len(across), across[0], across[-1]) == (5, pytest.approx(13.8), pytest.approx(16.2))
    # A butt cannot be lower than level.
    assert (up[0], up[-1]) == (pytest.approx(0.3), pytest.approx(2.7))
    cells = itertools.product(enumerate(across), enumerate(up))
    for (i, x), (j, y) in cells:
        inside = [
            float(row["duration"])
            for row in told
            if abs(float(row["angle"]) - x) < 0.3 + 1e-9 and abs(float(row["elevation"]) - y) < 0.3 + 1e-9
        ]
        # A handful of shots at least, or nothing is said of them.
        assert (len(inside) >= 5) == math.isfinite(seen.heat.mean[j, i])
        if len(inside) >= 5:
            assert seen.heat.mean[j, i] == pytest.approx(sum(inside) / len(inside))
    assert 0 < np.isnan(seen.heat.mean).sum() < 20


def test_rests_are_counted_where_they_are(tmp_path: Path) -> None:
    _, seen, told = found(tmp_path, SCENARIO + SWEEP)
    places = [(float(row["cue.x"]), float(row["cue.y"])) for row in told if row["cue.x"]]
    assert seen.rests.counts.sum() == len(places)
    for x, y in places:
        assert seen.rests.counts[cell_of(y), cell_of(x)] >= 1.0
    assert seen.rests.counts.shape == (cell_of(1.27 + MARGIN) + 1, cell_of(2.54 + MARGIN) + 1)
    assert (seen.shots, seen.failed) == (SHOTS, sum(bool(row["error"]) for row in told))
    assert 0 < seen.failed < SHOTS


def test_a_table_without_two_things_swept_has_no_map(tmp_path: Path) -> None:
    _, seen, _ = found(tmp_path, SCENARIO + "[grid]\nspeed = [1.0, 2.0]\n")
    assert seen.heat is None
