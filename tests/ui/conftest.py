"""A person at the table: an App without a screen, and hands that post events."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

os.environ["SDL_VIDEODRIVER"] = "dummy"
os.environ["SDL_AUDIODRIVER"] = "dummy"

import pygame
import pytest

from pool2d import Ball, Layout, load_table
from pool2d.ui.app import App
from pool2d.ui.play.play import Play

FRAME = 1.0 / 60.0
# The two balls of `two`.
CUE, ONE = Ball("cue", 0.6, 0.6), Ball("1", 1.4, 0.7)

pygame.font.init()


class Hand:
    """Moves the mouse and presses keys of an app, a frame after each."""

    def __init__(self, app: App) -> None:
        self.app = app
        self.play: Play = app.play
        self.open = app.step(0.0)
        self.at = (0, 0)

    @property
    def time(self) -> float:
        """The moment of the shot that is shown, s; below 0 the cue is still on its way."""
        shown = self.play.state.playback
        return 0.0 if shown is None else shown.time

    def post(self, kind: int, **fields: Any) -> None:
        pygame.event.post(pygame.event.Event(kind, **fields))
        self.open = self.app.step(FRAME)

    def move(self, pos: tuple[float, float]) -> None:
        to = (round(pos[0]), round(pos[1]))
        rel = (to[0] - self.at[0], to[1] - self.at[1])
        self.at = to
        self.post(pygame.MOUSEMOTION, pos=to, rel=rel, buttons=(0, 0, 0))

    def press(self, button: int = 1) -> None:
        self.post(pygame.MOUSEBUTTONDOWN, pos=self.at, button=button)

    def release(self, button: int = 1) -> None:
        self.post(pygame.MOUSEBUTTONUP, pos=self.at, button=button)

    def wheel(self, y: int) -> None:
        self.post(pygame.MOUSEWHEEL, x=0, y=y, flipped=False)

    def key(self, key: int, mod: int = 0) -> None:
        self.post(pygame.KEYDOWN, key=key, mod=mod, unicode="")
        self.post(pygame.KEYUP, key=key, mod=mod)

    def point(self, x: float, y: float) -> None:
        """Move to a place on the table, in m."""
        self.move(self.play.stage.view.to_screen(x, y))

    def pull(self, pixels: float) -> None:
        """From a pressed button, go back along the cue."""
        angle = math.radians(self.play.state.hands.aim.angle)
        self.move((self.at[0] - pixels * math.cos(angle), self.at[1] + pixels * math.sin(angle)))

    def wait_for_rest(self) -> None:
        for _ in range(3000):
            if not self.play.state.rollout:
                return
            self.app.step(FRAME)
        raise AssertionError("the balls are still running")

    def strike(self) -> None:
        """Strike by key, and see it to its end at once; where no stroke is armed, the first press arms it."""
        self.app.step(0.5)
        for _ in range(1 if self.play.state.hands.armed else 2):
            self.key(pygame.K_SPACE)
        self.key(pygame.K_SPACE)
        self.app.step(0.5)
        self.wait_for_rest()

    def set_balls(self, *balls: Ball, in_hand: bool = False) -> None:
        """Put these balls on the table instead of the rack; the cue ball is taken in hand where that is asked for."""
        cue = self.play.state.session.table.furniture.cue
        self.play.state.session.arrange(Layout(ball for ball in balls if not (in_hand and ball.id == cue)))


@pytest.fixture(autouse=True)
def data(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every test begins without records, results and presets of its own."""
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path / "data"))


@pytest.fixture
def hand() -> Iterator[Hand]:
    app = App(load_table("pool-9ft"), seed=3)
    pygame.event.clear()
    yield Hand(app)
    app.close()


@pytest.fixture
def two(hand: Hand) -> Hand:
    """A hand at a table with two balls."""
    hand.set_balls(CUE, ONE)
    hand.point(1.0, 0.3)
    return hand


@pytest.fixture
def guest() -> Iterator[Hand]:
    """A hand at a window that has opened with the menu."""
    app = App(load_table("pool-9ft"), seed=3, menu=True)
    pygame.event.clear()
    yield Hand(app)
    app.close()
