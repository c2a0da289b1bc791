"""Windows of any size: the tiniest does not end the program, and the largest kept fits on the screen."""

from __future__ import annotations

import pygame
import pytest

from pool2d import load_table
from pool2d.config.settings import Store
from pool2d.ui import window
from pool2d.ui.app import App
from pool2d.ui.window import LEAST, SMALLEST, canvas, first_size

from .conftest import FRAME, Hand

TABLE = load_table("pool-9ft")


@pytest.mark.parametrize("size", [(1, 1), (640, 2), (2, 640), (300, 1), (1, 300), (120, 8), (159, 90), (3000, 30)])
def test_nothing_ends_the_program_in_a_tiny_window(size: tuple[int, int]) -> None:
    app = App(TABLE, 3, size=size, menu=True)
    hand = Hand(app)
    hand.key(pygame.K_ESCAPE)
    for key in (pygame.K_SPACE, pygame.K_p, pygame.K_LEFT, pygame.K_ESCAPE, pygame.K_t, pygame.K_t, pygame.K_v):
        hand.key(key)
        hand.move((size[0] // 2, size[1] // 2))
        hand.press()
        hand.move((0, size[1] - 1))
        hand.release()
    for key in (pygame.K_F1, pygame.K_ESCAPE, pygame.K_o, pygame.K_ESCAPE, pygame.K_F2, pygame.K_RETURN):
        hand.key(key)
        hand.move((size[0] // 2, size[1] // 2))
    app.toast("A note that is wider than the window.")
    for _ in range(20):
        assert app.step(FRAME)
    app.close()


@pytest.mark.parametrize("size", [(1, 1), (640, 2), (2, 640)])
def test_a_window_drawn_small_and_large_again_looks_as_before(hand: Hand, size: tuple[int, int]) -> None:
    hand.key(pygame.K_SPACE)
    hand.key(pygame.K_p)
    hand.app.step(FRAME)
    for to in (size, (1280, 720)):
        pygame.display.set_mode(to, pygame.RESIZABLE)
        hand.post(pygame.VIDEORESIZE, size=to, w=to[0], h=to[1])
        hand.app.step(FRAME)
    assert hand.app.window.surface.get_size() == (1280, 720) and hand.play.stage.screen.width == 1280


def test_a_window_is_drawn_on_itself_unless_it_is_tiny() -> None:
    large = pygame.Surface(LEAST)
    assert canvas(large) is large
    assert canvas(pygame.Surface((1000, 1))).get_size() == (1000, LEAST[1])


def store(width: int, height: int) -> Store:
    made = Store()
    made.turn("screen.width", width)
    made.turn("screen.height", height)
    return made


@pytest.mark.parametrize(
    ("kept", "opens"),
    [((3840, 2160), (1920, 1080)), ((2560, 600), (1920, 600)), ((1000, 2000), (1000, 1080)), ((10, 10), SMALLEST),
     ((1500, 900), (1500, 900))],
)  # fmt: skip
def test_a_size_kept_from_a_larger_screen_fits_on_this_one(
    monkeypatch: pytest.MonkeyPatch, kept: tuple[int, int], opens: tuple[int, int]
) -> None:
    monkeypatch.setattr(pygame.display, "get_desktop_sizes", lambda: [(1280, 1024), (1920, 1080)])
    assert first_size(store(*kept)) == opens


def test_a_window_larger_than_can_be_kept_is_kept_as_the_largest(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    huge = pygame.Surface((window.LARGEST + 7, 100))
    monkeypatch.setattr(pygame.display, "get_surface", lambda: huge)
    monkeypatch.setattr(hand.app, "_draw", lambda scene: None)
    hand.post(pygame.VIDEORESIZE, size=huge.get_size(), w=huge.width, h=huge.height)
    assert hand.app.store.values.screen.width == window.LARGEST
