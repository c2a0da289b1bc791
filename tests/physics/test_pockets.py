"""Pockets: what follows in, what is refused, what hangs."""

from __future__ import annotations

import math

import pytest

from pool2d import Ball, Event, Layout, Rollout, Shot, load_table, simulate
from pool2d.physics.values import ROLLING

TABLE = load_table("pool-9ft")
RADIUS = TABLE.knobs.ball.radius


def first(rollout: Rollout, *kinds: str) -> Event:
    return next(event for event in rollout.events if event.kind in kinds)


def test_a_ball_follows_another_into_the_pocket() -> None:
    pocket = next(one for one in TABLE.geometry.pockets if one.name == "bottom-left")
    size = math.hypot(0.3 - pocket.x, 0.3 - pocket.y)
    ux, uy = (pocket.x - 0.3) / size, (pocket.y - 0.3) / size
    balls = [Ball("1", 0.3, 0.3), Ball("2", 0.3 - 2.2 * RADIUS * ux, 0.3 - 2.2 * RADIUS * uy)]
    moving = [ball._replace(vx=ux, vy=uy, wx=-uy / RADIUS, wy=ux / RADIUS) for ball in balls]
    rollout = simulate(TABLE, Layout(moving))
    assert [event.balls for event in rollout.events if event.kind == "ball_pocket"] == [("1",), ("2",)]


def test_a_fast_ball_at_a_bad_angle_is_refused() -> None:
    shot = Shot(angle=-20.0, speed=6.0)
    layout = Layout([Ball("cue", 1.05, 0.125)])
    met = [event.where for event in simulate(TABLE, layout, shot).events if event.where]
    # From the jaw across the table: where it goes from there is another matter.
    assert met[:2] == ["bottom-side jaw", "top-right"]


def test_a_slow_ball_hangs_on_the_shelf() -> None:
    """It rolls into the mouth of a corner pocket and stops before the slate ends."""
    pocket = next(one for one in TABLE.geometry.pockets if one.name == "top-right")
    size = math.hypot(2.2 - pocket.x, 0.93 - pocket.y)
    way = size - pocket.radius - 0.01
    speed = math.sqrt(2.0 * 0.01 * 9.81 * way)
    ux, uy = (pocket.x - 2.2) / size, (pocket.y - 0.93) / size
    ball = Ball("1", 2.2, 0.93, speed * ux, speed * uy, -speed * uy / RADIUS, speed * ux / RADIUS)
    rollout = simulate(TABLE, Layout([ball]))
    assert first(rollout, "rolling_resting").before["1"].phase == ROLLING
    end = rollout.layout()["1"]
    assert end.phase == "resting"
    assert math.hypot(end.x - pocket.x, end.y - pocket.y) == pytest.approx(pocket.radius + 0.01, abs=1e-6)
    assert TABLE.knobs.table.length - end.x < TABLE.reach(RADIUS)
