"""The energy of balls, and taking back what the rounding of an integration has added to it."""

from __future__ import annotations

import math

from .body import Body


def total(balls: list[Body]) -> float:
    """Kinetic energy of travel and spin, J. Summed exactly, so that the order of the balls is of no consequence."""
    return math.fsum([ball.energy() for ball in balls])


def take_back(balls: list[Body], before: float, anchored: bool) -> None:
    """Slow balls whose impact was integrated in steps to the energy they had `before`, J, if they have more.

    The momentum stays as it is, unless the balls are `anchored` by a cushion, which takes any. Of an elastic
    impact the steps miss some 1e-4 of the energy, to either side.
    """
    surplus = total(balls) - before
    if surplus <= 0.0:
        return
    vx = vy = 0.0
    if not anchored:
        mass = math.fsum([ball.mass for ball in balls])
        vx = math.fsum([ball.mass * ball.vx for ball in balls]) / mass
        vy = math.fsum([ball.mass * ball.vy for ball in balls]) / mass
    # The energy of travel about the common centre; it is the springs that the steps round.
    inner = math.fsum([_inner(ball, ball.vx - vx, ball.vy - vy) for ball in balls])
    if inner <= 0.0:
        return
    part = math.sqrt(max(0.0, 1.0 - surplus / inner)) * (1.0 - 1e-15)
    for ball in balls:
        ball.vx, ball.vy = vx + part * (ball.vx - vx), vy + part * (ball.vy - vy)


def _inner(ball: Body, vx: float, vy: float) -> float:
    return 0.5 * ball.mass * (vx * vx + vy * vy)
