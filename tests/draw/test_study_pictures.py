"""Pictures of a study: colours that tell numbers, in their places."""

from __future__ import annotations

import itertools

import numpy as np
import pygame
import pytest

from pool2d import Ball, Layout, load_table
from pool2d.draw.export import heat_map, rests_picture
from pool2d.draw.export.ramp import colors
from pool2d.draw.view import fit
from pool2d.study.findings import Axis, HeatMap, Rests, cell_of

from .findings import ANGLES, SPEEDS, map_of_a_ridge, rests_in_a_ring

SIZE = (1280, 720)
TABLE = load_table("pool-9ft")


def level(color: pygame.Color) -> float:
    """How bright a colour is to an eye, from 0 to 1."""
    return (0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b) / 255.0


def test_more_is_brighter() -> None:
    shades = [pygame.Color(*shade) for shade in colors(np.linspace(0.0, 1.0, 60)).tolist()]
    levels = [level(shade) for shade in shades]
    assert all(a < b for a, b in itertools.pairwise(levels))
    # Evenly, so that no value looks like an edge.
    steps = np.diff(levels)
    assert steps.max() < 3.5 * steps.min()


def cell(picture: pygame.Surface, column: int, row: int) -> tuple[int, ...]:
    """The colour of a cell of the ridge's map, found from its frame."""
    left, top, width, height = frame()
    x = left + (column + 0.5) / len(ANGLES) * width
    y = top + (1.0 - (row + 0.5) / len(SPEEDS)) * height
    return tuple(picture.get_at((round(x), round(y))))[:3]


def frame() -> tuple[int, int, int, int]:
    """Where the cells are on a picture of `SIZE`."""
    return 115, 86, 1280 - 115 - 144, 720 - 86 - 115


def test_a_cell_has_the_colour_of_its_mean() -> None:
    heat = map_of_a_ridge()
    picture = heat_map.draw(heat, SIZE)
    low, high = np.nanmin(heat.mean), np.nanmax(heat.mean)
    for row, column in itertools.product(range(len(SPEEDS)), range(len(ANGLES))):
        mean = heat.mean[row, column]
        if np.isnan(mean):
            assert cell(picture, column, row) == (40, 42, 44)
        else:
            expected = colors(np.array([(mean - low) / (high - low)]))[0]
            assert cell(picture, column, row) == tuple(expected)


def test_the_bar_beside_the_map_has_every_colour_from_the_least_below_to_the_most_above() -> None:
    picture = heat_map.draw(map_of_a_ridge(), SIZE)
    left, top, width, height = frame()
    # In the bar, which begins a letter's breadth to the right of the map.
    x = left + width + 25
    shades = [tuple(picture.get_at((x, top + height - 1 - y)))[:3] for y in range(height)]
    expected = colors(np.linspace(0.0, 1.0, height)).astype(int)
    assert np.abs(np.array(shades) - expected).max() <= 4


@pytest.mark.parametrize("mean", [0.0, 1.0, np.nan])
def test_a_map_of_one_value_or_none_is_drawn(mean: float) -> None:
    flat = HeatMap(Axis("side", (0.1,)), Axis("height", (0.0, 0.1)), "balls potted", np.full((2, 1), mean))
    colours = {tuple(heat_map.draw(flat, SIZE).get_at(place))[:3] for place in ((300, 200), (900, 500))}
    assert colours == {(40, 42, 44) if np.isnan(mean) else tuple(colors(np.zeros(1))[0])}


@pytest.mark.parametrize("size", [(64, 64), (2000, 300)])
def test_any_size_is_drawn(size: tuple[int, int]) -> None:
    assert heat_map.draw(map_of_a_ridge(), size).get_size() == size
    layout = Layout([Ball("cue", 0.6, 0.6)])
    assert rests_picture.draw(rests_in_a_ring(2.54, 1.27), TABLE, layout, size).get_size() == size


def test_ticks_are_even_and_few() -> None:
    for count in range(1, 400):
        places = [part for part, _ in heat_map._ticks(Axis("speed", tuple(map(float, range(count)))))]
        assert 1 <= len(places) <= 7
        assert np.ptp(np.diff(places)) < 1e-9 if len(places) > 2 else True


@pytest.mark.parametrize(
    ("value", "span", "said"),
    [(4.77e-11, 1.0, "0"), (0.5, 1.0, "0.5"), (8.123456, 0.01, "8.1235"), (123.456, 100.0, "123"), (7.0, 0.0, "7")],
)
def test_what_colours_mean_is_told_to_a_hundredth(value: float, span: float, said: str) -> None:
    assert heat_map._said(value, span) == said


def test_a_rest_is_bright_where_it_was_and_the_more_the_brighter() -> None:
    counts = np.zeros((736, 1371))
    places = {(0.6, 0.3): 1.0, (1.2, 0.9): 10.0, (2.0, 0.5): 100.0}
    for (x, y), count in places.items():
        counts[cell_of(y), cell_of(x)] = count
    layout = Layout([Ball("cue", 1.27, 0.3)])
    picture = rests_picture.draw(Rests("cue", counts), TABLE, layout, SIZE)
    empty = rests_picture.draw(Rests("cue", np.zeros_like(counts)), TABLE, layout, SIZE)
    strip = round(0.09 * SIZE[1])
    view = fit(2.54, 1.27, (0, strip, SIZE[0], SIZE[1] - strip))
    levels = []
    for x, y in places:
        px, py = view.to_screen(x, y)
        levels.append(level(picture.get_at((round(px), round(py)))))
        assert levels[-1] > 2.0 * level(empty.get_at((round(px), round(py))))
        # A blot is smaller than a ball.
        radius = round(TABLE.knobs.ball.radius * view.scale)
        beside = (round(px) + radius, round(py))
        assert picture.get_at(beside) == empty.get_at(beside)
    assert levels == sorted(levels)
    assert levels[2] > levels[0] + 0.2
