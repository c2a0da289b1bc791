"""The furniture of a table: spots, lines, ball groups and racks, and how a rack is filled."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass, field

from .physics.values import Ball, Layout


@dataclass(frozen=True, slots=True)
class Rack:
    """Balls in a triangular lattice: `rows` lead from the spot away from the head.

    A slot names a ball, a group, or "any". `gap` is the room between neighbours, m.
    """

    spot: str
    rows: tuple[tuple[str, ...], ...]
    gap: float = 0.0


@dataclass(frozen=True, slots=True)
class Furniture:
    """What stands on a table and is marked on it: the preset's marks, balls and racks."""

    head_string: float | None = None
    sights: int = 0
    sight_inset: float = 0.0
    spots: dict[str, tuple[float, float]] = field(default_factory=dict)
    cue: str = "cue"
    groups: dict[str, tuple[str, ...]] = field(default_factory=dict)
    racks: dict[str, Rack] = field(default_factory=dict)

    @property
    def balls(self) -> list[str]:
        """Every ball of the set but the cue ball."""
        return [ball for group in self.groups.values() for ball in group]


def arrange(furniture: Furniture, name: str, radius: float, rng: random.Random) -> Layout:
    """The balls of the rack `name`, and the cue ball on the head spot.

    Open slots are drawn; the rack is mirrored or not; each ball lies somewhere within its gap.
    """
    rack = furniture.racks[name]
    filled = _fill(rack, furniture, rng)
    if rng.random() < 0.5:
        filled = [row[::-1] for row in filled]
    x0, y0 = furniture.spots[rack.spot]
    pitch = 2.0 * radius + rack.gap
    play = rack.gap / 2.0
    balls = [Ball(furniture.cue, *furniture.spots["head"])]
    for i, row in enumerate(filled):
        for j, ball in enumerate(row):
            off, way = play * rng.random(), math.tau * rng.random()
            x = x0 + i * pitch * math.sqrt(0.75) + off * math.cos(way)
            y = y0 + (j - (len(row) - 1) / 2.0) * pitch + off * math.sin(way)
            balls.append(Ball(ball, x, y))
    return Layout(balls)


def _fill(rack: Rack, furniture: Furniture, rng: random.Random) -> list[list[str]]:
    """The rack's slots as balls: named ones first, then groups, then any."""
    named = {slot for row in rack.rows for slot in row}
    left = [ball for ball in furniture.balls if ball not in named]
    rng.shuffle(left)

    def draw(slot: str) -> str:
        group = furniture.groups.get(slot)
        ball = slot if group is None else next(ball for ball in left if ball in group)
        if ball in left:
            left.remove(ball)
        return ball

    rows = [[slot if slot == "any" else draw(slot) for slot in row] for row in rack.rows]
    return [[left.pop() if slot == "any" else slot for slot in row] for row in rows]
