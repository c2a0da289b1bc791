"""How long frames take, drawn in software: `python -m benchmarks.frames [WxH]`.

Prints the time from starting Python to the first frame, and the shortest, median and longest frame at rest,
while aiming (the guide is simulated anew each frame) and with sixteen balls rolling.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable

os.environ["SDL_VIDEODRIVER"] = "dummy"
os.environ["SDL_AUDIODRIVER"] = "dummy"

from pool2d import load_table
from pool2d.ui.app import App

_FRAMES = 200


def main(size: tuple[int, int]) -> None:
    print(f"{size[0]}x{size[1]}, {_FRAMES} frames each")
    starts = [_cold_start() for _ in range(5)]
    print(f"first frame    {1e3 * statistics.median(starts):7.0f} ms after the process began, median of {len(starts)}")
    app = App(load_table("pool-9ft"), seed=3, size=size)
    app.step(0.0)
    _tell("at rest", app, lambda: None)
    _tell("aiming", app, lambda: _turn(app))
    app.play.hands.aim = app.play.hands.aim.with_speed(8.0).toward(1.0, 0.003)
    app.play._strike(8.0)
    _tell("balls rolling", app, lambda: None, dt=0.02)


def _turn(app: App) -> None:
    app.play.hands.aim = app.play.hands.aim.turned(0.7)


def _tell(name: str, app: App, change: Callable[[], None], dt: float = 0.0) -> None:
    times = []
    for _ in range(_FRAMES):
        change()
        start = time.perf_counter()
        app.step(dt)
        times.append(1e3 * (time.perf_counter() - start))
    print(
        f"{name:<14} {statistics.median(times):7.2f} ms median, {min(times):6.2f} shortest, {max(times):6.2f} longest"
    )


def _cold_start() -> float:
    start = time.perf_counter()
    subprocess.run([sys.executable, "main.py", "--frames", "1"], check=True)
    return time.perf_counter() - start


if __name__ == "__main__":
    words = sys.argv[1].split("x") if len(sys.argv) > 1 else ["1280", "720"]
    main((int(words[0]), int(words[1])))
