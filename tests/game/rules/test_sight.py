"""What a cue ball sees of the balls on, along a line with balls on it, from every side."""

from __future__ import annotations

import math

import pytest

from pool2d import Ball, Layout, load_table
from pool2d.game.rules.sight import sees, sees_full, snookered, snookering

TABLE = load_table("snooker-12ft")
MIDDLE = (0.5 * TABLE.knobs.table.length, 0.5 * TABLE.knobs.table.width)
RADIUS = TABLE.knobs.ball.radius


def along(way: float, *places: tuple[str, float, float]) -> Layout:
    """Balls on a line through the middle of the table: how far along it and how far to its left, m."""
    cos, sin = math.cos(math.radians(way)), math.sin(math.radians(way))
    return Layout(
        Ball(ball, MIDDLE[0] + far * cos - aside * sin, MIDDLE[1] + far * sin + aside * cos)
        for ball, far, aside in places
    )


@pytest.mark.parametrize("way", [0.0, 50.0, 90.0, 180.0, 270.0, 311.0])
def test_of_two_balls_in_the_way_the_nearer_snookers(way: float) -> None:
    for order in (("blue", "pink"), ("pink", "blue")):
        layout = along(way, ("cue", -0.7, 0.0), (order[0], -0.4, 0.0), (order[1], 0.2, 0.0), ("red1", 0.7, 0.0))
        cue = layout["cue"]
        assert snookering(TABLE, layout, cue, ("red1",)) == order[0]
        assert snookered(TABLE, layout, cue, ("red1",)) and not sees_full(TABLE, layout, cue, ("red1",))
        assert not snookered(TABLE, layout, cue, ("red1",), by=())


@pytest.mark.parametrize("way", [0.0, 50.0, 180.0, 311.0])
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_half_way_a_ball_hides_by_how_far_it_stands_aside(way: float, side: float) -> None:
    """Half way between equal balls the lines to the edges pass a radius beside the middle one, on either side."""
    for aside in (0.9, 1.1, 1.9, 2.1, 2.9, 3.1):
        layout = along(way, ("cue", -0.6, 0.0), ("blue", 0.0, side * aside * RADIUS), ("red1", 0.6, 0.0))
        cue = layout["cue"]
        assert sees_full(TABLE, layout, cue, ("red1",)) == (aside > 2.0)
        assert snookered(TABLE, layout, cue, ("red1",)) == (aside < 3.0)
        assert snookering(TABLE, layout, cue, ("red1",)) == ("blue" if aside < 3.0 else "")
        assert sees(TABLE, layout, cue, ("red1",)) == (aside > 1.0)


def test_a_ball_on_hides_no_ball_on() -> None:
    layout = along(0.0, ("cue", -0.7, 0.0), ("red1", 0.0, 0.0), ("red2", 0.7, 0.0))
    assert not snookered(TABLE, layout, layout["cue"], ("red1", "red2"))
    assert snookering(TABLE, layout, layout["cue"], ("red1", "red2")) == ""
    assert snookering(TABLE, layout, layout["cue"], ("red2",)) == "red1"
