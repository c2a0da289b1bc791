"""`pool2d study`: results and pictures, the same bytes however it is played, gone on with where it was left."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pygame
import pytest

from pool2d import Summaries, WorkerError
from pool2d.cli import main
from pool2d.commands import study as command
from pool2d.draw.export import heat_map
from pool2d.study import simulate_many as many

from ..study.studies import SCENARIO, SHOTS, SWEEP, played, written
from .cli_runs import ROOT, Capture, refusal

NAMES = {"study.toml", "study.csv", "study-map.png", "study-rests.png"}


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """The results of a study that nothing interrupted."""
    folder = tmp_path_factory.mktemp("whole")
    assert played(written(folder)) == 0
    return (folder / "study.csv").read_bytes()


def test_results_and_pictures_lie_beside_the_study(tmp_path: Path, capsys: Capture, whole: bytes) -> None:
    assert played(written(tmp_path)) == 0
    assert {path.name for path in tmp_path.iterdir()} == NAMES
    told = capsys.readouterr()
    # Without a terminal there is no progress to see.
    assert told.err == ""
    failed = whole.count(b"the tip is off the ball")
    assert told.out.splitlines() == [
        f"{tmp_path / 'study-map.png'}: written",
        f"{tmp_path / 'study-rests.png'}: written",
        f"{tmp_path / 'study.csv'}: {SHOTS} shots, {failed} of them failed",
    ]
    assert (tmp_path / "study.csv").read_bytes() == whole
    for name in ("study-map.png", "study-rests.png"):
        assert pygame.image.load(tmp_path / name).get_size() == (320, 180)


def test_processes_write_the_same_bytes(tmp_path: Path, whole: bytes, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(many, "CHUNK", 7)
    file = written(tmp_path)
    assert main(["study", str(file), "--workers", "2", "--size", "320x180", "--out", str(tmp_path / "two.csv")]) == 0
    assert (tmp_path / "two.csv").read_bytes() == whole


def test_a_study_that_is_whole_is_only_drawn_again(
    tmp_path: Path, capsys: Capture, whole: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = written(tmp_path)
    (tmp_path / "study.csv").write_bytes(whole)
    monkeypatch.setattr(command, "each_chunk", None)
    assert played(file) == 0
    assert {path.name for path in tmp_path.iterdir()} == NAMES
    assert capsys.readouterr().out.count("written") == 2


def test_a_study_goes_on_where_it_was_killed(tmp_path: Path, whole: bytes, monkeypatch: pytest.MonkeyPatch) -> None:
    file = written(tmp_path)
    (tmp_path / "study.csv").write_bytes(whole[: len(whole) // 2])
    there = whole[: len(whole) // 2].count(b"\n") - 1
    counted: list[int] = []
    real = many.each_chunk

    def counting(*arguments: Any, **options: Any) -> Iterator[Summaries]:
        for part in real(*arguments, **options):
            counted.append(len(part))
            yield part

    monkeypatch.setattr(command, "each_chunk", counting)
    assert played(file) == 0
    assert sum(counted) == SHOTS - there
    assert (tmp_path / "study.csv").read_bytes() == whole


@pytest.mark.parametrize(("error", "status"), [(KeyboardInterrupt, 130), (WorkerError(3, "gone"), 2)])
def test_what_interrupts_it_leaves_what_was_played(
    error: BaseException | type[BaseException], status: int, tmp_path: Path, capsys: Capture, whole: bytes,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    real = many.each_chunk

    def failing(*arguments: Any, **options: Any) -> Iterator[Summaries]:
        parts = real(*arguments, chunk=8, **options)
        yield next(parts)
        yield next(parts)
        raise error

    monkeypatch.setattr(command, "each_chunk", failing)
    file = written(tmp_path)
    assert played(file) == status
    told = capsys.readouterr().err
    assert told.count("\n") == 1
    assert f"{tmp_path / 'study.csv'} has 16 of {SHOTS} shots, and the same command goes on from there" in told
    assert (tmp_path / "study.csv").read_bytes() == b"".join(whole.splitlines(keepends=True)[:17])
    monkeypatch.undo()
    assert played(file) == 0
    assert (tmp_path / "study.csv").read_bytes() == whole


def test_drawing_may_be_interrupted_too(
    tmp_path: Path, capsys: Capture, whole: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(heat_map, "draw", interrupted)
    assert played(written(tmp_path)) == 130
    assert capsys.readouterr().err == "pool2d: interrupted; the same command goes on from there\n"
    assert (tmp_path / "study.csv").read_bytes() == whole


@pytest.mark.skipif(sys.platform == "win32", reason="signals are POSIX")
@pytest.mark.parametrize("end", [signal.SIGKILL, signal.SIGINT])
def test_a_process_that_is_ended_loses_nothing(end: signal.Signals, tmp_path: Path) -> None:
    text = SCENARIO + SWEEP.replace("shots = 3", "shots = 40")
    file = written(tmp_path, text)
    words = [sys.executable, "-m", "pool2d", "study", str(file), "--size", "320x180", "--workers", "2"]
    run = subprocess.Popen(words, cwd=ROOT, stderr=subprocess.PIPE, env={**os.environ, "COLUMNS": "80"})
    out = tmp_path / "study.csv"
    for _ in range(1200):
        if out.exists() and out.stat().st_size > 20_000:
            break
        time.sleep(0.05)
    run.send_signal(end)
    _, complaint = run.communicate(timeout=60)
    assert run.returncode == (130 if end == signal.SIGINT else -end)
    if end == signal.SIGINT:
        assert complaint.count(b"\n") == 1, complaint
    left = out.read_bytes()
    assert 2 < left.count(b"\n") < 801
    assert played(file) == 0
    again = tmp_path / "again.csv"
    assert played(file, "--out", str(again)) == 0
    assert out.read_bytes() == again.read_bytes()
    assert out.read_bytes().startswith(left[: left.rindex(b"\n") + 1])


def test_results_of_another_study_are_refused_and_kept(tmp_path: Path, capsys: Capture, whole: bytes) -> None:
    file = written(tmp_path)
    out = tmp_path / "study.csv"
    out.write_bytes(whole)
    said = refusal(capsys, "study", str(file), "--set", "cloth.mu_roll=0.02")
    assert said.startswith(f"pool2d: {out}, line 2: belongs to another study")
    out.write_text("mine\n")
    assert refusal(capsys, "study", str(file)).startswith(f"pool2d: {out}, line 1: belongs to another study")
    assert out.read_text() == "mine\n"
    assert {path.name for path in tmp_path.iterdir()} == {"study.toml", "study.csv"}


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["--out", "x.txt"], "--out = 'x.txt': allowed is a name that ends in .csv or .parquet"),
        (["--out", "gone/x.csv"], "gone/x.csv: cannot be written: there is no such folder"),
        (["--out", ""], "--out = '': allowed is the name of a file"),
        (["--workers", "0"], "--workers = 0.0: allowed is a number from 1 to 60 processes"),
        (["--workers", "2.5"], "--workers = '2.5': allowed is a whole number"),
        (["--workers", "2", "--cluster", "tcp://x:1"], "--workers = 2: allowed is --workers or --cluster, not both"),
        (["--size", "9x9"], "--size = 9.0: allowed is a number from 64 to 8192 pixels"),
        (["--set", "cloth.mu=1"], "cloth.mu"),
    ],
)
def test_what_is_asked_wrongly_is_told_before_anything_is_played(
    words: list[str], told: str, tmp_path: Path, capsys: Capture
) -> None:
    assert told in refusal(capsys, "study", str(written(tmp_path)), *words)
    assert [path.name for path in tmp_path.iterdir()] == ["study.toml"]
