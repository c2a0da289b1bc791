"""Pictures kept on disk, so that what was drawn once need not be drawn again.

A picture's name is a digest of all that it is made of, the code that draws it among that, so none is
ever out of date. Nothing depends on them: a picture that is damaged is drawn anew, and where nothing
can be written every one is.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import sys
import tempfile
import zlib
from collections.abc import Hashable
from functools import lru_cache
from pathlib import Path

# The oldest pictures go when all of them are larger, bytes: room for five of 3840 by 2160.
_ROOM = 128 << 20
_ENDING = ".pixels"
_SUM = 4


def folder() -> Path:
    """Where pictures are kept: $POOL2D_CACHE, or the platform's usual place."""
    if given := os.environ.get("POOL2D_CACHE"):
        return Path(given)
    home = Path(os.path.expanduser("~"))
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or home / "AppData" / "Local") / "pool2d" / "Cache"
    if sys.platform == "darwin":
        return home / "Library" / "Caches" / "pool2d"
    return Path(os.environ.get("XDG_CACHE_HOME") or home / ".cache") / "pool2d"


def name_of(content: Hashable, files: tuple[str, ...]) -> str:
    """The name of a picture made of `content` by the code in `files`; `content` is told apart by its repr."""
    return hashlib.sha256(f"{_code(files)} {content!r}".encode()).hexdigest()[:32]


@lru_cache
def _code(files: tuple[str, ...]) -> str:
    """A digest of source files, or of their names where they cannot be read."""
    digest = hashlib.sha256()
    for file in files:
        digest.update(file.encode())
        with contextlib.suppress(OSError):
            digest.update(Path(file).read_bytes())
    return digest.hexdigest()


def load(name: str, size: int) -> memoryview | None:
    """A picture of `size` bytes; None where it is not there or not whole."""
    path = folder() / (name + _ENDING)
    try:
        content = path.read_bytes()
    except OSError:
        return None
    pixels = memoryview(content)[:-_SUM]
    if len(pixels) != size or zlib.crc32(pixels).to_bytes(_SUM, "big") != content[-_SUM:]:
        return None
    with contextlib.suppress(OSError):
        os.utime(path)
    return pixels


def save(name: str, pixels: bytes | memoryview) -> None:
    """Keep a picture, whole or not at all, and let the longest unused ones go."""
    place = folder()
    with contextlib.suppress(OSError):
        place.mkdir(parents=True, exist_ok=True)
        handle, draft = tempfile.mkstemp(".part", "", place)
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(pixels)
                file.write(zlib.crc32(pixels).to_bytes(_SUM, "big"))
            os.replace(draft, place / (name + _ENDING))
        finally:
            with contextlib.suppress(OSError):
                os.unlink(draft)
        _trim(place)


def _trim(place: Path) -> None:
    """Remove pictures, those not used for longest first, until the rest has room."""
    kept = []
    for path in place.glob("*" + _ENDING):
        with contextlib.suppress(OSError):
            status = path.stat()
            kept.append((status.st_mtime_ns, status.st_size, path))
    total = sum(size for _, size, _ in kept)
    for _, size, path in sorted(kept)[:-1]:
        if total <= _ROOM:
            return
        with contextlib.suppress(OSError):
            path.unlink()
        total -= size
