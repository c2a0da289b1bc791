"""A running shot's frame is drawn over the last one: what that leaves on the window is what a whole frame shows."""

from __future__ import annotations

import numpy as np
import pygame
import pytest

from pool2d import Ball
from pool2d.draw.balls import ball_skin
from pool2d.draw.tabletop.background import Background
from pool2d.game.aim import Aim
from pool2d.ui.frame import Frame
from pool2d.ui.stage import bars

from ..conftest import FRAME, Hand
from ..play.test_drill_scene import begin


@pytest.fixture(autouse=True)
def skins(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every ball that moves is looked up in its skin from the first, so that a frame drawn twice is the same."""
    monkeypatch.setattr(ball_skin, "known", lambda coat, radius: True)


@pytest.fixture
def parts(monkeypatch: pytest.MonkeyPatch) -> list[bool]:
    """Of each frame, whether only a part of it was drawn."""
    drawn: list[bool] = []
    show = Background.show

    def record(*given: object) -> bool:
        drawn.append(show(*given))  # type: ignore[arg-type]
        return drawn[-1]

    monkeypatch.setattr(Background, "show", record)
    return drawn


def watch(hand: Hand, frames: int) -> None:
    """Let the shot run, and compare each frame with one that is drawn as a whole."""
    for _ in range(frames):
        hand.app.step(FRAME)
        seen = pygame.surfarray.array3d(hand.app.window.surface)
        assert hand.app.scene is not None
        # Bars that are kept would say the same again.
        hand.play.stage.bars = bars.CachedBars()
        hand.app.scene.draw(Frame(hand.app.window.surface))
        whole = pygame.surfarray.array3d(hand.app.window.surface)
        assert np.array_equal(seen, whole), f"{np.argwhere(seen != whole)[[0, -1]]} at {hand.play.state.playback}"


def test_a_break_looks_as_if_every_frame_were_drawn_as_a_whole(hand: Hand, parts: list[bool]) -> None:
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(9.0).toward(1.0, 0.003)
    hand.key(pygame.K_SPACE)
    # Until the cue is gone every frame is a whole one.
    watch(hand, 40)
    del parts[:]
    watch(hand, 160)
    assert parts == [True, False] * 160


def test_it_does_from_near_where_balls_leave_the_picture(hand: Hand, parts: list[bool]) -> None:
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(9.0).toward(1.0, 0.003)
    hand.key(pygame.K_SPACE)
    watch(hand, 30)
    hand.play.stage.camera.zoom(5.0)
    while not hand.play.stage.still:
        hand.app.step(FRAME)
    del parts[:]
    watch(hand, 60)
    assert any(parts)


def test_nothing_stays_of_what_was_over_the_table(hand: Hand, parts: list[bool]) -> None:
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(9.0).toward(1.0, 0.003)
    hand.key(pygame.K_SPACE)
    watch(hand, 40)
    for key in (pygame.K_v, pygame.K_b, pygame.K_t, pygame.K_F1):
        for _ in range(2):
            hand.key(key)
            watch(hand, 3)
    hand.app.toast("a note")
    while hand.app.toasts.notes:
        hand.app.step(0.5)
    hand.play.state.playback.seek(0.7)  # type: ignore[union-attr]
    hand.play.state.playback.kept = False  # type: ignore[union-attr]
    watch(hand, 3)
    # The window was covered, or the system has taken its picture away.
    hand.app.window.surface.fill("red")
    hand.post(pygame.VIDEOEXPOSE)
    watch(hand, 3)
    assert parts[-2]


def test_the_marks_of_a_drill_stay_below_the_balls(hand: Hand) -> None:
    drill = begin(hand, "stop-shot")
    hand.play.state.hands.aim = Aim.of(drill.session.drill.solution[0])
    hand.key(pygame.K_SPACE)
    watch(hand, 60)


def test_the_time_line_covers_the_lower_bar_alone(hand: Hand, parts: list[bool]) -> None:
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(9.0).toward(1.0, 0.003)
    hand.key(pygame.K_SPACE)
    watch(hand, 40)
    hand.key(pygame.K_p)
    watch(hand, 2)
    hand.move((500, 660))
    hand.key(pygame.K_p)
    del parts[:]
    watch(hand, 5)
    assert any(parts)
    hand.key(pygame.K_ESCAPE)
    watch(hand, 3)


def test_the_bars_follow_what_is_set_while_a_shot_runs(hand: Hand) -> None:
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(9.0).toward(1.0, 0.003)
    hand.key(pygame.K_SPACE)
    watch(hand, 40)
    for name, value in (("aiming.speed_unit", "mph"), ("screen.language", "de"), ("balls.trails", False)):
        hand.app.store.turn(name, value)
        watch(hand, 3)


def test_nothing_stays_when_the_balls_come_to_rest_or_the_window_changes(hand: Hand) -> None:
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(2.0).toward(0.0, 1.0)
    hand.key(pygame.K_SPACE)
    watch(hand, 40)
    for _ in range(2):
        hand.key(pygame.K_F11)
        watch(hand, 3)
    while hand.play.state.playback is not None:
        hand.app.step(FRAME)
    watch(hand, 3)
    hand.wheel(5)
    watch(hand, 3)


def test_a_cue_that_strikes_again_at_once_leaves_nothing_on_the_bars(hand: Hand) -> None:
    # The cue ball near the lower rail: the cue lies over the bar.
    hand.set_balls(Ball("cue", 1.2, 0.1), Ball("1", 1.2, 1.0))
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(5.0).toward(0.0, 1.0)
    hand.key(pygame.K_SPACE)
    watch(hand, 60)
    hand.key(pygame.K_u)
    hand.key(pygame.K_SPACE)
    watch(hand, 60)
