"""Many shots for tests, and what it means that two sets of summaries are equal."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor, Future
from typing import Any, ParamSpec, TypeVar

import numpy as np

from pool2d import Ball, Layout, Shot, Summaries, load_table

TABLE = load_table("pool-9ft")
LAYOUT = Layout([Ball("cue", 0.6, 0.6), Ball("1", 1.9, 0.64), Ball("2", 2.3, 1.1), Ball("3", 0.3, 1.2417)])
SHOTS = [Shot(angle=-20.0 + i, speed=1.0 + 0.2 * i, side=0.01 * i, height=0.3 - 0.02 * i) for i in range(40)]
# What cannot be played stands between what can.
WRONG = {3: Shot(speed=99.0), 11: Shot(ball="9"), 12: Shot(side=0.9, height=0.9), 39: Shot(elevation=-1.0)}
MIXED = [WRONG.get(number, shot) for number, shot in enumerate(SHOTS)]

P = ParamSpec("P")
R = TypeVar("R")


class Here(Executor):
    """Carries tasks out at once, where they are submitted, and counts them."""

    def __init__(self) -> None:
        self.tasks = 0

    def submit(self, fn: Callable[P, R], /, *args: P.args, **kwargs: P.kwargs) -> Future[R]:
        self.tasks += 1
        future: Future[R] = Future()
        future.set_result(fn(*args, **kwargs))
        return future


class Backwards(Here):
    """Carries out what was submitted last first, but only when it has so many tasks."""

    def __init__(self, tasks: int) -> None:
        super().__init__()
        self.left = tasks
        self.waiting: list[Callable[[], None]] = []

    def submit(self, fn: Callable[P, R], /, *args: P.args, **kwargs: P.kwargs) -> Future[R]:
        future: Future[R] = Future()
        self.waiting.append(lambda: future.set_result(fn(*args, **kwargs)))
        self.left -= 1
        if not self.left:
            for task in reversed(self.waiting):
                task()
        return future


def assert_equal(a: Summaries, b: Summaries) -> None:
    """To the bit, errors and scenarios too."""
    assert (a.balls, a.pockets, a.scenarios) == (b.balls, b.pockets, b.scenarios)
    left, right = a.columns(), b.columns()
    assert list(left) == list(right)
    for name in left:
        assert left[name].dtype == right[name].dtype, name
        assert same(left[name], right[name]), name


def same(left: np.ndarray[Any, Any], right: np.ndarray[Any, Any]) -> bool:
    return left.tobytes() == right.tobytes() if left.dtype != object else left.tolist() == right.tolist()
