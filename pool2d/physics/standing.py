"""Whether balls plainly stand where they may: all at once, as most layouts do."""

from __future__ import annotations

import math
from typing import final

from .body import Body
from .detect import Element, nearest

Point = tuple[float, float]


@final
class Limits:
    """How far from zero place, m, velocity, m/s, and spin, rad/s, may be; between what radius, m, and mass, kg, lie."""

    __slots__ = ("place", "speed", "spin", "least_radius", "most_radius", "least_mass", "most_mass")

    def __init__(
        self, place: float, speed: float, spin: float,
        least_radius: float, most_radius: float, least_mass: float, most_mass: float,
    ) -> None:  # fmt: skip
        self.place = place
        self.speed = speed
        self.spin = spin
        self.least_radius = least_radius
        self.most_radius = most_radius
        self.least_mass = least_mass
        self.most_mass = most_mass


def in_range(bodies: list[Body], limits: Limits) -> bool:
    """Whether every number is within its limits, and every ball at the height of the cloth."""
    place, speed, spin = limits.place, limits.speed, limits.spin
    for body in bodies:
        if not (
            -place <= body.x <= place and -place <= body.y <= place and body.z == 0.0 and -speed <= body.vz <= speed
            and -speed <= body.vx <= speed and -speed <= body.vy <= speed
            and -spin <= body.wx <= spin and -spin <= body.wy <= spin and -spin <= body.wz <= spin
            and limits.least_radius <= body.radius <= limits.most_radius
            and limits.least_mass <= body.mass <= limits.most_mass and body.reach > 0.0
        ):  # fmt: skip
            return False
    return True


def stand_apart(bodies: list[Body], elements: list[Element], surface: list[Point], slack: float) -> bool:
    """Whether all centres lie within a polygon, and no ball deeper than `slack`, m, in an element or another ball."""
    for body in bodies:
        if not inside(body.x, body.y, surface):
            return False
        if nearest(elements, body.x, body.y, body.radius, body.reach)[0] < -slack:
            return False
    # Along the table one after the other: who is near follows soon.
    largest = max([body.radius for body in bodies], default=0.0)
    row = sorted([(body.x, body.index) for body in bodies])
    for k, (x, i) in enumerate(row, 1):
        a = bodies[i]
        far = x + a.radius + largest
        while k < len(row) and row[k][0] < far:
            b = bodies[row[k][1]]
            if math.hypot(b.x - x, b.y - a.y) < 2.0 * math.sqrt(a.radius * b.radius) - slack:
                return False
            k += 1
    return True


def inside(x: float, y: float, polygon: list[Point]) -> bool:
    """Whether a point is inside a polygon: a ray from it crosses the edge an odd number of times."""
    found = False
    bx, by = polygon[-1]
    for ax, ay in polygon:
        if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
            found = not found
        bx, by = ax, ay
    return found
