"""The camera: what is drawn and what the pointer means agree, at any zoom, and the table is never lost."""

from __future__ import annotations

import random

import pygame
import pytest

from pool2d import Ball
from pool2d.draw.effects import Effects
from pool2d.draw.view import FRAME, View
from pool2d.ui.stage.camera import MAX_ZOOM

from ..conftest import FRAME as TICK
from ..conftest import Hand

LENGTH, WIDTH = 2.54, 1.27


def settle(hand: Hand) -> View:
    for _ in range(200):
        if hand.play.stage.camera.settled:
            return hand.play.stage.view
        hand.app.step(TICK)
    raise AssertionError("the camera is still on its way")


def ctrl_wheel(hand: Hand, y: int) -> None:
    pygame.key.set_mods(pygame.KMOD_LCTRL)
    hand.wheel(y)
    pygame.key.set_mods(0)


def sensible(hand: Hand, view: View) -> bool:
    """Whether the table with its frame fills the room, or lies in its middle."""
    left, top, width, height = hand.play.stage.screen.table
    x0, y1 = view.to_screen(-FRAME, -FRAME)
    x1, y0 = view.to_screen(LENGTH + FRAME, WIDTH + FRAME)
    across = x1 - x0 <= width + 1e-6 or (x0 <= left + 1e-6 and x1 >= left + width - 1e-6)
    down = y1 - y0 <= height + 1e-6 or (y0 <= top + 1e-6 and y1 >= top + height - 1e-6)
    return across and down


def test_ctrl_and_the_wheel_zoom_at_the_pointer(hand: Hand) -> None:
    hand.point(1.9, 0.4)
    under = hand.play.stage.view.to_table(*hand.at)
    scale, aim = hand.play.stage.view.scale, hand.play.state.hands.aim
    ctrl_wheel(hand, 3)
    glide = hand.play.stage.view
    assert glide.to_table(*hand.at) == pytest.approx(under)
    assert scale < glide.scale < settle(hand).scale
    assert hand.play.stage.view.to_table(*hand.at) == pytest.approx(under)
    assert hand.play.stage.view.scale == pytest.approx(scale * 1.2**3)
    assert hand.play.state.hands.aim == aim


def test_reduced_motion_goes_there_at_once(hand: Hand) -> None:
    hand.play.state.show.effects = Effects(reduced_motion=True)
    hand.point(1.9, 0.4)
    ctrl_wheel(hand, 3)
    assert hand.play.stage.camera.settled


def test_by_keys_alone(hand: Hand) -> None:
    home = hand.play.stage.view
    for _ in range(5):
        hand.key(pygame.K_PLUS)
    near = settle(hand)
    assert near.scale > 2.0 * home.scale
    hand.key(pygame.K_l)
    hand.key(pygame.K_k)
    moved = settle(hand)
    assert moved.left < near.left
    assert moved.bottom < near.bottom
    hand.key(pygame.K_MINUS)
    assert settle(hand).scale < moved.scale
    hand.key(pygame.K_0)
    assert settle(hand) == home


def test_the_middle_button_drags_the_table_along(hand: Hand) -> None:
    hand.point(1.2, 0.6)
    ctrl_wheel(hand, 5)
    settle(hand)
    aim = hand.play.state.hands.aim
    under = hand.play.stage.view.to_table(*hand.at)
    hand.press(2)
    hand.move((hand.at[0] + 60, hand.at[1] - 40))
    assert hand.play.stage.view.to_table(*hand.at) == pytest.approx(under)
    hand.release(2)
    assert hand.play.state.hands.aim == aim
    there = hand.play.stage.view
    hand.move((hand.at[0] + 60, hand.at[1] - 40))
    assert hand.play.stage.view == there


@pytest.mark.parametrize("size", [(1280, 720), (960, 540), (700, 900)])
def test_the_table_is_never_lost(hand: Hand, size: tuple[int, int]) -> None:
    hand.app.window.surface = pygame.display.set_mode(size, pygame.RESIZABLE)
    hand.app.step(0.0)
    home = hand.play.stage.view
    rng = random.Random(5)
    for _ in range(60):
        hand.move((rng.randrange(size[0]), rng.randrange(size[1])))
        hand.key(rng.choice([pygame.K_PLUS, pygame.K_MINUS, pygame.K_i, pygame.K_j, pygame.K_k, pygame.K_l]))
        target = hand.play.stage.camera.target
        assert sensible(hand, target)
        assert home.scale * (1.0 - 1e-9) <= target.scale <= MAX_ZOOM * home.scale * (1.0 + 1e-9)
    hand.key(pygame.K_0)
    assert settle(hand) == home


def test_another_size_of_the_window_keeps_the_zoom(hand: Hand) -> None:
    hand.point(1.9, 0.4)
    ctrl_wheel(hand, 4)
    before = settle(hand)
    zoom = before.scale / hand.play.stage.camera.home.scale
    middle = before.to_table(640, 340)
    hand.app.window.surface = pygame.display.set_mode((1920, 1080), pygame.RESIZABLE)
    hand.app.step(0.0)
    after = hand.play.stage.view
    assert after.scale / hand.play.stage.camera.home.scale == pytest.approx(zoom)
    assert after.to_table(960, 510) == pytest.approx(middle, abs=0.02)


def test_a_ball_is_drawn_where_the_pointer_finds_it(hand: Hand) -> None:
    hand.set_balls(Ball("cue", 0.6, 0.6), Ball("8", 1.9, 0.4))
    hand.point(1.9, 0.4)
    hand.play.state.show.level = 0
    ctrl_wheel(hand, 6)
    view = settle(hand)
    hand.app.step(0.0)
    radius = 0.028575 * view.scale
    x, y = view.to_screen(1.9, 0.4)
    for dx, dy in ((0.8, 0.0), (-0.8, 0.0), (0.0, -0.8), (0.0, 0.8)):
        color = hand.app.window.surface.get_at((round(x + dx * radius), round(y + dy * radius)))
        assert max(color[:3]) < 125, "the eight is black"


@pytest.mark.parametrize(("x", "y"), [(0.0, 0.3), (2.54, 1.0), (0.7, 0.0), (2.0, 1.27)])
def test_the_table_is_drawn_where_the_view_says(hand: Hand, x: float, y: float) -> None:
    """The dark crease under a nose lies within a pixel or two of its place, also in the part cut out."""
    hand.set_balls(Ball("cue", 1.27, 0.635))
    hand.play.state.show.level = 0
    hand.point(1.27, 1.2)
    hand.point(x, y)
    ctrl_wheel(hand, 5)
    view = settle(hand)
    hand.app.step(0.0)
    px, py = view.to_screen(x, y)
    across = x in (0.0, LENGTH)
    light = []
    for step in range(-12, 13):
        at = (round(px) + step, round(py)) if across else (round(px), round(py) + step)
        light.append((sum(hand.app.window.surface.get_at(at)[:3]), abs(step)))
    assert min(light)[1] <= 4


def test_a_new_table_is_seen_whole(hand: Hand) -> None:
    hand.point(1.9, 0.4)
    ctrl_wheel(hand, 4)
    hand.play.state.open_table("snooker-12ft")
    hand.app.step(0.0)
    assert hand.play.stage.view == hand.play.stage.camera.home
