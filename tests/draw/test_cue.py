"""The cue on the screen: where the stroke has it, whole at any angle and at the window's edge."""

from __future__ import annotations

import math
from dataclasses import replace

import pygame
import pytest

from pool2d import Ball, load_table
from pool2d.draw import cue
from pool2d.draw.view import View
from pool2d.game.aim import Aim

TABLE = load_table("pool-9ft")
VIEW = View(300.0, 500.0, 400.0)
GROUND = (40, 120, 100)
BALL = Ball("cue", 0.0, 0.0)
BACK = 0.1


def drawn(aim: Aim, size: tuple[int, int] = (1000, 800), view: View = VIEW) -> pygame.Surface:
    surface = pygame.Surface(size, depth=32)
    surface.fill(GROUND)
    cue.draw(surface, TABLE, BALL, aim, BACK, view)
    return surface


def along(picture: pygame.Surface, angle: float, distance: float, aside: float = 0.0) -> pygame.Color:
    """The colour behind the tip of a level cue."""
    turn = math.radians(angle)
    far = TABLE.knobs.ball.radius + 0.006 + BACK + distance
    x, y = VIEW.to_screen(
        -far * math.cos(turn) + aside * math.sin(turn), -far * math.sin(turn) - aside * math.cos(turn)
    )
    return picture.get_at((round(x), round(y)))


@pytest.mark.parametrize("angle", [0.0, 17.0, 45.0, 90.0, 133.0, 180.0, 271.0, 315.0])
def test_maple_before_a_dark_butt_and_nothing_before_the_tip(angle: float) -> None:
    picture = drawn(Aim(angle=angle))
    assert along(picture, angle, -0.03)[:3] == GROUND
    for distance in (0.2, 0.4, 0.6):
        assert min(along(picture, angle, distance)[:2]) > 120
    assert max(along(picture, angle, 1.15)[:3]) < 150
    red, _, blue, _ = along(picture, angle, 0.006)
    assert blue > red


@pytest.mark.parametrize("angle", [0.0, 60.0, 200.0])
def test_edges_are_smoothed(angle: float) -> None:
    picture = drawn(Aim(angle=angle))
    shades = {along(picture, angle, 0.3 + i / 3000, 0.0066 + (i % 7 - 3) / 3000)[:3] for i in range(300)}
    assert len(shades) > 20


def test_the_higher_the_butt_the_further_its_shadow_and_the_shorter_the_cue() -> None:
    def shadow(elevation: float) -> int:
        """How far below the cue its shadow reaches, pixels."""
        picture = drawn(Aim(angle=0.0, elevation=elevation))
        dark = [
            y for y in range(800) for x in range(100, 500, 4)
            if picture.get_at((x, y))[1] < 110 and abs(picture.get_at((x, y))[0] * 3 - picture.get_at((x, y))[1]) < 9
        ]  # fmt: skip
        return max(dark) - 400

    def end(elevation: float) -> int:
        picture = drawn(Aim(angle=0.0, elevation=elevation))
        return min(x for x in range(1000) if picture.get_at((x, 400))[:3] != GROUND)

    assert shadow(0.0) + 20 < shadow(20.0)
    assert end(0.0) + 20 < end(30.0)


def test_the_higher_the_butt_the_softer_its_shadow() -> None:
    def edge(elevation: float) -> int:
        """How many pixels the shadow's far edge takes, from nearly the cloth to two thirds of it."""
        picture = drawn(Aim(angle=0.0, elevation=elevation), view=View(1200.0, 1700.0, 200.0))
        column = [picture.get_at((600, y))[1] for y in range(799, 200, -1)]
        near, far = (next(i for i, shade in enumerate(column) if shade < part * GROUND[1]) for part in (0.96, 0.67))
        return far - near

    soft = [edge(elevation) for elevation in (0.0, 8.0, 16.0)]
    assert soft[0] + 2 < soft[1] and soft[1] + 2 < soft[2]


@pytest.mark.parametrize("angle", range(0, 360, 24))
def test_at_the_edge_only_what_is_in_the_window_is_drawn(angle: int) -> None:
    whole = drawn(Aim(angle=float(angle)))
    part = drawn(Aim(angle=float(angle)), (200, 160), replace(VIEW, left=100.0, bottom=80.0))
    expected = whole.subsurface((400, 320, 200, 160))
    assert pygame.image.tobytes(part, "RGB") == pygame.image.tobytes(expected, "RGB")
