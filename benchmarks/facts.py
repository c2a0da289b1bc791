"""What the presets' cushions and cloths amount to at the table: `python -m benchmarks.facts`.

For each preset: how much of its speed a rolling ball keeps that meets a cushion square, at once and when
it rolls again; where one goes that rolls in at 45 degrees, likewise; and how many lengths of the table
a ball runs that rolls off at 3.5 m/s.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from pool2d import Ball, Event, Layout, Table, load_table, simulate
from pool2d.physics.detect import Rail
from pool2d.physics.values import SLIDING
from pool2d.table.preset import presets


class Rebound(NamedTuple):
    """A ball that came off a cushion: parts of its speed, and angles from the normal in degrees."""

    off: float
    settled: float
    way_off: float
    way_settled: float


def rebound(table: Table, angle: float, speed: float = 1.0) -> Rebound:
    """A ball that rolls into the middle of the longest cushion, `angle` degrees from its normal."""
    rails = [element for element in table.elements if isinstance(element, Rail)]
    rail = max(rails, key=lambda each: each.length)
    x, y = rail.ax + 0.5 * rail.length * rail.dx, rail.ay + 0.5 * rail.length * rail.dy
    nx, ny = rail.normal(x, y)
    away = table.reach(table.knobs.ball.radius) + 1e-7
    turn = math.radians(angle)
    vx = speed * (nx * math.cos(turn) + rail.dx * math.sin(turn))
    vy = speed * (ny * math.cos(turn) + rail.dy * math.sin(turn))
    radius = table.knobs.ball.radius
    ball = Ball("1", x - nx * away, y - ny * away, vx, vy, -vy / radius, vx / radius)
    roll = simulate(table, Layout([ball]))
    first = next(i for i, event in enumerate(roll.events) if event.rails)
    after = roll.events[first].after["1"]
    rolls = next(motion for motion in roll.tracks["1"][first + 1 :] if motion.phase != SLIDING)

    def way(one: Ball) -> float:
        return math.degrees(math.atan2(abs(one.vx * rail.dx + one.vy * rail.dy), -(one.vx * nx + one.vy * ny)))

    settled = rolls.at(rolls.t0)
    return Rebound(_speed(after) / speed, _speed(settled) / speed, way(after), way(settled))


def lengths(table: Table, speed: float = 3.5) -> float:
    """How many lengths of the table a ball runs that rolls off at `speed` along it."""
    radius, knobs = table.knobs.ball.radius, table.knobs.table
    reach = table.reach(radius)
    ball = Ball("1", 2.0 * reach, 0.3 * knobs.width, speed, 0.0, 0.0, speed / radius)
    roll = simulate(table, Layout([ball]))
    ends = [*(event.before["1"].x for event in roll.events if _lengthwise(event)), roll.layout()["1"].x]
    here, total = ball.x, 0.0
    for x in ends:
        here, total = x, total + abs(x - here)
    return total / (knobs.length - 2.0 * reach)


def _lengthwise(event: Event) -> bool:
    """Whether an event turned the ball back along the table."""
    return bool(event.rails) and event.before["1"].vx * event.after["1"].vx < 0.0


def _speed(ball: Ball) -> float:
    return math.hypot(ball.vx, ball.vy)


def main() -> None:
    print(f"{'preset':20}{'square: off':>12}{'settled':>9}{'at 45: off':>12}{'settled':>9}{'lengths':>9}")
    for name in presets():
        table = load_table(name)
        square, oblique = rebound(table, 0.0), rebound(table, 45.0)
        print(
            f"{name:20}{square.off:12.3f}{square.settled:9.3f}{oblique.way_off:12.1f}{oblique.way_settled:9.1f}"
            f"{lengths(table):9.2f}"
        )


if __name__ == "__main__":
    main()
