"""Whether balls may stand where a layout puts them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .errors import InputError
from .knobs import Knob
from .physics.detect import Pocket
from .physics.values import MOTION_FIELDS, POCKETED, Ball, Layout

if TYPE_CHECKING:
    from .table import Table

# Balls drawn this much into each other or into a cushion, m, are set apart: numbers get rounded on
# their way through files. More is an error.
SLACK = 1e-6
# An overlap that counts as contact, m: less than the depth at which the engine looks for one.
CLOSE = 1e-10
ROUNDS = 2000

RANGES: dict[str, Knob] = {
    "x": Knob(0.0, -100.0, 100.0, "m", "place along the table"),
    "y": Knob(0.0, -100.0, 100.0, "m", "place across the table"),
    "vx": Knob(0.0, -50.0, 50.0, "m/s", "velocity along the table"),
    "vy": Knob(0.0, -50.0, 50.0, "m/s", "velocity across the table"),
    "wx": Knob(0.0, -1000.0, 1000.0, "rad/s", "spin about the table's length"),
    "wy": Knob(0.0, -1000.0, 1000.0, "rad/s", "spin about the table's width"),
    "wz": Knob(0.0, -1000.0, 1000.0, "rad/s", "spin about the vertical"),
    "radius": Knob(0.028575, 0.01, 0.06, "m", "radius, the table's own where not given"),
    "mass": Knob(0.17, 0.01, 2.0, "kg", "mass, the table's own where not given"),
}


def settle(table: Table, layout: Layout) -> Layout:
    """The layout with its balls exactly where they may stand.

    Raises InputError for a number out of range, a ball off the table, in a pocket or a cushion, and
    for balls that overlap by more than rounding, or that cannot be set apart.
    """
    given = sorted(layout.on_table())
    gaps = [_check(table, ball) for ball in given]
    largest = max((2.0 * table.body_of(ball)[0] for ball in given), default=0.0)
    close = [(a, b) for i, b in enumerate(given) for a in given[:i] if abs(a.x - b.x) < largest > abs(a.y - b.y)]
    overlaps = [_overlap(table, a, b) for a, b in close]
    if all(gap >= -CLOSE for gap in gaps) and all(overlap <= CLOSE for overlap in overlaps):
        return layout
    balls = list(given)
    # Setting one pair apart presses the next; a rack settles in some tens of rounds.
    for _ in range(ROUNDS):
        if not _set_apart(table, balls):
            return layout.put(*(ball for ball, old in zip(balls, given, strict=True) if ball is not old))
    raise InputError(table.source, "balls", [ball.id for ball in given], "the balls overlap and have no room to part")


def mirrored(table: Table, layout: Layout, ends: bool = False) -> Layout:
    """The layout seen in a mirror: its sides swapped, or its ends.

    Raises InputError where the table is not as symmetric.
    """
    size = table.knobs.table
    balls = (
        ball._replace(x=size.length - ball.x) if ends else ball._replace(y=size.width - ball.y)
        for ball in map(_at_rest, layout.values())
    )
    return settle(table, Layout(balls))


def _at_rest(ball: Ball) -> Ball:
    return ball.still()._replace(phase=POCKETED) if ball.phase == POCKETED else ball.still()


def _check(table: Table, ball: Ball) -> float:
    """The room between a ball and the nearest element, m; raises InputError where the ball may not stand."""
    source = table.source
    for name in MOTION_FIELDS:
        RANGES[name].check(getattr(ball, name), source, f"balls.{ball.id}.{name}")
    for name in ("radius", "mass"):
        if (value := getattr(ball, name)) is not None:
            RANGES[name].check(value, source, f"balls.{ball.id}.{name}")
    radius = table.body_of(ball)[0]
    if table.knobs.cushion.nose_height >= 2.0 * radius:
        allowed = f"a ball must be higher than the cushion's nose, {table.knobs.cushion.nose_height:g} m"
        raise InputError(source, f"balls.{ball.id}.radius", radius, allowed)
    place = (ball.x, ball.y)
    if not table.on_cloth(ball.x, ball.y):
        knobs, reach = table.knobs.table, table.reach(radius)
        allowed = (
            f"the ball is off the table; allowed is x from {reach:.4f} to {knobs.length - reach:.4f} m"
            f" and y from {reach:.4f} to {knobs.width - reach:.4f} m, within the outline"
        )
        raise InputError(source, f"balls.{ball.id}.x, y", place, allowed)
    gap, element = table.element_gap(ball.x, ball.y, radius)
    if gap < -SLACK and element is not None:
        what = "in the pocket" if isinstance(element, Pocket) else "inside the cushion"
        allowed = f"the ball is {what} {element.name}, by {-gap:.3g} m; allowed is none"
        raise InputError(source, f"balls.{ball.id}.x, y", place, allowed)
    return gap


def _overlap(table: Table, a: Ball, b: Ball) -> float:
    """How far two balls are drawn into each other; raises InputError where that is more than rounding."""
    overlap = table.touch(a, b) - math.hypot(a.x - b.x, a.y - b.y)
    if overlap > 2.0 * SLACK:
        allowed = f"the balls overlap by {overlap:.3g} m; allowed is none"
        raise InputError(table.source, f"balls.{b.id}, balls.{a.id}", (b.x, b.y), allowed)
    return overlap


def _set_apart(table: Table, balls: list[Ball]) -> bool:
    """Move balls out of what they were drawn a hair into, once round; whether any had to move."""
    found = False
    for i, ball in enumerate(balls):
        gap, element = table.element_gap(ball.x, ball.y, table.body_of(ball)[0])
        if gap < -CLOSE and element is not None and not isinstance(element, Pocket):
            nx, ny = element.normal(ball.x, ball.y)
            balls[i] = ball = ball._replace(x=ball.x + gap * nx, y=ball.y + gap * ny)
            found = True
        for j, other in enumerate(balls[:i]):
            touch = table.touch(ball, other)
            dx, dy = ball.x - other.x, ball.y - other.y
            if abs(dx) >= touch or abs(dy) >= touch or (overlap := touch - math.hypot(dx, dy)) <= CLOSE:
                continue
            share = 0.5 * overlap / (touch - overlap)
            balls[i] = ball = ball._replace(x=ball.x + share * dx, y=ball.y + share * dy)
            balls[j] = other._replace(x=other.x - share * dx, y=other.y - share * dy)
            found = True
    return found
