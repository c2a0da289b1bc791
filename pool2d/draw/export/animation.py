"""A shot as pictures, one for each moment: as numbered files, or as one that moves."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from functools import partial
from pathlib import Path

import numpy as np
import pygame

from ...config.files import write_bytes
from ...errors import InputError
from ...game.orientations import racked_orientations
from ...physics.orientation import BallRotation
from ...physics.rollout import Rollout
from ...table.table import Table
from ..balls import ball_art, tray
from ..tabletop import table_picture
from ..view import fit
from . import gif, picture_file

# How long the last picture is held, in hundredths of a second.
_HOLD = 100


def frames(table: Table, rollout: Rollout, size: tuple[int, int], times: Iterable[float]) -> Iterator[pygame.Surface]:
    """The table at moments of a shot, s."""
    view = fit(table.knobs.table.length, table.knobs.table.width, (0, 0, *size))
    background = table_picture.window_copy(table_picture.draw(table, size, view))
    turning = BallRotation(rollout, racked_orientations(rollout.start))
    placed = partial(ball_art.placed_on, table, view)

    for t in times:
        picture, layout = background.copy(), rollout.at(t)
        balls = [placed(ball, turning.at(ball.id, t)) for ball in ball_art.from_below(layout.on_table())]
        ball_art.draw_all(picture, [*tray.going(rollout, turning, table, t, placed), *balls])
        yield picture


def to_png(table: Table, rollout: Rollout, folder: Path, name: str, size: tuple[int, int], rate: int) -> int:
    """Write the pictures as name-0001.png and so on; returns how many. Raises InputError."""
    pygame.font.init()
    times = _times(rollout, rate)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for number, picture in enumerate(frames(table, rollout, size, times), 1):
            picture_file.save(picture, folder / f"{name}-{number:04d}.png")
    except OSError as error:
        raise InputError(str(folder), "", None, f"cannot be written: {error.strerror}") from error
    return len(times)


def to_gif(table: Table, rollout: Rollout, out: Path, size: tuple[int, int], rate: int) -> None:
    """Write the pictures as a GIF that goes round, holding its last picture; raises InputError."""
    picture_file.check_path(out, moving=True)
    pygame.font.init()
    palette = gif.median_cut([_pixels(picture) for picture in frames(table, rollout, size, (0.0, rollout.duration))])
    shown = map(_pixels, frames(table, rollout, size, _times(rollout, rate)))
    write_bytes(out, gif.encode(shown, palette, 100 // rate, _HOLD))


def _times(rollout: Rollout, rate: int) -> list[float]:
    """The moments of the pictures, the shot's end included."""
    return [number / rate for number in range(math.ceil(rollout.duration * rate) + 1)]


def _pixels(picture: pygame.Surface) -> gif.Pixels:
    return np.ascontiguousarray(pygame.surfarray.array3d(picture).swapaxes(0, 1))
