"""Where balls may be put down, and how those drawn a hair into each other are set apart."""

from __future__ import annotations

import math
import re

import pytest

from pool2d import Ball, InputError, Layout, load_table, simulate
from pool2d.physics.values import POCKETED

from .checks import assert_sound

TABLE = load_table("pool-9ft")
RADIUS = TABLE.knobs.ball.radius
REACH = TABLE.reach(RADIUS)


def triangle(pitch: float) -> Layout:
    """Fifteen balls with centres `pitch` apart."""
    balls: list[Ball] = []
    for i in range(5):
        for j in range(i + 1):
            balls.append(Ball(str(len(balls)), 1.9 + i * pitch * math.sqrt(0.75), 0.635 + (j - i / 2.0) * pitch))
    return Layout(balls)


def overlap(layout: Layout) -> float:
    """The deepest overlap of two balls, m."""
    balls = layout.on_table()
    return max(
        TABLE.touch(a, b) - math.hypot(a.x - b.x, a.y - b.y) for i, a in enumerate(balls) for b in balls[:i]
    )  # fmt: skip


def test_balls_with_room_stay_to_the_bit() -> None:
    layout = triangle(2.0 * RADIUS + 1e-6).put(Ball("out", 0.0, 0.0, phase=POCKETED))
    assert TABLE.settle(layout) is layout


@pytest.mark.parametrize("depth", [0.0, 1e-15, 1e-9, 1e-7, 1e-6, 1.9e-6])
def test_rack_drawn_too_tight_is_set_apart(depth: float) -> None:
    given = triangle(2.0 * RADIUS - depth)
    settled = TABLE.settle(given)
    assert overlap(settled) < 1.01e-10
    for ball in given.values():
        assert math.hypot(settled[ball.id].x - ball.x, settled[ball.id].y - ball.y) < 10.0 * depth + 1e-12
    assert TABLE.settle(settled) == settled
    cue = Ball("cue", 0.6, 0.635, vx=6.0)
    assert_sound(TABLE, simulate(TABLE, given.put(cue)))


def test_row_drawn_into_a_rail_and_into_itself() -> None:
    row = Layout(Ball(str(i), 2.54 - REACH + 5e-7 - i * (2.0 * RADIUS - 1e-6), 0.6) for i in range(6))
    settled = TABLE.settle(row)
    assert overlap(settled) < 1.01e-10
    assert TABLE.element_gap(settled["0"].x, 0.6, RADIUS)[0] > -1.01e-10


def test_balls_with_no_room_to_part_are_refused() -> None:
    """A row that is jammed between two rails: each pair within the slack, and none can give way."""
    count, short = 8, 8e-6
    tight = TABLE.with_knobs({"table.width": 2.0 * REACH + (count - 1) * 2.0 * RADIUS - short})
    width = tight.knobs.table.width
    row = Layout(Ball(str(i), 0.6, REACH + i * (width - 2.0 * REACH) / (count - 1)) for i in range(count))
    with pytest.raises(InputError, match="no room to part"):
        tight.settle(row)
    tight.settle(row.without("3"))


@pytest.mark.parametrize(
    ("balls", "words"),
    [
        ([Ball("a", 1.0, 0.6), Ball("b", 1.0 + 2.0 * RADIUS - 3e-6, 0.6)], r"balls\.b, balls\.a .* overlap by 3e-06 m"),
        ([Ball("a", 1.0, 0.6), Ball("b", 1.0, 0.6)], r"overlap by 0\.0571 m"),
        ([Ball("a", 1.0, REACH - 2e-6)], r"inside the cushion bottom-left, by 2e-06 m"),
        ([Ball("a", 0.0, 0.0)], r"in the pocket bottom-left"),
        ([Ball("a", 1.0, -0.1)], r"balls\.a\.x, y = \(1\.0, -0\.1\): the ball is off the table"),
        ([Ball("a", 5.0, 0.6)], r"off the table; allowed is x from 0\.0275 to 2\.5125 m"),
        ([Ball("a", math.nan, 0.6)], r"balls\.a\.x = nan"),
        ([Ball("a", 1.0, 0.6, vx=math.inf)], r"balls\.a\.vx = inf"),
        ([Ball("a", 1.0, 0.6, wz=1e9)], r"balls\.a\.wz"),
        ([Ball("a", 1.0, 0.6, radius=-1.0)], r"balls\.a\.radius"),
        ([Ball("a", 1.0, 0.6, mass=math.nan)], r"balls\.a\.mass"),
        ([Ball("a", 1.0, 0.6, radius=0.018)], r"higher than the cushion's nose"),
    ],
)
def test_balls_that_may_not_be_there(balls: list[Ball], words: str) -> None:
    with pytest.raises(InputError) as caught:
        TABLE.settle(Layout(balls))
    assert re.search(words, str(caught.value))
    with pytest.raises(InputError):
        simulate(TABLE, Layout(balls))
