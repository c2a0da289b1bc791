"""Where balls are spotted and where the cue ball may be put: WPA 1.5 and 1.6."""

from __future__ import annotations

import math
import random

import pytest

from pool2d import Ball, Layout, load_table
from pool2d.game.rules.spotting import CLEAR, KITCHEN, D, Where, foot_spot, nearest, spot_balls, within
from pool2d.physics.values import POCKETED

TABLE, SNOOKER = load_table("pool-9ft"), load_table("snooker-12ft")
X, Y = TABLE.furniture.spots["foot"]
TWO_R = 2.0 * TABLE.knobs.ball.radius
DOWN = Ball("9", 0.0, 0.0, phase=POCKETED)


def spot(*others: Ball) -> tuple[float, float]:
    _, ((ball, place),) = spot_balls(TABLE, Layout([DOWN, *others]), ("9",))
    assert ball == "9"
    return place


def test_the_foot_spot() -> None:
    assert spot() == (X, Y)


def test_a_ball_in_the_way_is_touched_from_below() -> None:
    assert spot(Ball("1", X, Y)) == pytest.approx((X + TWO_R, Y), abs=1e-8)


def test_a_ball_beside_the_line_is_touched_too() -> None:
    x, y = spot(Ball("1", X, Y + 0.03))
    assert math.hypot(x - X, y - Y - 0.03) == pytest.approx(TWO_R, abs=1e-8)
    assert x > X


def test_the_cue_ball_is_not_touched() -> None:
    assert spot(Ball("cue", X, Y)) == pytest.approx((X + TWO_R + CLEAR, Y), abs=1e-8)


def test_a_ball_further_down_leaves_no_room_between() -> None:
    assert spot(Ball("1", X, Y), Ball("2", X + 1.5 * TWO_R, Y)) == pytest.approx((X + 2.5 * TWO_R, Y), abs=1e-8)


def test_a_full_line_below_the_spot_sends_a_ball_above() -> None:
    row = [Ball(str(i), X + i * TWO_R, Y) for i in range(11)]
    assert spot(*row) == pytest.approx((X - TWO_R, Y), abs=1e-8)


def test_balls_are_spotted_one_after_the_other() -> None:
    layout, spotted = spot_balls(TABLE, Layout([DOWN, DOWN._replace(id="8"), Ball("cue", 0.3, 0.3)]), ("8", "9"))
    assert [ball for ball, _ in spotted] == ["8", "9"]
    assert layout["9"].x == pytest.approx(X + TWO_R, abs=1e-8)
    TABLE.settle(layout)


def test_a_ball_without_room_stays_off() -> None:
    layout = Layout([DOWN, *(Ball(f"red{i}", 0.05 + i * 0.99 * TWO_R, Y) for i in range(44))])
    assert nearest(TABLE, layout, "9", (X, Y), 1) is None
    assert spot_balls(TABLE, layout, ("9",)) == (layout, ())


def test_another_spot_and_balls_that_must_not_be_touched() -> None:
    other, layout = (X - 0.4, Y), Layout([DOWN, Ball("1", X - 0.4, Y)])
    _, ((_, touching),) = spot_balls(TABLE, layout, ("9",), other)
    _, ((_, apart),) = spot_balls(TABLE, layout, ("9",), other, frozenset(layout))
    assert touching == pytest.approx((X - 0.4 + TWO_R, Y), abs=1e-8)
    assert apart == pytest.approx((X - 0.4 + TWO_R + CLEAR, Y), abs=1e-8)


@pytest.mark.parametrize(
    ("where", "x", "y", "there"),
    [
        (KITCHEN, 0.634, 0.3, True),
        (KITCHEN, 0.635, 0.3, False),
        (KITCHEN, -0.1, 0.3, False),
        ("anywhere", 2.0, 0.3, True),
        ("anywhere", 2.6, 0.3, False),
    ],
)
def test_areas(where: Where, x: float, y: float, there: bool) -> None:
    assert within(TABLE, where, x, y) == there


@pytest.mark.parametrize(
    ("dx", "dy", "there"),
    [(0.0, 0.0, True), (0.0, 0.292, True), (0.0, 0.293, False), (-0.292, 0.0, True), (0.01, 0.0, False)],
)
def test_the_d(dx: float, dy: float, there: bool) -> None:
    assert within(SNOOKER, D, 0.737 + dx, 0.889 + dy) == there


def test_a_table_without_a_foot_spot_has_it_as_far_from_the_foot_as_the_head_spot_from_the_head() -> None:
    for name in ("english-7ft", "snooker-12ft"):
        table = load_table(name)
        x, y = table.furniture.spots["head"]
        assert foot_spot(table) == (table.knobs.table.length - x, y)
    assert foot_spot(TABLE) == (X, Y)


def test_a_full_line_below_the_spot_sends_a_ball_above_without_touching_those_it_must_not() -> None:
    layout = Layout([DOWN, *(Ball(str(i), X + i * TWO_R, Y) for i in range(11))])
    _, ((_, apart),) = spot_balls(TABLE, layout, ("9",), (X, Y), frozenset(layout) - {"9"})
    assert apart == pytest.approx((X - TWO_R - CLEAR, Y), abs=1e-8)


@pytest.mark.parametrize("way", [1, -1])
@pytest.mark.parametrize("apart", [False, True])
def test_a_ball_is_spotted_as_near_as_there_is_room(way: int, apart: bool) -> None:
    """Found again by trying place after place along the line, from the spot on."""
    rng, step = random.Random(f"spots {way}"), 1e-4
    for _ in range(30):
        others = [Ball(str(i), X + rng.uniform(-0.2, 0.2), Y + rng.uniform(-0.08, 0.08)) for i in range(6)]
        layout = Layout([DOWN._replace(id="cue"), *others])
        found = nearest(TABLE, layout, "cue", (X, Y), way, frozenset(layout) if apart else frozenset())
        assert found is not None and found[1] == Y
        least = TWO_R + (CLEAR if apart else 0.0)
        assert all(math.dist(found, (ball.x, ball.y)) >= least - 1e-9 for ball in others)
        tried = (X + way * step * i for i in range(4000))
        free = next(x for x in tried if all(math.dist((x, Y), (ball.x, ball.y)) > least + 1e-7 for ball in others))
        assert -1e-6 <= way * (free - found[0]) <= step + 1e-6
