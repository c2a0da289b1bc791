"""What `benchmarks.speed` times: each case makes its scenes, which is not timed, and then takes one sample at a time.

A sample is the time of the processor, s, of one shot, one event, one frame of the window, or one start of a process.
"""

from __future__ import annotations

import functools
import math
import random
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from pool2d import Ball, Layout, Rollout, Shot, Table, load_table, simulate
from tests.scenes import break_shot, random_shot

from . import machine
from .machine import took

Sample = Callable[[int], float]
Scene = tuple[Layout, Shot]

# How many shots of a random kind are played for one sample, which is their mean.
_MANY = 20
# The most events played among many balls, and how much of the table each of these has, as of sixteen on one
# of nine feet.
_EVENTS, _ROOM = 400, 2.54 * 1.27 / 16
CROWDS = (16, 64, 256, 1024)


def cases(tree: Path) -> dict[str, Callable[[], Sample]]:
    """Every case by its name, in the order in which they are shown; `tree` holds the package that is timed."""
    pool = functools.partial(load_table, "pool-9ft")
    crowds = {f"event among {count:,} balls": functools.partial(_crowd, count) for count in CROWDS}
    return {
        "break": lambda: _shots(pool(), 1, lambda table, seed: break_shot(table, seed % 15)),
        "tight break": lambda: _shots(pool(), 1, tight_break),
        "two balls": lambda: _shots(pool(), _MANY, two_balls),
        "16 balls, random": lambda: _shots(pool(), _MANY, random_shot),
        "snooker break": lambda: _shots(load_table("snooker-12ft"), 1, snooker_break),
        "carom, random": lambda: _shots(
            load_table("carom-10ft"), _MANY, lambda table, seed: random_shot(table, seed, 3)
        ),
        "impact on a rack": lambda: _impact(pool()),
        "guide, a frame": _guide,
        **crowds,
        f"set-up of {CROWDS[-1]:,} balls": lambda: _set_up(CROWDS[-1]),
        "import": lambda: _started(tree, "from pool2d import Ball, Layout, Shot, load_table, simulate"),
        "start, --version": lambda: _started(tree, _COMMAND.format(["--version"])),
        "start, first frame": lambda: _started(tree, _FRAME),
    }


def tight_break(table: Table, seed: int) -> Scene:
    """Fifteen balls touching, struck a little off square; `seed` says how much."""
    radius = table.knobs.ball.radius
    balls = [Ball("cue", 0.635, 0.635 + 0.0005 * (seed % 15))]
    for i in range(5):
        for j in range(i + 1):
            x, y = 1.905 + i * math.sqrt(3.0) * radius, 0.635 + (2 * j - i) * radius
            balls.append(Ball(str(len(balls)), x, y))
    return Layout(balls), Shot(angle=0.0, speed=8.0)


def two_balls(table: Table, seed: int) -> Scene:
    """A cut, thinner or fuller as `seed` says."""
    rng = random.Random(seed)
    layout = Layout([Ball("cue", 0.635, 0.635), Ball("1", 1.5, 0.635)])
    return layout, Shot(angle=rng.uniform(-3.0, 3.0), speed=rng.uniform(1.0, 4.0), side=rng.uniform(-0.3, 0.3))


def snooker_break(table: Table, seed: int) -> Scene:
    """A break-off that clips the reds at the side and comes back, at several speeds."""
    layout = table.rack("snooker", seed=seed)
    cue, reds = layout["cue"], [ball for name, ball in layout.items() if name.startswith("red")]
    last = max(reds, key=lambda ball: (round(ball.x, 6), ball.y))
    angle = math.degrees(math.atan2(last.y - cue.y + 1.5 * table.knobs.ball.radius, last.x - cue.x))
    return layout, Shot(angle=angle, speed=4.0 + 0.1 * (seed % 10), side=0.3)


def crowd(count: int, seed: int) -> tuple[Table, Layout]:
    """So many balls on the move, each with as much room as the others, on a table as large as that takes."""
    width = math.sqrt(0.5 * count * _ROOM)
    table = _large(2.0 * width, width)
    rng, across = random.Random(seed), math.ceil(math.sqrt(2.0 * count))
    cells = 2.0 * width / across, width / math.ceil(count / across)
    balls = []
    for i in range(count):
        row, column = divmod(i, across)
        x, y = ((at + rng.uniform(0.25, 0.75)) * cell for at, cell in zip((column, row), cells, strict=True))
        way, speed = rng.uniform(0.0, math.tau), rng.uniform(0.5, 2.0)
        balls.append(Ball(str(i), x, y, speed * math.cos(way), speed * math.sin(way)))
    return table, Layout(balls)


@functools.lru_cache(maxsize=len(CROWDS))
def _large(length: float, width: float) -> Table:
    return load_table("pool-9ft", {"table.length": length, "table.width": width})


def _shots(table: Table, many: int, scene: Callable[[Table, int], Scene]) -> Sample:
    """Whole shots, `many` of them for a sample."""

    def play(scenes: Sequence[Scene]) -> None:
        for layout, shot in scenes:
            simulate(table, layout, shot)

    def sample(number: int) -> float:
        scenes = [scene(table, many * number + i) for i in range(many)]
        return took(lambda: play(scenes)) / many

    return sample


def _impact(table: Table) -> Sample:
    """What a struck rack takes until it has parted: the stroke and the contact of all its balls."""

    def sample(number: int) -> float:
        layout, shot = tight_break(table, number)
        return took(lambda: simulate(table, layout, shot, events=2))

    return sample


def _crowd(count: int) -> Sample:
    """An event among so many balls, without what it takes to begin."""

    def sample(number: int) -> float:
        (table, first), (_, second) = crowd(count, 2 * number), crowd(count, 2 * number + 1)
        begin = took(lambda: simulate(table, first, events=0))
        played: list[Rollout] = []
        whole = took(lambda: played.append(simulate(table, second, events=_EVENTS)))
        return (whole - begin) / len(played[0].events)

    return sample


def _set_up(count: int) -> Sample:
    def sample(number: int) -> float:
        table, layout = crowd(count, number)
        return took(lambda: simulate(table, layout, events=0))

    return sample


def _guide() -> Sample:
    """A frame of the window while the whole guide is aimed at a full rack: the shot, its picture, and all else."""
    from pool2d.draw import guide
    from pool2d.ui.app import App

    app = App(load_table("pool-9ft"), seed=3, size=(1280, 720))
    app.step(0.0)
    state = app.play.state
    state.show.level = guide.WHOLE
    square = state.hands.aim

    def sample(number: int) -> float:
        state.hands.aim = square.turned(0.05 * (number % 40 - 20))
        app.redraw()
        return took(lambda: app.step(1.0 / 60.0))

    return sample


def _started(tree: Path, script: str) -> Sample:
    """A process of its own from its beginning to its end."""
    timed = script + "\nimport time; print(time.process_time())"
    # The first makes what is kept for the others.
    _told(tree, timed)
    return lambda number: _told(tree, timed)


def held(tree: Path) -> float:
    """The most memory that the window holds until its first frame, MiB."""
    return _told(tree, f"{_FRAME}\nimport runpy; print(runpy.run_path({machine.__file__!r})['memory']())")


def _told(tree: Path, script: str) -> float:
    """The number that a process prints last, the package of a folder at hand."""
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, check=True, capture_output=True, text=True, cwd=tree)
    return float(done.stdout.split()[-1])


_COMMAND = """
from pool2d.cli import main
try:
    main({})
except SystemExit:
    pass
"""
_FRAME = _COMMAND.format(["play", "--frames", "1"])
