"""Where the user's own files are, on each platform; a variable of the environment may say otherwise."""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path

from .reader import read_bytes

_NAME = "pool2d"


def data_folder() -> Path:
    """Where presets and records of the user's own are: $POOL2D_DATA, or the platform's usual place."""
    return _given("POOL2D_DATA") or _usual("XDG_DATA_HOME", ".local/share")


def config_folder() -> Path:
    """Where the settings are: $POOL2D_CONFIG, or the platform's usual place."""
    return _given("POOL2D_CONFIG") or _usual("XDG_CONFIG_HOME", ".config")


def pictures_folder() -> Path:
    """Where pictures of the window go: $POOL2D_PICTURES, the user's pictures, or where there are none the data."""
    if given := _given("POOL2D_PICTURES"):
        return given
    pictures = _linux_pictures() if sys.platform.startswith("linux") else _home() / "Pictures"
    return pictures / _NAME if pictures.is_dir() else data_folder() / "pictures"


def _given(variable: str) -> Path | None:
    value = os.environ.get(variable)
    return Path(value) if value else None


def _home() -> Path:
    return Path(os.path.expanduser("~"))


def _usual(variable: str, below: str) -> Path:
    """The platform's place; `variable` and `below` the home are what it is on Linux."""
    if sys.platform == "win32":
        return Path(os.environ.get("APPDATA") or _home() / "AppData" / "Roaming") / _NAME
    if sys.platform == "darwin":
        return _home() / "Library" / "Application Support" / _NAME
    return Path(os.environ.get(variable) or _home() / below) / _NAME


def _linux_pictures() -> Path:
    """The pictures' folder by its name in the user's language (xdg-user-dirs keeps it in a file)."""
    settings = Path(os.environ.get("XDG_CONFIG_HOME") or _home() / ".config") / "user-dirs.dirs"
    try:
        said = re.search(r'^XDG_PICTURES_DIR="(.+)"', read_bytes(settings).decode("utf-8"), re.MULTILINE)
    except ValueError:
        said = None
    return Path(said[1].replace("$HOME", str(_home()))) if said else _home() / "Pictures"
