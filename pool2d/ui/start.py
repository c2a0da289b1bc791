"""From a command to a window one can play in: something is on the screen before anything slow is read."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import pygame

from ..config.settings import Store
from ..errors import InputError
from .window import Splash, first_size, open_window

if TYPE_CHECKING:
    from ..table.table import Table

# Drivers that show nothing, which SDL falls back to without a screen.
_UNSEEN = ("dummy", "offscreen", "evdev")


def play(load: Callable[[], Table], seed: int | None = None, frames: int | None = None, menu: bool = False) -> int:
    """Open a window, load the table and play, at first the menu where it is asked for; returns the exit status.

    Raises InputError where there is no display, and whatever `load` raises.
    """
    with _opened(frames) as (splash, store, size):
        # What the game needs takes several times as long to read as the window to open.
        from .app import App

        splash.tell(0.4)
        table = load()
        splash.tell(0.7)
        seed = time.time_ns() & 0x3FFFFFFF if seed is None else seed
        app = App(table, seed, size, store, splash.surface, menu)
        splash.tell(1.0)
        app.run(frames)
        app.close()
    return 0


def replay(path: Path, number: int | None = None, frames: int | None = None) -> int:
    """Open a window and show a record, from a shot on if its number is given; returns the exit status.

    Raises InputError where there is no display, no such shot, or the file is no good record.
    """
    with _opened(frames) as (splash, store, size):
        from ..game.records.record import load
        from ..game.records.recorded_shots import RecordedShots
        from .app import App
        from .replay.replay_scene import Replay

        splash.tell(0.4)
        shots = RecordedShots(load(path, torn=True))
        if number is not None and not 1 <= number <= len(shots):
            raise InputError("command line", "--shot", number, f"allowed is 1 to {len(shots)}")
        splash.tell(0.7)
        app = App(shots[0].match.table, 0, size, store, splash.surface)
        shown = Replay(shots, app.words, None, store, app.sounds)
        shown.state.go((number or 1) - 1)
        app.scene = shown
        splash.tell(1.0)
        app.run(frames)
        app.close()
    return 0


@contextmanager
def _opened(frames: int | None) -> Iterator[tuple[Splash, Store, tuple[int, int]]]:
    """A window with the splash on it, the settings, and its size by them; raises InputError without a display."""
    store = Store.open()
    try:
        size = first_size(store)
        surface = open_window(size, store.values.screen.full)
    except pygame.error as error:
        raise InputError("display", "", None, f"no window can be opened: {error}") from error
    try:
        if frames is None and pygame.display.get_driver() in _UNSEEN and "SDL_VIDEODRIVER" not in os.environ:
            raise InputError("display", "", None, "no screen was found to open a window on")
        splash = Splash(surface)
        yield splash, store, size
    finally:
        pygame.display.quit()
