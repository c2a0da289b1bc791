"""How far a long task has come, told on a terminal and nowhere else."""

from __future__ import annotations

import io

import pytest

from pool2d.commands.progress import Progress


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


class Clock:
    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture(autouse=True)
def columns(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "100")


def test_it_tells_the_share_the_rate_and_the_time_left() -> None:
    stream, clock = Terminal(), Clock()
    progress = Progress(10_000, 2_000, stream, clock)
    clock.now += 4.0
    progress.went(2_000)
    # What was there before this run does not count as fast.
    assert progress.line() == f"[{'#' * 16}{'.' * 24}]  40 %  4,000 of 10,000  500/s  0:12 left"
    assert stream.getvalue().endswith(f"\r{progress.line()}\x1b[K")
    clock.now += 4_000.0
    progress.went(10)
    assert progress.line().endswith("0.5/s  3:18:52 left")
    progress.end()
    progress.end()
    assert stream.getvalue().count("\n") == 1


def test_it_is_drawn_now_and_then_and_at_the_end() -> None:
    stream, clock = Terminal(), Clock()
    progress = Progress(1_000, 0, stream, clock)
    for _ in range(1_000):
        clock.now += 0.001
        progress.went(1)
    assert 10 <= stream.getvalue().count("\r") <= 13
    assert "100 %  1,000 of 1,000" in stream.getvalue().rpartition("\r")[2]


def test_a_narrow_terminal_gets_the_numbers_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "30")
    assert Progress(10, 1, Terminal(), Clock()).line() == "10 %  1 of 10  0.0/s  ..."


def test_nobody_else_sees_it() -> None:
    stream = io.StringIO()
    progress = Progress(10, 0, stream, Clock())
    progress.went(10)
    progress.end()
    assert stream.getvalue() == ""


def test_a_terminal_that_goes_is_no_reason_to_stop() -> None:
    stream = Terminal()
    progress = Progress(10, 0, stream, Clock())
    stream.close()
    progress.went(10)
    progress.end()
    assert progress.done == 10


def test_nothing_to_do_is_done() -> None:
    assert "100 %  0 of 0" in Progress(0, 0, Terminal(), Clock()).line()
