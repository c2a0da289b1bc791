"""The fuzzer of the benchmarks: that it runs, and that it sees what it looks for."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from benchmarks.fuzz import examine, faults, play
from benchmarks.wide import wide
from pool2d import Ball, Layout, Rollout, load_table, simulate
from pool2d.physics.values import ROLLING

TABLE = load_table("pool-9ft")


def test_shots_are_sound() -> None:
    results = [play(TABLE, 1, number) for number in range(150)]
    assert [result for result in results if result.faults] == []
    assert sum(result.events for result in results) > 1500


def test_shots_from_the_whole_range_of_everything_are_sound() -> None:
    results = [examine(number, *wide(f"1 {number}")) for number in range(60)]
    assert [result for result in results if result.faults] == []
    assert sum(result.events for result in results) > 500


def overlap(roll: Rollout) -> None:
    roll.tracks["1"][0].x, roll.tracks["1"][0].y = 0.65, 0.6


def leave(roll: Rollout) -> None:
    roll.tracks["1"][0].y = 5.0


def lean(roll: Rollout) -> None:
    roll.tracks["1"][0].y = 0.02


def vanish(roll: Rollout) -> None:
    roll.tracks["1"][0].x = math.nan


def hasten(roll: Rollout) -> None:
    for event in roll.events:
        event._new[0].vx += 1.0


def go_on(roll: Rollout) -> None:
    roll.tracks["cue"][-1].phase = ROLLING


def go_back(roll: Rollout) -> None:
    roll.events[0].t = 100.0


@pytest.mark.parametrize(
    ("spoil", "fault"),
    [
        (overlap, "overlap by"),
        (leave, "off the table"),
        (lean, "inside bottom-left"),
        (vanish, "nowhere"),
        (hasten, "energy rises"),
        (go_on, "not all balls are at rest"),
        (go_back, "time runs backward"),
    ],
)
def test_faults_are_seen(spoil: Callable[[Rollout], None], fault: str) -> None:
    roll = simulate(TABLE, Layout([Ball("cue", 0.6, 0.6, 1.0), Ball("1", 1.0, 0.9)]))
    assert list(faults(TABLE, roll)) == []
    spoil(roll)
    assert any(fault in text for text in faults(TABLE, roll))
