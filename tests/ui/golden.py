"""Pictures that were looked at and found good, to compare with: `python -m tests.ui.golden` draws them anew.

Names draw only these. Look at what it changed before committing it. A scene is one entry of SCENES; with
`check` a test compares a scene's picture with the one in golden/, and a failure leaves both and their
difference side by side.
"""

from __future__ import annotations

import math
import os
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from unittest import mock

os.environ.setdefault("SDL_VIDEODRIVER", "dummy")

import numpy as np
import numpy.typing as npt
import pygame

from docs import picture_scenes, pictures
from pool2d import Ball, load_table
from pool2d.config.catalogue import TABLES, shipped
from pool2d.draw import theme
from pool2d.draw.balls import ball_art
from pool2d.draw.export import heat_map, rests_picture
from pool2d.draw.tabletop import table_picture
from pool2d.draw.view import View, fit
from pool2d.game.orientations import racked_orientations
from pool2d.ui.dialogs import help

from ..draw import findings
from . import pages_sheet, parts_sheet
from .widgets import widget_sheet

SIZE = (640, 360)
FOLDER = Path(__file__).parent / "golden"
# Levels of 255: what the mean pixel may differ by, and all but one pixel in two thousand. pygame 2.6 draws the edges
# of the smallest shapes otherwise than pygame-ce, by up to 35.
MEAN, MOST, FEW = 1.0, 40.0, 0.0005
# So that a mark or a line of small print counts, too: how large a part of the picture is looked at by itself, in
# pixels, and how many of its pixels may differ by more.
PART, ODD = 32, 16
# How many balls of a set stand side by side.
_ACROSS = 8
# The scenes of the documentation of which the whole window is compared.
WINDOWS = (
    "play", "pulling", "whole-guide", "arrows", "time-line", "tuning", "in-hand", "geometry", "options", "keys", "help",
    "german", "menu", "new-match", "lag", "choice", "call", "snooker", "pause", "frame-over", "drills", "drill",
    "replay", "replay-shots", "why",
)  # fmt: skip


def empty(name: str) -> pygame.Surface:
    """A table without balls, as large as the picture."""
    table = load_table(name)
    size = table.knobs.table
    return table_picture.draw(table, SIZE, fit(size.length, size.width, (0, 0, *SIZE)))


def balls(name: str, style: theme.Style = theme.PLAIN) -> pygame.Surface:
    """A table's set of balls, large, side by side on its cloth, each as it lies when racked."""
    table = load_table(name)
    layout = table.rack(next(iter(table.furniture.racks)), seed=1)
    room = SIZE[0] / _ACROSS
    picture = pygame.Surface((SIZE[0], round(room * math.ceil(len(layout) / _ACROSS))))
    picture.fill(theme.rgb(table.furniture.finish.cloth))
    lies = racked_orientations(layout)
    looks = [ball_art.look_of(table, ball) for ball in layout]
    placed = [
        ball_art.Placed(look, (room * (i % _ACROSS + 0.5), room * (i // _ACROSS + 0.5)), 0.36 * room, lies[ball])
        for i, (ball, look) in enumerate(zip(layout, looks, strict=True))
    ]
    ball_art.draw_all(picture, placed, style)
    return picture


def flying() -> pygame.Surface:
    """Balls at growing heights over the cloth, one over another, on a rail's top, over that, and in a pocket."""
    table = load_table("pool-9ft")
    view = View(scale=450.0, left=-60.0, bottom=330.0)
    picture = table_picture.draw(table, SIZE, view)
    heights = (0.0, 0.002, 0.005, 0.01, 0.02, 0.04, 0.08, 0.15, 0.3)
    top = table.bed.ground.high
    balls = [Ball(str(i + 1), 0.21 + 0.145 * i, 0.6, z=z) for i, z in enumerate(heights)]
    balls += [Ball("cue", 0.53, 0.27, z=0.06), Ball("7", 0.5, 0.25), Ball("3", 0.4, -0.05, z=top)]
    balls += [Ball("4", 0.7, -0.05, z=top + 0.05), Ball("5", 1.27, -0.05, z=-0.015)]
    placed = [ball_art.placed_on(table, view, ball, (1.0, 0.2, 0.1, 0.0)) for ball in ball_art.from_below(balls)]
    ball_art.draw_all(picture, placed)
    return picture


def rests() -> pygame.Surface:
    """Where a cue ball may have come to rest, on a table with its rack."""
    table = load_table("pool-7ft")
    size = table.knobs.table
    return rests_picture.draw(findings.rests_in_a_ring(size.length, size.width), table, table.rack("eight-ball"), SIZE)


def window(name: str) -> pygame.Surface:
    """The whole window at one of the scenes of the documentation."""
    with mock.patch.object(help, "engine", lambda: "interpreted"):
        return pictures.draw(picture_scenes.SCENES[name], SIZE)


SCENES: dict[str, Callable[[], pygame.Surface]] = {
    **{name: partial(empty, name) for name in shipped(TABLES)},
    **{f"balls-{name}": partial(balls, name) for name in shipped(TABLES)},
    **{f"balls-{name}".replace(" ", "-"): partial(balls, "pool-9ft", theme.Style(palette, patterned=True))
       for name, palette in theme.PALETTES.items()},
    "balls-in-the-air": flying,
    "study-map": lambda: heat_map.draw(findings.map_of_a_ridge(), SIZE),
    "study-rests": rests,
    **{f"window-{name}": partial(window, name) for name in WINDOWS},
    **{f"widgets-{unit}": partial(widget_sheet.sheet, unit) for unit in (7, 12)},
    "widgets-scrolled": widget_sheet.scrolled,
    "scoreboards": parts_sheet.scoreboards,
    "notes": parts_sheet.notes,
    "controls": parts_sheet.controls,
    "time-lines": parts_sheet.time_lines,
    "pages": pages_sheet.pages,
}  # fmt: skip


def check(scene: str, out: Path, folder: Path = FOLDER) -> str:
    """What is wrong with a scene's picture, or nothing; then `out` has expected, actual and difference in it."""
    actual = _pixels(SCENES[scene]())
    expected = _pixels(pygame.image.load(folder / f"{scene}.png"))
    if actual.shape != expected.shape:
        return f"{scene} is {actual.shape[:2]} pixels large, not {expected.shape[:2]}"
    off = np.abs(actual - expected)
    mean, far, odd = float(off.mean()), float(np.quantile(off.max(axis=2), 1.0 - FEW)), _odd(off)
    if mean <= MEAN and far <= MOST and odd <= ODD:
        return ""
    path = out / f"{scene}.png"
    # Four times as strong, for the eye.
    _save(np.concatenate([expected, actual, np.minimum(4.0 * off, 255.0)]), path)
    return (
        f"{scene} differs by {mean:.2f} levels in the mean (allowed {MEAN:g}), by {far:.0f} at its worst "
        f"(allowed {MOST:g}), and in one place by more in {odd} pixels (allowed {ODD}); expected, actual and "
        f"difference, left to right: {path}"
    )


def _odd(off: npt.NDArray[np.float64]) -> int:
    """How many pixels differ much in the part of a picture where most do."""
    far = np.pad(off.max(axis=2) > MOST, [(0, -length % PART) for length in off.shape[:2]])
    parts = far.reshape(far.shape[0] // PART, PART, far.shape[1] // PART, PART)
    return int(parts.sum(axis=(1, 3)).max())


def draw_all(*names: str) -> None:
    """Draw scenes anew, without names every one, and remove pictures of scenes that are no more."""
    FOLDER.mkdir(exist_ok=True)
    for path in FOLDER.glob("*.png"):
        if path.stem not in SCENES:
            path.unlink()
    for scene in names or SCENES:
        pygame.image.save(SCENES[scene](), FOLDER / f"{scene}.png")
        print(FOLDER / f"{scene}.png")


def _pixels(picture: pygame.Surface) -> npt.NDArray[np.float64]:
    return np.asarray(pygame.surfarray.array3d(picture), np.float64)


def _save(pixels: npt.NDArray[np.float64], path: Path) -> None:
    pygame.image.save(pygame.surfarray.make_surface(pixels.astype(np.uint8)), path)


if __name__ == "__main__":
    draw_all(*sys.argv[1:])
