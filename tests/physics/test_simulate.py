"""What holds of every shot, looked for in random play."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pool2d
from pool2d import Ball, BudgetError, Layout, Shot, Table, load_scenario, simulate
from pool2d.physics.values import AIRBORNE, GONE, OFF, POCKETED, RESTING

from ..checks import assert_sound, energy
from ..plays import plays, shots
from ..scenes import Play, break_shot, frozen, random_shot

TABLE = pool2d.load_table("pool-9ft")
KINDS = {
    "cue_ball", "ball_ball", "ball_cushion", "ball_pocket",
    "sliding_rolling", "rolling_resting", "spin_end", "cluster", "ball_slate", "ball_off",
}  # fmt: skip
FROZEN = frozen(TABLE)

KNOBS = st.fixed_dictionaries(
    {
        "ball.restitution": st.sampled_from([0.0, 0.5, 0.95, 1.0]),
        "ball.friction": st.sampled_from([0.0, 0.06, 1.0]),
        "cushion.restitution": st.sampled_from([0.0, 0.5, 0.85, 1.0]),
        "cushion.friction": st.sampled_from([0.0, 0.14, 1.0]),
        "cushion.nose_height": st.sampled_from([0.028575, 0.0362903, 0.04]),
        "cloth.mu_slide": st.sampled_from([0.05, 0.2, 1.0]),
        "cloth.mu_roll": st.sampled_from([0.005, 0.01, 0.1]),
    }
)


@settings(max_examples=400)
@given(plays(TABLE))
def test_random_play_is_sound(play: Play) -> None:
    """Energy never rises, nothing overlaps or leaves the table, and it ends."""
    assert_sound(TABLE, simulate(TABLE, *play))


@settings(max_examples=150)
@given(st.data(), KNOBS)
def test_random_play_on_odd_tables_is_sound(data: st.DataObject, knobs: dict[str, float]) -> None:
    table = TABLE.with_knobs(knobs)
    assert_sound(table, simulate(table, *data.draw(plays(table, most=8))))


@settings(max_examples=150)
@given(plays(TABLE, most=8, own_sizes=True))
def test_random_play_with_balls_of_all_sizes_is_sound(play: Play) -> None:
    assert_sound(TABLE, simulate(TABLE, *play))


@settings(max_examples=25)
@given(st.integers(0, 1000), shots())
def test_break_is_sound(seed: int, shot: Shot) -> None:
    layout = TABLE.rack("eight-ball", seed=seed).put(Ball("cue", 0.9, 0.635))
    assert_sound(TABLE, simulate(TABLE, layout, shot), samples=5)


@pytest.mark.parametrize("name", FROZEN)
def test_frozen_balls_are_an_ordinary_case(name: str) -> None:
    layout, shot = FROZEN[name]
    roll = simulate(TABLE, layout, shot)
    assert_sound(TABLE, roll, samples=200)
    # Pressing makes some bounces, not a storm of them.
    assert 0 < len(roll.events) < 300
    assert roll.duration < 20.0


def test_ball_pressed_on_a_rail_by_its_spin_stays_there() -> None:
    """Its spin, not its way, is what the cushion and the cloth take from it."""
    layout, _ = FROZEN["one on a rail, pressed by its spin"]
    roll = simulate(TABLE, layout)
    start, end = layout["cue"], roll.layout()["cue"]
    assert abs(end.x - start.x) < 1e-9
    assert max(y for _, _, y in roll.path("cue", 0.001)) < start.y + 1e-3
    assert end.y == pytest.approx(start.y, abs=1e-3)


def test_frozen_row_passes_the_blow_on() -> None:
    layout, shot = FROZEN["a row along a rail"]
    gone = {name: ball.x - layout[name].x for name, ball in simulate(TABLE, layout, shot).at(0.3).items()}
    assert gone["2"] > gone["1"] + 0.05 > gone["cue"] + 0.05 > 0.5


@settings(max_examples=40)
@given(plays(TABLE), st.randoms(use_true_random=False))
def test_equal_input_gives_equal_output_in_any_order(play: Play, rng: random.Random) -> None:
    layout, shot = play
    roll = simulate(TABLE, layout, shot)
    again = simulate(pool2d.load_table("pool-9ft"), layout, shot)
    balls = list(layout.values())
    rng.shuffle(balls)
    shuffled = simulate(TABLE, Layout(balls), shot)
    assert roll.digest() == again.digest() == shuffled.digest()
    assert [event.as_dict() for event in roll.events] == [event.as_dict() for event in shuffled.events]
    assert dict(roll.layout()) == dict(shuffled.layout())


@settings(max_examples=40)
@given(plays(TABLE))
def test_nothing_is_lost_on_the_way(play: Play) -> None:
    """Every ball is accounted for, every change of a ball is an event, and its state is continuous.

    The cloth's friction in portions is no event: a ball gets one just before a contact, and then coasts.
    """
    layout, shot = play
    roll = simulate(TABLE, layout, shot)
    assert roll.layout().keys() == layout.keys() == roll.tracks.keys()
    assert {event.kind for event in roll.events} <= KINDS
    for ball_id, track in roll.tracks.items():
        mine = [event for event in roll.events if ball_id in event.balls]
        for old, new in pairwise(track):
            before, after = old.at(new.t0), new.at(new.t0)
            assert (before.x, before.y) == pytest.approx((after.x, after.y), abs=1e-12)
            if mine and (mine[0].t, mine[0].after[ball_id]) == (new.t0, after):
                assert mine.pop(0).before[ball_id] == before
            else:
                assert new.coasts() or old.coasts() or new.phase == AIRBORNE
        assert not mine
    for event in roll.events:
        assert event.before.keys() == event.after.keys() == set(event.balls)
        assert all(ball.phase == POCKETED for ball in event.after.values()) == (event.kind == "ball_pocket")
        assert all(ball.phase == OFF for ball in event.after.values()) == (event.kind == "ball_off")
        kind = "ball_pocket" if event.kind == "ball_pocket" else "ball_cushion"
        names = {element.name for element in TABLE.elements if element.kind == kind} or {"miscue"}
        # The air has more: the backs of pockets, and the rims of their holes.
        names |= {solid.name for solid in TABLE.bed.solids if event.kind != "ball_pocket"}
        slipped = (event.kind, event.where) == ("cue_ball", "miscue")
        assert slipped or event.where is None or names.issuperset(event.where.split(", "))
        assert event.where is not None or not event.rails


@settings(max_examples=30)
@given(plays(TABLE, most=8), st.integers(1, 40))
def test_events_stops_after_so_many(play: Play, count: int) -> None:
    whole = simulate(TABLE, *play)
    part = simulate(TABLE, *play, events=count)
    assert part.truncated == (count < len(whole.events))
    assert [event.as_dict() for event in part.events] == [event.as_dict() for event in whole.events[:count]]
    assert part.duration == (part.events[-1].t if part.events else 0.0)
    for ball in part.layout().values():
        assert ball == whole.ball_at(ball.id, part.duration) or part.duration in {e.t for e in whole.events[count:]}


def test_events_may_ask_for_as_many_as_the_budget() -> None:
    layout, shot = random_shot(TABLE, 1)
    assert simulate(TABLE, layout, shot, events=5, budget=5).truncated
    with pytest.raises(BudgetError):
        simulate(TABLE, layout, shot, events=6, budget=5)


def test_budget_error_carries_a_scenario_that_reproduces_it(tmp_path: Path) -> None:
    table = TABLE.with_knobs({"cloth.mu_slide": 0.3})
    layout, shot = random_shot(table, 5)
    layout = layout.put(Ball("1", 0.0, 0.0, phase=POCKETED), layout["2"]._replace(vx=1.0, wz=3.0, mass=0.2))
    with pytest.raises(BudgetError) as caught:
        simulate(table, layout, shot, budget=12)
    assert (caught.value.budget, caught.value.time > 0.0) == (12, True)
    path = tmp_path / "again.json"
    path.write_text(json.dumps(caught.value.scenario))
    again = load_scenario(path)
    with pytest.raises(BudgetError) as repeated:
        simulate(again.table, again.layout, again.shot, budget=12)
    assert repeated.value.time == caught.value.time
    assert again.simulate().digest() == simulate(table, layout.without("1"), shot).digest()


def random_shots(table: Table, count: int) -> Iterator[pool2d.Rollout]:
    for seed in range(count):
        yield simulate(table, *random_shot(table, seed))


def test_a_thousand_random_shots_end() -> None:
    hits = drops = 0
    for roll in random_shots(TABLE, 1000):
        assert {ball.phase for ball in roll.layout().values()} <= {RESTING, *GONE}
        assert not roll.truncated
        assert len(roll.events) < 2000
        hits += sum(event.kind in ("ball_ball", "cluster") for event in roll.events)
        drops += sum(event.kind == "ball_pocket" for event in roll.events)
    # They are real shots: most of them meet a ball, some pot one.
    assert hits > 1000
    assert drops > 50


def test_breaks_scatter_the_rack() -> None:
    for seed in range(5):
        layout, shot = break_shot(TABLE, seed)
        roll = simulate(TABLE, layout, shot)
        moved = [ball for ball in roll.layout().values() if (ball.x, ball.y) != (layout[ball.id].x, layout[ball.id].y)]
        assert len(moved) == 16
        assert sum(event.kind == "ball_cushion" for event in roll.events) >= 4
        first = next(event for event in roll.events if event.kind in ("ball_ball", "cluster"))
        before = energy(TABLE, (ball for ball in roll.at(first.t - 1e-9).values()))
        assert energy(TABLE, roll.at(first.t + 0.05).values()) > 0.5 * before


def test_balls_already_moving_need_no_shot() -> None:
    ball = Ball("cue", 0.6, 0.6, 1.0, 0.0)
    roll = simulate(TABLE, Layout([ball, Ball("1", 1.2, 0.6), Ball("2", 0.0, 0.0, phase=POCKETED)]))
    assert [event.kind for event in roll.events][:2] == ["sliding_rolling", "ball_ball"]
    assert roll.layout()["2"] == Ball("2", 0.0, 0.0, phase=POCKETED)
    assert simulate(TABLE, Layout()).events == []
    assert simulate(TABLE, Layout([ball.still()])).duration == 0.0


def test_table_of_another_size_of_ball() -> None:
    """A light cue ball comes back off a heavy ball, and a small ball meets a large one above its middle."""
    light = Layout([Ball("cue", 0.6, 0.6, 1.0, mass=0.1), Ball("1", 1.0, 0.6, mass=0.4)])
    event = next(event for event in simulate(TABLE, light).events if event.kind == "ball_ball")
    assert event.after["cue"].vx < 0.0 < event.after["1"].vx
    small = Layout([Ball("cue", 0.6, 0.6, 1.0, radius=0.02), Ball("1", 1.0, 0.6, radius=0.035)])
    event = next(event for event in simulate(TABLE, small).events if event.kind == "ball_ball")
    gap = event.after["1"].x - event.after["cue"].x
    assert gap == pytest.approx(2.0 * (0.02 * 0.035) ** 0.5, abs=1e-9)
