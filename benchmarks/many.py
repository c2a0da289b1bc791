"""Many shots: two processes against one, and what is held meanwhile: `python -m benchmarks.many`. It judges nothing.

Two busy loops beside each other show what the machine gives two processes at that moment, so they alternate with the
shots. Seconds are those of a clock, less what starting the processes takes, which is told by itself; on a machine that
has others to serve too, the processor time of a shot tells more: handing out and taking back are in it.
"""

from __future__ import annotations

import argparse
import os
import random
import resource
import statistics
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from multiprocessing import get_context

from pool2d import Layout, Shot, Table, load_table, simulate_many
from pool2d.study.simulate_many import each_chunk
from pool2d.study.workers import processes

# Steps of a busy loop.
_STEPS = 20_000_000


def spin(steps: int) -> None:
    """Keep a processor busy."""
    x = 0.5
    for _ in range(steps):
        x = 3.9 * x * (1.0 - x)


def hand(count: int, seed: int = 1) -> Iterator[Shot]:
    """Breaks as a hand plays them that errs."""
    rng = random.Random(seed)
    return (Shot(angle=rng.gauss(0.0, 0.3), speed=max(0.5, rng.gauss(8.0, 0.3))) for _ in range(count))


def clocked(task: Callable[[], object]) -> float:
    """The seconds that a task takes."""
    begin = time.perf_counter()
    task()
    return time.perf_counter() - begin


def loops(count: int) -> float:
    """The seconds that so many busy loops take beside each other."""
    context = get_context("spawn")
    with context.Pool(count) as pool:
        pool.map(abs, range(count), 1)
        return clocked(lambda: pool.map(spin, [_STEPS] * count, 1))


def busy() -> float:
    """Processor time of this process and of those that it has started and that have ended, s."""
    usages = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(usage.ru_utime + usage.ru_stime for usage in usages)


def timed(table: Table, layout: Layout, count: int, shots: int) -> tuple[float, float, float]:
    """Seconds to play with so many processes, seconds to begin, and processor seconds of both."""
    before = busy()
    with processes(count) as pool:
        # Every process has begun once each has something to do.
        begin = clocked(lambda: simulate_many(table, layout, hand(2 * count), executor=pool, chunk=1))
        seconds = clocked(lambda: simulate_many(table, layout, hand(shots), executor=pool))
    return seconds, begin, busy() - before


def played(table: Table, layout: Layout, count: int, shots: int) -> tuple[float, float, float]:
    """The same, but processor seconds to play alone: what a process has cost is known only when it has ended."""
    _, _, beginning = timed(table, layout, count, 0)
    seconds, begin, cost = timed(table, layout, count, shots)
    return seconds, begin, cost - beginning


def compare(table: Table, layout: Layout, shots: int, rounds: int) -> None:
    """Print how much faster two processes are than one, beside two busy loops."""
    print(f"{'':>8} {'loops':>7} {'shots':>7}   CPU of a shot, ms: by one, by two   begin, s")
    ratios, costs = [], []
    for number in range(rounds):
        one, two = loops(1), loops(2)
        (first, _, single), (second, begin, double) = (played(table, layout, count, shots) for count in (1, 2))
        ratios.append((2.0 * one / two, first / second))
        costs.append((1e3 * single / shots, 1e3 * double / shots))
        print(
            f"{number + 1:>8} {ratios[-1][0]:7.2f} {ratios[-1][1]:7.2f}   {costs[-1][0]:.3f} {costs[-1][1]:.3f}", end=""
        )
        print(f"   {begin:.2f}", flush=True)
    loop, shot = (statistics.median(values) for values in zip(*ratios, strict=True))
    print(f"{'median':>8} {loop:7.2f} {shot:7.2f}   ", end="")
    print(*(f"{statistics.median(values):.3f}" for values in zip(*costs, strict=True)))


def held() -> float:
    """What this process holds, MiB."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize() / 2**20


def memory(table: Table, layout: Layout, shots: int, executor: Executor) -> None:
    """Print what this process holds as shots without number go by, and what columns of a tenth of them hold."""
    parts = each_chunk(table, layout, hand(sys.maxsize), executor=executor)
    done = 0
    for mark in (shots // 10, shots // 2, shots):
        while done < mark:
            done += len(next(parts))
        print(f"after {done:>7} shots {held():7.1f} MiB")
    before = held()
    many = simulate_many(table, layout, hand(shots // 10), executor=executor)
    size = sum(column.nbytes for column in (many.x, many.y, many.pocket, many.cushions)) / 2**20
    print(
        f"columns of {len(many)} shots: {held() - before:.1f} MiB more, {size:.1f} MiB of it places, pockets, cushions"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--shots", type=int, default=2000, help="breaks in each run (2000)")
    parser.add_argument("--rounds", type=int, default=5, help="how often one and two are compared (5)")
    parser.add_argument("--memory", type=int, default=0, metavar="N", help="what is held over N shots instead")
    arguments = parser.parse_args()
    table = load_table("pool-7ft")
    layout = table.rack("eight-ball", seed=1)
    if arguments.memory:
        with processes(os.cpu_count() or 1) as pool:
            memory(table, layout, arguments.memory, pool)
    else:
        compare(table, layout, arguments.shots, arguments.rounds)


if __name__ == "__main__":
    main()
