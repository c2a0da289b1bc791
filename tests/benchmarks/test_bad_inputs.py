"""Some of the bad inputs of `benchmarks.bad_inputs`, and that it notices what is wrong."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from benchmarks import bad_inputs
from pool2d import InputError


def test_bad_inputs_are_answered_in_one_line() -> None:
    faults, seen, _ = bad_inputs.run(150, seed=7)
    # How long it takes is the benchmark's to say: the machine may be busy.
    assert [fault for fault in faults if not fault.what.endswith(" s")] == []
    assert len({name.partition(",")[0] for name in seen}) == 13
    assert sum(count for name, count in seen.items() if name.endswith("2")) > 50


def refuse(path: Path) -> int:
    raise InputError(str(path), "", None, "no")


def crash(path: Path) -> int:
    raise KeyError(path)


def steer(path: Path) -> int:
    print("\x1b[2J")
    return 0


def leave(path: Path) -> int:
    raise SystemExit(2)


@pytest.mark.parametrize(
    ("take", "words"),
    [
        (lambda path: 0, ""), (refuse, ""), (crash, "KeyError"), (steer, "steer a terminal"), (leave, "would end"),
        (lambda path: 3, "exit status 3"), (lambda path: 2, "exit status 2 with 0 lines"),
    ],
)  # fmt: skip
def test_a_wrong_answer_is_noticed(take: Callable[[Path], int], words: str) -> None:
    wrong = bad_inputs.tried("any", Path("a.toml"), take)[2]
    assert words in wrong and bool(words) == bool(wrong)
