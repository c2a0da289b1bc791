"""Trails and arrows show what the rollout says, and nothing where nothing moves."""

from __future__ import annotations

import math
from itertools import pairwise

import pygame
import pytest

from pool2d import Ball, Layout, Rollout, Shot, load_table, simulate
from pool2d.draw import trail, vectors
from pool2d.draw.effects import Effects
from pool2d.draw.view import fit
from pool2d.ui.stage.legend import draw_legend

from ..ui.conftest import Hand

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


def test_marks_lie_on_a_balls_way_where_it_is_at_their_time() -> None:
    times, places = trail.marks(ROLL, TABLE)["cue"]
    assert len(times) > 50
    for then, (x, y) in zip(times, places, strict=True):
        ball = ROLL.ball_at("cue", then)
        # The way is followed in short straight lines.
        assert math.dist((x, y), (ball.x, ball.y)) < 0.004
    assert all(a < b for a, b in pairwise(times))


def test_marks_are_evenly_apart_and_follow_every_turn() -> None:
    times, places = trail.marks(ROLL, TABLE)["cue"]
    contact = next(event for event in ROLL.events if event.kind == "ball_ball")
    gaps = {(a, b): math.dist(p, q) for (a, p), (b, q) in pairwise(zip(times, places, strict=True))}
    turns = [event.t for event in ROLL.events if "cue" in event.balls]
    pitch = gaps[min(gaps)]
    straight = [gap for (a, b), gap in gaps.items() if not any(a < t < b for t in turns)]
    assert straight == pytest.approx([pitch] * len(straight), rel=0.01)
    bent = next(gap for (a, b), gap in gaps.items() if a < contact.t < b)
    assert bent < 0.99 * pitch


def drawn(ball: str, roll: Rollout, t: float) -> bool:
    """Whether a ball has a trail."""
    alone = Rollout(Layout([roll.start[ball]]), {ball: roll.tracks[ball]}, roll.events, False)
    return bool(trail.draw(pygame.Surface(SIZE), alone, t, TABLE, VIEW))


def test_a_ball_that_rests_or_has_not_moved_yet_has_no_trail() -> None:
    for ball, t in (("8", 0.5), ("1", 0.1), ("cue", -0.1)):
        assert not drawn(ball, ROLL, t)
    assert drawn("cue", ROLL, 0.1)
    assert not drawn("cue", ROLL, ROLL.duration + trail.LENGTH)


def test_a_trail_fades_when_its_ball_has_fallen() -> None:
    potted = simulate(TABLE, Layout([Ball("cue", 0.3, 0.3)]), Shot(angle=225.0, speed=2.0))
    fall = next(event for event in potted.events if event.kind == "ball_pocket")
    assert drawn("cue", potted, fall.t)
    assert not drawn("cue", potted, fall.t + trail.LENGTH)


def test_all_light_of_a_trail_is_in_the_boxes_that_are_told() -> None:
    picture = pygame.Surface(SIZE)
    boxes = trail.draw(picture, ROLL, 0.9, TABLE, VIEW)
    assert len(boxes) > 5
    for box in boxes:
        picture.fill("black", box)
    assert not pygame.surfarray.array3d(picture).any()


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
    hand.play.state.show.effects = effects
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
    hand.app.window.surface = pygame.display.set_mode(size, pygame.RESIZABLE)
    hand.app.step(0.0)
    legend = draw_legend(hand.app.window.surface, hand.app.words, hand.play.stage.screen)
    assert pygame.Rect(hand.play.stage.screen.table).contains(legend)
    assert legend.right <= hand.play.stage.view.to_screen(0.0, 0.0)[0]
    hand.point(1.7, 0.3)
    plain = pygame.image.tobytes(hand.app.window.surface, "RGB")
    hand.key(pygame.K_v)
    assert hand.play.state.show.vectors
    assert pygame.image.tobytes(hand.app.window.surface, "RGB") != plain
    hand.key(pygame.K_v)
    assert not hand.play.state.show.vectors
