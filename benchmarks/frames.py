"""How long starting and frames take, drawn in software: `python -m benchmarks.frames [WxH]`.

Prints the time from starting Python to the splash and to the end of the first frame, without a kept picture of the
table and with one; then frames at rest, while aiming (the guide is simulated anew each frame) anywhere and, with the
whole shot as the guide, at a full rack, while a player who is no person looks about, with nobody thinking and with a
process that thinks all the while, of a break with all that can be shown, and while the camera comes nearer for the
first time. What presenting a frame took is told apart, with the part of the window that was presented: it is the
screen's driver that does it. Without a screen that is nothing; SDL_VIDEODRIVER=x11 measures it on one. Beside the
clock's time stands the processor's, of all threads together, which tells the truth on a machine that has other things
to do. As machines, and one machine from minute to minute, differ in speed, each line ends with the median over the time
that a loop of 100,000 additions took just then.
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
from itertools import count
from typing import Any

from .machine import memory

os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
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
    print(f"memory at most {memory():.0f} MiB")


def _frames(size: tuple[int, int]) -> None:
    from pool2d import load_table
    from pool2d.draw import guide
    from pool2d.game.session import practice
    from pool2d.ui.app import App

    app = App(load_table("pool-9ft"), seed=3, size=size)
    app.step(0.0)
    presented = _Presented()
    hands = app.play.state.hands

    def turn() -> None:
        hands.aim = hands.aim.turned(0.7)
        app.redraw()

    square, sways = hands.aim, count()

    def sway() -> None:
        hands.aim = square.turned(0.05 * (next(sways) % 40 - 20))
        app.redraw()

    def frames(name: str, change: Callable[[], None] = lambda: None, dt: float = _FRAME) -> None:
        drawn, shown, parts = [], [], []
        for _ in range(_FRAMES):
            change()
            presented.forget()
            clock, processor = time.perf_counter(), time.process_time()
            app.step(dt)
            took = time.perf_counter() - clock, time.process_time() - processor
            shown.append(presented.took)
            drawn.append((took[0] - presented.took[0], took[1] - presented.took[1]))
            parts.append(presented.part)
        _tell(name, drawn)
        _tell(f"  presenting {100.0 * statistics.median(parts):.0f} % of it", shown)

    frames("at rest")
    frames("the same, drawn again", app.redraw)
    frames("aiming", turn)
    show, hands.aim = app.play.state.show, square
    level, show.level = show.level, guide.WHOLE
    frames("aiming at a rack, whole guide", sway)
    show.level = level
    for name, thinker in (("a player looks about", _Idle()), ("the same, while one thinks", _Busy(app.play.state))):
        _sit_down(app.play.state, thinker)
        frames(name)
    app.play.state.begin(practice(load_table("pool-9ft"), 3))
    hands.aim = hands.aim.with_speed(8.0).toward(1.0, 0.003)
    app.play.state.strike(8.0)
    frames("balls rolling")
    app.play.stage.camera.zoom(3.0)
    frames("coming nearer")
    # The larger picture that is seen from near, drawn beside the loop, is counted among what is held.
    while not app.play.stage.still:
        app.step(_FRAME)


class _Idle:
    """Never has an answer."""

    def ask(self, *question: Any) -> None:
        """Nobody thinks about it."""

    def answer(self) -> None:
        """There is none."""

    def close(self) -> None:
        """There is nothing to close."""


class _Busy(_Idle):
    """Thinks all the while: what has been thought of is thought of again."""

    def __init__(self, state: Any) -> None:
        from pool2d.opponent.thinker import Thinker

        self._thinker = Thinker(state.session.table, _match(state).setup)
        self._question: Any = None

    def ask(self, *question: Any) -> None:
        self._question = question
        self._thinker.ask(*question)

    def answer(self) -> None:
        if self._thinker.answer() is not None:
            self._thinker.ask(*self._question)

    def close(self) -> None:
        self._thinker.close()


def _match(state: Any) -> Any:
    """Eight-ball between players, of whom the strongest breaks."""
    from pool2d.game import Match, Setup

    return Match(state.session.table, Setup("eight-ball", players=("ada", "ada"), breaker=0, seed=3))


def _sit_down(state: Any, thinker: _Idle) -> None:
    """Have a player at the table who is told what to do by this thinker."""
    from pool2d.game import Choice
    from pool2d.game.session import Session
    from pool2d.ui.play.modes.opponent_mode import OpponentMode

    session = Session(_match(state))
    session.do(Choice("place", 0.5, 0.5))
    state.begin(session)
    state.mode.leave()
    state.take_up(OpponentMode(state, thinker))


class _Presented:
    """What presenting took since it was forgotten, s by the clock and of the processor, and how much it was."""

    def __init__(self) -> None:
        import pygame

        self._size = pygame.display.get_window_size()
        self._flip, self._update = pygame.display.flip, pygame.display.update
        pygame.display.flip = lambda: self._time(self._flip, 1.0)
        pygame.display.update = self._boxes  # type: ignore[assignment]
        self.forget()

    def forget(self) -> None:
        self.took, self.part = (0.0, 0.0), 0.0

    def _boxes(self, boxes: list[Any]) -> None:
        within = [box.clip((0, 0, *self._size)) for box in boxes]
        pixels = sum(box.width * box.height for box in within)
        self._time(lambda: self._update(boxes), pixels / (self._size[0] * self._size[1]))

    def _time(self, present: Callable[[], None], part: float) -> None:
        clock, processor = time.perf_counter(), time.process_time()
        present()
        self.took = time.perf_counter() - clock, time.process_time() - processor
        self.part = part


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


if __name__ == "__main__":
    words = sys.argv[1].split("x") if len(sys.argv) > 1 else ["1280", "720"]
    main((int(words[0]), int(words[1])))
