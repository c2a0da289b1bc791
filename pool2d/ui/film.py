"""A shot as pictures, one for each moment: as numbered files, or as one that moves."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pygame

from ..errors import InputError
from ..files import write_bytes
from ..physics.rollout import Rollout
from ..table import Table
from . import ball_art, gif, table_art
from .view import fit

# How long the last picture is held, s.
_HOLD = 1.0


def frames(table: Table, rollout: Rollout, size: tuple[int, int], rate: int) -> Iterator[pygame.Surface]:
    """The table every 1 / rate s from the shot's start to its end, which is included."""
    view = fit(table.knobs.table.length, table.knobs.table.width, (0, 0, *size))
    background = table_art.draw(table, size, view)
    for number in range(math.ceil(rollout.duration * rate) + 1):
        picture = background.copy()
        for ball in rollout.at(number / rate).on_table():
            look = table.furniture.looks.get(ball.id)
            place = view.to_screen(ball.x, ball.y)
            ball_art.draw(picture, ball.id, place, table.body_of(ball)[0] * view.scale, look=look)
        yield picture


def to_png(table: Table, rollout: Rollout, folder: Path, name: str, size: tuple[int, int], rate: int) -> int:
    """Write the pictures as name-0001.png and so on; returns how many. Raises InputError."""
    pygame.font.init()
    number = 0
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for number, picture in enumerate(frames(table, rollout, size, rate), 1):
            pygame.image.save(picture, folder / f"{name}-{number:04d}.png")
    except (OSError, pygame.error) as error:
        raise InputError(str(folder), "", None, f"cannot be written: {error}") from error
    return number


def to_gif(table: Table, rollout: Rollout, out: Path, size: tuple[int, int], rate: int) -> None:
    """Write the pictures as a GIF that goes round, holding its last picture; raises InputError."""
    pygame.font.init()
    pictures = (pygame.surfarray.array3d(picture).swapaxes(0, 1) for picture in frames(table, rollout, size, rate))
    write_bytes(out, gif.encode((np.ascontiguousarray(picture) for picture in pictures), 100 // rate, _HOLD))
