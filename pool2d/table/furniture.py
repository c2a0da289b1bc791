"""The furniture of a table: its outline, spots, lines, balls and racks, and how a rack is filled."""

from __future__ import annotations

import math
import random
from collections.abc import Mapping
from dataclasses import dataclass, field

from ..physics.values import Ball, Layout
from .outline import RECTANGLE, Corner, Point


@dataclass(frozen=True, slots=True)
class Rack:
    """How the balls stand at the start: `rows` of a triangular lattice and `placed` ones.

    The rows lead from `spot` away from the head; row number `on` lies on it, counted from 1. A slot
    names a ball, a group, or "any" of `balls` that is left. `gap` is the room between neighbours, m.
    `placed` balls stand where it says, as does the cue ball.
    """

    cue: Point
    spot: Point = (0.0, 0.0)
    on: int = 1
    rows: tuple[tuple[str, ...], ...] = ()
    balls: tuple[str, ...] = ()
    gap: float = 0.0
    placed: Mapping[str, Point] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Look:
    """What a ball looks like: colour as "#rrggbb", a stripe, dots, and a number, or none."""

    color: str
    stripe: bool = False
    dots: bool = False
    number: str = ""


@dataclass(frozen=True, slots=True)
class Finish:
    """What a table is made of to look at: the colours of its cloth and its wood, as "#rrggbb"."""

    cloth: str = "#1f8d7a"
    wood: str = "#8a4a26"


@dataclass(frozen=True, slots=True)
class Furniture:
    """What a preset says beside its knobs: outline, marks, finish, balls and racks.

    `outline` is in parts of the table's length and width; `head_string` and `d_radius` in m. Of balls
    that are unlike the others, `sizes` gives radius and mass, in m and kg, and `looks` the look.
    """

    outline: tuple[Corner, ...] = RECTANGLE
    head_string: float | None = None
    d_radius: float = 0.0
    sights: int = 0
    sight_inset: float = 0.0
    spots: Mapping[str, Point] = field(default_factory=dict)
    finish: Finish = Finish()
    cue: str = "cue"
    groups: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    sizes: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    looks: Mapping[str, Look] = field(default_factory=dict)
    racks: Mapping[str, Rack] = field(default_factory=dict)

    @property
    def balls(self) -> list[str]:
        """Every ball of the set but the cue ball."""
        return [ball for group in self.groups.values() for ball in group]


def arrange(furniture: Furniture, rack: Rack, radius: float, rng: random.Random) -> Layout:
    """The balls of a rack, and the cue ball.

    Open slots are drawn; the rack is mirrored or not; each ball lies somewhere within its gap.
    """
    filled = _fill(rack, furniture, rng)
    if rng.random() < 0.5:
        filled = [row[::-1] for row in filled]
    x0, y0 = rack.spot
    pitch = 2.0 * radius + rack.gap
    play = rack.gap / 2.0
    balls = [Ball(furniture.cue, *rack.cue)]
    for i, row in enumerate(filled):
        for j, ball in enumerate(row):
            off, way = play * rng.random(), math.tau * rng.random()
            x = x0 + (i + 1 - rack.on) * pitch * math.sqrt(0.75) + off * math.cos(way)
            y = y0 + (j - (len(row) - 1) / 2.0) * pitch + off * math.sin(way)
            balls.append(Ball(ball, x, y))
    balls += [Ball(ball, *place) for ball, place in rack.placed.items()]
    return Layout(balls)


def _fill(rack: Rack, furniture: Furniture, rng: random.Random) -> list[list[str]]:
    """The rack's slots as balls: named ones first, then groups, then any."""
    named = {slot for row in rack.rows for slot in row} | set(rack.placed)
    left = [ball for ball in rack.balls if ball not in named]
    rng.shuffle(left)

    def draw(slot: str) -> str:
        group = furniture.groups.get(slot)
        ball = slot if group is None else next(ball for ball in left if ball in group)
        if ball in left:
            left.remove(ball)
        return ball

    rows = [[slot if slot == "any" else draw(slot) for slot in row] for row in rack.rows]
    return [[left.pop() if slot == "any" else slot for slot in row] for row in rows]
