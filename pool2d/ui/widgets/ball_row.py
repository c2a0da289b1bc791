"""A widget that shows pool balls in a row, so that a palette or the shapes can be judged where they are set."""

from __future__ import annotations

from collections.abc import Callable

import pygame

from ...draw import theme
from ...draw.balls import ball_art, tray
from ...physics.orientation import FACING, turn
from .widget import Widget

# Shapes are beside the numbers: balls that have them are turned so far that both are seen, rad.
_TILT = (0.0, 0.85, 0.0)
_BALLS = tuple(str(number) for number in range(1, 16))


class BallRow(Widget):
    """The balls of a pool set side by side; `style` is asked at each frame how they are drawn."""

    rows = 1.6
    focusable = False

    def __init__(self, style: Callable[[], theme.Style]) -> None:
        super().__init__()
        self.style = style

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        style = self.style()
        orientation = turn(*_TILT) if style.patterned else FACING
        tray.draw(surface, self.rect, [ball_art.usual(ball) for ball in _BALLS], style, orientation)
