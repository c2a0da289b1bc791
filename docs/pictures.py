"""The pictures of `docs/pictures.md` and of the README, drawn by the game: `python -m docs.pictures`.

Every scene of `docs.picture_scenes` is drawn in the real window, without a screen, at three sizes: one picture each at
1280x720, and a sheet of all for each of the other sizes. `--out FOLDER` writes every picture at every size there
instead, to be looked at; names draw only these scenes. Needs the optional extra: `pip install -e '.[dev]'`.
"""

from __future__ import annotations

import argparse
import math
import time
from pathlib import Path

import numpy as np
import pygame

from pool2d import Shot, load_table, simulate
from pool2d.config.settings import Store
from pool2d.draw import theme
from pool2d.draw.export import animation, gif
from pool2d.ui.app import App
from tests.ui.conftest import Hand

from .picture_scenes import SCENES, PictureScene

HERE = Path(__file__).parent
FOLDER = HERE / "pictures"
SIZE = (1280, 720)
OTHERS = ((960, 540), (1920, 1080))
# The sheets: how many pictures side by side, and how wide each is, in pixels.
ACROSS, WIDTH = 4, 480
# The picture of the table is drawn beside the frames: how long it is waited for at most, s.
_PATIENCE = 30.0
# The moving picture: its size, pictures a second, and how long a break is followed, s.
BREAK_SIZE, RATE, LENGTH = (480, 270), 20, 5.0


def draw(scene: PictureScene, size: tuple[int, int]) -> pygame.Surface:
    """The window at a scene."""
    store = Store()
    store.turn("screen.language", "en")
    # What scenes aim is struck as they have it: they were composed for a cue that lies level.
    store.turn("aiming.easy_stroke", True)
    app = App(load_table(scene.table), 3, size, store)
    pygame.event.clear()
    scene.go(Hand(app))
    settle(app)
    picture = app.window.surface.copy()
    app.close()
    return picture


def settle(app: App) -> None:
    """Draw frames, no time going by in them, until the picture of the table is drawn in full."""
    shown: object = app.scene
    while not hasattr(shown, "stage"):
        shown = shown.below  # type: ignore[attr-defined]
    until = time.monotonic() + _PATIENCE
    app.step(0.0)
    while not shown.stage.still:
        app.step(0.0)
        time.sleep(0.005)
        if time.monotonic() > until:
            raise RuntimeError("the picture of the table is not drawn")


def sheet(pictures: list[pygame.Surface]) -> pygame.Surface:
    """Pictures of one size, made smaller, in rows."""
    height = WIDTH * pictures[0].get_height() // pictures[0].get_width()
    whole = pygame.Surface((ACROSS * WIDTH, math.ceil(len(pictures) / ACROSS) * height))
    whole.fill(theme.BACKGROUND)
    for i, picture in enumerate(pictures):
        whole.blit(pygame.transform.smoothscale(picture, (WIDTH, height)), (i % ACROSS * WIDTH, i // ACROSS * height))
    return whole


def moving_break() -> bytes:
    """A break of the nine-foot table as a GIF."""
    table = load_table("pool-9ft")
    rollout = simulate(table, table.rack("eight-ball", seed=7), Shot(angle=0.2, speed=9.0))
    # The rack is seen for half a second before it is broken.
    times = [max(0.0, number / RATE - 0.5) for number in range(round(LENGTH * RATE))]
    pictures = [
        np.ascontiguousarray(pygame.surfarray.array3d(picture).swapaxes(0, 1))
        for picture in animation.frames(table, rollout, BREAK_SIZE, times)
    ]
    return gif.encode(pictures, gif.median_cut([pictures[0], pictures[-1]]), 100 // RATE, 100)


def page(scenes: dict[str, PictureScene]) -> str:
    """The page that shows them."""
    names = list(scenes)
    rows = []
    for first in range(0, len(names), 2):
        pair = names[first : first + 2]
        rows.append(
            "| " + " | ".join(f"![{name}](pictures/{name}.jpg)<br>{scenes[name].caption}" for name in pair) + " |"
        )
    sheets = " and ".join(f"[{width}x{height}](pictures/{width}x{height}.jpg)" for width, height in OTHERS)
    return "\n".join(
        [
            "# Pictures",
            "",
            "`python -m docs.pictures` draws them all: a hand that posts events brings the real window to each scene",
            "of [picture_scenes.py](picture_scenes.py). "
            f"These are at {SIZE[0]}x{SIZE[1]}; there are sheets of {sheets}.",
            "",
            "|  |  |",
            "|---|---|",
            *rows,
            "",
        ]
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="SCENE", help=f"only these: {', '.join(SCENES)}")
    parser.add_argument("--out", type=Path, help="write all of them here, at every size, as PNG")
    arguments = parser.parse_args()
    if wrong := set(arguments.names) - set(SCENES):
        parser.error(f"no such scene: {', '.join(sorted(wrong))}")
    if arguments.out:
        arguments.out.mkdir(parents=True, exist_ok=True)
        for name in arguments.names or SCENES:
            for size in (SIZE, *OTHERS):
                pygame.image.save(draw(SCENES[name], size), arguments.out / f"{name}-{size[0]}x{size[1]}.png")
        return
    FOLDER.mkdir(exist_ok=True)
    for name in arguments.names or SCENES:
        pygame.image.save(draw(SCENES[name], SIZE), FOLDER / f"{name}.jpg")
    if arguments.names:
        return
    for path in FOLDER.glob("*.jpg"):
        if path.stem not in SCENES:
            path.unlink()
    for size in OTHERS:
        pictures = [draw(scene, size) for scene in SCENES.values()]
        pygame.image.save(sheet(pictures), FOLDER / f"{size[0]}x{size[1]}.jpg")
    (FOLDER / "break.gif").write_bytes(moving_break())
    (HERE / "pictures.md").write_text(page(SCENES), encoding="utf-8")


if __name__ == "__main__":
    main()
