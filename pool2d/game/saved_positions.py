"""Positions that the player keeps: scenario files of one line, by name."""

from __future__ import annotations

from pathlib import Path

from ..config import catalogue
from ..config.files import to_toml, write_text
from ..errors import InputError
from ..physics.values import Layout, Shot
from ..table.position_text import write
from ..table.scenario import Scenario, load_scenario
from ..table.table import Table


def positions() -> list[str]:
    """The names of the positions kept."""
    return catalogue.own(catalogue.POSITIONS)


def save(name: str, table: Table, layout: Layout, shot: Shot | None = None) -> Path:
    """Keep a position, and perhaps a shot, replacing the one of that name; returns its file. Raises InputError."""
    path = catalogue.own_path(catalogue.POSITIONS, name)
    write_text(path, to_toml({"position": write(layout, shot, table)}))
    return path


def load(name: str) -> Scenario:
    """The position of a name, or of a scenario file; raises InputError."""
    return load_scenario(catalogue.find(catalogue.POSITIONS, name))


def remove(name: str) -> None:
    """Throw a position that is kept away; raises InputError where that cannot be."""
    path = catalogue.own_path(catalogue.POSITIONS, name)
    try:
        path.unlink(missing_ok=True)
    except OSError as error:
        raise InputError(str(path), "", None, f"cannot be removed: {error.strerror}") from error
