"""The five measurements that anyone can make at a table, and what the engine would show of each.

All are played on a bare rectangle of the table's length and width, along its middle: no pocket is in the way there,
and none would be at the table.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise

from ..config.knobs import Knob
from ..physics.event import Event
from ..physics.rollout import Rollout
from ..physics.simulate import simulate
from ..physics.values import Ball, Layout, Shot
from ..table.outline import Corner
from ..table.table import Table
from .readings import Quantity

BARE = (Corner(0.0, 0.0, "bottom"), Corner(1.0, 0.0, "right"), Corner(1.0, 1.0, "top"), Corner(0.0, 1.0, "left"))
# From here a ball is sent up the table, in parts of its length: the head spot of most tables.
_START = 0.25
# Speeds of a cue between which strokes are looked for, m/s.
_SOFTEST, _HARDEST = 0.05, 30.0
# By what the square of the speed is changed until the stroke lies between two.
_WIDER = 1.4
# How exactly a stroke is found, as a part of its speed, and the steps that it may take.
_EXACT, _STEPS = 1e-7, 60
# A spin that the cloth brings to rest, rad/s.
_SPIN = 10.0
# A ball this far from a nose, m, has not touched it yet.
_CLEAR = 1e-7

Given = Mapping[str, float]


@dataclass(frozen=True, slots=True)
class Measurement:
    """One of the five.

    Attributes:
        name: Its name, such as "lag".
        how: How it is made, in a few sentences.
        turns: The knob that it tells.
        seen: What comes of it.
        terms: What else has to be known of it: how hard, from where.
        play: What the engine shows of `seen` on a bare table, for the terms by name; infinite or 0 where the ball does
            not get so far.
    """

    name: str
    how: str
    turns: str
    seen: Quantity
    terms: tuple[Quantity, ...]
    play: Callable[[Table, Given], float]

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """All that is read off, what comes of it first."""
        return self.seen, *self.terms


def bare(table: Table) -> Table:
    """The table without its pockets and bends."""
    return Table(
        table.source, table.title, table.base, replace(table.furniture, outline=BARE), table.set, table.conditions
    )


def _lag(table: Table, given: Given) -> float:
    """How long a lag takes, s, by the stroke with which the ball comes to rest so far from the head cushion."""
    wanted = given["lag.gap"]

    def over(speed: float) -> float:
        return wanted - _short(table, _struck(table, speed, lambda event: "left" in _noses(event)))

    # It comes back with a little more than half its speed, and rolls out over a length.
    knobs = table.knobs
    speed = _stroke(over, 1.9 * math.sqrt(2.0 * knobs.cloth.mu_roll * knobs.gravity * knobs.table.length))
    return math.inf if speed is None else _struck(table, speed).duration


def _short(table: Table, roll: Rollout) -> float:
    """How far from the head cushion a ball comes to rest, m; less than 0 by what it would still have rolled."""
    last = roll.events[-1]
    (ball,) = (last.before if last.rails else last.after).values()
    if not last.rails:
        return ball.x - _reach(table, ball)
    return -(ball.vx * ball.vx) / (2.0 * table.knobs.cloth.mu_roll * table.knobs.gravity)


def _hard(table: Table, given: Given) -> float:
    """How many lengths a ball runs in all that takes so long to the foot cushion."""
    first = given["hard.first"]

    def early(speed: float) -> float:
        # A ball that does not get there is late by as much as its speed is short of that.
        roll = _struck(table, speed, lambda event: bool(event.rails))
        return first / roll.duration - 1.0 if roll.events[-1].rails else -1.0

    speed = _stroke(early, 0.7 * (1.0 - _START) * table.knobs.table.length / first)
    return 0.0 if speed is None else _lengths(table, _struck(table, speed))


def _lengths(table: Table, roll: Rollout) -> float:
    """The way of a ball that rolls up and down a table, in lengths of it."""
    (ball,) = roll.start.values()
    turns = [next(iter(event.before.values())).x for event in roll.events if event.rails]
    way = math.fsum(abs(b - a) for a, b in pairwise([ball.x, *turns, roll.layout()[ball.id].x]))
    return way / (table.knobs.table.length - 2.0 * _reach(table, ball))


def _reach(table: Table, ball: Ball) -> float:
    """How far from a nose a ball's centre is as it touches, m."""
    return table.reach(table.body_of(ball)[0])


def _spin(table: Table, given: Given) -> float:
    """How often a ball turns on the spot until it stops after so long: its spin falls evenly."""
    roll = simulate(table, Layout([_ball(table, 0.5, wz=_SPIN)]))
    return _SPIN / roll.duration * given["spin.seconds"] ** 2 / (2.0 * math.tau)


def _oblique(table: Table, given: Given) -> float:
    """The direction, in degrees from the normal, in which a ball rolls on that rolled in obliquely."""
    turn = math.radians(given["oblique.angle"])
    settled = _settled(table, math.cos(turn), math.sin(turn))
    # One that would roll into the cushion again goes along it.
    return math.degrees(math.atan2(settled.vx, max(0.0, settled.vy)))


def _rebound(table: Table, given: Given) -> float:
    """What part of its speed a ball has that rolled in square, once it rolls back; both where it passes a line."""
    speed = given["rebound.speed"]
    lost = 2.0 * table.knobs.cloth.mu_roll * table.knobs.gravity
    settled = _settled(table, speed, 0.0)
    # Where it still slides at the line, its speed is told where it rolls: as near to the line as can be.
    line = given["rebound.line"] + _reach(table, settled)
    back = settled.vy * settled.vy - lost * max(0.0, line - settled.y)
    there = speed * speed + lost * given["rebound.line"]
    return math.sqrt(max(0.0, back) / there) if settled.vy > 0.0 else 0.0


def _settled(table: Table, square: float, along: float) -> Ball:
    """A ball that rolled into the lower cushion with these speeds, m/s, at the moment when it rolls again."""
    ball = _ball(table, 0.5)
    radius = table.body_of(ball)[0]
    ball = ball._replace(
        y=table.reach(radius) + _CLEAR, vx=along, vy=-square, wx=square / radius, wy=along / radius
    )  # fmt: skip
    roll = simulate(table, Layout([ball]), until=lambda event: event.kind == "sliding_rolling")
    touch = next(event for event in roll.events if event.rails)
    return next((event for event in roll.events if event.t > touch.t), touch).after[ball.id]


def _struck(table: Table, speed: float, until: Callable[[Event], bool] | None = None) -> Rollout:
    """A ball sent up the table by a stroke in its centre."""
    ball = _ball(table, _START)
    return simulate(table, Layout([ball]), Shot(0.0, speed, ball=ball.id), until=until)


def _ball(table: Table, part: float, wz: float = 0.0) -> Ball:
    """The cue ball in the middle of the width, a part of the length from the head."""
    size = table.knobs.table
    return Ball(table.furniture.cue, part * size.length, 0.5 * size.width, wz=wz)


def _noses(event: Event) -> list[str]:
    """The cushions that were touched."""
    return [name for _, name in event.rails]


def _stroke(excess: Callable[[float], float], about: float) -> float | None:
    """The speed, m/s, of a stroke that is too soft while `excess` is below 0; None where none is hard enough.

    The search begins at `about`. A ball's way grows with the square of its speed: in that, `excess` is nearly a line,
    and is brought to 0 by false position (Illinois).
    """

    def beyond(square: float) -> float:
        return excess(math.sqrt(square))

    low = high = about * about
    while beyond(high) < 0.0:
        low, high = high, high * _WIDER
        if low > _HARDEST * _HARDEST:
            return None
    while beyond(low) >= 0.0:
        low, high = low / _WIDER, low
        if high < _SOFTEST * _SOFTEST:
            return None
    return math.sqrt(_root(beyond, low, high))


def _root(value: Callable[[float], float], low: float, high: float) -> float:
    """Where a rising function is 0, between two places where it is below and above that."""
    below, above, side = value(low), value(high), 0
    for _ in range(_STEPS):
        here = (low * above - high * below) / (above - below)
        found = value(here)
        if found < 0.0:
            above *= 0.5 if side < 0 else 1.0
            low, below, side = here, found, -1
        else:
            below *= 0.5 if side > 0 else 1.0
            high, above, side = here, found, 1
        if high - low < _EXACT * high or abs(found) < _EXACT:
            break
    return here


def _seen(name: str, lo: float, hi: float, unit: str, error: float, doc: str) -> Quantity:
    return Quantity(name, Knob(0.0, lo, hi, unit, doc), error)


def _term(
    name: str, usual: float, lo: float, hi: float, unit: str, error: float, doc: str, asked: bool = False
) -> Quantity:
    return Quantity(name, Knob(usual, lo, hi, unit, doc), error, assumed=True, asked=asked)


MEASUREMENTS = (
    Measurement(
        "lag",
        "Lag: from the head spot off the foot cushion and back, so that the ball dies at the head cushion. The head "
        "spot is a quarter of the length from the head.",
        "cloth.mu_roll",
        _seen("lag.seconds", 0.5, 120.0, "s", 0.2, "from the stroke until a lag up the table and back is at rest"),
        (_term("lag.gap", 0.0, 0.0, 2.0, "m", 0.05, "left between the ball and the head cushion", asked=True),),
        _lag,
    ),
    Measurement(
        "hard",
        "Hard ball: a hard stroke in the centre, from the head spot straight up the table. The way to the foot "
        "cushion is three quarters of a length, each way after it a whole one. A phone that records hears stroke "
        "and cushion.",
        "cushion.restitution",
        _seen("hard.lengths", 0.1, 100.0, "lengths", 0.1, "that a hard ball runs, from a quarter of the table on"),
        (_seen("hard.first", 0.1, 3.0, "s", 0.02, "from its stroke to its first cushion"),),
        _hard,
    ),
    Measurement(
        "spin",
        "Spinning ball: spin a ball on the spot and film it slowed down. Count its turns, and the seconds, from any "
        "moment until it stops.",
        "cloth.mu_spin",
        _seen("spin.turns", 0.1, 1000.0, "turns", 0.3, "that a ball spinning on the spot makes until it stops"),
        (_seen("spin.seconds", 0.1, 120.0, "s", 0.1, "that they take"),),
        _spin,
    ),
    Measurement(
        "oblique",
        "At 45 degrees: roll a ball, slowly and without english, into a long cushion at 45 degrees. It comes off, "
        "bends, and goes straight again: at what angle from the normal?",
        "cushion.friction",
        _seen("oblique.leaves", 0.1, 89.9, "degrees", 1.0, "from the normal, as a ball rolls on that rolled in at 45"),
        (_term("oblique.angle", 45.0, 20.0, 70.0, "degrees", 0.7, "from the normal, at which it rolls in"),),
        _oblique,
    ),
    Measurement(
        "rebound",
        "Straight ball: roll a ball square into a cushion. How fast does it roll back, as a part of how fast it "
        "came? Film it: the seconds over a stretch near the cushion, by those over the same stretch on the way "
        "back.",
        "cushion.restitution",
        _seen("rebound.kept", 0.01, 1.0, "", 0.02, "of its speed by a ball that rolls in square, once it rolls back"),
        (
            _term("rebound.line", 0.0, 0.0, 2.0, "m", 0.05, "from the cushion, where the speeds are compared"),
            _term("rebound.speed", 1.5, 0.2, 10.0, "m/s", 0.4, "with which it meets the cushion"),
        ),
        _rebound,
    ),
)  # fmt: skip
QUANTITIES = {quantity.name: quantity for each in MEASUREMENTS for quantity in each.quantities}
