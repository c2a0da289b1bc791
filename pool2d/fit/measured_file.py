"""A file of measurements: which table was measured, and what was read off."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..config.fields import check_keys
from ..config.reader import line_of, read_toml
from ..errors import InputError
from .measurements import MEASUREMENTS, QUANTITIES
from .readings import Reading, read


@dataclass(frozen=True, slots=True)
class Measured:
    """What a file holds: `table` is the preset that it names, if it does, `readings` go by the quantities' names."""

    table: str | None
    readings: dict[str, Reading]


def read_measured(path: Path) -> Measured:
    """Read what was measured from a .toml file; raises InputError naming the file, the key and what is allowed."""
    source = str(path)
    if path.suffix != ".toml":
        raise InputError(source, "", None, "the name of a file of measurements ends in .toml")
    data = read_toml(path)
    names = [each.name for each in MEASUREMENTS]
    check_keys(data, ["table", *names], source)
    try:
        readings = {key: value for name in names for key, value in _section(data, name, source).items()}
        return Measured(_table(data, source), readings)
    except InputError as error:
        raise located(error, path) from None


def located(error: InputError, path: Path) -> InputError:
    """A complaint about what a file holds, with the line."""
    return InputError(error.source, error.key, error.value, error.allowed, line_of(path, error.key))


def _table(data: dict[str, Any], source: str) -> str | None:
    name = data.get("table")
    if name is None or (isinstance(name, str) and name):
        return name
    raise InputError(source, "table", name, "allowed is a preset's name or a path to a .toml file")


def _section(data: dict[str, Any], name: str, source: str) -> dict[str, Reading]:
    """The readings of one measurement, by the names of the quantities."""
    section, prefix = data.get(name, {}), name + "."
    if not isinstance(section, dict):
        raise InputError(source, name, section, f"allowed is a section [{name}]")
    check_keys(section, [key.removeprefix(prefix) for key in QUANTITIES if key.startswith(prefix)], source, prefix)
    return {prefix + key: read(given, QUANTITIES[prefix + key], source) for key, given in section.items()}
