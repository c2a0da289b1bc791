"""A ball at the present moment."""

from __future__ import annotations

from .values import Ball

Velocity = tuple[float, float, float, float, float]


class Body:
    """What contacts change, and what a new motion starts from.

    Up to the time `paid`, s, it has had the cloth's friction in advance (see `pressing`).
    """

    __slots__ = ("id", "index", "radius", "mass", "x", "y", "vx", "vy", "wx", "wy", "wz", "paid")

    def __init__(self, ball: Ball, index: int, radius: float, mass: float) -> None:
        self.id = ball.id
        self.index = index
        self.radius = radius
        self.mass = mass
        self.x = ball.x
        self.y = ball.y
        self.vx = ball.vx
        self.vy = ball.vy
        self.wx = ball.wx
        self.wy = ball.wy
        self.wz = ball.wz
        self.paid = 0.0

    def velocity(self) -> Velocity:
        """Velocity and spin: (vx, vy, wx, wy, wz)."""
        return self.vx, self.vy, self.wx, self.wy, self.wz

    def set_velocity(self, velocity: Velocity) -> None:
        self.vx, self.vy, self.wx, self.wy, self.wz = velocity

    def energy(self) -> float:
        """Kinetic energy of travel and spin, J."""
        spin = self.wx * self.wx + self.wy * self.wy + self.wz * self.wz
        return 0.5 * self.mass * (self.vx**2 + self.vy**2 + 0.4 * self.radius * self.radius * spin)
