"""Pictures as they were found good: every scene of `golden`, and the comparison itself."""

from __future__ import annotations

from pathlib import Path

import pygame
import pytest

from . import golden


@pytest.mark.parametrize("scene", golden.SCENES)
def test_a_scene_looks_as_it_was_found_good(scene: str, tmp_path: Path) -> None:
    assert golden.check(scene, tmp_path) == ""


def test_every_golden_picture_belongs_to_a_scene() -> None:
    assert {path.stem for path in golden.FOLDER.glob("*.png")} == set(golden.SCENES)


@pytest.mark.parametrize("spoil", ["a pocket", "a shade", "a mark"])
def test_a_difference_is_found_and_shown(spoil: str, tmp_path: Path) -> None:
    picture = golden.empty("carom-10ft")
    if spoil == "a pocket":
        pygame.draw.circle(picture, (0, 0, 0), (320, 40), 10)
    elif spoil == "a mark":
        pygame.draw.rect(picture, (255, 255, 255), (320, 180, 8, 4))
    else:
        picture.fill((3, 3, 3), special_flags=pygame.BLEND_RGB_ADD)
    pygame.image.save(picture, tmp_path / "carom-10ft.png")
    out = tmp_path / "out"
    out.mkdir()
    told = golden.check("carom-10ft", out, tmp_path)
    assert str(out / "carom-10ft.png") in told
    width, height = golden.SIZE
    assert pygame.image.load(out / "carom-10ft.png").get_size() == (3 * width, height)
