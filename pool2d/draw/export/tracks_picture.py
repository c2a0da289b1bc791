"""A tracked shot and the engine's: where balls were seen, as dots, over the ways that a fit gives them."""

from __future__ import annotations

import pygame

from ...fit.launch import MOMENT
from ...fit.miss import Stretch, play
from ...fit.shot_fit import Fitted
from ...game.orientations import racked_orientations
from ...table.table import Table
from .. import guide, pen, text, theme
from ..balls import ball_art
from ..tabletop import table_picture
from ..view import fit

# In parts of the picture's height: letters, the strip above the table that holds them, and dots.
_LETTERS, _STRIP, _DOT = 0.036, 0.09, 0.0028
# Colours of what was seen, by how the fit has it: near, and farther off than a ball's radius.
_NEAR, _FAR = (240, 244, 240), (255, 96, 72)


def draw(table: Table, stretch: Stretch, fitted: Fitted, title: str, size: tuple[int, int]) -> pygame.Surface:
    """The table, the balls where they began, their ways as the engine has them, and every place where one was seen."""
    pygame.font.init()
    strip, letters = round(_STRIP * size[1]), round(_LETTERS * size[1])
    view = fit(table.knobs.table.length, table.knobs.table.width, (0, strip, size[0], size[1] - strip))
    picture = table_picture.window_copy(table_picture.draw(table, size, view))
    rollout = play(table, stretch, fitted.numbers)
    guide.draw_whole(picture, rollout, table, view)
    orientations = racked_orientations(rollout.start)
    ball_art.draw_all(
        picture, [ball_art.placed_on(table, view, ball, orientations[ball.id]) for ball in rollout.start.values()]
    )
    for ball, track in stretch.tracks.items():
        if ball not in stretch.seen.moved:
            continue
        radius = table.body_of(rollout.start[ball])[0]
        for t, x, y in zip(track.t.tolist(), track.x.tolist(), track.y.tolist(), strict=True):
            there = rollout.ball_at(ball, min(max(0.0, t - fitted.numbers[MOMENT]), rollout.duration))
            far = (there.x - x) ** 2 + (there.y - y) ** 2 > radius**2
            pen.disc(picture, _FAR if far else _NEAR, view.to_screen(x, y), max(1.0, _DOT * size[1]))
    corner = (view.to_screen(0.0, 0.0)[0], 0.5 * strip)
    text.draw(picture, text.fitted(title, letters, size[0]), letters, theme.TEXT, corner, (0.0, 0.5))
    return picture
