"""The geometry that B shows."""

from __future__ import annotations

import pygame
import pytest

from pool2d import load_table
from pool2d.draw.debug import draw_geometry

from ..conftest import Hand


class Recorder:
    """A pen that notes what it draws."""

    def __init__(self) -> None:
        self.drawn: list[tuple[str, tuple[float, ...]]] = []

    def line(self, what: str, ax: float, ay: float, bx: float, by: float) -> None:
        self.drawn.append((what, (ax, ay, bx, by)))

    def circle(self, what: str, x: float, y: float, radius: float) -> None:
        self.drawn.append((what, (x, y, radius)))

    def box(self, what: str, left: float, bottom: float, right: float, top: float) -> None:
        self.drawn.append((what, (left, bottom, right, top)))


def test_the_geometry_drawn_is_the_one_the_physics_sees(hand: Hand) -> None:
    table = load_table("pool-9ft")
    pen = Recorder()
    draw_geometry(pen, table)
    kinds = [what for what, _ in pen.drawn]
    assert kinds.count("drop") == 6
    assert kinds.count("jaw") == 12
    assert kinds.count("nose") == 6 + 12
    assert kinds.count("broad phase") == len(table.elements)
    bottom = [place for what, place in pen.drawn if what == "contact" and len(place) == 4]
    assert any(ay == pytest.approx(table.reach(0.028575)) and by == pytest.approx(ay) for _, ay, _, by in bottom)
    plain = pygame.image.tobytes(hand.app.window.surface, "RGB")
    hand.key(pygame.K_b)
    assert pygame.image.tobytes(hand.app.window.surface, "RGB") != plain
    hand.key(pygame.K_b)
    assert pygame.image.tobytes(hand.app.window.surface, "RGB") == plain
