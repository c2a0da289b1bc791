"""Discs and rings."""

from __future__ import annotations

import math

import pygame
import pytest

from pool2d.ui import pen


def level(surface: pygame.Surface, x: float, y: float) -> int:
    return surface.get_at((round(x), round(y)))[0]


@pytest.mark.parametrize("radius", [2.0, 5.5, 20.0])
def test_a_disc_is_filled_to_its_middle_and_no_further_than_its_edge(radius: float) -> None:
    picture = pygame.Surface((60, 60))
    pen.disc(picture, (255, 255, 255), (30.0, 30.0), radius)
    assert level(picture, 30, 30) == 255
    total = sum(level(picture, x, y) for x in range(60) for y in range(60)) / 255.0
    assert total == pytest.approx(math.pi * radius * radius, rel=0.06)
    assert level(picture, 30 + radius + 2, 30) == 0


def test_a_ring_is_empty_inside() -> None:
    picture = pygame.Surface((60, 60))
    pen.ring(picture, (255, 255, 255), (30.0, 30.0), 20.0, 3.0)
    assert level(picture, 30, 30) == 0
    assert level(picture, 50, 30) == 255
    total = sum(level(picture, x, y) for x in range(60) for y in range(60)) / 255.0
    assert total == pytest.approx(math.tau * 20.0 * 3.0, rel=0.05)
