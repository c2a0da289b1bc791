"""Where presets and conditions are kept: the shipped ones, and the user's own beside them."""

from __future__ import annotations

import re
from pathlib import Path

from ..errors import InputError, suggest
from .assets import asset, assets
from .folders import data_folder

TABLES, CONDITIONS, DRILLS, POSITIONS, PLAYERS = "tables", "conditions", "drills", "positions", "players"
_WHAT = {TABLES: "table", CONDITIONS: "conditions", DRILLS: "drill", POSITIONS: "position", PLAYERS: "player"}
# Names that Windows keeps for devices, whatever their ending.
_DEVICES = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)


def shipped(folder: str) -> list[str]:
    """The names of what comes with pool2d."""
    return sorted(path.stem for path in assets(folder, ".toml"))


def own(folder: str) -> list[str]:
    """The names of what the user keeps, less those that are shipped."""
    return sorted({path.stem for path in (data_folder() / folder).glob("*.toml")} - set(shipped(folder)))


def find(folder: str, name: str) -> Path:
    """The file behind a name, shipped or the user's, or behind a path to a .toml file.

    Raises InputError, with the nearest name, where there is none of that name.
    """
    if name.endswith(".toml"):
        return Path(name)
    if name in shipped(folder):
        return asset(folder, name + ".toml")
    if name in own(folder):
        return data_folder() / folder / (name + ".toml")
    known = (*shipped(folder), *own(folder))
    raise InputError(_WHAT[folder], _WHAT[folder], name, f"{suggest(name, known)}; or a path to a .toml file")


def own_path(folder: str, name: str) -> Path:
    """Where the user's file of that name is to be.

    Raises InputError for what is not a plain file name, and for a shipped name.
    """
    plain = re.fullmatch(r"[^\W_][\w .+-]{0,63}", name) and not name.endswith((".", " ", ".toml"))
    if not plain or _DEVICES.fullmatch(name):
        allowed = "allowed is a plain file name of up to 64 letters, digits, blanks and _ . + -"
        raise InputError("save", "name", name, allowed)
    if name.casefold() in map(str.casefold, shipped(folder)):
        raise InputError("save", "name", name, "allowed is another name than a shipped preset's")
    return data_folder() / folder / (name + ".toml")
