"""How long frames take, drawn in software: `python -m benchmarks.frames [WxH]`.

Prints the time from starting Python to the splash and to the end of the first frame, and the shortest, median and
longest frame at rest, while aiming (the guide is simulated anew each frame) and with sixteen balls rolling.
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
    starts = [_cold_start() for _ in range(9)]
    for name, times in zip(("splash after", "ready after"), zip(*starts, strict=True), strict=True):
        print(f"{name:<14} {1e3 * statistics.median(times):7.0f} ms, median of {len(times)} starts of Python")
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


# Plays one frame, and prints when the splash and the frame were on the screen.
_START = """
import sys, time
from pool2d.cli import main
from pool2d.ui.window import Splash
def tell(self, part, real=Splash.tell):
    real(self, part)
    if part == 0.0:
        print(time.time())
Splash.tell = tell
main(["play", "--frames", "1"])
print(time.time())
"""


def _cold_start() -> tuple[float, float]:
    """How long after its start Python shows the splash, and the first frame, s."""
    start = time.time()
    done = subprocess.run([sys.executable, "-c", _START], check=True, capture_output=True, text=True)
    splash, ready = (float(line) - start for line in done.stdout.split())
    return splash, ready


if __name__ == "__main__":
    words = sys.argv[1].split("x") if len(sys.argv) > 1 else ["1280", "720"]
    main((int(words[0]), int(words[1])))
