"""Random shots that look for a fault: `python -m benchmarks.fuzz --shots 100000 --seed 0 --jobs 2`.

A third of the balls are frozen to a rail or to another ball; speeds go to 12 m/s; one layout in eight
has balls of several sizes. With `--wide` tables, layouts and shots come from the whole range of everything
(see `wide`); with `--flights` every preset is played in turn, with the butt raised up to 80 degrees, balls that fly
already, and breaks at 12 m/s. A shot has to end, with every number finite, no overlap above 1 nm, every ball on the
table, in a pocket or off, no event that adds energy, and the same bits with its balls in another order. Prints how to
repeat each shot that fails, and a line of totals; the exit status is 1 where one failed.
"""

from __future__ import annotations

import argparse
import math
import random
import signal
import sys
import time
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from multiprocessing import Pool
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pool2d import Ball, BudgetError, Layout, Rollout, Shot, Table, load_table, simulate
from pool2d.physics.motion import Motion
from pool2d.physics.values import GONE, OFF, POCKETED, RESTING
from pool2d.table.preset import presets

from .wide import wide

NANOMETRE = 1e-9
SIZES = ((None, None), (0.0255, 0.12), (0.034, 0.28))
# A shot that takes more CPU than this, s, is taken not to end.
PATIENCE = 60
# One that takes more CPU than this, s, is counted as slow.
SLOW = 2.0
# Shots of fewer events are played again with their balls in another order.
_SHORT = 200
Floats = NDArray[np.float64]
# Where a ball is at each of some times, x, y and z, and whether it is on the table then.
Path = tuple[Floats, Floats, Floats, NDArray[np.bool_]]


class Result(NamedTuple):
    """One shot: its number, what is wrong with it, how many events it took, and how much CPU, s."""

    number: int
    faults: list[str]
    events: int
    seconds: float


def scene(table: Table, seed: str) -> tuple[Layout, Shot]:
    """A random layout and shot."""
    rng = random.Random(seed)
    knobs = table.knobs.table
    own_sizes = rng.random() < 1 / 8
    layout = Layout()
    for number in range(rng.randint(2, 16)):
        radius, mass = rng.choice(SIZES) if own_sizes else SIZES[0]
        ball = Ball(str(number) if number else "cue", 0.0, 0.0, radius=radius, mass=mass)
        while not table.has_room(ball.x, ball.y, table.body_of(ball)[0], layout):
            ball = ball._replace(x=rng.uniform(0.0, knobs.length), y=rng.uniform(0.0, knobs.width))
        layout = layout.put(freeze(table, ball, layout, rng) if rng.random() < 1 / 3 else ball)
    shot = Shot(
        angle=toward(layout["cue"], layout, rng),
        speed=rng.choice((rng.uniform(0.0, 12.0), 10.0 ** rng.uniform(-3.0, 1.0))),
        side=rng.uniform(-0.5, 0.5),
        height=rng.uniform(-0.5, 0.5),
        elevation=rng.choice((0.0, rng.uniform(0.0, 90.0))),
    )
    return layout, shot


def flight(table: Table, seed: str) -> tuple[Layout, Shot]:
    """A random layout, or a break at 12 m/s, with the butt raised; one time in eight balls are in the air already."""
    rng = random.Random(seed)
    racks = list(table.furniture.racks)
    if racks and rng.random() < 1 / 8:
        layout = table.rack(rng.choice(racks), seed=rng.randint(0, 99))
        cue = table.furniture.cue
        layout = layout if cue in layout else layout.put(Ball(cue, *table.furniture.spots["head"]))
        return layout, Shot(toward(layout[cue], layout, rng), 12.0, elevation=rng.uniform(0.0, 20.0), ball=cue)
    layout, shot = scene(table, seed)
    if rng.random() < 1 / 8:
        balls = [_thrown(table, ball, rng) for ball in layout.values()]
        layout = Layout(balls)
    return layout, replace(shot, elevation=rng.uniform(0.0, 80.0))


def _thrown(table: Table, ball: Ball, rng: random.Random) -> Ball:
    """The ball in the air, above all others, or as it was: only the cue ball has to stay for its stroke."""
    if ball.id == "cue" or rng.random() < 0.5:
        return ball
    # Each in a layer of its own: none is in another.
    z = 0.1 + 0.13 * int(ball.id)
    vx, vy, vz = (rng.uniform(-4.0, 4.0) for _ in range(3))
    return ball._replace(z=z, vx=vx, vy=vy, vz=vz, wx=rng.uniform(-100.0, 100.0), wy=rng.uniform(-100.0, 100.0))


def freeze(table: Table, ball: Ball, layout: Layout, rng: random.Random) -> Ball:
    """The ball sent on until it touches something, unless that is a pocket."""
    way = math.radians(toward(ball, layout, rng))
    dx, dy = math.cos(way), math.sin(way)
    distance, what = table.cast(ball.x, ball.y, dx, dy, layout, table.body_of(ball)[0], ball.id)
    if what is None or any(pocket.name == what for pocket in table.geometry.pockets):
        return ball
    return ball._replace(x=ball.x + dx * distance, y=ball.y + dy * distance)


def toward(ball: Ball, layout: Layout, rng: random.Random) -> float:
    """Some direction, degrees; every other time nearly that of another ball."""
    others = [other for other in layout.values() if other.id != ball.id]
    if not others or rng.random() < 0.5:
        return rng.uniform(-180.0, 180.0)
    other = rng.choice(others)
    return math.degrees(math.atan2(other.y - ball.y, other.x - ball.x)) + rng.choice((0.0, rng.gauss(0.0, 3.0)))


def play(table: Table, seed: int, number: int) -> Result:
    """Simulate one shot of `scene` and look for faults."""
    return examine(number, table, *scene(table, f"{seed} {number}"))


def examine(number: int, table: Table, layout: Layout, shot: Shot | None) -> Result:
    """Simulate a shot and look for faults; whatever it raises is one."""
    start = time.process_time()
    try:
        roll = simulate(table, layout, shot)
        seconds = time.process_time() - start
        wrong = list(faults(table, roll))
        if len(roll.events) < _SHORT:
            other = simulate(table, Layout(reversed(list(layout.values()))), shot)
            wrong += [] if other.digest() == roll.digest() else ["the order of the balls tells"]
    except (BudgetError, TimeoutError, ArithmeticError, ValueError, LookupError) as error:
        return Result(number, [f"{type(error).__name__}: {error}"], 0, time.process_time() - start)
    return Result(number, wrong, len(roll.events), seconds)


def faults(table: Table, roll: Rollout) -> Iterator[str]:
    """Whatever is wrong with a rollout, in words."""
    if {ball.phase for ball in roll.layout().values()} - {RESTING, POCKETED, OFF}:
        yield "not all balls are at rest"
    for event in roll.events:
        before, after = (energy(table, roll.start, states) for states in (event.before, event.after))
        if event.kind != "cue_ball" and not after <= before + 1e-12 * abs(before) + 1e-15:
            yield f"{event}: energy rises by {after - before:.3g} J, of {before:.3g} J"
    moments = [0.0, *(event.t for event in roll.events)]
    if moments != sorted(moments):
        yield "time runs backward"
    # Where things happen, and half-way between.
    times = np.unique(np.array(moments + [0.5 * (a + b) for a, b in pairwise(moments)]))
    names = list(roll.tracks)
    paths = [positions(roll.tracks[name], times) for name in names]
    radii = [table.body_of(roll.start[name])[0] for name in names]
    for name, (x, y, z, present) in zip(names, paths, strict=True):
        if not np.isfinite((x, y, z)).all():
            yield f"{name} is nowhere"
        # A ball that never moves is looked at once.
        kept = present & (times <= times[0]) if _lies(roll.tracks[name]) else present
        yield from misplaced(table, roll.start[name], x[kept], y[kept], z[kept])
    for i, j in near(paths, radii):
        overlap = radii[i] + radii[j] - apart(paths[i], paths[j], radii[i] - radii[j])
        if not overlap <= NANOMETRE:
            yield f"{names[i]} and {names[j]} overlap by {overlap:.3g} m"


def _lies(track: list[Motion]) -> bool:
    return len(track) == 1 and track[0].phase == RESTING


def near(paths: list[Path], radii: list[float]) -> Iterator[tuple[int, int]]:
    """The pairs of balls the boxes of whose ways come within a touch of each other."""
    places = np.array([path[:3] for path in paths])
    low, high, size = places.min(axis=2), places.max(axis=2), np.array(radii)
    gap = np.maximum(low[:, None] - high[None], low[None] - high[:, None]).max(axis=2)
    # Heights are those of the lowest points: the centres' differ by what the radii do besides.
    close = gap <= size[:, None] + size[None] + np.abs(size[:, None] - size[None]) + NANOMETRE
    yield from zip(*(indices.tolist() for indices in np.nonzero(np.tril(close, -1))), strict=True)


def apart(one: Path, other: Path, higher: float) -> float:
    """The least distance of two balls' centres while both are on the table, m; the one's is so much `higher`."""
    x, y, z = one[0] - other[0], one[1] - other[1], one[2] - other[2] + higher
    square = (x * x + y * y + z * z)[one[3] & other[3]]
    return math.sqrt(square.min(initial=math.inf))


def energy(table: Table, sizes: Layout, states: dict[str, Ball]) -> float:
    """Of travel, spin and height, J."""
    total = 0.0
    for ball in states.values():
        radius, mass = table.body_of(sizes[ball.id])
        spin = ball.wx**2 + ball.wy**2 + ball.wz**2
        total += 0.5 * mass * (ball.vx**2 + ball.vy**2 + ball.vz**2 + 0.4 * radius**2 * spin)
        # What has fallen into a pocket is told as lying at the height of the cloth.
        total += mass * table.knobs.gravity * (-radius if ball.phase == POCKETED else ball.z)
    return total


def positions(track: list[Motion], times: Floats) -> Path:
    """Where a ball is at each time, and whether it is on the table."""
    rows = np.array([(m.t0, m.x, m.y, m.z, m.vx, m.vy, m.vz, m.hx, m.hy, m.hz, m.phase not in GONE) for m in track])
    t0, x, y, z, vx, vy, vz, hx, hy, hz, present = rows[np.searchsorted(rows[:, 0], times, side="right") - 1].T
    s = times - t0
    return x + (vx + hx * s) * s, y + (vy + hy * s) * s, z + (vz + hz * s) * s, present > 0.0


def misplaced(table: Table, ball: Ball, x: Floats, y: Floats, z: Floats) -> Iterator[str]:
    """Where a ball is off the table or in a cushion. Between the noses it cannot be: only beyond is looked at."""
    radius = table.body_of(ball)[0]
    inset, knobs = table.reach(radius) - NANOMETRE, table.knobs.table
    beyond = (x < inset) | (x > knobs.length - inset) | (y < inset) | (y > knobs.width - inset)
    for px, py, pz in zip(x[beyond].tolist(), y[beyond].tolist(), z[beyond].tolist(), strict=True):
        if pz != 0.0:
            room, what = table.bed.room(px, py, pz, radius)
            # A pocket's back gives way to what comes round to it from beneath the slate's edge.
            if room < -NANOMETRE and not what.endswith(" back"):
                yield f"{ball.id} is {-room:.3g} m inside {what}, {pz} m high"
            continue
        gap, element = table.element_gap(px, py, radius)
        if not table.on_cloth(px, py):
            yield f"{ball.id} is off the table, at {px}, {py}"
        elif element is not None and element.kind == "ball_cushion" and gap < -NANOMETRE:
            yield f"{ball.id} is {-gap:.3g} m inside {element.name}"


class _Worker:
    """What each process keeps: its own table, for a Space must stay within one; None where each shot has one."""

    table: Table | None
    tables: list[Table]
    seed: int

    @classmethod
    def prepare(cls, source: str | None, overrides: dict[str, Any], seed: int, flights: bool) -> None:
        cls.table, cls.seed = load_table(source, overrides) if source else None, seed
        cls.tables = [load_table(name, overrides) for name in presets()] if flights else []
        signal.signal(signal.SIGPROF, _give_up)

    @classmethod
    def play(cls, number: int) -> Result:
        signal.setitimer(signal.ITIMER_PROF, PATIENCE)
        try:
            if cls.tables:
                table = cls.tables[number % len(cls.tables)]
                return examine(number, table, *flight(table, f"{cls.seed} {number}"))
            if cls.table is None:
                return examine(number, *wide(f"{cls.seed} {number}"))
            return play(cls.table, cls.seed, number)
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0.0)


def _give_up(number: int, frame: object) -> None:
    raise TimeoutError(f"still computing after {PATIENCE} s of CPU")


def _override(setting: str) -> tuple[str, float | str]:
    name, _, text = setting.partition("=")
    try:
        return name, float(text)
    except ValueError:
        return name, text


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--shots", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--first", type=int, default=0, help="number of the first shot")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--table", default="pool-9ft")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="override a knob")
    parser.add_argument("--wide", action="store_true", help="any table, any knobs, any layout")
    parser.add_argument("--flights", action="store_true", help="every preset, butts raised, balls in the air")
    options = parser.parse_args()
    overrides = dict(map(_override, options.set))
    load_table(options.table, overrides)  # Says what is wrong with it before there are processes.
    source = None if options.wide else options.table
    numbers = range(options.first, options.first + options.shots)
    begun = time.perf_counter()
    events, failed, slow, slowest, longest = 0, 0, 0, Result(0, [], 0, 0.0), Result(0, [], 0, 0.0)
    with Pool(options.jobs, _Worker.prepare, (source, overrides, options.seed, options.flights)) as pool:
        for result in pool.imap_unordered(_Worker.play, numbers, chunksize=8):
            events += result.events
            slow += result.seconds > SLOW
            slowest = max(slowest, result, key=lambda one: one.seconds)
            longest = max(longest, result, key=lambda one: one.events)
            if result.faults:
                failed += 1
                again = f"--seed {options.seed} --first {result.number} --shots 1"
                print(f"{again}: {'; '.join(result.faults[:3])}", flush=True)
    print(
        f"{options.shots} shots, {failed} failed, {events} events, {time.perf_counter() - begun:.0f} s;"
        f" {slow} took more than {SLOW:g} s of CPU, the slowest, number {slowest.number}, {slowest.seconds:.2f} s;"
        f" the most events were {longest.events}, of number {longest.number}"
    )
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
