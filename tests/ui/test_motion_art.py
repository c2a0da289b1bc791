"""Trails and arrows show what the rollout says, and nothing where nothing moves."""

from __future__ import annotations

import math
from itertools import pairwise

import pygame
import pytest

from pool2d import Ball, Layout, Shot, load_table, simulate
from pool2d.ui import trail, vectors
from pool2d.ui.effects import Effects
from pool2d.ui.view import fit

from .conftest import Hand

TABLE = load_table("pool-9ft")
CUE = Ball("cue", 0.635, 0.5)
CUT = Layout([CUE, Ball("1", 1.5, 0.53), Ball("8", 2.2, 1.1)])
ROLL = simulate(TABLE, CUT, Shot(angle=1.0, speed=3.0))
SIZE = (1280, 720)
VIEW = fit(2.54, 1.27, (0, 0, *SIZE))


def lit(picture: pygame.Surface, color: tuple[int, int, int]) -> list[tuple[float, float]]:
    """Where on the table a colour is, m."""
    mask = pygame.mask.from_threshold(picture, color, (24, 24, 24, 255))
    return [VIEW.to_table(x, y) for x in range(SIZE[0]) for y in range(SIZE[1]) if mask.get_at((x, y))]


def arrows(*balls: Ball) -> pygame.Surface:
    picture = pygame.Surface(SIZE)
    vectors.draw(picture, Layout(balls), TABLE, VIEW)
    return picture


def test_a_trail_ends_at_the_ball_and_lies_on_its_way() -> None:
    t = 0.5
    points = trail.tail(ROLL, "cue", t)
    assert points[-1][0] == t
    assert points[0][0] == pytest.approx(t - trail.LENGTH)
    for then, x, y in points:
        ball = ROLL.ball_at("cue", then)
        assert (x, y) == (ball.x, ball.y)
    assert all(a[0] < b[0] for a, b in pairwise(points))


def test_a_trail_turns_where_the_ball_turned() -> None:
    contact = next(event for event in ROLL.events if event.kind == "ball_ball")
    points = trail.tail(ROLL, "cue", contact.t + 0.1)
    assert contact.t in [then for then, _, _ in points]


def test_a_ball_at_rest_or_fallen_has_no_trail() -> None:
    assert trail.tail(ROLL, "8", 0.5) == []
    assert trail.tail(ROLL, "1", 0.1) == []
    assert trail.tail(ROLL, "cue", 0.0) == []
    assert trail.tail(ROLL, "cue", -0.1) == []
    potted = simulate(TABLE, Layout([Ball("cue", 0.3, 0.3)]), Shot(angle=225.0, speed=2.0))
    fall = next(event for event in potted.events if event.kind == "ball_pocket")
    assert trail.tail(potted, "cue", fall.t - 0.01)
    assert trail.tail(potted, "cue", fall.t) == []


def test_a_trail_fades_with_age() -> None:
    fast = simulate(TABLE, Layout([CUE]), Shot(angle=0.0, speed=3.0))
    picture = pygame.Surface(SIZE)
    t = 0.4
    trail.draw(picture, fast, t, TABLE, VIEW)

    def light(age: float) -> int:
        ball = fast.ball_at("cue", t - age)
        x, y = VIEW.to_screen(ball.x, ball.y)
        return sum(picture.get_at((round(x), round(y)))[:3])

    levels = [light(age) for age in (0.02, 0.1, 0.2, 0.28)]
    assert levels == sorted(levels, reverse=True)
    assert levels[0] > 3 * levels[2] > 0


@pytest.mark.parametrize(
    ("effects", "shown"),
    [(Effects(), True), (Effects(trails=False), False), (Effects(reduced_motion=True), False)],
)
def test_trails_are_an_option(hand: Hand, monkeypatch: pytest.MonkeyPatch, effects: Effects, shown: bool) -> None:
    drawn: list[object] = []

    def record(*args: object) -> list[pygame.Rect]:
        drawn.append(args)
        return []

    monkeypatch.setattr(trail, "draw", record)
    hand.play.effects = effects
    hand.key(pygame.K_SPACE)
    assert bool(drawn) is shown


@pytest.mark.parametrize("angle", [0.0, 60.0, 200.0])
def test_the_arrow_of_speed_points_ahead_and_grows_with_it(angle: float) -> None:
    cos, sin = math.cos(math.radians(angle)), math.sin(math.radians(angle))

    def reach(speed: float) -> float:
        ball = Ball("1", 1.27, 0.635, vx=speed * cos, vy=speed * sin)
        places = lit(arrows(ball), vectors.SPEED)
        assert all(abs((x - 1.27) * -sin + (y - 0.635) * cos) < 0.03 for x, y in places)
        return max((x - 1.27) * cos + (y - 0.635) * sin for x, y in places)

    assert reach(1.0) == pytest.approx(0.1 + 0.028575, abs=0.012)
    assert reach(3.0) == pytest.approx(0.3 + 0.028575, abs=0.012)


def test_the_arrow_of_roll_lies_on_that_of_speed_where_the_ball_rolls_and_against_it_with_draw() -> None:
    radius = 0.028575
    rolling = Ball("1", 1.27, 0.635, vx=2.0, wy=2.0 / radius)
    ahead = max(x for x, _ in lit(arrows(rolling), vectors.ROLL))
    assert ahead == pytest.approx(1.27 + 0.2 + radius, abs=0.012)
    drawn = rolling._replace(wy=-2.0 / radius)
    assert min(x for x, _ in lit(arrows(drawn), vectors.ROLL)) == pytest.approx(1.27 - 0.2 - radius, abs=0.012)


@pytest.mark.parametrize("spin", [60.0, -60.0])
def test_side_spin_is_an_arc_from_above_the_ball_that_goes_the_way_it_turns(spin: float) -> None:
    places = lit(arrows(Ball("1", 1.27, 0.635, wz=spin)), vectors.SIDE)
    assert places
    # Half a turn, counter-clockwise for a positive spin: on the left of the ball.
    assert sum(x - 1.27 for x, _ in places) * spin < 0.0


def test_a_ball_at_rest_has_no_arrows() -> None:
    picture = arrows(Ball("1", 1.27, 0.635))
    assert pygame.mask.from_threshold(picture, (0, 0, 0), (1, 1, 1, 255)).count() == SIZE[0] * SIZE[1]


def test_the_arrow_of_the_cue_starts_where_the_tip_meets_the_ball() -> None:
    picture = pygame.Surface(SIZE)
    vectors.draw_cue(picture, CUE, Shot(angle=0.0, speed=2.0, side=0.5), TABLE, VIEW)
    places = lit(picture, vectors.CUE)
    middle = sum(y for _, y in places) / len(places)
    assert middle == pytest.approx(CUE.y - 0.5 * 0.028575, abs=0.004), "right-hand english is to the right"
    assert max(x for x, _ in places) == pytest.approx(CUE.x + 0.2 + 0.028575, abs=0.012)


@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (1920, 1080)])
def test_v_shows_the_arrows_and_a_legend_clear_of_the_cloth(hand: Hand, size: tuple[int, int]) -> None:
    hand.app.surface = pygame.display.set_mode(size, pygame.RESIZABLE)
    hand.app.step(0.0)
    legend = vectors.draw_legend(hand.app.surface, hand.play.stage.screen)
    assert pygame.Rect(hand.play.stage.screen.table).contains(legend)
    assert legend.right <= hand.play.stage.view.to_screen(0.0, 0.0)[0]
    hand.point(1.7, 0.3)
    plain = pygame.image.tobytes(hand.app.surface, "RGB")
    hand.key(pygame.K_v)
    assert hand.play.vectors
    assert pygame.image.tobytes(hand.app.surface, "RGB") != plain
    hand.key(pygame.K_v)
    assert not hand.play.vectors
