"""Random tables, layouts and shots from the whole range of everything, for `benchmarks.fuzz --wide`.

A table is any preset, with its own knobs, a few turned, or all of them, each anywhere in its range or at an end
of it. Balls are strewn, stand in a grid that touches, in a row along a rail, before a pocket's jaws or on its lip;
some are frozen to others, some move and spin as fast as a scenario may have them.
"""

from __future__ import annotations

import math
import random

from pool2d import Ball, InputError, Layout, Shot, Table, load_table
from pool2d.config.knobs import Knob, walk
from pool2d.table.placing import RANGES
from pool2d.table.preset import presets

_PRESETS = presets()
_ROUNDS = 200


def wide(seed: str) -> tuple[Table, Layout, Shot | None]:
    """A table, a layout on it, and a shot, or none where balls move."""
    rng = random.Random(seed)
    table = _table(rng)
    while True:
        layout = rng.choice((_strewn, _strewn, _grid, _row, _jaws, _lips))(table, rng)
        if layout:
            layout = _moving(layout, rng) if rng.random() < 0.3 else layout
            try:
                return table, table.settle(layout), _shot(layout, rng)
            except InputError:
                # Sizes that a grid cannot hold, say: another layout.
                continue


def _table(rng: random.Random) -> Table:
    table = load_table(rng.choice(_PRESETS))
    share = rng.choice((0.0, 0.0, 0.15, 1.0))
    turned = {}
    for name, knob, _ in walk(table.knobs):
        if rng.random() < share:
            turned[name] = _value(knob, rng)
    # What contradicts itself is taken back, one knob at a time.
    while turned:
        try:
            return table.with_knobs(turned)
        except InputError:
            turned.pop(rng.choice(list(turned)))
    return table


def _value(knob: Knob, rng: random.Random) -> float | str:
    if knob.choices:
        return rng.choice(knob.choices)
    inside = rng.uniform(knob.lo, knob.hi)
    if knob.lo > 0.0:
        inside = rng.choice((inside, knob.lo * (knob.hi / knob.lo) ** rng.random()))
    return rng.choice((knob.lo, knob.hi, inside, inside))


def _add(table: Table, layout: Layout, ball: Ball) -> Layout:
    """The layout with a ball, where there is room for it."""
    return layout.put(ball) if table.has_room(ball.x, ball.y, table.body_of(ball)[0], layout) else layout


def _ball(layout: Layout, x: float, y: float, rng: random.Random, lowest: float | None = None) -> Ball:
    name = str(len(layout)) if layout else "cue"
    if lowest is None:
        return Ball(name, x, y)
    least = max(RANGES["radius"].lo, lowest)
    radius = rng.choice((None, least, RANGES["radius"].hi, rng.uniform(least, 0.06)))
    mass = rng.choice((None, RANGES["mass"].lo, RANGES["mass"].hi, rng.uniform(0.1, 0.3)))
    return Ball(name, x, y, radius=radius, mass=mass)


def _strewn(table: Table, rng: random.Random) -> Layout:
    """Balls anywhere, a third of them sent on until they touch something."""
    layout, size = Layout(), table.knobs.table
    # A ball of its own size must stand higher than the nose.
    lowest = 0.51 * table.knobs.cushion.nose_height if rng.random() < 0.3 else None
    count = rng.randint(1, 16)
    for _ in range(_ROUNDS):
        ball = _ball(layout, rng.uniform(0.0, size.length), rng.uniform(0.0, size.width), rng, lowest)
        if len(layout) < count and table.has_room(ball.x, ball.y, table.body_of(ball)[0], layout):
            layout = layout.put(_frozen(table, ball, layout, rng) if rng.random() < 1 / 3 else ball)
    return layout


def _frozen(table: Table, ball: Ball, layout: Layout, rng: random.Random) -> Ball:
    way = rng.uniform(-math.pi, math.pi)
    dx, dy = math.cos(way), math.sin(way)
    distance, what = table.cast(ball.x, ball.y, dx, dy, layout, table.body_of(ball)[0], ball.id)
    if what is None or any(pocket.name == what for pocket in table.geometry.pockets):
        return ball
    return ball._replace(x=ball.x + dx * distance, y=ball.y + dy * distance)


def _grid(table: Table, rng: random.Random) -> Layout:
    """Rows and columns that touch, square or packed, somewhere or in a corner; the cue ball is one of them or not."""
    size, radius = table.knobs.table, table.knobs.ball.radius
    reach, pitch = table.reach(radius), 2.0 * radius + rng.choice((0.0, 5e-10, 1e-6))
    packed, height = rng.random() < 0.5, rng.randint(1, 7)
    rise = pitch * (math.sqrt(0.75) if packed else 1.0)
    x0 = rng.choice((reach, rng.uniform(reach, size.length)))
    y0 = rng.choice((reach, rng.uniform(reach, size.width)))
    layout = Layout()
    for i in range(rng.randint(1, 28)):
        column, row = divmod(i, height)
        shift = 0.5 * pitch * (column % 2) if packed else 0.0
        layout = _add(table, layout, _ball(layout, x0 + column * rise, y0 + row * pitch + shift, rng))
    return layout


def _row(table: Table, rng: random.Random) -> Layout:
    """A row along a rail, touching it and each other, or nearly."""
    radius = table.knobs.ball.radius
    gap = rng.choice((0.0, 1e-9, 1e-5))
    layout, x0 = Layout(), rng.uniform(0.1, 0.5) * table.knobs.table.length
    for i in range(rng.randint(2, 8)):
        layout = _add(table, layout, _ball(layout, x0 + i * (2.0 * radius + gap), table.reach(radius) + gap, rng))
    return layout


def _jaws(table: Table, rng: random.Random) -> Layout:
    """Balls sent toward pockets until they touch a jaw, or each other."""
    layout = Layout()
    for _ in range(rng.randint(1, 6)):
        layout = _toward_pocket(table, layout, rng)
    return layout or _strewn(table, rng)


def _toward_pocket(table: Table, layout: Layout, rng: random.Random) -> Layout:
    if not table.geometry.pockets:
        return layout
    pocket = rng.choice(table.geometry.pockets)
    size = table.knobs.table
    ball = _ball(layout, rng.uniform(0.2, 0.8) * size.length, rng.uniform(0.2, 0.8) * size.width, rng)
    if not table.has_room(ball.x, ball.y, table.body_of(ball)[0], layout):
        return layout
    way = math.atan2(pocket.y - ball.y, pocket.x - ball.x) + rng.gauss(0.0, 0.05)
    dx, dy = math.cos(way), math.sin(way)
    distance, what = table.cast(ball.x, ball.y, dx, dy, layout)
    if what is None or what == pocket.name:
        return layout
    return _add(table, layout, ball._replace(x=ball.x + dx * distance, y=ball.y + dy * distance))


def _lips(table: Table, rng: random.Random) -> Layout:
    """Balls whose centres stand a hair outside a pocket's rim."""
    layout = Layout()
    for pocket in table.geometry.pockets:
        middle = (0.5 * table.knobs.table.length, 0.5 * table.knobs.table.width)
        way = math.atan2(middle[1] - pocket.y, middle[0] - pocket.x) + rng.gauss(0.0, 0.3)
        far = pocket.radius + rng.choice((1e-12, 1e-9, 1e-6, 1e-3))
        layout = _add(table, layout, _ball(layout, pocket.x + far * math.cos(way), pocket.y + far * math.sin(way), rng))
    return layout or _strewn(table, rng)


def _moving(layout: Layout, rng: random.Random) -> Layout:
    """The same with velocities and spins, some tiny, some as large as allowed."""

    def number(name: str) -> float:
        most = RANGES[name].hi
        return rng.choice(
            (0.0, rng.uniform(-most, most), 10.0 ** rng.uniform(-10.0, 0.0), 0.1 * rng.uniform(-most, most))
        )

    return Layout(
        ball._replace(vx=number("vx"), vy=number("vy"), wx=number("wx"), wy=number("wy"), wz=number("wz"))
        if rng.random() < 0.5
        else ball
        for ball in layout.values()
    )


def _shot(layout: Layout, rng: random.Random) -> Shot:
    side, height = rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)
    size = max(1.0, math.hypot(side, height) * (1.0 + 1e-9))
    return Shot(
        angle=rng.choice((0.0, 90.0, 180.0, -90.0, *(rng.uniform(-180.0, 180.0) for _ in range(4)))),
        speed=rng.choice((0.0, 50.0, rng.uniform(0.0, 12.0), min(10.0 ** rng.uniform(-6.0, 1.7), 50.0))),
        side=side / size,
        height=height / size,
        elevation=rng.choice((0.0, 90.0, 89.999, rng.uniform(0.0, 90.0))),
        ball=rng.choice(list(layout)),
    )
