"""From a command to a window one can play in: something is on the screen before anything slow is read."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from typing import TYPE_CHECKING

import pygame

from ..errors import InputError
from ..settings import Store
from . import words
from .window import Splash, first_size, open_window

if TYPE_CHECKING:
    from ..table import Table

# Drivers that show nothing, which SDL falls back to without a screen.
_UNSEEN = ("dummy", "offscreen", "evdev")


def play(load: Callable[[], Table], seed: int | None = None, frames: int | None = None, menu: bool = False) -> int:
    """Open a window, load the table and play, at first the menu where it is asked for; returns the exit status.

    Raises InputError where there is no display, and whatever `load` raises.
    """
    store = Store.open()
    try:
        size = first_size(store)
        surface = open_window(size, store.values.screen.full)
    except pygame.error as error:
        raise InputError("display", "", None, f"no window can be opened: {error}") from error
    try:
        if frames is None and pygame.display.get_driver() in _UNSEEN and "SDL_VIDEODRIVER" not in os.environ:
            raise InputError("display", "", None, "no screen was found to open a window on")
        words.speak(store.values.screen.language)
        splash = Splash(surface)
        # What the game needs takes several times as long to read as the window to open.
        from .app import App

        splash.tell(0.4)
        table = load()
        splash.tell(0.7)
        app = App(table, time.time_ns() & 0x3FFFFFFF if seed is None else seed, size, store, surface, menu)
        splash.tell(1.0)
        app.run(frames)
        app.close()
    finally:
        pygame.display.quit()
    return 0
