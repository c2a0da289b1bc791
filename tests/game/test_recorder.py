"""Writing records: each action is on the disk before the game goes on."""

from __future__ import annotations

import errno
import os
import subprocess
import sys
from pathlib import Path

import pytest

from benchmarks import replays
from benchmarks.random_play import new_match
from pool2d import InputError, Shot
from pool2d.game.actions import Concede, Stroke
from pool2d.game.records.record import load, matches_folder
from pool2d.game.records.recorder import record, records, remove, resume, unfinished
from pool2d.game.records.replaying import verify

from .record_files import played_on

ROOT = Path(__file__).resolve().parents[2]


def test_unfinished_matches_are_offered_the_latest_first(tmp_path: Path) -> None:
    assert unfinished() == []
    paths = []
    for seed in range(3):
        with record(new_match("nine-ball", seed)) as recorder:
            played_on(recorder, 2, seed=1)
        os.utime(recorder.path, (seed, seed))
        paths.append(recorder.path)
    with record(new_match("nine-ball", 9)):
        pass  # Nothing was played: nothing to resume.
    (matches_folder() / "noise.jsonl").write_text("noise")
    assert unfinished() == paths[::-1]
    assert unfinished(3) == [paths[2]]  # Beside the noise and the one that was not begun.
    remove(paths[1])
    assert unfinished() == [paths[2], paths[0]]
    assert len(records()) == 4 and paths[1] not in records()
    with resume(paths[2]) as recorder:
        recorder.play(Concede(0))
        assert recorder.match.over
    assert unfinished() == [paths[0]]
    assert verify(load(paths[2])) is None
    with resume(paths[2]) as recorder:
        recorder.undo()
    assert set(unfinished()) == {paths[0], paths[2]}


def test_two_windows_do_not_write_one_record() -> None:
    if sys.platform == "win32":
        pytest.skip("Windows has no such locks")
    with record(new_match("nine-ball", 3)) as recorder:
        played_on(recorder, 2, seed=1)
        before = recorder.path.read_bytes()
        with pytest.raises(InputError, match="is being played in another window"):
            resume(recorder.path)
    assert recorder.path.read_bytes() == before


def test_a_full_disk_stops_the_record_not_the_match(monkeypatch: pytest.MonkeyPatch) -> None:
    recorder = record(new_match("practice", 3))
    recorder.play(Stroke(Shot(10.0, 1.0)))
    whole = recorder.path.read_bytes()
    write = os.write

    def full(file: int, data: bytes) -> int:
        write(file, bytes(data)[:10])
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "write", full)
    recorder.play(Stroke(Shot(20.0, 1.0)))
    monkeypatch.undo()
    assert "No space left on device" in str(recorder.fault)
    recorder.play(Stroke(Shot(30.0, 1.0)))
    assert len(recorder.match.history) == 4
    assert recorder.path.read_bytes() == whole


def test_a_match_begun_on_a_full_disk_is_refused_and_leaves_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    write = os.write

    def full(file: int, data: bytes) -> int:
        write(file, bytes(data)[:10])
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(os, "write", full)
        with pytest.raises(InputError, match="cannot be written: No space left on device"):
            record(new_match("practice", 3))
    assert records() == []
    record(new_match("practice", 3)).close()
    assert len(records()) == 1


def test_a_record_is_never_written_over(tmp_path: Path) -> None:
    path = tmp_path / "a.jsonl"
    path.write_text("mine")
    with pytest.raises(InputError, match="is there already"):
        record(new_match("practice", 3), path)
    assert path.read_text() == "mine"
    with pytest.raises(InputError, match="cannot be written"):
        record(new_match("practice", 3), path / "b.jsonl")
    with pytest.raises(InputError, match="cannot be read: No such file"):
        resume(tmp_path / "none.jsonl")


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such locks")
def test_where_nothing_can_be_locked_no_match_is_recorded_and_nothing_is_left(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import fcntl

    def refuse(*_: object) -> None:
        raise OSError(errno.EAGAIN, "busy")

    monkeypatch.setattr(fcntl, "flock", refuse)
    with pytest.raises(InputError):
        record(new_match("practice", 3), tmp_path / "a.jsonl")
    assert list(tmp_path.glob("*.jsonl")) == []


def test_a_record_is_begun_by_its_first_action(tmp_path: Path) -> None:
    with record(new_match("nine-ball", 3), tmp_path / "a.jsonl") as recorder:
        assert not recorder.begun
        played_on(recorder, 1, seed=1)
        assert recorder.begun
    with resume(tmp_path / "a.jsonl") as recorder:
        assert recorder.begun


def test_records_begun_in_the_same_second_have_names_of_their_own() -> None:
    recorders = [record(new_match("practice", seed)) for seed in range(3)]
    for recorder in recorders:
        recorder.close()
    assert len(list(matches_folder().iterdir())) == 3


@pytest.mark.skipif(not hasattr(os, "fork"), reason="a process is killed that was forked")
def test_a_few_kills_lose_nothing() -> None:
    words = [sys.executable, "-m", "benchmarks.kills", "--kills", "4"]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False, timeout=60)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("4 kills, ")
    assert ", 0 faults; " in done.stdout


def test_a_random_match_of_a_game_comes_back() -> None:
    for what, _ in (replays.attempt(("nine-ball", 4)), replays.attempt(("practice", 4))):
        assert what == ""
