"""Random play for hypothesis: balls free, frozen to whatever they meet, moving or still, and shots."""

from __future__ import annotations

import math

from hypothesis import strategies as st

from pool2d import Ball, Layout, Shot, Table

from .scenes import Play

UNIT = st.floats(0.0, 1.0)


def between(low: float, high: float) -> st.SearchStrategy[float]:
    """A number in a range, which shrinks towards zero where that is within."""
    return st.floats(low, high, allow_nan=False, allow_subnormal=False)


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
    """A layout of up to `most` balls and perhaps a shot."""
    knobs = table.knobs.table
    layout = Layout()
    for number in range(draw(st.integers(1, most))):
        radius = draw(st.sampled_from([0.022, 0.0255, 0.028575, 0.034])) if own_sizes else None
        mass = draw(st.sampled_from([0.1, 0.17, 0.3])) if own_sizes else None
        ball = Ball(
            f"b{number}" if number else "cue", draw(UNIT) * knobs.length, draw(UNIT) * knobs.width,
            radius=radius, mass=mass,
        )  # fmt: skip
        if not table.has_room(ball.x, ball.y, table.body_of(ball)[0], layout):
            continue
        if draw(st.booleans()):
            ball = _frozen(table, ball, draw(UNIT) * math.tau, layout)
        if draw(st.booleans()):
            ball = ball._replace(vx=draw(between(-8.0, 8.0)), vy=draw(between(-8.0, 8.0)))
        if draw(st.booleans()):
            spin = between(-300.0, 300.0)
            ball = ball._replace(wx=draw(spin), wy=draw(spin), wz=draw(spin))
        layout = layout.put(ball)
    return layout, draw(shots()) if "cue" in layout and draw(st.booleans()) else None


def _frozen(table: Table, ball: Ball, way: float, layout: Layout) -> Ball:
    """The ball sent along `way` until it touches something, unless that is a pocket."""
    dx, dy = math.cos(way), math.sin(way)
    distance, what = table.cast(ball.x, ball.y, dx, dy, layout, ball.radius)
    if what is None or any(pocket.name == what for pocket in table.geometry.pockets):
        return ball
    return ball._replace(x=ball.x + dx * distance, y=ball.y + dy * distance)
