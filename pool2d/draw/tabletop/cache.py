"""Pictures kept on disk, so that what was drawn once need not be drawn again.

A picture's name is a digest of all that it is made of, the code that draws it among that, so none is
ever out of date. Nothing depends on them: a picture that is damaged is drawn anew, and where nothing
can be written every one is.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
import sys
import tempfile
import zlib
from collections.abc import Hashable, Iterator
from functools import lru_cache
from pathlib import Path

from ...config.reader import read_bytes
from ...errors import InputError

# The oldest pictures go when all of them are larger, bytes: room for five of 3840 by 2160.
_ROOM = 128 << 20
_ENDING = ".pixels"
_SUM = 4
# `from .module import name, name`, where the names may go on over lines in brackets.
_IMPORT = re.compile(r"^[ \t]*from (\.+)([\w.]*) import (\([^)]*\)|[^\n]*)", re.MULTILINE)


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


def name_of(content: Hashable, file: str) -> str:
    """The name of a picture made of `content` by the code in `file`; `content` is told apart by its repr."""
    return hashlib.sha256(f"{_code(file)} {content!r}".encode()).hexdigest()[:32]


@lru_cache
def _code(file: str) -> str:
    """A digest of a source file and all that it imports of pool2d."""
    digest = hashlib.sha256()
    for path, source in sorted(sources(Path(file)).items()):
        digest.update(path.name.encode() + source)
    return digest.hexdigest()


def sources(file: Path) -> dict[Path, bytes]:
    """A source file and those that it imports by relative names, they theirs and so on: what each holds.

    Who imports the package by its name is not followed; where nothing can be read, there is only the name.
    """
    found: dict[Path, bytes] = {}
    ahead = [file.resolve()]
    while ahead:
        path = ahead.pop()
        if path not in found:
            found[path] = b""
            with contextlib.suppress(OSError):
                found[path] = path.read_bytes()
            ahead += _imported(path.parent, found[path].decode("utf-8", "replace"))
    return found


def _imported(folder: Path, source: str) -> Iterator[Path]:
    """The files of the modules that a source in this folder imports from beside or above it."""
    for dots, module, names in _IMPORT.findall(source):
        base = folder.joinpath(*[".."] * (len(dots) - 1), *module.split(".")).resolve()
        words = re.findall(r"\w+", names)
        for path in (base.with_name(base.name + ".py"), base / "__init__.py", *(base / f"{word}.py" for word in words)):
            if path.is_file():
                yield path


def load(name: str, size: int) -> memoryview | None:
    """A picture of `size` bytes; None where it is not there or not whole."""
    path = folder() / (name + _ENDING)
    try:
        content = read_bytes(path, size + _SUM)
    except InputError:
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
