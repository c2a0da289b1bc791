"""The pictures of the documentation: every scene can be drawn, and the page shows each."""

from __future__ import annotations

import pygame
import pytest

from docs import pictures
from docs.picture_scenes import SCENES, PictureScene

SIZE = (640, 360)


@pytest.fixture(scope="module")
def untouched() -> bytes:
    """The window before a hand does anything."""
    return pygame.image.tobytes(pictures.draw(PictureScene("", lambda hand: None), SIZE), "RGB")


@pytest.mark.parametrize("name", [name for name in SCENES if not name.startswith("table-")])
def test_a_hand_comes_to_the_scene(name: str, untouched: bytes) -> None:
    picture = pictures.draw(SCENES[name], SIZE)
    assert picture.get_size() == SIZE
    assert pygame.image.tobytes(picture, "RGB") != untouched


def test_the_page_shows_every_scene_and_each_has_its_picture() -> None:
    page = (pictures.HERE / "pictures.md").read_text(encoding="utf-8")
    assert page == pictures.page(SCENES), "python -m docs.pictures draws and writes them anew"
    sheets = {f"{width}x{height}" for width, height in pictures.OTHERS}
    assert {path.stem for path in pictures.FOLDER.glob("*.jpg")} == {*SCENES, *sheets}
