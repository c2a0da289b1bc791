"""Height seen from above: by size, by light, by a shadow that parts from its ball, and by what lies over what."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import pygame
import pytest

from pool2d import Ball, Layout, Shot, load_table, simulate
from pool2d.draw import vectors
from pool2d.draw.balls import ball_art, ball_light, tray
from pool2d.draw.view import View
from pool2d.game.falling import ending, flying_off, gone
from pool2d.physics.orientation import FACING, BallRotation
from pool2d.physics.values import AIRBORNE
from pool2d.table import leaving

TABLE = load_table("pool-9ft")
RADIUS = TABLE.knobs.ball.radius
# 20 pixels to a radius.
VIEW = View(20.0 / RADIUS, -300.0, 700.0)
GROUND = (90, 90, 90)
PLACE = (0.7, 0.6)


def drawn(*balls: Ball) -> npt.NDArray[np.float64]:
    """Balls on plain grey, as levels by x and y."""
    surface = pygame.Surface((400, 500))
    surface.fill(GROUND)
    ball_art.draw_all(surface, [ball_art.placed_on(TABLE, VIEW, one, FACING) for one in ball_art.from_below(balls)])
    return pygame.surfarray.array3d(surface).astype(np.float64)


def at(z: float, name: str = "cue", x: float = PLACE[0]) -> Ball:
    return Ball(name, x, PLACE[1], z=z, phase=AIRBORNE if z else "resting")


def middle(dark: npt.NDArray[np.float64]) -> tuple[float, float]:
    """The middle of what is darker than the ground, weighed by how much, from the ball's place; right and down."""
    weight = np.maximum(GROUND[0] - dark.mean(axis=2) - 1.0, 0.0)
    x, y = VIEW.to_screen(*PLACE)
    across, down = np.arange(dark.shape[0])[:, None], np.arange(dark.shape[1])[None, :]
    return float((weight * (across - x)).sum() / weight.sum()), float((weight * (down - y)).sum() / weight.sum())


def test_the_higher_the_larger() -> None:
    placed = [ball_art.placed_on(TABLE, VIEW, at(z), FACING) for z in (0.0, 0.01, 0.05, 0.2, 0.5)]
    sizes = [one.nearer for one in placed]
    assert sizes == sorted(sizes) and sizes[0] == 1.0 and 1.05 < sizes[2] < 1.1 and sizes[-1] <= 2.0
    # What lies on the cloth is drawn as if there were no heights.
    assert placed[0] == ball_art.Placed(placed[0].look, VIEW.to_screen(*PLACE), 20.0)


def test_the_white_ball_covers_more_pixels_the_higher_it_is() -> None:
    covered = [(drawn(at(z)).min(axis=2) > 150.0).sum() for z in (0.0, 0.05, 0.2)]
    assert 1.05 * covered[0] < covered[1] < 0.9 * covered[2]


def test_the_shadow_parts_from_its_ball_away_from_the_lamp() -> None:
    # Where there is a shadow only, and the ball is over it no more.
    x, y = middle(drawn(at(0.12)))
    far = math.hypot(x, y) / VIEW.scale
    assert x > 0.0 < y
    # The lamp stands 35 degrees from above.
    assert far == pytest.approx(0.12 * math.hypot(0.34, 0.46) / 0.82, rel=0.15)


def test_the_shadow_grows_fainter_and_softer() -> None:
    pictures = [pygame.surfarray.array_alpha(ball_light.shadow(20.0, 10, height)[0]) for height in (0.0, 0.5, 2.0, 6.0)]
    darkest, wide = [int(picture.max()) for picture in pictures], [picture.shape[0] for picture in pictures[1:]]
    assert darkest == sorted(darkest, reverse=True) and darkest[0] > 3 * darkest[-1] > 0
    assert wide == sorted(wide)


def test_a_red_ball_has_more_light_the_higher_it_is() -> None:
    x, y = (round(part) for part in VIEW.to_screen(*PLACE))
    light = [drawn(at(z, "3"))[x + 3 : x + 9, y + 12 : y + 16].mean() for z in (0.0, 0.1, 0.25)]
    assert light[0] < light[1] < light[2]


def test_a_flying_ball_lies_over_the_one_below_whatever_their_order() -> None:
    high, low = at(0.07), at(0.0, "8", PLACE[0] + 0.6 * RADIUS)
    assert (drawn(high, low) == drawn(low, high)).all()
    x, y = (round(part) for part in VIEW.to_screen(*PLACE))
    assert drawn(high, low)[x + 8, y].min() > 150.0


def test_on_a_rails_top_a_ball_throws_its_shadow_as_on_the_cloth() -> None:
    top = TABLE.bed.ground.high
    on_top = ball_art.placed_on(TABLE, VIEW, Ball("3", 0.6, -0.06, z=top), FACING)
    assert on_top.height == pytest.approx(0.0) and on_top.nearer > 1.0
    over_it = ball_art.placed_on(TABLE, VIEW, Ball("3", 0.6, -0.06, z=top + 0.05), FACING)
    assert over_it.height == pytest.approx(0.05 * VIEW.scale)
    in_a_pocket = ball_art.placed_on(TABLE, VIEW, Ball("3", 1.27, -0.05, z=-0.01), FACING)
    assert not in_a_pocket.shadow and in_a_pocket.nearer < 1.0


OFF = simulate(TABLE, Layout([Ball("cue", 0.8, 0.635)]), Shot(0.0, 9.0, elevation=60.0))


def test_a_ball_that_goes_over_the_edge_flies_on_fades_and_is_gone() -> None:
    event = next(event for event in OFF.events if event.kind == "ball_off")
    turning, edge = BallRotation(OFF, {}), event.before["cue"]
    assert flying_off(OFF, turning, TABLE, event.t - 1e-6) == []
    steps = [flying_off(OFF, turning, TABLE, event.t + leaving.FOLLOWED * i / 10.0)[0] for i in range(10)]
    assert (steps[0].x, steps[0].y, steps[0].z) == (edge.x, edge.y, edge.z)
    assert steps[5].x == pytest.approx(edge.x + edge.vx * 0.5 * leaving.FOLLOWED)
    assert steps[-1].z < steps[0].z and steps[0].orientation != steps[5].orientation
    placed = [
        tray.going(OFF, turning, TABLE, event.t + s, lambda ball, lies: ball_art.placed_on(TABLE, VIEW, ball, lies))[0]
        for s in (0.0, 0.3, 0.55)
    ]
    assert [one.alpha for one in placed] == sorted((one.alpha for one in placed), reverse=True)
    assert placed[0].alpha == 255 and placed[-1].alpha < 60 and not any(one.shadow for one in placed)
    assert gone(OFF, event.t) == [] and gone(OFF) == ["cue"]
    assert ending(OFF) == event.t + leaving.FOLLOWED


def test_arrows_tell_rising_from_sinking_and_how_fast() -> None:
    def arrows(vz: float) -> npt.NDArray[np.bool_]:
        surface = pygame.Surface((400, 500))
        vectors.draw(surface, Layout([Ball("cue", *PLACE, vz=vz, z=0.05, phase=AIRBORNE)]), TABLE, VIEW)
        return np.asarray(pygame.surfarray.array3d(surface).any(axis=2))

    rising, sinking, fast, none = (arrows(vz) for vz in (0.5, -0.5, 1.0, 0.0))
    assert not none.any()
    x, y = (round(part) for part in VIEW.to_screen(*PLACE))
    # A dot is round, a cross has nothing straight above its middle.
    assert rising[x, y - 4] and not sinking[x, y - 4] and sinking[x - 4, y - 4] and sinking[x + 4, y - 4]
    reach = [np.flatnonzero(picture.any(axis=1)).max() - x for picture in (rising, sinking, fast)]
    assert reach[0] == reach[1] and reach[2] - reach[0] == pytest.approx(0.05 * VIEW.scale, abs=1.5)
