"""Where a study's cue ball came to rest, drawn on its table: the more often, the brighter."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import pygame

from ...game.orientations import racked_orientations
from ...physics.values import Layout
from ...study.findings import CELL, MARGIN, Rests
from ...table.table import Table
from .. import text, theme
from ..balls import ball_art
from ..tabletop import table_picture
from ..view import fit
from .ramp import colors

# A rest counts for all places within this part of a ball's radius.
_BLOT = 0.3
# How bright the faintest places are, from 0 to 1, and how much of the table's light is left around all of them.
_LEAST = 0.45
_LIGHT = 0.5
# How solid the balls before the shot are, of 255.
_FAINT = 110
# In parts of the picture's height: letters, and the strip above the table that holds them.
_LETTERS, _STRIP = 0.036, 0.09


def draw(rests: Rests, table: Table, layout: Layout, size: tuple[int, int]) -> pygame.Surface:
    """The table, the balls as they stand before the shot, faintly, and where the struck one rests."""
    pygame.font.init()
    strip, letters = round(_STRIP * size[1]), round(_LETTERS * size[1])
    view = fit(table.knobs.table.length, table.knobs.table.width, (0, strip, size[0], size[1] - strip))
    picture = table_picture.window_copy(table_picture.draw(table, size, view))
    picture.fill([round(255 * _LIGHT)] * 3, special_flags=pygame.BLEND_RGB_MULT)
    radius = table.body_of(layout[rests.ball])[0]
    rows, columns = rests.counts.shape
    left, top = view.to_screen(-0.5 * CELL - MARGIN, (rows - 0.5) * CELL - MARGIN)
    area = (round(columns * CELL * view.scale), round(rows * CELL * view.scale))
    cloud = pygame.transform.smoothscale(_cloud(_blurred(rests.counts, _BLOT * radius / CELL)), area)
    picture.blit(cloud, (round(left), round(top)))
    lies = racked_orientations(layout)
    ball_art.draw_all(
        picture,
        [
            ball_art.Placed(
                ball_art.look_of(table, ball.id), view.to_screen(ball.x, ball.y), table.body_of(ball)[0] * view.scale,
                lies[ball.id], alpha=_FAINT,
            )
            for ball in layout.on_table()
        ],
    )  # fmt: skip
    name = "the cue ball" if rests.ball == table.furniture.cue else f"ball {rests.ball}"
    said = f"where {name} comes to rest, in {int(rests.counts.sum())} shots"
    corner = (view.to_screen(0.0, 0.0)[0], 0.5 * strip)
    text.draw(picture, text.fitted(said, letters, size[0]), letters, theme.TEXT, corner, (0.0, 0.5))
    return picture


def _blurred(counts: npt.NDArray[np.float64], radius: float) -> npt.NDArray[np.float64]:
    """How many rests there are within `radius` cells of each."""
    reach = math.ceil(radius)
    padded = np.pad(counts, reach)
    rows, columns = counts.shape
    total = np.zeros_like(counts)
    for down in range(-reach, reach + 1):
        for along in range(-reach, reach + 1):
            if down * down + along * along <= radius * radius:
                total += padded[reach + down : reach + down + rows, reach + along : reach + along + columns]
    return total


def _cloud(near: npt.NDArray[np.float64]) -> pygame.Surface:
    """A picture of how many are near each place, by its root: lonely rests are seen beside crowded ones."""
    most = near.max(initial=0.0)
    share = np.sqrt((np.maximum(near, 1.0) - 1.0) / max(most - 1.0, 1.0))
    cloud = pygame.Surface(near.shape[::-1], pygame.SRCALPHA)
    pygame.surfarray.pixels3d(cloud)[...] = colors(_LEAST + (1.0 - _LEAST) * share)[::-1].transpose(1, 0, 2)
    pygame.surfarray.pixels_alpha(cloud)[...] = np.where(near > 0.0, 255, 0).astype(np.uint8)[::-1].T
    return cloud
