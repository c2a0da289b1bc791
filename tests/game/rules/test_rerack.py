"""Racking again in 14.1: WPA 7.8 and its Table 1."""

from __future__ import annotations

import math
import random

import pytest

from pool2d import Ball, Layout
from pool2d.game.rules.pool.rerack import interferes, rerack

from .cases import POOL, Case, judged, line
from .notation import without

RACK, HEAD, CENTER, KITCHEN, BELOW = (1.95, 0.64), (0.63, 0.62), (1.27, 0.635), (0.3, 0.3), (1.2, 0.3)
SPOT = POOL.furniture.spots
RADIUS = POOL.knobs.ball.radius


def beside(radii: float, aside: float) -> tuple[float, float]:
    """A place beside the head spot, so many ball radii along the table and across it."""
    return SPOT["head"][0] + radii * RADIUS, SPOT["head"][1] + aside * RADIUS


def left_over(cue: tuple[float, float], ball: tuple[float, float] | None) -> Layout:
    """A table with the cue ball, and the seven if it has a place."""
    layout = without(POOL.rack("straight-pool", 3), *(str(number) for number in range(1, 16)))
    return layout.put(Ball("cue", *cue), *([Ball("7", *ball)] if ball else []))


@pytest.mark.parametrize(
    ("cue", "ball", "cue_ends", "ball_ends", "where"),
    [
        pytest.param(BELOW, KITCHEN, BELOW, KITCHEN, "", id="nothing in the way: both stay"),
        pytest.param(RACK, RACK, None, None, "kitchen", id="both in the rack: all fifteen"),
        pytest.param(BELOW, RACK, BELOW, SPOT["head"], "", id="the ball in the rack: to the head spot"),
        pytest.param(HEAD, RACK, HEAD, SPOT["center"], "", id="... to the centre spot, the cue ball in the way"),
        pytest.param(RACK, None, None, None, "kitchen", id="the last ball fell, the cue ball in the rack"),
        pytest.param(BELOW, None, BELOW, None, "", id="the last ball fell, the cue ball elsewhere"),
        pytest.param(HEAD, None, HEAD, None, "", id="the last ball fell, the cue ball on the head spot"),
        pytest.param(RACK, KITCHEN, SPOT["head"], KITCHEN, "", id="the cue ball in the rack, the ball in the kitchen"),
        pytest.param(RACK, HEAD, SPOT["center"], HEAD, "", id="... the ball on the head spot"),
        pytest.param(RACK, SPOT["head"], SPOT["center"], SPOT["head"], "", id="... exactly on it, as a rerack puts it"),
        pytest.param(RACK, beside(1.99, 0.0), SPOT["center"], beside(1.99, 0.0), "", id="... nearly a ball beyond it"),
        pytest.param(RACK, beside(0.0, -1.99), SPOT["center"], beside(0.0, -1.99), "", id="... beside it"),
        pytest.param(RACK, beside(-1.4, 1.4), SPOT["center"], beside(-1.4, 1.4), "", id="... behind it, aside"),
        pytest.param(RACK, beside(-1.5, 1.5), SPOT["head"], beside(-1.5, 1.5), "", id="... behind it, out of the way"),
        pytest.param(RACK, beside(2.01, 0.0), None, beside(2.01, 0.0), "kitchen", id="... beyond it, out of the way"),
        pytest.param(
            beside(1.9, 0.0), RACK, beside(1.9, 0.0), SPOT["center"], "", id="the cue ball beyond the head spot"
        ),
        pytest.param(beside(2.01, 0.0), RACK, beside(2.01, 0.0), SPOT["head"], "", id="... out of the way"),
        pytest.param(RACK, BELOW, None, BELOW, "kitchen", id="... the ball beyond the head string"),
        pytest.param(RACK, (0.635, 0.2), None, (0.635, 0.2), "kitchen", id="... the ball on the head string"),
    ],
)
def test_table_1(
    cue: tuple[float, float],
    ball: tuple[float, float] | None,
    cue_ends: tuple[float, float] | None,
    ball_ends: tuple[float, float] | None,
    where: str,
) -> None:
    layout, area = rerack(POOL, left_over(cue, ball), "straight-pool", seed=5)
    assert area == where
    assert sorted(layout) == sorted(["cue", *(str(number) for number in range(1, 16))])
    assert len(layout.on_table()) == 16 - bool(where)
    if cue_ends:
        assert (layout["cue"].x, layout["cue"].y) == cue_ends
    if ball_ends:
        assert (layout["7"].x, layout["7"].y) == ball_ends
    # The apex is empty where a ball was left out of the rack.
    apex = [one.id for one in layout.values() if abs(one.x - SPOT["foot"][0]) < RADIUS > abs(one.y - SPOT["foot"][1])]
    assert bool(apex) == (ball_ends is None)
    assert POOL.settle(layout) == layout


@pytest.mark.parametrize("seed", range(16))
def test_fourteen_balls_stand_whatever_their_order(seed: int) -> None:
    """The ball that stays may be the one that the draw put at the apex."""
    layout, _ = rerack(POOL, left_over(BELOW, KITCHEN), "straight-pool", seed)
    back = [one for one in layout.values() if one.x > SPOT["foot"][0] + RADIUS]
    assert len(back) == 14
    POOL.settle(layout)


@pytest.mark.parametrize(
    ("x", "y", "there"),
    [
        (SPOT["foot"][0], SPOT["foot"][1], True),
        (SPOT["foot"][0] - 2.9 * RADIUS, SPOT["foot"][1], True),
        (SPOT["foot"][0] - 3.1 * RADIUS, SPOT["foot"][1], False),
        (SPOT["foot"][0] + 9.8 * RADIUS, SPOT["foot"][1], False),
        (SPOT["foot"][0] + 8.8 * RADIUS, SPOT["foot"][1], True),
        (SPOT["foot"][0], SPOT["foot"][1] + 2.5 * RADIUS, False),
    ],
)
def test_the_outline_of_the_rack(x: float, y: float, there: bool) -> None:
    """7.2: a tight rack of fifteen; a ball inside or over the line is in the way."""
    assert interferes(POOL, "straight-pool", (x, y)) == there


@pytest.mark.parametrize("number", range(40))
def test_what_is_not_in_the_way_has_room(number: int) -> None:
    """Right at the outline, whatever play the balls have in the rack."""
    rng = random.Random(number)
    way = rng.uniform(0.0, math.tau)
    near, far = 0.0, 0.5
    for _ in range(60):
        middle = 0.5 * (near + far)
        x, y = 2.0 + middle * math.cos(way), SPOT["foot"][1] + middle * math.sin(way)
        near, far = (middle, far) if interferes(POOL, "straight-pool", (x, y)) else (near, middle)
    place = 2.0 + far * math.cos(way), SPOT["foot"][1] + far * math.sin(way)
    layout, _ = rerack(POOL, left_over(place, KITCHEN), "straight-pool", seed=number)
    assert POOL.settle(layout) == layout


def test_the_shooter_goes_on_with_a_new_rack() -> None:
    case = Case("7.4", "", "balls 7 8", "8>", "cue-8 8>", "")
    _, ruling = judged("straight", case)
    assert line(ruling) == "0 aims; points 1 0"
    assert len(ruling.layout.on_table()) == 16
    assert "re-racked" in [note.key for note in ruling.notes]


def test_the_last_two_balls_in_one_shot() -> None:
    _, ruling = judged("straight", Case("7.8", "", "balls 7 8", "8>", "cue-8 8> 7>", ""))
    assert line(ruling) == "0 aims; points 2 0"
    assert len(ruling.layout.on_table()) == 16
