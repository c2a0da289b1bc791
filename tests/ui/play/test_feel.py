"""How the cue feels in the hand: the same at any size, calm near the ball, and seen to strike."""

from __future__ import annotations

import math
import random
import time
from dataclasses import replace
from itertools import pairwise

import pygame
import pytest

from pool2d import Ball
from pool2d.draw import cue_motion
from pool2d.draw.effects import Effects
from pool2d.game.aim import FULL_PULL, MAX_SPEED, Aim, drawn_back, pulled_speed

from ..conftest import FRAME, Hand

CUE = Ball("cue", 0.635, 0.635)


@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (1920, 1080), (3840, 2160)])
@pytest.mark.parametrize("zoom", [0, 4])
def test_the_same_part_of_the_window_gives_the_same_speed(hand: Hand, size: tuple[int, int], zoom: int) -> None:
    hand.app.window.surface = pygame.display.set_mode(size, pygame.RESIZABLE)
    hand.app.step(0.0)
    hand.play.state.show.effects = Effects(reduced_motion=True)
    hand.move((size[0] * 0.6, size[1] * 0.4))
    for _ in range(zoom):
        hand.key(pygame.K_PLUS)
    hand.press()
    hand.pull(size[1] / 6)
    assert hand.play.state.hands.speed == pytest.approx(pulled_speed(1 / 6), rel=0.02)


def test_in_a_narrow_window_the_width_is_the_measure(hand: Hand) -> None:
    hand.app.window.surface = pygame.display.set_mode((800, 1000), pygame.RESIZABLE)
    hand.app.step(0.0)
    hand.point(1.9, 0.635)
    hand.press()
    hand.pull(FULL_PULL * 450)
    assert hand.play.state.hands.speed == pytest.approx(MAX_SPEED, rel=0.02)


def test_a_drawn_cue_tells_its_speed() -> None:
    for speed in (0.2, 1.0, 3.0, MAX_SPEED):
        assert pulled_speed(drawn_back(speed) * FULL_PULL) == pytest.approx(speed)


def test_close_to_the_ball_a_small_movement_is_a_small_turn(hand: Hand) -> None:
    """A trembling pointer a little beside the ball must not throw the cue about."""
    view = hand.play.stage.view
    hand.point(1.5, 0.7)
    x, y = view.to_screen(CUE.x + 0.035, CUE.y + 0.004)
    hand.move((x, y))
    rng = random.Random(1)
    for _ in range(40):
        before, at = hand.play.state.hands.aim.angle, hand.at
        hand.move((x + rng.randint(-2, 2), y + rng.randint(-2, 2)))
        turn = abs(math.remainder(hand.play.state.hands.aim.angle - before, 360.0))
        moved = math.dist(at, hand.at) / view.scale
        assert turn <= 1.4 * math.degrees(moved / (6 * 0.028575)) + 1e-9


def test_away_from_the_ball_the_cue_points_through_the_pointer_again(hand: Hand) -> None:
    view = hand.play.stage.view
    hand.point(1.5, 0.7)
    x, y = view.to_screen(CUE.x, CUE.y)
    for step in range(200):
        # Round the ball once, close to it, and then out.
        out = 14 + max(0, step - 60) * 2
        angle = min(step, 60) / 60 * 2.0
        hand.move((x + out * math.cos(angle), y - out * math.sin(angle)))
    px, py = view.to_table(*hand.at)
    through = math.degrees(math.atan2(py - CUE.y, px - CUE.x))
    assert hand.play.state.hands.aim.angle == pytest.approx(through)


def test_after_a_shot_the_cue_points_through_the_resting_pointer(hand: Hand) -> None:
    hand.set_balls(CUE)
    hand.point(1.4, 0.9)
    hand.key(pygame.K_SPACE)
    hand.key(pygame.K_SPACE)
    x, y = hand.play.stage.view.to_table(*hand.at)
    cue = hand.play.state.session.cue
    assert hand.play.state.hands.aim.angle == pytest.approx(math.degrees(math.atan2(y - cue.y, x - cue.x)) % 360.0)


def test_the_cue_comes_forward_meets_the_ball_and_is_gone() -> None:
    drawn = drawn_back(4.0)
    times = [-cue_motion.FORWARD + i * 0.005 for i in range(100)]
    backs = [cue_motion.reach(drawn, t)[0] for t in times]
    assert backs[0] == pytest.approx(cue_motion.stand(drawn))
    assert all(a >= b for a, b in pairwise(backs))
    assert cue_motion.reach(drawn, 0.0) == pytest.approx((0.0, 1.0), abs=1e-12)
    assert cue_motion.reach(drawn, -cue_motion.FORWARD - cue_motion.BACK) == pytest.approx((cue_motion.REST, 1.0))
    seen = [cue_motion.reach(drawn, t)[1] for t in times]
    assert seen[0] == 1.0
    assert seen[-1] == 0.0
    assert all(a >= b for a, b in pairwise(seen))


def test_the_balls_start_when_the_stroke_has_come_to_them(hand: Hand) -> None:
    hand.point(1.905, 0.635)
    hand.press()
    hand.pull(150)
    hand.release()
    playback = hand.play.state.playback
    assert playback is not None
    assert -cue_motion.FORWARD < playback.time < 0.0
    assert playback.rollout.at(playback.time)["cue"][1:3] == (CUE.x, CUE.y)
    for _ in range(8):
        hand.app.step(FRAME)
    assert playback.rollout.at(playback.time)["cue"].x > CUE.x


def test_with_reduced_motion_the_balls_start_at_once(hand: Hand) -> None:
    hand.play.state.show.effects = Effects(reduced_motion=True)
    hand.point(1.905, 0.635)
    hand.key(pygame.K_SPACE)
    assert hand.time == pytest.approx(2 * FRAME)


def test_at_rest_nothing_needs_to_be_drawn_anew(hand: Hand) -> None:
    assert hand.play.still
    hand.point(1.7, 0.3)
    hand.key(pygame.K_PLUS)
    assert not hand.play.still
    # The nearer picture is drawn on a thread, in its own time.
    for _ in range(3000):
        hand.app.step(FRAME)
        if hand.play.still:
            break
        time.sleep(0.01)
    assert hand.play.still
    hand.key(pygame.K_SPACE)
    assert not hand.play.still
    hand.key(pygame.K_p)
    assert hand.play.still
    hand.key(pygame.K_SPACE)
    assert not hand.play.still


@pytest.mark.parametrize(("table", "angle"), [("pool-9ft", 0.0), ("carom-10ft", None)])
def test_a_new_rack_is_faced(hand: Hand, table: str, angle: float | None) -> None:
    hand.play.state.open_table(table)
    hand.point(0.1, 1.2)
    hand.key(pygame.K_w)
    hand.key(pygame.K_UP)
    before = hand.play.state.hands.aim
    hand.key(pygame.K_n)
    aim, session = hand.play.state.hands.aim, hand.play.state.session
    others = [ball for ball in session.layout.values() if ball.id != session.cue.id]
    x, y = sum(ball.x for ball in others) / len(others), sum(ball.y for ball in others) / len(others)
    way = math.degrees(math.atan2(y - session.cue.y, x - session.cue.x))
    assert math.remainder(aim.angle - (way if angle is None else angle), 360.0) == pytest.approx(0.0, abs=0.01)
    # Whoever tries a break again wants it as it was struck.
    assert aim == replace(before, angle=aim.angle) and aim.height > 0.0
    hand.play.state.open_table(table)
    assert hand.play.state.hands.aim == Aim(angle=aim.angle)
