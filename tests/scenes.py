"""Scenes that the tests and the benchmarks share."""

from __future__ import annotations

import math
import random

import pool2d
from pool2d import Ball, Layout, Shot, Table

Play = tuple[Layout, Shot | None]


def open_table(**physics: float | str) -> Table:
    """The largest table, so that a ball may run far; `ball__mass=0.2` sets ball.mass."""
    knobs = {name.replace("__", "."): value for name, value in physics.items()}
    return pool2d.load_table("pool-9ft", {"table.length": 6.0, "table.width": 4.0, **knobs})


def break_shot(table: Table, seed: int) -> tuple[Layout, Shot]:
    """An eight-ball break, square and hard."""
    return table.rack("eight-ball", seed=seed), Shot(angle=0.0, speed=8.0)


def random_shot(table: Table, seed: int, balls: int = 16) -> tuple[Layout, Shot]:
    """Balls strewn over the table and a shot in any direction."""
    rng = random.Random(seed)
    knobs, radius = table.knobs.table, table.knobs.ball.radius
    layout = Layout()
    while len(layout) < balls:
        x, y = rng.uniform(0.0, knobs.length), rng.uniform(0.0, knobs.width)
        if table.has_room(x, y, radius, layout):
            layout = layout.put(Ball(str(len(layout)) if layout else "cue", x, y))
    shot = Shot(
        angle=rng.uniform(0.0, 360.0),
        speed=rng.uniform(0.2, 8.0),
        side=rng.uniform(-0.35, 0.35),
        height=rng.uniform(-0.35, 0.35),
        elevation=rng.uniform(0.0, 20.0),
    )
    return layout, shot


def frozen(table: Table) -> dict[str, Play]:
    """Balls that touch each other and the cushions, by name."""
    radius = table.knobs.ball.radius
    far, low = table.knobs.table.length - table.reach(radius), table.reach(radius)
    pair = 2.0 * radius
    row = [Ball("cue", far - 2.0 * pair, 0.4), Ball("1", far - pair, 0.4), Ball("2", far, 0.4)]
    along = [Ball("cue", 0.8, low), Ball("1", 0.8 + pair, low), Ball("2", 0.8 + 2.0 * pair, low)]
    triangle = [
        Ball("cue", 0.6, 0.6),
        Ball("1", 1.2, 0.6),
        Ball("2", 1.2 + pair * math.sqrt(0.75), 0.6 - radius),
        Ball("3", 1.2 + pair * math.sqrt(0.75), 0.6 + radius),
    ]
    return {
        "one on a rail, struck into it": (Layout([Ball("cue", 0.8, low)]), Shot(angle=-90.0, speed=2.0)),
        "one on a rail, struck along it": (Layout([Ball("cue", 0.8, low)]), Shot(angle=0.0, speed=2.0, side=0.3)),
        "one on a rail, pressed by its spin": (Layout([Ball("cue", 0.8, low, wx=70.0)]), None),
        "one on a rail, pressed as it slides along": (Layout([Ball("cue", 0.8, low, vx=1.0, wx=70.0)]), None),
        "a row into a rail": (Layout(row), Shot(angle=0.0, speed=3.0, height=0.3)),
        "a row into a rail, drawn": (Layout(row), Shot(angle=0.0, speed=3.0, height=-0.4)),
        "a row along a rail": (Layout(along), Shot(angle=0.0, speed=3.0)),
        "a row along a rail, into it": (Layout(along), Shot(angle=-45.0, speed=3.0)),
        "a triangle": (Layout(triangle), Shot(angle=0.0, speed=4.0)),
        "two, one spinning into the other": (
            Layout([Ball("cue", 1.0, 0.6, wy=20.0), Ball("1", 1.0 + pair, 0.6)]),
            None,
        ),
    }
