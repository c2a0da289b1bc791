"""Where balls may be put down, and how those drawn a hair into each other are set apart."""

from __future__ import annotations

import math
import random
import re
from typing import Any

import pytest

from pool2d import Ball, InputError, Layout, load_table, simulate
from pool2d.physics.values import POCKETED
from pool2d.table import placing
from pool2d.table.placing import CLOSE, ROUNDS

from ..checks import assert_sound

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


def grid(columns: int, rows: int, pitch: float, radius: float) -> list[Ball]:
    """Balls beside and above each other on the cloth, `pitch` apart."""
    places = [(0.1 + i * pitch, 0.1 + j * pitch) for i in range(columns) for j in range(rows)]
    return [Ball(f"{number:04}", x, y, radius=radius) for number, (x, y) in enumerate(places)]


def by_all_pairs(balls: list[Ball], touch: float) -> list[Ball]:
    """Balls set apart by looking at every pair in every round, clear of the cushions."""
    balls = sorted(balls)
    for _ in range(ROUNDS):
        found = False
        for i in range(len(balls)):
            for j in range(i):
                dx, dy = balls[i].x - balls[j].x, balls[i].y - balls[j].y
                if (lap := touch - math.hypot(dx, dy)) > CLOSE:
                    share = 0.5 * lap / (touch - lap)
                    balls[i] = balls[i]._replace(x=balls[i].x + share * dx, y=balls[i].y + share * dy)
                    balls[j] = balls[j]._replace(x=balls[j].x - share * dx, y=balls[j].y - share * dy)
                    found = True
        if not found:
            break
    return balls


def test_only_neighbours_are_looked_at_and_nothing_is_missed() -> None:
    """To the bit what comes of looking at all pairs, wherever the ids are in their order."""
    table, rng = load_table("pool-9ft"), random.Random(4)
    for _ in range(10):
        balls = grid(
            rng.randint(1, 5), rng.randint(2, 5), 2.0 * table.knobs.ball.radius - 1e-6, table.knobs.ball.radius
        )
        ids = [ball.id for ball in balls]
        rng.shuffle(ids)
        off = [rng.uniform(-4e-7, 4e-7) for _ in balls]
        balls = [b._replace(id=name, x=b.x + d, y=b.y - d) for b, name, d in zip(balls, ids, off, strict=True)]
        settled = table.settle(Layout(balls))
        assert sorted(settled.values()) == by_all_pairs(balls, 2.0 * math.sqrt(RADIUS * RADIUS))


def test_a_thousand_balls_have_a_place() -> None:
    table = load_table("pool-9ft")
    balls = grid(48, 22, 0.0485, 0.024)
    assert len(balls) >= 1024
    assert table.settle(Layout(balls)) == Layout(balls)


def test_more_balls_than_allowed_are_refused() -> None:
    table = load_table("pool-9ft", {"cushion.nose_height": 0.015})
    with pytest.raises(InputError, match="balls = 2001: allowed are up to 2000 balls"):
        table.settle(Layout(grid(69, 29, 0.0305, 0.015)))


def test_three_hundred_balls_drawn_into_each_other_end_soon(monkeypatch: pytest.MonkeyPatch) -> None:
    """Set apart or told, after a bounded number of looks."""
    table, looks = load_table("pool-9ft"), 0
    part = placing._part

    def counted(*given: Any) -> bool:
        nonlocal looks
        looks += 1
        return part(*given)

    monkeypatch.setattr(placing, "_part", counted)
    with pytest.raises(InputError, match="the balls overlap and are too many, 300, to be set apart; leave them room"):
        table.settle(Layout(grid(20, 15, 0.048 - 1e-6, 0.024)))
    assert looks <= 300_000
