"""How far a long task has come: on a terminal a bar, how fast it goes, how long it will take; elsewhere nothing."""

from __future__ import annotations

import shutil
import sys
import time
from collections.abc import Callable
from typing import TextIO

# Between two drawings, s.
_PAUSE = 0.1
_WIDEST = 40


class Progress:
    """A line that is written over and over on standard error, where that is a terminal."""

    def __init__(
        self, total: int, done: int, stream: TextIO | None = None, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self.total = total
        self.done = self.before = done
        self._stream = sys.stderr if stream is None else stream
        self._clock = clock
        self._start = self._drawn = clock()
        self._on = self._stream is not None and self._stream.isatty()
        self._draw()

    def went(self, count: int) -> None:
        """So many more are done."""
        self.done += count
        if self._clock() - self._drawn >= _PAUSE or self.done == self.total:
            self._draw()

    def end(self) -> None:
        """Leave the line, so that what is told next has one of its own."""
        self._write("\n")
        self._on = False

    def line(self) -> str:
        """What it says: how much is done, how fast, and how long the rest will take."""
        seconds = self._clock() - self._start
        rate = (self.done - self.before) / seconds if seconds > 0.0 else 0.0
        left = f"{_clock_of((self.total - self.done) / rate)} left" if rate > 0.0 else "..."
        share = self.done / self.total if self.total else 1.0
        said = f" {100.0 * share:3.0f} %  {self.done:,} of {self.total:,}  {_rate(rate)}  {left}"
        room = min(_WIDEST, shutil.get_terminal_size().columns - len(said) - 3)
        if room < 4:
            return said.strip()
        full = int(room * share)
        return f"[{'#' * full}{'.' * (room - full)}]{said}"

    def _draw(self) -> None:
        self._drawn = self._clock()
        # The rest of the line is erased.
        self._write(f"\r{self.line()}\x1b[K")

    def _write(self, text: str) -> None:
        if self._on:
            try:
                self._stream.write(text)
                self._stream.flush()
            except (OSError, ValueError):
                # The terminal has gone. What it looked at goes on.
                self._on = False


def _rate(rate: float) -> str:
    return f"{rate:,.0f}/s" if rate >= 10.0 else f"{rate:.1f}/s"


def _clock_of(seconds: float) -> str:
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"
