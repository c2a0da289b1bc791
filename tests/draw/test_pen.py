"""Discs and rings."""

from __future__ import annotations

import math

import pygame
import pytest

from pool2d.draw import pen
from pool2d.draw.theme import Color


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


@pytest.mark.parametrize("width", [1.2, 1.6, 2.0, 3.4])
@pytest.mark.parametrize("turn", [0, 3, 7, 15, 30, 44, 45, 46, 60, 83, 90, 91, 135, 170, 225, 300])
def test_a_line_has_one_width_at_every_angle_and_place(width: float, turn: float) -> None:
    way = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    for x, y in ((100.0, 100.0), (100.3, 99.6), (99.51, 100.49)):
        picture = pygame.Surface((200, 200))
        ends = [(x + side * 80.0 * way[0], y + side * 80.0 * way[1]) for side in (-1.0, 1.0)]
        pen.line(picture, (255, 255, 255), ends[0], ends[1], width)
        total = pygame.surfarray.array3d(picture)[:, :, 0].sum() / 255.0
        assert total / 160.0 == pytest.approx(width, rel=0.02)


def test_a_way_of_many_pieces_looks_like_one() -> None:
    one, many = pygame.Surface((200, 120)), pygame.Surface((200, 120))
    a, b = (10.2, 20.4), (190.7, 97.3)
    between = [(a[0] + (b[0] - a[0]) * i / 37, a[1] + (b[1] - a[1]) * i / 37) for i in range(38)]
    pen.line(one, (220, 180, 90), a, b, 1.6)
    pen.paths(many, [pen.Path((220, 180, 90), between, 1.6)])
    difference = pygame.surfarray.array3d(one).astype(int) - pygame.surfarray.array3d(many)
    assert abs(difference).max() <= 30


def test_many_lines_drawn_together_look_as_if_drawn_one_after_another() -> None:
    fan = [
        pen.Path(
            (255, 40 * i, 0, 255 - 30 * i), [(100.3, 60.1), (10.0 + 40.0 * i, 5.0), (90.0, 100.0 - 9.0 * i)], width
        )
        for i, width in enumerate((1.2, 2.0, 7.0, 1.6, 3.0))
    ]
    together, apart = pygame.Surface((200, 120)), pygame.Surface((200, 120))
    for picture in (together, apart):
        picture.fill((20, 90, 60))
    pen.paths(together, fan)
    for path in fan:
        pen.paths(apart, [path])
    assert pygame.image.tobytes(together, "RGB") == pygame.image.tobytes(apart, "RGB")
    pen.paths(apart, reversed(fan))
    assert pygame.image.tobytes(together, "RGB") != pygame.image.tobytes(apart, "RGB")


def test_a_line_goes_over_what_is_there_by_its_colours_own_transparency() -> None:
    picture = pygame.Surface((40, 40))
    picture.fill((200, 100, 0))
    pen.line(picture, (0, 100, 200, 51), (0.0, 20.0), (40.0, 20.0), 3.0)
    assert picture.get_at((20, 20))[:3] == (160, 100, 40)
    assert picture.get_at((20, 30))[:3] == (200, 100, 0)


@pytest.mark.parametrize(
    "points", [[], [(5.0, 5.0)], [(5.0, 5.0), (5.0, 5.0)], [(-9.0, 5.0), (-3.0, 5.0)], [(5.0, -3.0), (15.0, -3.5)]]
)
def test_a_way_that_is_none_or_out_of_sight_leaves_no_mark(points: list[pen.Point]) -> None:
    picture = pygame.Surface((20, 20))
    pen.paths(picture, [pen.Path((255, 255, 255), points)])
    assert not pygame.surfarray.array3d(picture).any()


@pytest.mark.parametrize("clip", [(20, 20, 20, 20), (0, 0, 31, 60), (10, 25, 50, 3), (29, 0, 2, 60)])
@pytest.mark.parametrize("turn", [0, 14, 45, 76, 90, 120])
def test_of_a_line_the_clip_leaves_what_is_within_it(clip: tuple[int, int, int, int], turn: float) -> None:
    x, y = 80.0 * math.cos(math.radians(turn)), 80.0 * math.sin(math.radians(turn))
    ends = (30.2 - x, 30.7 - y), (30.2 + x, 30.7 + y)
    whole, part = pygame.Surface((60, 60)), pygame.Surface((60, 60))
    part.set_clip(clip)
    for picture in (whole, part):
        pen.line(picture, (255, 255, 255), *ends, 2.0)
    expected = pygame.Surface((60, 60))
    expected.blit(whole, clip[:2], clip)
    assert pygame.image.tobytes(part, "RGB") == pygame.image.tobytes(expected, "RGB")


def test_a_line_that_was_drawn_before_is_drawn_anew_in_another_colour_width_or_place() -> None:
    points = [(5.0, 7.3), (50.0, 30.0), (12.0, 38.0)]

    def drawn(color: Color, width: float, size: tuple[int, int]) -> pygame.Surface:
        picture = pygame.Surface(size)
        picture.fill((20, 90, 60))
        pen.paths(picture, [pen.Path(color, points, width)])
        return picture.subsurface((0, 0, 60, 40))

    def look(picture: pygame.Surface) -> bytes:
        return pygame.image.tobytes(picture, "RGB")

    first = drawn((255, 0, 0), 2.0, (60, 40))
    assert look(drawn((255, 0, 0), 2.0, (90, 44))) == look(first)
    assert look(drawn((255, 0, 0, 128), 2.0, (60, 40))) != look(first) != look(drawn((255, 0, 0), 3.0, (60, 40)))
    assert drawn((0, 0, 255), 2.0, (60, 40)).get_at((30, 20))[:3] != first.get_at((30, 20))[:3] != (20, 90, 60)
    points[1] = (50.0, 31.0)
    assert look(drawn((255, 0, 0), 2.0, (60, 40))) != look(first)
