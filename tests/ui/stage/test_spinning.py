"""A ball that spins on in its place: seen through quickly, and said to do so."""

from __future__ import annotations

import pytest

from pool2d import Ball, Layout, Shot, load_table, simulate
from pool2d.ui.stage.playback import Playback
from pool2d.ui.wording import shot_text
from pool2d.ui.wording.words import Words

TABLE = load_table("pool-9ft")
ROLL = simulate(TABLE, Layout([Ball("cue", 0.635, 0.5), Ball("1", 1.5, 0.53)]), Shot(angle=1.0, speed=3.0))
SPUN = simulate(TABLE, Layout([Ball("cue", 0.635, 0.5, wz=200.0)]))


def test_a_ball_that_only_spins_holds_nobody_up() -> None:
    shown = Playback(SPUN, None)
    assert shown.end > 4.0
    shown.update(0.25)
    assert shown.time == pytest.approx(2.0)


def test_on_the_time_line_it_spins_as_long_as_it_does() -> None:
    shown = Playback(SPUN, None, again=True)
    shown.update(0.25)
    assert shown.time == pytest.approx(0.25)


def test_while_a_ball_moves_time_runs_as_it_is() -> None:
    shown = Playback(ROLL, None)
    last = max(event.t for event in ROLL.events if event.kind == "rolling_resting")
    assert shown.time < last - 0.1
    while shown.time < last - 0.1:
        before = shown.time
        shown.update(0.05)
        assert shown.time == pytest.approx(before + 0.05)


def test_a_ball_that_stands_and_spins_on_is_not_said_to_rest() -> None:
    roll = simulate(TABLE, Layout([Ball("cue", 0.635, 0.5, vx=0.2, wz=100.0)]))
    told = [
        shot_text.title(Words(), event, "cue") for event in roll.events if event.kind in ("rolling_resting", "spin_end")
    ]
    assert told == ["Cue ball stands, and spins on", "Cue ball stops spinning"]
    still = simulate(TABLE, Layout([Ball("cue", 0.635, 0.5)]), Shot(angle=0.0, speed=1.0))
    assert shot_text.title(Words(), still.events[-1], "cue") == "Cue ball comes to rest"
