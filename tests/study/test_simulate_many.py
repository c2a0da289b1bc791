"""`simulate_many`: each row is what `simulate` says, whoever plays it, in whatever pieces."""

from __future__ import annotations

import itertools
import json
import math
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pool2d import Ball, BudgetError, InputError, Layout, Shot, load_scenario, load_table, simulate, simulate_many
from pool2d.game import observe
from pool2d.study import simulate_many as many
from pool2d.study import summarize as summarizing
from pool2d.study.simulate_many import each_chunk

from ..scenes import random_shot
from .many import LAYOUT, MIXED, SHOTS, TABLE, WRONG, Backwards, Here, assert_equal

ROOT = Path(__file__).resolve().parents[2]
EXPECTED = simulate_many(TABLE, LAYOUT, MIXED, executor=Here(), chunk=len(MIXED))


def test_a_row_is_what_simulate_says() -> None:
    for row, shot in enumerate(MIXED):
        if row in WRONG:
            continue
        roll = simulate(TABLE, LAYOUT, shot)
        assert (EXPECTED.angle[row], EXPECTED.speed[row]) == (shot.angle, shot.speed)
        assert (EXPECTED.side[row], EXPECTED.height[row], EXPECTED.elevation[row]) == (shot.side, shot.height, 0.0)
        assert (EXPECTED.duration[row], EXPECTED.events[row]) == (roll.duration, len(roll.events))
        assert EXPECTED.balls[EXPECTED.struck[row]] == "cue"
        for i, ball in enumerate(roll.layout().values()):
            place = (EXPECTED.x[row, i], EXPECTED.y[row, i])
            assert np.isnan(place).all() if ball.phase == "pocketed" else place == (ball.x, ball.y)


def test_what_fell_and_what_was_met_is_as_a_referee_sees_it() -> None:
    seen = set()
    for seed in range(12):
        table = load_table("pool-9ft")
        layout, _ = random_shot(table, seed)
        shots = [Shot(angle=37.0 * i, speed=1.0 + i, ball=next(iter(layout))) for i in range(6)]
        rows = simulate_many(table, layout, shots, executor=Here())
        for row, shot in enumerate(shots):
            report = observe(table, simulate(table, layout, shot), cue=shot.ball)
            fell = {b: rows.pockets[p] for b, p in zip(rows.balls, rows.pocket[row], strict=True) if p >= 0}
            assert fell == {c.ball: c.other for c in report.contacts if c.kind == "pocket"}
            assert (rows.scratch[row], rows.potted[row]) == (report.scratch, len(report.potted))
            assert (rows.balls[rows.first[row]] if rows.first[row] >= 0 else None) == next(iter(report.first), None)
            met = [c.ball for c in report.contacts if c.kind == "rail"]
            assert rows.cushions[row].tolist() == [met.count(ball) for ball in rows.balls]
            seen |= {("scratch", report.scratch), ("fell", bool(fell)), ("first", bool(report.first))}
    assert len(seen) == 6


def test_a_ball_that_is_pressed_along_its_cushion_does_not_come_there() -> None:
    width, radius = TABLE.knobs.table.width, TABLE.knobs.ball.radius
    alone, shot = Layout([Ball("3", 0.3, width - TABLE.reach(radius))]), Shot(angle=20.0, speed=2.0, ball="3")
    touched = [rail for event in simulate(TABLE, alone, shot).events for _, rail in event.rails]
    # It is pushed into the cushion on which it lies, rolls along it, and comes to the other end of the table.
    assert touched[0] == "top-left"
    (count,) = simulate_many(TABLE, alone, [shot], executor=Here()).cushions[0]
    assert 0 < count < len(touched)


@pytest.mark.parametrize("chunk", [1, 7, 39, 40, 1000, None])
def test_chunks_are_of_no_consequence(chunk: int | None) -> None:
    there = Here()
    assert_equal(simulate_many(TABLE, LAYOUT, iter(MIXED), executor=there, chunk=chunk), EXPECTED)
    assert there.tasks == math.ceil(len(MIXED) / (chunk or many.CHUNK))


def test_who_plays_is_of_no_consequence() -> None:
    with ThreadPoolExecutor(3) as threads:
        assert_equal(simulate_many(TABLE, LAYOUT, MIXED, executor=threads, chunk=2), EXPECTED)
        # Whoever brought it may go on with it.
        assert threads.submit(int, "7").result() == 7
    assert_equal(simulate_many(TABLE, LAYOUT, MIXED, executor=Backwards(8), chunk=5), EXPECTED)


def test_processes_play_by_default(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(many, "processors", lambda: 2)
    assert_equal(simulate_many(TABLE, LAYOUT, MIXED, chunk=7), EXPECTED)


def test_without_a_second_processor_none_is_started(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(many, "processes", None)
    monkeypatch.setattr(many, "processors", lambda: 1)
    assert_equal(simulate_many(TABLE, LAYOUT, MIXED, chunk=7), EXPECTED)
    monkeypatch.setattr(many, "processors", lambda: 8)
    assert_equal(simulate_many(TABLE, LAYOUT, MIXED, chunk=40), EXPECTED)


def test_a_shot_that_fails_is_a_row_with_its_scenario(tmp_path: Path) -> None:
    assert sorted(EXPECTED.scenarios) == sorted(WRONG)
    assert EXPECTED.error[3] == "shot: shot.speed = 99.0: allowed is a number from 0 to 50 m/s"
    for row, shot in WRONG.items():
        assert np.isnan(EXPECTED.x[row]).all()
        assert np.isnan(EXPECTED.duration[row])
        assert (EXPECTED.events[row], EXPECTED.first[row], EXPECTED.potted[row]) == (0, -1, 0)
        assert EXPECTED.balls[EXPECTED.struck[row]] == "cue" if shot.ball == "cue" else EXPECTED.struck[row] == -1
        file = tmp_path / f"{row}.json"
        file.write_text(json.dumps(EXPECTED.scenarios[row]))
        with pytest.raises(InputError) as told:
            load_scenario(file)
        key = str(EXPECTED.error[row]).split(": ")[1].split(" = ")[0]
        assert told.value.key == key
    assert not any(EXPECTED.error[row] for row in range(len(MIXED)) if row not in WRONG)


def test_a_shot_without_end_and_a_fault_of_the_engine_are_rows_too(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(table: Any, layout: Layout, shot: Shot) -> Any:
        if shot.speed == 2.0:
            raise BudgetError(50_000, 1.5, table.scenario(layout, shot))
        if shot.speed == 3.0:
            raise ZeroDivisionError("float\ndivision by zero")
        return simulate(table, layout, shot)

    monkeypatch.setattr(summarizing, "simulate", broken)
    rows = simulate_many(TABLE, LAYOUT, [Shot(speed=float(speed)) for speed in (1, 2, 3, 4)], executor=Here(), chunk=3)
    assert rows.error[1] == "the shot is not over after 50000 events, at t = 1.500000 s"
    assert str(rows.error[2]).startswith("ZeroDivisionError: float")
    assert "\n" not in str(rows.error[2])
    assert [error == "" for error in rows.error] == [True, False, False, True]
    assert [rows.scenarios[row]["shot"]["speed"] for row in sorted(rows.scenarios)] == [2.0, 3.0]


def test_shots_without_end_are_gone_through_a_little_ahead() -> None:
    taken = 0

    def endless() -> Iterator[Shot]:
        nonlocal taken
        for taken in itertools.count(1):
            yield SHOTS[taken % len(SHOTS)]

    executor = Here()
    parts = each_chunk(TABLE, LAYOUT.without("1", "2", "3"), endless(), executor=executor, chunk=2)
    sizes = [len(next(parts)) for _ in range(5)]
    assert sizes == [2] * 5
    assert executor.tasks <= many._AHEAD + 5
    assert taken <= 2 * (many._AHEAD + 6)


def test_what_was_handed_out_is_taken_back_when_nobody_asks_any_more() -> None:
    with ThreadPoolExecutor(1) as threads:
        parts = each_chunk(TABLE, LAYOUT, itertools.cycle(SHOTS), executor=threads, chunk=1)
        next(parts)
        parts.close()
        # The one thread would otherwise have hundreds of shots to play first.
        assert threads.submit(int, "1").result(timeout=60) == 1


@pytest.mark.parametrize("chunk", [0, -1, 2.5, True, "8"])
def test_chunks_have_at_least_a_shot(chunk: Any) -> None:
    with pytest.raises(InputError, match=r"simulate_many: chunk = .*: allowed is a whole number from 1"):
        simulate_many(TABLE, LAYOUT, SHOTS, chunk=chunk)


def test_what_is_no_shot_or_no_layout_is_told_before_anything_is_played() -> None:
    with pytest.raises(InputError, match="simulate_many: shots = 7: allowed are shots"):
        simulate_many(TABLE, LAYOUT, [7])  # type: ignore[list-item]
    with pytest.raises(InputError):
        simulate_many(TABLE, LAYOUT.put(LAYOUT["1"]._replace(id="4")), SHOTS)


def test_no_shots_and_no_balls_are_no_rows() -> None:
    rows = simulate_many(TABLE, LAYOUT, [])
    assert (len(rows), rows.x.shape, rows.columns()["1.x"].shape) == (0, (0, 4), (0,))
    rows = simulate_many(TABLE, Layout(), SHOTS[:2])
    assert (len(rows), rows.x.shape, rows.scratch.tolist()) == (2, (2, 0), [False, False])
    assert all(rows.error)


def test_columns_tell_balls_and_pockets_by_name() -> None:
    columns = EXPECTED.columns()
    assert {len(column) for column in columns.values()} == {len(MIXED)}
    for row in range(len(MIXED)):
        first = EXPECTED.first[row]
        assert columns["first"][row] == ("" if first < 0 else EXPECTED.balls[first])
        pocket = EXPECTED.pocket[row, 1]
        assert columns["1.pocket"][row] == ("" if pocket < 0 else EXPECTED.pockets[pocket])
    assert columns["struck"].tolist() == ["" if row == 11 else "cue" for row in range(len(MIXED))]


def test_the_package_is_imported_without_numpy() -> None:
    code = "import sys, pool2d, pool2d.game, pool2d.cli; pool2d.simulate; sys.exit('numpy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=False).returncode == 0
