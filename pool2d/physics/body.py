"""A ball at the present moment."""

from __future__ import annotations

from typing import final

from .values import Ball

Velocity = tuple[float, float, float, float, float]


@final
class Body:
    """What contacts change, and what a new motion starts from.

    Place and velocity hold at the time `t`, s. `reach` is how far from a nose, in plan, its centre is when it touches,
    m. Up to the time `paid`, s, it has had the cloth's friction in advance (see `pressing`). `held` counts how often in
    a row something in the air has only held it up.
    """

    __slots__ = (
        "id", "index", "radius", "mass", "reach", "x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz", "t",
        "paid", "held",
    )  # fmt: skip

    def __init__(self, ball: Ball, index: int, radius: float, mass: float, reach: float = 0.0) -> None:
        self.id: str = ball.id
        self.index = index
        self.radius = radius
        self.mass = mass
        self.reach = reach
        self.x: float = ball.x
        self.y: float = ball.y
        self.z: float = ball.z
        self.vx: float = ball.vx
        self.vy: float = ball.vy
        self.vz: float = ball.vz
        self.wx: float = ball.wx
        self.wy: float = ball.wy
        self.wz: float = ball.wz
        self.t = 0.0
        self.paid = 0.0
        self.held = 0

    def aloft(self) -> bool:
        """Whether it is off the cloth: in the air, or on a rail's top."""
        return self.z != 0.0 or self.vz != 0.0

    def velocity(self) -> Velocity:
        """Velocity and spin: (vx, vy, wx, wy, wz)."""
        return self.vx, self.vy, self.wx, self.wy, self.wz

    def set_velocity(self, velocity: Velocity) -> None:
        self.vx, self.vy, self.wx, self.wy, self.wz = velocity

    def energy(self) -> float:
        """Kinetic energy of travel and spin, J."""
        spin = self.wx * self.wx + self.wy * self.wy + self.wz * self.wz
        travel = self.vx * self.vx + self.vy * self.vy
        return 0.5 * self.mass * (travel + 0.4 * self.radius * self.radius * spin + self.vz * self.vz)
