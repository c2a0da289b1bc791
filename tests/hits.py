"""One ball hit with another: the scene of the ball cases, through the engine and in hand.

The cue ball travels along +x and cuts the other, which lies at rest, to its left.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

from pool2d import Ball, Layout, Table, simulate
from pool2d.physics.body import Body
from pool2d.physics.detect import SKIN
from pool2d.physics.laws.registry import CUSHION_LAWS
from pool2d.physics.materials import materials
from pool2d.physics.params import BallKnobs, Physics
from pool2d.physics.values import SLIDING

from .scenes import open_table

Point = tuple[float, float]


class Hit(NamedTuple):
    """The balls right after the contact, and where each is as it stops sliding; the place of the contact."""

    cue: Ball
    other: Ball
    cue_rolls: Ball
    other_rolls: Ball
    ghost: Point
    slide: float


def hit(table: Table, cut: float, v: float = 1.0, topspin: float = 0.0, english: float = 0.0) -> Hit:
    """Cut a ball by an angle in degrees; spins are R w / v."""
    turn, radius = math.radians(cut), table.knobs.ball.radius
    # From so near that the cloth has no time to act, to a contact at exactly this angle.
    away, back = 2.0 * radius - SKIN, 1e-9 / math.cos(turn)
    ghost = (3.0 - away * math.cos(turn), 2.0 - away * math.sin(turn))
    cue = Ball("cue", ghost[0] - back, ghost[1], v, wy=topspin * v / radius, wz=english * v / radius)
    roll = simulate(table, Layout([cue, Ball("1", 3.0, 2.0)]))
    first = roll.events[0]
    assert first.kind == "ball_ball"
    rolls = []
    for name in ("cue", "1"):
        motion = next(motion for motion in roll.tracks[name] if motion.t0 >= first.t and motion.phase != SLIDING)
        rolls.append((motion.at(motion.t0), motion.t0 - first.t))
    return Hit(first.after["cue"], first.after["1"], rolls[0][0], rolls[1][0], ghost, rolls[0][1])


def speed(ball: Ball) -> float:
    return math.hypot(ball.vx, ball.vy)


def way(ball: Ball) -> float:
    """Direction of travel, degrees; for the cue ball to the right of its old one is negative."""
    return math.degrees(math.atan2(ball.vy, ball.vx))


def smooth(e: float) -> Table:
    return open_table(ball__law="frictionless", ball__restitution=e)


def greatest(value: Callable[[float], float], low: float, high: float) -> float:
    """Where in a range a function with one hump is greatest."""
    for _ in range(80):
        third = (high - low) / 3.0
        low, high = (low + third, high) if value(low + third) < value(high - third) else (low, high - third)
    return 0.5 * (low + high)


def touching(cut: float, v: float, wz: float) -> tuple[Body, Body]:
    """The two balls in contact, for what the engine's nanometres would blur."""
    turn, radius, mass = math.radians(cut), BallKnobs().radius, BallKnobs().mass
    cue = Body(Ball("cue", 0.0, 0.0, v, wz=wz), 0, radius, mass)
    return cue, Body(Ball("1", 2.0 * radius * math.cos(turn), 2.0 * radius * math.sin(turn)), 1, radius, mass)


def collide_balls(law: str, a: Body, b: Body, physics: Physics) -> None:
    """Let a law alone act on two balls that touch."""
    made = materials(replace(physics, ball=replace(physics.ball, law=law)))
    made.ball_law.collide(a, b, made.ball)


def collide_cushion(law: str, ball: Body, nx: float, ny: float, physics: Physics) -> None:
    """Let a law alone act on a ball that touches a cushion in the direction (nx, ny)."""
    CUSHION_LAWS[law].collide(ball, nx, ny, materials(physics).cushion)
