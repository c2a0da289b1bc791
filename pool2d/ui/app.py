"""The window and its loop."""

from __future__ import annotations

import os
import time
from pathlib import Path

import pygame

from ..errors import InputError
from ..game.session import Session
from ..preset import load_table, preset_files
from ..table import Table
from .keys import action_of
from .play import Play
from .scene import Scene

SIZE = (1280, 720)
_FPS = 60
# Drivers that show nothing, which SDL falls back to without a screen.
_UNSEEN = ("dummy", "offscreen", "evdev")
# How often the open preset's file is looked at, s.
_WATCH = 0.5


class App:
    """A window on a table. `step` is one frame; tests post events and call it as the loop does."""

    def __init__(self, table: Table, seed: int, size: tuple[int, int] = SIZE) -> None:
        pygame.display.init()
        pygame.font.init()
        pygame.key.set_repeat(300, 30)
        pygame.display.set_caption(f"pool2d \N{EN DASH} {table.title}")
        self.size = size
        self.surface = pygame.display.set_mode(size, pygame.RESIZABLE)
        self.play = Play(Session(table, seed=seed))
        self.scene: Scene | None = self.play
        self._files = Watched(table)
        self._came: list[pygame.event.Event] = []

    def step(self, dt: float) -> bool:
        """Take the waiting events, let `dt` seconds pass and draw; False when the player has quit."""
        came, self._came = self._came, []
        for event in [*came, *pygame.event.get()]:
            if event.type == pygame.QUIT:
                self.scene = None
            elif not self._window(event) and self.scene is not None:
                self.scene = self.scene.handle(event)
        if self.scene is not None:
            self.scene = self.scene.update(dt)
        if self.scene is None:
            return False
        self._watch(dt)
        self.scene.draw(self.surface)
        pygame.display.flip()
        return True

    def run(self, frames: int | None = None) -> None:
        """Play until the player quits, or for a number of frames."""
        clock = pygame.time.Clock()
        dt = 0.0
        count = 0
        while (frames is None or count < frames) and self.step(dt):
            if frames is None and self.scene is not None and self.scene.still:
                self._rest()
                clock.tick()
            # A long pause, such as a window being dragged, is not made up for.
            dt = min(clock.tick(_FPS) / 1000.0, 0.1)
            count += 1

    def _rest(self) -> None:
        """Do nothing until an event comes, or until the preset's file is to be looked at again."""
        event = pygame.event.wait(round(1000 * _WATCH))
        if event.type == pygame.NOEVENT:
            self._watch(_WATCH)
        else:
            self._came.append(event)

    def close(self) -> None:
        pygame.display.quit()

    def _window(self, event: pygame.event.Event) -> bool:
        """Whether an event was about the window itself, which is then done."""
        if event.type == pygame.VIDEORESIZE:
            self.surface = pygame.display.get_surface() or self.surface
            return True
        action = action_of(event.key, getattr(event, "mod", 0)) if event.type == pygame.KEYDOWN else None
        if action == "fullscreen":
            self._toggle_fullscreen()
        elif action == "screenshot":
            self._screenshot()
        return action in ("fullscreen", "screenshot")

    def _toggle_fullscreen(self) -> None:
        if self.surface.get_flags() & pygame.FULLSCREEN:
            self.surface = pygame.display.set_mode(self.size, pygame.RESIZABLE)
        else:
            self.size = self.surface.get_size()
            self.surface = pygame.display.set_mode((0, 0), pygame.FULLSCREEN)

    def _screenshot(self) -> None:
        path = Path(time.strftime("pool2d-%Y%m%d-%H%M%S.png")).absolute()
        try:
            pygame.image.save(self.surface, path)
            self.play.message = f"Saved {path}"
        except (OSError, pygame.error) as error:
            self.play.message = f"The picture could not be saved: {error}"

    def _watch(self, dt: float) -> None:
        """Take a saved change of the preset's file, or say what is wrong with it and keep the old table."""
        table = self.play.session.table
        if (table.source, table.conditions) != self._files.behind:
            self._files = Watched(table)
            self.play.warning = ""
        if self._files.changed(dt):
            try:
                self.play.change_table(load_table(table.source, table.set, table.conditions))
                self.play.warning = ""
            except InputError as error:
                self.play.warning = str(error)


class Watched:
    """The files behind a table, and whether one has changed since they were last looked at."""

    def __init__(self, table: Table) -> None:
        self.behind = (table.source, table.conditions)
        self._paths = preset_files(table)
        self._stamps = self._read()
        self._wait = _WATCH

    def changed(self, dt: float) -> bool:
        """Whether a file has changed; asks the disk only now and then."""
        self._wait -= dt
        if self._wait > 0.0:
            return False
        self._wait = _WATCH
        before, self._stamps = self._stamps, self._read()
        return self._stamps != before

    def _read(self) -> list[tuple[int, int] | None]:
        return [_stamp(path) for path in self._paths]


def _stamp(path: Path) -> tuple[int, int] | None:
    """What changes about a file when it is saved; None where it is not there."""
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size


def play(table: Table, seed: int | None = None, frames: int | None = None) -> int:
    """Open a window and play; returns the exit status. Raises InputError where there is no display."""
    try:
        app = App(table, time.time_ns() & 0x3FFFFFFF if seed is None else seed)
    except pygame.error as error:
        raise InputError("display", "", None, f"no window can be opened: {error}") from error
    try:
        if frames is None and pygame.display.get_driver() in _UNSEEN and "SDL_VIDEODRIVER" not in os.environ:
            raise InputError("display", "", None, "no screen was found to open a window on")
        app.run(frames)
    finally:
        app.close()
    return 0
