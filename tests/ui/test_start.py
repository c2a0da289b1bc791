"""Starting: the splash comes before anything slow, at a size that fits the screen and the settings."""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

import pygame
import pytest

from pool2d import InputError, load_table
from pool2d.config.settings import Store
from pool2d.ui import start, window

ROOT = Path(__file__).parents[2]


def test_the_splash_comes_before_the_table_physics_and_numpy_are_read() -> None:
    code = (
        "import sys; from pool2d.cli import main; from pool2d.ui import window\n"
        "class Seen(Exception): pass\n"
        "def tell(self, part): raise Seen\n"
        "window.Splash.tell = tell\n"
        "try: main(['--frames', '1'])\n"
        "except Seen:\n"
        "    slow = ('numpy', 'pymunk', 'pool2d.table.table', 'pool2d.ui.play.play')\n"
        "    print([m for m in slow if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ("[]\n", "")


def test_the_splash_is_told_until_the_table_is_there(monkeypatch: pytest.MonkeyPatch) -> None:
    parts: list[float] = []
    real = window.Splash.tell

    def tell(splash: window.Splash, part: float) -> None:
        parts.append(part)
        real(splash, part)

    monkeypatch.setattr(window.Splash, "tell", tell)
    assert start.play(lambda: load_table("pool-9ft"), seed=1, frames=1) == 0
    assert parts == sorted(parts) and parts[0] == 0.0 and parts[-1] == 1.0


def test_a_bar_tells_how_far_it_is_only_where_it_takes_long(monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: list[float] = []
    now = [100.0]
    monkeypatch.setattr(window, "draw_splash", lambda surface, part: drawn.append(part))
    monkeypatch.setattr(time, "perf_counter", lambda: now[0])
    splash = window.Splash(window.open_window((640, 360)))
    splash.tell(0.4)
    now[0] += 0.6
    splash.tell(0.7)
    assert drawn == [0.0, 0.0, 0.7]
    pygame.display.quit()


@pytest.mark.parametrize("size", [(320, 200), (960, 540), (3840, 2160)])
def test_the_splash_fits_any_window(size: tuple[int, int]) -> None:
    surface = pygame.Surface(size)
    window.draw_splash(surface, 0.5)
    mask = pygame.mask.from_threshold(surface, surface.get_at((0, 0)), (1, 1, 1, 255))
    mask.invert()
    around = mask.get_bounding_rects()[0].unionall(mask.get_bounding_rects())
    assert pygame.Rect(0, 0, *size).inflate(-4, -4).contains(around)
    assert around.width > size[0] / 10


@pytest.mark.parametrize(
    ("desktop", "expected"),
    [((1920, 1080), (1280, 720)), ((3840, 2160), (2560, 1440)), ((1366, 768), (1280, 720)), ((1024, 600), (960, 540))],
)
def test_the_first_window_suits_the_screen(
    monkeypatch: pytest.MonkeyPatch, desktop: tuple[int, int], expected: tuple[int, int]
) -> None:
    monkeypatch.setattr(pygame.display, "get_desktop_sizes", lambda: [desktop])
    assert window.first_size(Store()) == expected


def test_the_window_opens_as_large_as_it_was_left_but_never_tiny() -> None:
    store = Store()
    store.turn("screen.width", 1000.0)
    store.turn("screen.height", 100.0)
    assert window.first_size(store) == (1000, 360)


def test_a_table_that_cannot_be_loaded_closes_the_window() -> None:
    def fail() -> object:
        raise InputError("mine.toml", "", None, "cannot be read")

    with pytest.raises(InputError, match=r"mine\.toml"):
        start.play(fail, frames=1)  # type: ignore[arg-type]
    assert not pygame.display.get_init()
