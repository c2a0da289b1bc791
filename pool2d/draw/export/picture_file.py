"""Writing pictures: whole, or not at all and told."""

from __future__ import annotations

import io
from pathlib import Path

import pygame

from ...config.files import check_target, write_bytes
from ...errors import InputError

_ENDINGS = (".png", ".jpg", ".bmp", ".tga")


def check_path(path: Path, moving: bool = False) -> None:
    """Raises InputError where no picture can be written under that name: to be asked before it is drawn."""
    if path.suffix.lower() not in ((".gif",) if moving else _ENDINGS):
        still = "a picture's name ends in .png, .jpg, .bmp or .tga"
        raise InputError(str(path), "", None, "a moving picture's name ends in .gif" if moving else still)
    if not path.parent.is_dir():
        raise InputError(str(path), "", None, "cannot be written: there is no such folder")
    check_target(path)


def save(picture: pygame.Surface, path: Path) -> None:
    """Write a picture in the format that its ending names; raises InputError where it cannot be written whole.

    pygame encodes it in memory alone: of a file that takes only a part it says nothing.
    """
    content = io.BytesIO()
    try:
        pygame.image.save(picture, content, "x" + path.suffix)
    except pygame.error as error:
        raise InputError(str(path), "", None, f"cannot be written: {error}") from error
    write_bytes(path, content.getvalue())
