"""The best results of drills, kept in one file in the player's data folder."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from ...config import catalogue
from ...config.files import write_text
from ...config.folders import data_folder
from ...config.reader import read_json
from ...errors import InputError

_FILE = "best.json"


def best(drill: str) -> int | None:
    """The best result kept of a drill; None where there is none, or what is kept cannot be read."""
    value = _results().get(drill)
    return value if type(value) is int else None


def keep(drill: str, result: int) -> bool:
    """Keep a result if it is better than the best; whether it was. Raises InputError where it cannot be written."""
    before = best(drill)
    if before is not None and before >= result:
        return False
    path, results = _path(), _results()
    if not results and path.exists():
        raise InputError(str(path), "", None, "not a file of results; it is left as it is")
    write_text(path, json.dumps({**results, drill: result}, indent=1, sort_keys=True) + "\n")
    return True


def _path() -> Path:
    return data_folder() / catalogue.DRILLS / _FILE


def _results() -> dict[str, Any]:
    try:
        data = read_json(_path())
    except InputError:
        return {}
    return data if isinstance(data, dict) else {}
