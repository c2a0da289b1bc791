"""How fast shots are worked out: `python -m benchmarks.speed`. It prints, and judges nothing."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Iterable

import pool2d
from pool2d import Layout, Shot, Table, simulate
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


def main() -> None:
    table = pool2d.load_table("pool-9ft")
    # The first shots find cold caches; nobody waits for them.
    timed(table, random_shot, range(20))
    seconds, events = timed(table, break_shot, range(BREAKS))
    print(f"eight-ball break   {1e3 * statistics.median(seconds):8.2f} ms, median of {BREAKS}")
    print(f"                   {statistics.median(events):8.0f} events")
    print(f"                   {1e6 * sum(seconds) / sum(events):8.1f} us an event")
    seconds, events = timed(table, random_shot, range(SHOTS))
    print(f"16-ball shots      {SHOTS / sum(seconds):8.0f} a second, over {SHOTS}")
    print(f"                   {statistics.mean(events):8.1f} events")
    print(f"                   {1e6 * sum(seconds) / sum(events):8.1f} us an event")


if __name__ == "__main__":
    main()
