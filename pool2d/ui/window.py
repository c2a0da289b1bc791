"""The window itself: opened sharp on every screen, at a size that fits, with something on it at once."""

from __future__ import annotations

import os
import time
from pathlib import Path

import pygame

from .._version import __version__
from ..config.folders import pictures_folder
from ..config.settings import Store
from ..draw import shapes, text, theme
from ..draw.export import picture_file
from ..printable import printable
from .frame import Frame

SIZE = (1280, 720)
# Below this nobody can read anything; the window does not open smaller.
SMALLEST = (640, 360)
# The largest size that is kept.
LARGEST = 16384
# Nothing is laid out in less than this; a smaller window shows the corner of it.
LEAST = (160, 90)
# What takes longer than this, s, shows how far it is.
_SOON = 0.5


def open_window(size: tuple[int, int], full: bool = False) -> pygame.Surface:
    """Open the window; raises pygame.error where there is no screen."""
    # SDL reads this before the first window: pixels are pixels, and Windows does not blur them larger.
    os.environ.setdefault("SDL_WINDOWS_DPI_AWARENESS", "permonitorv2")
    pygame.display.init()
    pygame.font.init()
    surface = set_mode(size, full)
    pygame.display.set_caption("pool2d")
    return surface


def set_mode(size: tuple[int, int], full: bool) -> pygame.Surface:
    """Fill the screen, or show a window of this size."""
    if full:
        return pygame.display.set_mode((0, 0), pygame.FULLSCREEN)
    return pygame.display.set_mode(size, pygame.RESIZABLE)


def first_size(store: Store) -> tuple[int, int]:
    """The size that was set, or a comfortable one for the screen: 1280x720, twice that on a 4K one, or less."""
    screen = store.values.screen
    pygame.display.init()
    width, height = max(pygame.display.get_desktop_sizes(), default=SIZE)
    if screen.width and screen.height:
        # It may have been set on a larger screen.
        kept = min(int(screen.width), width), min(int(screen.height), height)
        return max(SMALLEST[0], kept[0]), max(SMALLEST[1], kept[1])
    # Some room is left for what the desktop keeps on its edges.
    fitting = (n for n in (2.0, 1.0, 0.75) if n * SIZE[0] <= 0.95 * width and n * SIZE[1] <= 0.95 * height)
    scale = next(fitting, 0.5)
    return round(SIZE[0] * scale), round(SIZE[1] * scale)


def canvas(window: pygame.Surface) -> pygame.Surface:
    """What is drawn on in place of the window: itself, unless it is too small for anything to be laid out in it."""
    width, height = window.get_size()
    if width >= LEAST[0] and height >= LEAST[1]:
        return window
    return pygame.Surface((max(width, LEAST[0]), max(height, LEAST[1])))


class Window:
    """The window and what is drawn on it; `size` is what it has when it does not fill the screen.

    `surface` is the window's own; without one it is opened, `full` or not, and closed in the end. What is drawn on is
    `frame`, a larger one where the window is too small.
    """

    def __init__(self, surface: pygame.Surface | None, size: tuple[int, int], full: bool) -> None:
        self._opened = surface is None
        self.surface = surface or open_window(size, full)
        self.size = size
        self.frame = Frame(canvas(self.surface))
        self._caption = ""
        # Events that came while nothing was to be done.
        self._came: list[pygame.event.Event] = []
        # The files of fonts whose loss has been told.
        self._told: set[Path] = set()

    @property
    def full(self) -> bool:
        """Whether it fills the screen."""
        return bool(self.surface.get_flags() & pygame.FULLSCREEN)

    @full.setter
    def full(self, full: bool) -> None:
        if full != self.full:
            self.surface = set_mode(self.size, full)
            self.frame.forget()

    @property
    def room(self) -> tuple[int, int]:
        """The size that things are laid out for, in pixels."""
        width, height = self.surface.get_size()
        return max(width, LEAST[0]), max(height, LEAST[1])

    def resized(self) -> None:
        """Take the size that the system has given the window."""
        self.surface = pygame.display.get_surface() or self.surface
        self.frame.forget()
        if not self.full:
            self.size = self.surface.get_size()

    def close(self) -> None:
        """Close the window, unless it was opened by others, who close it."""
        if self._opened:
            pygame.display.quit()

    def name(self, caption: str) -> None:
        """Give the window a caption."""
        if caption != self._caption:
            self._caption = caption
            pygame.display.set_caption(printable(caption, 200))

    def screenshot(self) -> Path:
        """Save a picture of the window under the time of day; raises InputError where that cannot be."""
        path = pictures_folder() / time.strftime("pool2d-%Y%m%d-%H%M%S.png")
        for number in range(2, 100):
            if not path.exists():
                break
            path = path.with_stem(f"{path.stem.partition('_')[0]}_{number}")
        picture_file.save(self.surface, path)
        return path

    def faults(self) -> set[Path]:
        """The files of fonts that could not be read, each once."""
        new = text.unreadable - self._told
        self._told |= new
        return new

    # What comes from it, and what is shown on it.

    def events(self) -> list[pygame.event.Event]:
        """What has come since this was asked last."""
        came, self._came = self._came, []
        return [*came, *pygame.event.get()]

    def wait(self, seconds: float) -> bool:
        """Do nothing until an event comes, which is kept, or the time is over; whether one came."""
        event = pygame.event.wait(round(1000 * seconds))
        if event.type == pygame.NOEVENT:
            return False
        self._came.append(event)
        return True

    def begin(self) -> Frame:
        """The frame to draw the next picture on."""
        on = canvas(self.surface)
        if on is not self.frame.surface:
            self.frame = Frame(on)
        self.frame.begin()
        return self.frame

    def present(self) -> None:
        """Let be seen what has changed."""
        if self.frame.surface is not self.surface:
            self.surface.blit(self.frame.surface, (0, 0))
            self.frame.cover()
        if self.frame.changed is None:
            pygame.display.flip()
        else:
            pygame.display.update(self.frame.changed)


class Splash:
    """What the window shows until the table is set up: the name, and if that takes long, how far it is."""

    def __init__(self, surface: pygame.Surface) -> None:
        self.surface = surface
        self.since = time.perf_counter()
        self.tell(0.0)

    def tell(self, part: float) -> None:
        """Show that so much is done, 0 to 1, and let the system see that the window lives."""
        pygame.event.pump()
        draw_splash(self.surface, part if time.perf_counter() - self.since > _SOON else 0.0)
        pygame.display.flip()


def draw_splash(surface: pygame.Surface, part: float) -> None:
    """The name in the middle; a bar below it where `part` is not 0."""
    width, height = surface.get_size()
    unit = theme.unit(min(height, width * 9 // 16))
    surface.fill(theme.BACKGROUND)
    middle = (width / 2, height / 2)
    text.draw(surface, "pool2d", 8 * unit, theme.TEXT, (middle[0], middle[1] - 3 * unit), (0.5, 0.5))
    # No word of any language: those are read later.
    text.draw(surface, __version__, 2 * unit, theme.QUIET, (middle[0], middle[1] + 4 * unit), (0.5, 0.5))
    if part > 0.0:
        bar = pygame.Rect(0, 0, 40 * unit, max(2, unit // 2))
        bar.center = (width // 2, height // 2 + 8 * unit)
        shapes.rounded(surface, bar, theme.EDGE, unit)
        bar.width = round(bar.width * part)
        shapes.rounded(surface, bar, theme.ACCENT, unit)
