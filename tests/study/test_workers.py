"""Processes that play: they end with whoever started them, and are missed where they end too early."""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from pool2d import Shot, WorkerError, simulate_many
from pool2d.study import simulate_many as many
from pool2d.study.workers import processes

from .many import LAYOUT, SHOTS, TABLE, Here

ROOT = Path(__file__).resolve().parents[2]
ENDLESS = """
import itertools, multiprocessing
from pool2d import Ball, Layout, Shot, load_table
from pool2d.study.simulate_many import each_chunk

if __name__ == "__main__":
    layout = Layout([Ball("cue", 0.6, 0.6), Ball("1", 1.9, 0.64)])
    parts = each_chunk(load_table("pool-9ft"), layout, itertools.repeat(Shot()), chunk=1, workers=2)
    next(parts)
    print(*(child.pid for child in multiprocessing.active_children()), flush=True)
    for part in parts:
        pass
"""


def alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    # One that has ended and that nobody has asked for is still listed.
    state = Path(f"/proc/{process}/stat")
    return not state.exists() or state.read_text().rpartition(")")[2].split()[0] != "Z"


@pytest.mark.skipif(sys.platform == "win32", reason="signals are POSIX")
@pytest.mark.parametrize("end", [signal.SIGINT, signal.SIGKILL])
def test_processes_end_with_the_one_that_started_them(end: signal.Signals, tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(ENDLESS)
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    run = subprocess.Popen(
        [sys.executable, script],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=environment,
        start_new_session=True,
        # A shell lets what it starts in the background ignore Ctrl-C, and that is handed down.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    try:
        _end_with(run, end)
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(run.pid, signal.SIGKILL)


def _end_with(run: subprocess.Popen[bytes], end: signal.Signals) -> None:
    assert run.stdout is not None
    workers = [int(word) for word in run.stdout.readline().split()]
    assert len(workers) == 2
    assert all(map(alive, workers))
    if end == signal.SIGINT:
        # As a terminal does: Ctrl-C goes to all that were started from it.
        os.killpg(run.pid, end)
    else:
        run.send_signal(end)
    _, complaints = run.communicate(timeout=60)
    assert run.returncode != 0
    # Nobody but the one that was asked to end says so.
    assert complaints.count(b"Traceback") == (end == signal.SIGINT)
    for _ in range(600):
        if not any(map(alive, workers)):
            return
        time.sleep(0.1)
    pytest.fail("a worker outlives the one that started it")


def test_ctrl_c_is_for_the_one_that_started_them() -> None:
    with processes(1) as pool:
        pool.submit(signal.raise_signal, signal.SIGINT).result(timeout=60)
        assert pool.submit(int, "7").result(timeout=60) == 7


def test_a_process_that_dies_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(many, "processors", lambda: 2)

    def shots() -> Iterator[Shot]:
        yield from SHOTS * 2
        for child in multiprocessing.active_children():
            child.kill()
        yield from SHOTS * 2

    with pytest.raises(WorkerError, match=r"the shots after the first \d+ did not come back .*BrokenProcessPool"):
        simulate_many(TABLE, LAYOUT, shots(), chunk=10)
    assert multiprocessing.active_children() == []


def test_processes_that_cannot_begin_are_told_with_the_usual_reason() -> None:
    with (
        ProcessPoolExecutor(1, multiprocessing.get_context("spawn"), initializer=os._exit, initargs=(3,)) as pool,
        pytest.raises(WorkerError, match="below `if __name__ == '__main__':`") as told,
    ):
        simulate_many(TABLE, LAYOUT, SHOTS, executor=pool, chunk=10)
    assert told.value.done == 0


def test_an_executor_that_takes_no_more_is_told() -> None:
    class Tired(Here):
        def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
            if self.tasks == 2:
                raise RuntimeError("cannot schedule new futures after shutdown")
            return super().submit(fn, *args, **kwargs)

    executor: Executor = Tired()
    with pytest.raises(WorkerError, match="RuntimeError: cannot schedule new futures after shutdown"):
        simulate_many(TABLE, LAYOUT, SHOTS, executor=executor, chunk=10)
