"""A rollout as a value: any moment of a shot, its paths, its digest."""

from __future__ import annotations

import copy
import math
import pickle
from collections.abc import Callable

import pytest

from pool2d import Ball, Layout, Rollout, Shot, load_table, simulate

from ..scenes import random_shot

TABLE = load_table("pool-9ft")
ROLL = simulate(TABLE, *random_shot(TABLE, 3))


def test_time_is_clamped_to_the_shot() -> None:
    assert ROLL.at(-1.0) == ROLL.at(0.0)
    assert ROLL.at(ROLL.duration + 1.0) == ROLL.at(ROLL.duration) == ROLL.layout()
    assert ROLL.at(math.inf) == ROLL.layout()
    assert ROLL.duration == ROLL.events[-1].t


def test_at_an_event_the_ball_is_as_it_was_left() -> None:
    left = {(event.t, ball_id): ball for event in ROLL.events for ball_id, ball in event.after.items()}
    assert left
    for (t, ball_id), ball in left.items():
        assert ROLL.at(t)[ball_id] == ball


@pytest.mark.parametrize(("radius", "mass"), [(0.03, 0.2), (0.03, None), (None, 0.2), (None, None)])
def test_a_ball_keeps_what_it_has_of_its_own(radius: float | None, mass: float | None) -> None:
    roll = simulate(TABLE, Layout([Ball("cue", 0.6, 0.6, 1.0, radius=radius, mass=mass), Ball("1", 1.2, 0.6)]))
    for t in (0.0, 0.3, roll.duration):
        assert (roll.at(t)["cue"].radius, roll.at(t)["cue"].mass) == (radius, mass)
        assert (roll.at(t)["1"].radius, roll.at(t)["1"].mass) == (None, None)


def test_final_layout_can_be_played_on() -> None:
    again = simulate(TABLE, ROLL.layout(), Shot(angle=10.0, speed=2.0, ball="7"))
    assert again.events[0].balls == ("7",)
    assert again.start["cue"] == ROLL.layout()["cue"]


@pytest.mark.parametrize("step", [0.01, 0.1, 1.0, 1000.0])
def test_path_covers_the_shot(step: float) -> None:
    path = ROLL.path("cue", step)
    times = [t for t, _, _ in path]
    assert (times[0], times[-1]) == (0.0, ROLL.duration)
    assert len(path) == math.ceil(ROLL.duration / step) + 1
    assert times[1:-1] == pytest.approx([step * i for i in range(1, len(path) - 1)])
    for t, x, y in path[:: max(1, len(path) // 20)]:
        ball = ROLL.at(t)["cue"]
        assert (ball.x, ball.y) == (x, y)


def test_digest_tells_every_difference() -> None:
    layout, shot = random_shot(TABLE, 3)
    assert simulate(TABLE, layout, shot).digest() == ROLL.digest()
    cue = layout["cue"]
    nudged = layout.put(cue._replace(x=math.nextafter(cue.x, 2.0)))
    assert simulate(TABLE, nudged, shot).digest() != ROLL.digest()
    assert simulate(TABLE, layout, shot, events=len(ROLL.events) - 1).digest() != ROLL.digest()
    # A ball that nothing touches counts too.
    alone = Layout([Ball("1", 1.0, 0.6)])
    moved = Layout([Ball("1", 1.0, 0.7)])
    assert simulate(TABLE, alone).digest() != simulate(TABLE, moved).digest()


@pytest.mark.parametrize(("name", "value"), [("kind", "another"), ("where", "another"), ("balls", ("another",))])
def test_digest_tells_what_happened_and_where(name: str, value: object) -> None:
    """Two rollouts in which every ball is moved alike, but by another cushion, say."""
    events = [copy.copy(event) for event in ROLL.events]
    number = next(i for i, event in enumerate(events) if event.where)
    setattr(events[number], name, value)
    assert Rollout(ROLL.start, ROLL.tracks, list(ROLL.events), False).digest() == ROLL.digest()
    assert Rollout(ROLL.start, ROLL.tracks, events, False).digest() != ROLL.digest()


def test_layout_is_a_value() -> None:
    a, b = Ball("a", 1.0, 0.6), Ball("b", 1.2, 0.6)
    layout = Layout([a, b])
    assert layout == Layout([b, a])
    assert hash(layout) == hash(Layout([b, a]))
    moved = layout.put(a._replace(x=0.5), Ball("c", 0.3, 0.3))
    assert (layout["a"].x, moved["a"].x, list(moved)) == (1.0, 0.5, ["a", "b", "c"])
    assert list(layout.without("a")) == ["b"]
    assert Ball("a", 1.0, 0.6, 1.0, 2.0, 3.0, 4.0, 5.0, "sliding", 0.03, 0.2).still() == Ball(
        "a", 1.0, 0.6, radius=0.03, mass=0.2
    )


@pytest.mark.parametrize(
    "again", [copy.deepcopy, lambda roll: pickle.loads(pickle.dumps(roll))], ids=["copy", "pickle"]
)
def test_a_rollout_can_be_copied_and_sent(again: Callable[[Rollout], Rollout]) -> None:
    """Its compiled parts too, to the bit."""
    other = again(ROLL)
    assert other is not ROLL
    assert [event.as_dict() for event in other.events] == [event.as_dict() for event in ROLL.events]
    for t in (0.0, 0.3 * ROLL.duration, ROLL.duration):
        assert other.at(t) == ROLL.at(t)
    assert Rollout(other.start, other.tracks, other.events, other.truncated).digest() == ROLL.digest()


def test_where_nothing_moves_a_shot_is_over_at_once() -> None:
    layout = Layout([Ball("cue", 0.6, 0.6), Ball("1", 1.2, 0.6)])
    still = simulate(load_table("pool-9ft"), layout)
    assert still.events == [] and still.duration == 0.0
    assert still.layout() == layout
