"""Whether balls may stand where a layout puts them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Protocol

from ..config.knobs import Knob
from ..errors import InputError
from ..physics.body import Body
from ..physics.detect import Element, Pocket
from ..physics.flight.bed import Bed
from ..physics.standing import Limits, in_range, stand_apart
from ..physics.values import GONE, MOTION_FIELDS, Ball, Layout
from .table_knobs import Knobs

# Balls drawn this much into each other or into a cushion, m, are set apart: numbers get rounded on
# their way through files. More is an error.
SLACK = 1e-6
# An overlap that counts as contact, m: less than the depth at which the engine looks for one.
CLOSE = 1e-10
ROUNDS = 2000
# Far more than any game has: so many are looked through in some hundredths of a second.
MOST_BALLS = 2000
# No ball moves as far as this, m, while balls are set apart: that many overlaps of 2 micrometres take 4 mm.
_REACH = 0.005
# How many pairs of balls are looked at while they are set apart, and how many of them a look at the cushions takes.
_WORK = 300_000
_WALL = 10
_LONGEST_ID = 40

RANGES: dict[str, Knob] = {
    "x": Knob(0.0, -100.0, 100.0, "m", "place along the table"),
    "y": Knob(0.0, -100.0, 100.0, "m", "place across the table"),
    "z": Knob(0.0, 0.0, 10.0, "m", "height of its lowest point above the cloth"),
    "vx": Knob(0.0, -50.0, 50.0, "m/s", "velocity along the table"),
    "vy": Knob(0.0, -50.0, 50.0, "m/s", "velocity across the table"),
    "vz": Knob(0.0, -50.0, 50.0, "m/s", "velocity upward"),
    "wx": Knob(0.0, -1000.0, 1000.0, "rad/s", "spin about the table's length"),
    "wy": Knob(0.0, -1000.0, 1000.0, "rad/s", "spin about the table's width"),
    "wz": Knob(0.0, -1000.0, 1000.0, "rad/s", "spin about the vertical"),
    "radius": Knob(0.028575, 0.01, 0.06, "m", "radius, the table's own where not given"),
    "mass": Knob(0.17, 0.01, 2.0, "kg", "mass, the table's own where not given"),
}
_LIMITS = Limits(
    *(RANGES[name].hi for name in ("x", "vx", "wx")),
    *(bound for name in ("radius", "mass") for bound in (RANGES[name].lo, RANGES[name].hi)),
)


class PlacingTable(Protocol):
    """What a table answers to who would put balls on it; see `table.Table`."""

    source: str
    knobs: Knobs
    surface: list[tuple[float, float]]

    @property
    def elements(self) -> Sequence[Element]: ...

    @property
    def bed(self) -> Bed: ...

    def body_of(self, ball: Ball) -> tuple[float, float]: ...

    def bodies(self, balls: Sequence[Ball]) -> list[Body]: ...

    def near(self, left: float, bottom: float, right: float, top: float) -> list[int]: ...

    def touch(self, a: Ball, b: Ball) -> float: ...

    def reach(self, radius: float) -> float: ...

    def on_cloth(self, x: float, y: float) -> bool: ...

    def element_gap(self, x: float, y: float, radius: float) -> tuple[float, Element | None]: ...


def check_id(name: object, source: str, key: str) -> str:
    """A ball's id; raises InputError for one that nobody could read or tell from another."""
    if not isinstance(name, str) or not name.isprintable() or name.strip() != name or not 0 < len(name) <= _LONGEST_ID:
        allowed = f"allowed is a text of printable characters, not empty, up to {_LONGEST_ID}, no blanks around it"
        raise InputError(source, key, name, allowed)
    return name


def settle(table: PlacingTable, layout: Layout) -> Layout:
    """The layout with its balls exactly where they may stand.

    Raises InputError for a number out of range, a ball off the table, in a pocket or a cushion, and
    for balls that overlap by more than rounding, or that cannot be set apart.
    """
    given = sorted(layout.on_table())
    if len(given) > MOST_BALLS:
        raise InputError(table.source, "balls", len(given), f"allowed are up to {MOST_BALLS} balls")
    if table.knobs.rail.height == 0.0 and _plain(table, given):
        return layout
    # Ball by ball, for what is to be told, or to be set apart.
    given = _check_aloft(table, given)
    gaps = [_check(table, ball) for ball in given]
    apart = all(gap >= -CLOSE for gap in gaps)
    close = _neighbours(table, given)
    for ball, near in zip(given, close, strict=True):
        for other in near:
            apart &= _overlap(table, given[other], ball) <= CLOSE
    return layout if apart else layout.put(*_set_apart(table, given, close))


def _plain(table: PlacingTable, balls: list[Ball]) -> bool:
    """Whether all is well at a quick look: most layouts are played again and again."""
    try:
        bodies = table.bodies(balls)
        return in_range(bodies, _LIMITS) and stand_apart(bodies, list(table.elements), table.surface, CLOSE)
    except TypeError:
        # A number that is none.
        return False


def mirrored(table: PlacingTable, layout: Layout, ends: bool = False) -> Layout:
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
    return ball.still()._replace(phase=ball.phase) if ball.phase in GONE else ball.still()


def _check_aloft(table: PlacingTable, given: list[Ball]) -> list[Ball]:
    """The balls that lie on the cloth; raises InputError where one off it may not be where it is."""
    for ball in given:
        if ball.z != 0.0:
            _check_numbers(table, ball)
            radius = table.body_of(ball)[0]
            room, what = table.bed.room(ball.x, ball.y, ball.z, radius)
            for other in given:
                if other.id != ball.id and (gap := _room_between(table, ball, other)) < room:
                    room, what = gap, f"ball {other.id}"
            if room < -SLACK:
                allowed = f"the ball is in {what}, by {-room:.3g} m; allowed is none"
                raise InputError(table.source, f"balls.{ball.id}.x, y, z", (ball.x, ball.y, ball.z), allowed)
    return [ball for ball in given if ball.z == 0.0]


def _room_between(table: PlacingTable, a: Ball, b: Ball) -> float:
    """How far two balls are apart in three dimensions, m."""
    r, s = table.body_of(a)[0], table.body_of(b)[0]
    return math.hypot(a.x - b.x, a.y - b.y, a.z + r - b.z - s) - r - s


def _check_numbers(table: PlacingTable, ball: Ball) -> None:
    """Raises InputError for a number out of its range."""
    source = table.source
    for name in MOTION_FIELDS:
        RANGES[name].check(getattr(ball, name), source, f"balls.{ball.id}.{name}")
    for name in ("radius", "mass"):
        if (value := getattr(ball, name)) is not None:
            RANGES[name].check(value, source, f"balls.{ball.id}.{name}")
    radius, nose = table.body_of(ball)[0], table.knobs.cushion.nose_height
    if nose >= 2.0 * radius:
        allowed = f"a ball must be higher than the cushion's nose, {nose:g} m"
        raise InputError(source, f"balls.{ball.id}.radius", radius, allowed)
    if radius > nose and table.knobs.rail.height > 0.0:
        allowed = (
            f"its centre is above the cushion's nose, {nose:g} m: then the rail's top must be level, rail.height = 0"
        )
        raise InputError(source, f"balls.{ball.id}.radius", radius, allowed)


def _check(table: PlacingTable, ball: Ball) -> float:
    """The room between a ball and the nearest element, m; raises InputError where the ball may not stand."""
    _check_numbers(table, ball)
    source, radius = table.source, table.body_of(ball)[0]
    if not table.on_cloth(ball.x, ball.y):
        knobs, reach = table.knobs.table, table.reach(radius)
        allowed = (
            f"the ball is off the table; allowed is x from {reach:.4f} to {knobs.length - reach:.4f} m"
            f" and y from {reach:.4f} to {knobs.width - reach:.4f} m, within the outline"
        )
        raise InputError(source, f"balls.{ball.id}.x, y", (ball.x, ball.y), allowed)
    gap, element = table.element_gap(ball.x, ball.y, radius)
    if gap < -SLACK and element is not None:
        what = "in the pocket" if isinstance(element, Pocket) else "inside the cushion"
        allowed = f"the ball is {what} {element.name}, by {-gap:.3g} m; allowed is none"
        raise InputError(source, f"balls.{ball.id}.x, y", (ball.x, ball.y), allowed)
    return gap


def _overlap(table: PlacingTable, a: Ball, b: Ball) -> float:
    """How far two balls are drawn into each other; raises InputError where that is more than rounding."""
    overlap = table.touch(a, b) - math.hypot(a.x - b.x, a.y - b.y)
    if overlap > 2.0 * SLACK:
        allowed = f"the balls overlap by {overlap:.3g} m; allowed is none"
        raise InputError(table.source, f"balls.{b.id}, balls.{a.id}", (b.x, b.y), allowed)
    return overlap


def _neighbours(table: PlacingTable, balls: Sequence[Ball]) -> list[list[int]]:
    """For each ball the earlier ones that it may come to touch while balls are set apart, by their places."""
    far = _REACH + max([2.0 * table.body_of(ball)[0] for ball in balls], default=0.0)
    found: list[list[int]] = [[] for _ in balls]
    # Along the table one after the other: who is near follows soon.
    row = sorted([(ball.x, ball.y, i) for i, ball in enumerate(balls)])
    for k, (x, y, i) in enumerate(row, 1):
        while k < len(row) and row[k][0] < x + far:
            _, other, j = row[k]
            if -far < other - y < far:
                found[max(i, j)].append(min(i, j))
            k += 1
    for near in found:
        near.sort()
    return found


def _set_apart(table: PlacingTable, given: Sequence[Ball], close: Sequence[Sequence[int]]) -> list[Ball]:
    """The balls that had to move out of what they were drawn a hair into, where they are then.

    Setting one pair apart presses the next; a rack settles in some tens of rounds. Raises InputError where
    they have no room to part, or are so many that it would take too long.
    """
    x, y = [ball.x for ball in given], [ball.y for ball in given]
    pairs = [[(j, table.touch(ball, given[j])) for j in close[i]] for i, ball in enumerate(given)]
    walled = [_walled(table, ball) for ball in given]
    rounds = min(ROUNDS, _WORK // (sum(map(len, pairs)) + _WALL * sum(walled) + 1))
    for _ in range(rounds):
        found = False
        for i, ball in enumerate(given):
            found |= walled[i] and _out_of_the_wall(table, ball, x, y, i)
            for j, touch in pairs[i]:
                found |= _part(x, y, i, j, touch)
        if not found:
            return [ball._replace(x=x[i], y=y[i]) for i, ball in enumerate(given) if (x[i], y[i]) != (ball.x, ball.y)]
    ids = [ball.id for ball in given]
    what = "have no room to part" if rounds == ROUNDS else f"are too many, {len(ids)}, to be set apart; leave them room"
    raise InputError(table.source, "balls", ids, f"the balls overlap and {what}")


def _walled(table: PlacingTable, ball: Ball) -> bool:
    """Whether a cushion is so near that the ball may be pressed into it."""
    far = table.body_of(ball)[0] + _REACH
    return bool(table.near(ball.x - far, ball.y - far, ball.x + far, ball.y + far))


def _out_of_the_wall(table: PlacingTable, ball: Ball, x: list[float], y: list[float], i: int) -> bool:
    """Move ball number i out of the cushion that it was drawn into; whether it had to move."""
    gap, element = table.element_gap(x[i], y[i], table.body_of(ball)[0])
    if gap >= -CLOSE or element is None or isinstance(element, Pocket):
        return False
    nx, ny = element.normal(x[i], y[i])
    x[i] += gap * nx
    y[i] += gap * ny
    return True


def _part(x: list[float], y: list[float], i: int, j: int, touch: float) -> bool:
    """Move two balls, each by a half, to where they touch; whether they had to move."""
    dx, dy = x[i] - x[j], y[i] - y[j]
    if abs(dx) >= touch or abs(dy) >= touch or (overlap := touch - math.hypot(dx, dy)) <= CLOSE:
        return False
    share = 0.5 * overlap / (touch - overlap)
    x[i] += share * dx
    y[i] += share * dy
    x[j] -= share * dx
    y[j] -= share * dy
    return True
