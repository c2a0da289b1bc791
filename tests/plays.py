"""Random play for hypothesis: balls free, frozen to whatever they meet, moving or still, and shots."""

from __future__ import annotations

import math
import random

from hypothesis import strategies as st

from pool2d import Ball, Layout, Shot, Table

from .scenes import Play


def between(low: float, high: float) -> st.SearchStrategy[float]:
    """A number in a range, to a millionth, zero among the first tried where it is within."""
    return st.floats(low, high).map(lambda value: round(value, 6))


def shots() -> st.SearchStrategy[Shot]:
    """Any shot that a cue can make, most of them clean."""
    return st.builds(
        Shot,
        angle=between(-360.0, 360.0) | st.sampled_from([0.0, 90.0, 180.0, -90.0, 45.0]),
        speed=between(0.0, 12.0),
        side=between(-0.7, 0.7),
        height=between(-0.7, 0.7),
        elevation=st.just(0.0) | between(0.0, 90.0),
    )


@st.composite
def plays(draw: st.DrawFn, table: Table, most: int = 16, own_sizes: bool = False) -> Play:
    """A layout of up to `most` balls and perhaps a shot.

    Hypothesis chooses how many balls, how many of them are frozen and move, and shrinks that; the places
    come from a seed, for its own numbers crowd round the simple ones.
    """
    count, frozen, moving = draw(st.integers(1, most)), draw(st.integers(0, 4)), draw(st.integers(0, 4))
    shot = draw(st.none() | shots())
    rng = random.Random(draw(st.integers(0, 2**32)))
    layout = Layout()
    while len(layout) < count:
        ball = _somewhere(table, layout, rng, own_sizes)
        if rng.randrange(4) < frozen:
            ball = _frozen(table, ball, layout, rng)
        if rng.randrange(4) < moving:
            ball = _moving(ball, rng)
        layout = layout.put(ball)
    return layout, shot


def _somewhere(table: Table, layout: Layout, rng: random.Random, own_sizes: bool) -> Ball:
    """A ball where there is room."""
    knobs = table.knobs.table
    name = f"b{len(layout)}" if layout else "cue"
    while True:
        radius = rng.choice([0.022, 0.0255, 0.028575, 0.034]) if own_sizes else None
        mass = rng.choice([0.1, 0.17, 0.3]) if own_sizes else None
        ball = Ball(name, rng.uniform(0.0, knobs.length), rng.uniform(0.0, knobs.width), radius=radius, mass=mass)
        if table.has_room(ball.x, ball.y, table.body_of(ball)[0], layout):
            return ball


def _frozen(table: Table, ball: Ball, layout: Layout, rng: random.Random) -> Ball:
    """The ball sent along until it touches something, unless that is a pocket."""
    way = rng.choice([0.0, 0.5, 1.0, 1.5, rng.uniform(0.0, 2.0)]) * math.pi
    dx, dy = math.cos(way), math.sin(way)
    distance, what = table.cast(ball.x, ball.y, dx, dy, layout, ball.radius)
    if what is None or any(pocket.name == what for pocket in table.geometry.pockets):
        return ball
    return ball._replace(x=ball.x + dx * distance, y=ball.y + dy * distance)


def _moving(ball: Ball, rng: random.Random) -> Ball:
    """The ball with a velocity, or a spin, or both, small or large."""
    speed, spin = rng.choice([0.0, 0.01, 1.0, 4.0]), rng.choice([0.0, 0.1, 10.0, 100.0])
    vx, vy = (rng.gauss(0.0, speed) for _ in range(2))
    wx, wy, wz = (rng.gauss(0.0, spin) for _ in range(3))
    return ball._replace(vx=vx, vy=vy, wx=wx, wy=wy, wz=wz)
