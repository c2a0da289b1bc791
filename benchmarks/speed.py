"""How fast shots are worked out: `python -m benchmarks.speed`. It prints, and judges nothing."""

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Callable, Iterable

import pool2d
from pool2d import Ball, Layout, Shot, Table, simulate
from pool2d.physics.body import Body
from pool2d.physics.contact import Contacts
from pool2d.physics.crowd import Crowd
from pool2d.physics.materials import materials
from pool2d.physics.motion import start
from tests.scenes import break_shot, random_shot

BREAKS, SHOTS = 15, 400
Scene = Callable[[Table, int], tuple[Layout, Shot]]


def timed(table: Table, scene: Scene, seeds: Iterable[int]) -> tuple[list[float], list[int]]:
    """The seconds that each shot took, without the making of its scene, and its events."""
    seconds, events = [], []
    for seed in seeds:
        layout, shot = scene(table, seed)
        begin = time.perf_counter()
        roll = simulate(table, layout, shot)
        seconds.append(time.perf_counter() - begin)
        events.append(len(roll.events))
    return seconds, events


def tight_break(table: Table, seed: int) -> tuple[Layout, Shot]:
    """Fifteen balls touching, struck a little off square; `seed` says how much."""
    knobs = table.knobs.ball
    balls = [Ball("cue", 0.635, 0.635 + 0.0005 * seed)]
    for i in range(5):
        for j in range(i + 1):
            x, y = 1.905 + i * math.sqrt(3.0) * knobs.radius, 0.635 + (2 * j - i) * knobs.radius
            balls.append(Ball(str(len(balls)), x, y))
    return Layout(balls), Shot(angle=0.0, speed=8.0)


def contact(table: Table, law: str) -> float:
    """Microseconds that one contact takes to solve: of two balls, or of a ball and a cushion."""
    radius, mass = table.knobs.ball.radius, table.knobs.ball.mass
    reach = table.reach(radius)
    made, elements = materials(table.physics), list(table.elements)
    rail = next(element for element in table.elements if element.name == "right")
    x, y = table.knobs.table.length - reach, 0.5 * table.knobs.table.width
    count, total = 4000, 0.0
    for i in range(count):
        spin = (i % 7 - 3) * 10.0
        moving = Ball("1", x if law == "cushion" else 1.0, y, 1.0, 0.3, spin, 30.0, -spin)
        a = Body(moving, 0, radius, mass, reach)
        b = Body(Ball("2", 1.0 + 2.0 * radius, y), 1, radius, mass, reach)
        contacts = Contacts(Crowd([a, b], [start(body, 0.0, made.cloth) for body in (a, b)]), elements, made)
        begin = time.perf_counter()
        if law == "ball":
            contacts.balls(a, b, 0.0)
        else:
            contacts.cushion(a, rail, 0.0)
        total += time.perf_counter() - begin
    return 1e6 * total / count


def main() -> None:
    table = pool2d.load_table("pool-9ft")
    # The first shots find cold caches; nobody waits for them.
    timed(table, random_shot, range(20))
    seconds, events = timed(table, break_shot, range(BREAKS))
    print(f"eight-ball break   {1e3 * statistics.median(seconds):8.2f} ms, median of {BREAKS}")
    print(f"                   {statistics.median(events):8.0f} events")
    print(f"                   {1e6 * sum(seconds) / sum(events):8.1f} us an event")
    seconds, events = timed(table, tight_break, range(BREAKS))
    print(f"tight break        {1e3 * statistics.median(seconds):8.2f} ms, median of {BREAKS}")
    print(f"                   {statistics.median(events):8.0f} events")
    seconds, events = timed(table, random_shot, range(SHOTS))
    print(f"16-ball shots      {SHOTS / sum(seconds):8.0f} a second, over {SHOTS}")
    print(f"                   {statistics.mean(events):8.1f} events")
    print(f"                   {1e6 * sum(seconds) / sum(events):8.1f} us an event")
    for law in ("ball", "cushion"):
        print(f"{law + ' contact':<18} {contact(table, law):8.1f} us")


if __name__ == "__main__":
    main()
