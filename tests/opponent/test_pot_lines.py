"""Ways to a pocket: what lies open, where the ball has to go, and that it goes there on the engine."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pool2d import Ball, Layout, load_table, simulate
from pool2d.opponent.aiming import GOOD, aimed_at
from pool2d.opponent.candidates.pots import stroked
from pool2d.opponent.mouths import mouths, windows
from pool2d.opponent.pot_lines import pot_lines
from pool2d.opponent.stray import Hand
from pool2d.physics.event import Event

TABLE = load_table("pool-9ft")
HAND = Hand()


def test_a_ball_before_a_corner_goes_in_along_the_diagonal_and_a_nearer_one_by_a_wider_window() -> None:
    seen = mouths(TABLE)
    corner = seen.names.index("top-right")
    x, y = TABLE.knobs.table.length, TABLE.knobs.table.width
    places = np.array([(x - 0.3, y - 0.3), (x - 0.6, y - 0.6)])
    direction, half = windows(seen, places, TABLE.reach(0.028575))
    assert direction[0, corner] == pytest.approx(math.radians(45.0), abs=1e-6)
    assert half[0, corner] > 1.8 * half[1, corner] > 0.0


def test_a_side_pocket_is_shut_to_a_ball_that_comes_along_its_rail() -> None:
    seen = mouths(TABLE)
    _, half = windows(seen, np.array([(0.4, 0.06)]), TABLE.reach(0.028575))
    assert half[0, seen.names.index("bottom-side")] < 0.0 < half[0, seen.names.index("bottom-left")]


def test_balls_in_the_way_shut_it_on_either_leg() -> None:
    cue, ball = Ball("cue", 1.0, 0.5), Ball("1", 1.6, 0.8)
    layout = Layout([cue, ball])
    pockets = {way.pocket for way in pot_lines(TABLE, layout, cue, ("1",), HAND)}
    assert "top-right" in pockets
    for x, y in ((1.3, 0.65), (2.0, 1.0)):
        blocked = layout.put(Ball("2", x, y))
        assert "top-right" not in {way.pocket for way in pot_lines(TABLE, blocked, cue, ("1",), HAND)}


def test_thin_and_far_shots_are_less_likely() -> None:
    ball = Ball("1", 2.0, 0.9)
    straight = math.atan2(1.24 - ball.y, 2.51 - ball.x)

    def chance(back: float, far: float) -> float:
        way = straight + math.radians(back)
        cue = Ball("cue", ball.x - far * math.cos(way), ball.y - far * math.sin(way))
        found = pot_lines(TABLE, Layout([cue, ball]), cue, ("1",), HAND)
        return next(way.chance for way in found if way.pocket == "top-right")

    assert chance(5.0, 0.4) > chance(5.0, 0.8) > chance(45.0, 0.8) > chance(65.0, 0.8)


@pytest.mark.parametrize("height", [0.0, -0.4, 0.4])
@pytest.mark.parametrize("side", [0.0, 0.3])
def test_an_aim_is_refined_until_the_ball_goes_where_it_is_meant(height: float, side: float) -> None:
    cue, ball = Ball("cue", 1.0, 0.5), Ball("1", 1.6, 0.8)
    layout = Layout([cue, ball])
    way = next(way for way in pot_lines(TABLE, layout, cue, ("1",), HAND) if way.pocket == "top-right")
    (shot,) = stroked(TABLE, layout, "cue", way, height, side, (1.3,))

    def met(event: Event) -> bool:
        return any("cue" in pair for pair in event.pairs)

    rollout = simulate(TABLE, layout, shot, until=met)
    sent = rollout.ball_at("1", rollout.duration)
    assert math.atan2(sent.vy, sent.vx) == pytest.approx(way.direction, abs=GOOD)
    assert simulate(TABLE, layout, shot).layout()["1"].phase == "pocketed"


def test_a_ball_that_cannot_be_met_gives_no_aim() -> None:
    layout = Layout([Ball("cue", 1.0, 0.5), Ball("1", 1.6, 0.8), Ball("2", 1.3, 0.65)])
    way = next(pot_lines(TABLE, layout.without("2"), layout["cue"], ("1",), HAND))
    (shot,) = stroked(TABLE, layout.without("2"), "cue", way, 0.0, 0.0, (1.3,))
    assert aimed_at(TABLE, layout, shot, "1", way.direction, way.lead) is None
