"""Reading TOML files, and writing them so that a kill at any moment leaves the old file or the new one."""

from __future__ import annotations

import contextlib
import json
import os
import re
import stat
import tomllib
from collections.abc import Mapping
from datetime import date, time
from pathlib import Path
from typing import Any

from .errors import InputError

# Far more than any preset or scenario takes; reading stops there.
_LARGEST = 1 << 20
# A dotted key with so many parts is no preset's, and tomllib takes time that grows with their square.
_LONG_KEY = re.compile(rb"""(?<![\w"'.-])(?:[\w"'-]++\s*+\.\s*+){200}""")


def read_bytes(path: Path, most: int = _LARGEST) -> bytes:
    """A regular file's content; raises InputError where it cannot be read or has more than `most` bytes."""
    try:
        # Opening a pipe would wait for its other end.
        if not stat.S_ISREG(os.stat(path).st_mode) and not path.is_dir():
            raise InputError(str(path), "", None, "cannot be read: not a regular file")
        with path.open("rb") as file:
            content = file.read(most + 1)
    except OSError as error:
        raise InputError(str(path), "", None, f"cannot be read: {error.strerror}") from error
    except InputError:
        raise
    except ValueError as error:
        raise InputError(str(path), "", None, f"cannot be read: {error}") from error
    if len(content) > most:
        raise InputError(str(path), "", None, f"too large; allowed are {most >> 20} MiB")
    return content


def read_toml(path: Path) -> dict[str, Any]:
    """A TOML file's content; raises InputError where it cannot be read or is not TOML."""
    content = read_bytes(path)
    if _LONG_KEY.search(content):
        raise InputError(str(path), "", None, "not a TOML file: a key has too many parts")
    try:
        return tomllib.loads(content.decode("utf-8"))
    except (ValueError, RecursionError) as error:
        raise InputError(str(path), "", None, f"not a TOML file: {error}") from error


def line_of(path: Path, key: str) -> int:
    """The line of a TOML file that sets a dotted key, counted from 1; 0 where none plainly does."""
    section, _, name = re.split(r"[\[,]", key)[0].rpartition(".")
    here = ""
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError):
        return 0
    for number, line in enumerate(lines, 1):
        if header := re.match(r"\s*\[+\s*([^\[\]]+?)\s*\]", line):
            here = header[1]
        elif (word := re.match(r"""\s*["']?([\w.-]+)["']?\s*=""", line)) and word[1] == name and here == section:
            return number
    return 0


def write_text(path: Path, text: str, new: bool = False) -> None:
    """Write a text file whole or not at all; `new` refuses to replace one.

    Raises InputError where the file is there, with `new`, or cannot be written.
    """
    try:
        content = text.encode("utf-8")
    except ValueError as error:
        raise InputError(str(path), "", None, f"cannot be written: {error}") from error
    write_bytes(path, content, new)


def write_bytes(path: Path, content: bytes, new: bool = False) -> None:
    """Write a file whole or not at all, as `write_text`."""
    # Slow to read, and of no use before the window is open.
    import tempfile

    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        # The ending keeps a half-written file from being taken for a preset.
        handle, draft = tempfile.mkstemp(".part", "." + path.name[:40], path.parent)
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(content)
                file.flush()
                os.fsync(file.fileno())
            _put(draft, path, new)
        finally:
            with contextlib.suppress(OSError):
                os.unlink(draft)
    except OSError as error:
        raise InputError(str(path), "", None, f"cannot be written: {error.strerror}") from error
    except InputError:
        raise
    except ValueError as error:
        raise InputError(str(path), "", None, f"cannot be written: {error}") from error


def _put(draft: str, path: Path, new: bool) -> None:
    """Give a finished draft its name."""
    if new:
        try:
            os.link(draft, path)
            return
        except OSError as error:
            # Not every disk has links; where it has none, look first.
            if isinstance(error, FileExistsError) or path.exists():
                raise InputError(str(path), "", None, "is there already; nothing was written") from error
    os.replace(draft, path)


def to_toml(data: Mapping[str, Any]) -> str:
    """A TOML file's text: plain keys first, then each section."""
    lines = [f"{_key(key)} = {_value(value)}" for key, value in data.items() if not isinstance(value, dict)]
    for key, value in data.items():
        if isinstance(value, dict):
            lines += ["", f"[{_key(key)}]", *(f"{_key(name)} = {_value(inner)}" for name, inner in value.items())]
    return "\n".join(lines) + "\n"


def _key(key: str) -> str:
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else to_text(key)


def _value(value: Any) -> str:
    if isinstance(value, dict):
        inner = ", ".join(f"{_key(key)} = {_value(one)}" for key, one in value.items())
        return f"{{ {inner} }}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_value, value)) + "]"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return to_text(value)
    if isinstance(value, (date, time)):
        return value.isoformat()
    assert isinstance(value, (int, float))
    # TOML writes inf and nan as Python does.
    return repr(value)


def to_text(text: str) -> str:
    """A text in quotes."""
    # What JSON escapes, TOML escapes alike; it also wants DEL escaped.
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
