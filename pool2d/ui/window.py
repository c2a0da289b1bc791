"""The window itself: opened sharp on every screen, at a size that fits, with something on it at once."""

from __future__ import annotations

import os
import time

import pygame

from .._version import __version__
from ..config.settings import Store
from ..draw import shapes, text, theme

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
