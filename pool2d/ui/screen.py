"""Where things are in a window of some size."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import pygame

from ..draw import theme


@dataclass(frozen=True)
class Screen:
    """Where things are in a window of a given size."""

    width: int
    height: int

    @cached_property
    def measure(self) -> int:
        """The height, or of a narrow window what it would be at 16 to 9, in pixels."""
        return min(self.height, self.width * 9 // 16)

    @cached_property
    def unit(self) -> int:
        return theme.unit(self.measure)

    @property
    def small(self) -> int:
        return self.unit * 7 // 4

    @property
    def large(self) -> int:
        return self.unit * 5 // 2

    @property
    def top(self) -> pygame.Rect:
        return pygame.Rect(0, 0, self.width, self.unit * 4)

    @property
    def tray(self) -> pygame.Rect:
        """Where the fallen balls lie: in the middle of the upper bar."""
        return pygame.Rect(self.width * 5 // 16, 0, self.width * 3 // 8, self.top.height)

    @property
    def bottom(self) -> pygame.Rect:
        return pygame.Rect(0, self.height - self.unit * 9, self.width, self.unit * 9)

    @property
    def table(self) -> tuple[int, int, int, int]:
        """The room between the bars, as left, top, width, height."""
        return 0, self.top.bottom, self.width, max(1, self.bottom.top - self.top.bottom)

    @property
    def ball_diagram(self) -> pygame.Rect:
        return pygame.Rect(self.unit * 2, self.bottom.top + self.unit // 2, self.unit * 8, self.unit * 8)

    @property
    def cue_diagram(self) -> pygame.Rect:
        return pygame.Rect(
            self.ball_diagram.right + self.unit * 2, self.ball_diagram.top, self.unit * 14, self.unit * 8
        )

    @property
    def power(self) -> pygame.Rect:
        left = self.cue_diagram.right + self.unit * 3
        return pygame.Rect(left, self.bottom.top + self.unit * 6, self.unit * 22, self.unit)

    @property
    def message(self) -> pygame.Rect:
        left = self.power.right + self.unit * 4
        return pygame.Rect(left, self.bottom.top, max(1, self.width - left - self.unit * 2), self.unit * 9)

    def spin_at(self, pos: tuple[int, int]) -> tuple[float, float]:
        """The tip's (side, height) for a point on the ball diagram."""
        box = self.ball_diagram
        return (pos[0] - box.centerx) / (box.width / 2), (box.centery - pos[1]) / (box.width / 2)

    def elevation_at(self, pos: tuple[int, int]) -> float:
        """The cue's elevation for a point on the cue diagram, degrees."""
        ball = self.cue_ball_centre
        return math.degrees(math.atan2(ball[1] - pos[1], max(1.0, ball[0] - pos[0])))

    @property
    def cue_ball_centre(self) -> tuple[float, float]:
        """The ball in the cue diagram, which is seen from the side."""
        box = self.cue_diagram
        return box.right - self.unit * 2.5, box.bottom - self.unit * 2.5
