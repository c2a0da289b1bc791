"""A scenario as a picture: the table, the balls, and the ways of the shot."""

from __future__ import annotations

from pathlib import Path

import pygame

from ...game.orientations import racked_orientations
from ...table.scenario import Scenario
from .. import guide
from ..balls import ball_art
from ..tabletop import table_picture
from ..view import fit
from . import picture_file


def render(scenario: Scenario, out: Path, size: tuple[int, int]) -> None:
    """Write the picture; a ball is shown where it starts, and faintly where it ends.

    Raises InputError where the file cannot be written.
    """
    picture_file.check_path(out)
    pygame.font.init()
    table = scenario.table
    view = fit(table.knobs.table.length, table.knobs.table.width, (0, 0, *size))
    picture = table_picture.window_copy(table_picture.draw(table, size, view))
    guide.draw_whole(picture, scenario.simulate(), table, view)
    orientations = racked_orientations(scenario.layout)
    balls = scenario.layout.on_table()
    ball_art.draw_all(picture, [ball_art.placed_on(table, view, ball, orientations[ball.id]) for ball in balls])
    picture_file.save(picture, out)
