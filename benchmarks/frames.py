"""How long starting and frames take, drawn in software: `python -m benchmarks.frames [WxH]`.

Prints the time from starting Python to the splash and to the end of the first frame, without a kept picture of the
table and with one; then frames at rest, while aiming (the guide is simulated anew each frame), of a break with all
that can be shown, and while the camera comes nearer for the first time. Beside the clock's time stands the
processor's, of all threads together, which tells the truth on a machine that has other things to do. As machines,
and one machine from minute to minute, differ in speed, each line ends with the median over the time that a loop of
100,000 additions took just then.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile
import time
import timeit
from collections.abc import Callable, Sequence

os.environ["SDL_VIDEODRIVER"] = "dummy"
os.environ["SDL_AUDIODRIVER"] = "dummy"

_FRAMES, _STARTS = 200, 5
_FRAME = 1.0 / 60.0


def main(size: tuple[int, int]) -> None:
    print(f"{size[0]}x{size[1]}, in ms   by the clock: median, shortest, longest; of the processor: the same; in loops")
    with tempfile.TemporaryDirectory() as folder:
        os.environ["POOL2D_CACHE"] = os.environ["POOL2D_CONFIG"] = folder
        # Compiled code is kept, as it is for a player; only the first start is without.
        os.environ["PYTHONPYCACHEPREFIX"] = folder
        os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
        with open(os.path.join(folder, "settings.toml"), "w", encoding="utf-8") as settings:
            print(f"[screen]\nwidth = {size[0]}\nheight = {size[1]}", file=settings)
        for name, kept in (("without a kept picture", False), ("with one", True)):
            starts = [_start(folder, kept) for _ in range(_STARTS)]
            _tell("splash, " + name, [start[:2] for start in starts])
            _tell("ready, " + name, [start[2:] for start in starts])
        _frames(size)
    print(f"memory at most {_memory():.0f} MiB")


def _frames(size: tuple[int, int]) -> None:
    from pool2d import load_table
    from pool2d.ui.app import App

    app = App(load_table("pool-9ft"), seed=3, size=size)
    app.step(0.0)
    hands = app.play.hands

    def turn() -> None:
        hands.aim = hands.aim.turned(0.7)
        app.redraw()

    def frames(name: str, change: Callable[[], None] = lambda: None, dt: float = _FRAME) -> None:
        times = []
        for _ in range(_FRAMES):
            change()
            clock, processor = time.perf_counter(), time.process_time()
            app.step(dt)
            times.append((time.perf_counter() - clock, time.process_time() - processor))
        _tell(name, times)

    frames("at rest")
    frames("the same, drawn again", app.redraw)
    frames("aiming", turn)
    hands.aim = hands.aim.with_speed(8.0).toward(1.0, 0.003)
    app.play._strike(8.0)
    frames("balls rolling")
    app.play.stage.camera.zoom(3.0)
    frames("coming nearer")
    # The larger picture that is seen from near, drawn beside the loop, is counted among what is held.
    while not app.play.stage.still:
        app.step(_FRAME)


def _tell(name: str, times: Sequence[tuple[float, ...]]) -> None:
    """Print seconds by the clock and of the processor."""
    columns = (f"{1e3 * pick(column):8.2f}" for column in zip(*times, strict=True) for pick in _PICKS)
    print(f"{name:<32}", *columns, f"{statistics.median(row[0] for row in times) / _loop():8.2f}")


def _loop() -> float:
    """How fast the machine is at this moment: the least time of a few loops, s."""
    return min(timeit.repeat("for i in range(100_000): total += i", "total = 0", number=1, repeat=5))


_PICKS: tuple[Callable[[tuple[float, ...]], float], ...] = (statistics.median, min, max)

# Plays one frame, and prints the clock's time and the processor's at the splash and at the end.
_GAME = """
import time
from pool2d.cli import main
from pool2d.ui.window import Splash
def tell(self, part, real=Splash.tell):
    real(self, part)
    if part == 0.0:
        print(time.time(), time.process_time())
Splash.tell = tell
main(["play", "--frames", "1"])
print(time.time(), time.process_time())
"""


def _start(folder: str, kept: bool) -> tuple[float, ...]:
    """The clock's time and the processor's from starting Python to the splash, then to the first frame, s."""
    for name in os.listdir(folder):
        if name.endswith(".pixels") and not kept:
            os.remove(os.path.join(folder, name))
    start = time.time()
    done = subprocess.run([sys.executable, "-c", _GAME], check=True, capture_output=True, text=True)
    splash, at_splash, ready, at_ready = map(float, done.stdout.split())
    return splash - start, at_splash, ready - start, at_ready


def _memory() -> float:
    """The most memory that this process has held, MiB; where the system does not say, 0."""
    try:
        import resource
    except ImportError:
        return 0.0
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return float(most) / (1 << 20 if sys.platform == "darwin" else 1 << 10)


if __name__ == "__main__":
    words = sys.argv[1].split("x") if len(sys.argv) > 1 else ["1280", "720"]
    main((int(words[0]), int(words[1])))
