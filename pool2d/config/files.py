"""Writing files so that a kill at any moment leaves the old file or the new one; `reader` reads them."""

from __future__ import annotations

import contextlib
import itertools
import json
import os
import re
import stat
from collections.abc import Mapping
from datetime import date, time
from pathlib import Path
from typing import Any

from ..errors import InputError

# What tells the drafts of one process apart.
_numbers = itertools.count()


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
    check_target(path)
    try:
        # A link to a file is kept, and the file it leads to is written.
        path = Path(os.path.realpath(path))
        path.parent.mkdir(parents=True, exist_ok=True)
        # The ending keeps a half-written file from being taken for a preset.
        draft = path.parent / f".{path.name[:40]}{os.getpid()}-{next(_numbers)}.part"
        try:
            with open(draft, "xb") as file:
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


def check_target(path: Path) -> None:
    """Raises InputError where there is something of that name that is no file and must not be replaced by one."""
    try:
        mode = os.stat(path).st_mode
    except (OSError, ValueError):
        return
    if not stat.S_ISREG(mode):
        what = "a folder" if stat.S_ISDIR(mode) else "not a regular file"
        raise InputError(str(path), "", None, f"cannot be written: it is {what}")


def _put(draft: Path, path: Path, new: bool) -> None:
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
