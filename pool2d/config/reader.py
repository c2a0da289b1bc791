"""All that is read from outside goes through here: regular files of a limited size, TOML or JSON, with sound values.

Whatever a file holds, what comes back is small and plain: no whole number beyond 64 bits, no text that cannot be
shown, nothing nested deep or said twice. Everything else is told, as an InputError of one line.
"""

from __future__ import annotations

import json
import os
import re
import stat
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ..errors import InputError
from ..printable import is_shown

# Bytes; far more than any scenario takes, or any preset. Reading stops there. TOML is read more slowly by far.
_LARGEST = 1 << 20
_LARGEST_TOML = 1 << 18
# Values in one file, and how deep they lie in each other.
_MOST = 100_000
_DEEPEST = 20
# What all readers and writers of numbers agree on.
_WIDEST = 1 << 63
# A dotted key with so many parts is no preset's, and tomllib takes time that grows with their square.
_LONG_KEY = re.compile(rb"""(?<![\w"'.-])(?:[\w"'-]++\s*+\.\s*+){64}""")
_BREAKS = frozenset("\n\r\t")


def read_bytes(path: Path, most: int = _LARGEST) -> bytes:
    """A regular file's content; raises InputError where it cannot be read or has more than `most` bytes."""
    try:
        # Opening a pipe would wait for its other end, and some devices act when they are opened.
        if not stat.S_ISREG(os.stat(path).st_mode) and not path.is_dir():
            raise InputError(str(path), "", None, "cannot be read: not a regular file")
        with open(path, "rb", opener=_without_waiting) as file:
            content = file.read(most + 1)
    except OSError as error:
        raise InputError(str(path), "", None, f"cannot be read: {error.strerror}") from error
    except InputError:
        raise
    except ValueError as error:
        raise InputError(str(path), "", None, f"cannot be read: {error}") from error
    if len(content) > most:
        size = f"{most >> 20} MiB" if most >= 1 << 20 else f"{most >> 10} KiB"
        raise InputError(str(path), "", None, f"too large; allowed are {size}")
    return content


def read_toml(path: Path, sound: bool = True) -> dict[str, Any]:
    """A TOML file's content; raises InputError where it cannot be read or is not TOML, or its values are not sound.

    Without `sound` the values are left to the caller, who has `check_sound` for them.
    """
    # Much is asked of this module that needs no TOML, and starts sooner without.
    import tomllib

    content = read_bytes(path, _LARGEST_TOML)
    if _LONG_KEY.search(content):
        raise InputError(str(path), "", None, "not a TOML file: a key has too many parts")
    try:
        data = tomllib.loads(_decoded(content))
    except (ValueError, RecursionError) as error:
        raise InputError(str(path), "", None, f"not a TOML file: {error}") from error
    if sound:
        check_sound(data, str(path))
    return data


def read_json(path: Path, most: int = _LARGEST) -> Any:
    """A JSON file's content; raises InputError as `read_toml`, and where a key is there twice."""
    return parse_json(read_bytes(path, most), str(path))


def parse_json(content: bytes, source: str, line: int = 0, values: int = _MOST) -> Any:
    """What JSON holds; raises InputError where it is none, its values are not sound, or it has more than so many."""
    try:
        data = json.loads(_decoded(content), object_pairs_hook=_once)
    except (ValueError, RecursionError) as error:
        raise InputError(source, "", None, f"not a JSON file: {error}", line) from error
    check_sound(data, source, line=line, most=values)
    return data


def check_sound(data: Any, source: str, key: str = "", line: int = 0, most: int = _MOST) -> None:
    """Raises InputError for a value that no file of pool2d may hold, naming its key."""
    for number, (name, value, depth) in enumerate(_walk(data, key, 0)):
        allowed = _unsound(value)
        if number > most:
            name, value, allowed = "", None, f"too many values; allowed are {most}"
        elif depth > _DEEPEST:
            name, value, allowed = "", None, f"nested too deep; allowed are {_DEEPEST} levels"
        if allowed:
            raise InputError(source, name, value, allowed, line)


def line_of(path: Path, key: str) -> int:
    """The line of a TOML file that sets a dotted key, counted from 1; 0 where none plainly does."""
    section, _, name = re.split(r"[\[,]", key)[0].rpartition(".")
    here = ""
    try:
        lines = _decoded(read_bytes(path)).splitlines()
    except ValueError:
        return 0
    for number, line in enumerate(lines, 1):
        if header := re.match(r"\s*\[+\s*([^\[\]]+?)\s*\]", line):
            here = header[1]
        elif (word := re.match(r"""\s*["']?([\w.-]+)["']?\s*=""", line)) and word[1] == name and here == section:
            return number
    return 0


def _without_waiting(path: str, flags: int) -> int:
    """Open a file that may have become a pipe since it was looked at."""
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))


def _decoded(content: bytes) -> str:
    """UTF-8, perhaps with the mark that some editors put in front."""
    return content.decode("utf-8-sig")


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """A JSON object none of whose keys is there twice."""
    data: dict[str, Any] = {}
    for key, value in pairs:
        if key in data:
            raise ValueError(f"the key {key[:40]!r} is there twice")
        data[key] = value
    return data


def _walk(value: Any, key: str, depth: int) -> Iterator[tuple[str, Any, int]]:
    """Every key and every value below `value`, with the dotted name it goes by and how deep it lies."""
    yield key, value, depth
    if depth > _DEEPEST:
        return
    if isinstance(value, dict):
        for name, inner in value.items():
            yield (full := f"{key}.{name}" if key else name), name, depth
            yield from _walk(inner, full, depth + 1)
    elif isinstance(value, list):
        for number, inner in enumerate(value):
            yield from _walk(inner, f"{key}[{number}]", depth + 1)


def _unsound(value: Any) -> str:
    """What is allowed instead of a value; empty where it is sound."""
    if isinstance(value, str) and not value.isprintable():
        if not all(is_shown(char) or char in _BREAKS for char in value):
            return "allowed is a text of printable characters"
    elif isinstance(value, int) and not -_WIDEST <= value < _WIDEST:
        return "allowed is a whole number of up to 64 bits"
    return ""
