"""Table presets: TOML files that hold a table's knobs and furniture, or what differs from a base.

Sections are merged key by key, the base's below the file's own. What a key holds is replaced whole: a
rack, a group of balls, the spots; so is the outline.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..config import catalogue
from ..config.files import to_toml, write_text
from ..config.knobs import apply, walk
from ..config.reader import line_of, read_toml
from ..errors import InputError, suggest
from .furniture import Furniture
from .furniture_file import SECTIONS, read_furniture
from .table import Table
from .table_knobs import Knobs

_GROUPS = tuple(dict.fromkeys(name.partition(".")[0] for name, _, _ in walk(Knobs()) if "." in name))
_PLAIN = ("name", "base", "gravity", "outline")
# Far more than anybody builds on each other; each is read.
_MOST_BASES = 20
_LONGEST_TITLE = 80
_CONDITIONS = ("cloth", "ball", "cushion", "facing")


@dataclass(frozen=True, slots=True)
class Preset:
    """A preset as read: `origins` says of each knob that was set which file, or conditions, set it."""

    source: str
    title: str
    knobs: Knobs
    furniture: Furniture
    origins: Mapping[str, str]


def load_table(name: str | Path, overrides: Mapping[str, Any] | None = None, conditions: Sequence[str] = ()) -> Table:
    """A table by preset name ("pool-9ft"), or from a .toml file.

    `conditions` are laid over the preset, and `overrides`, dotted knobs, on top. Raises InputError,
    naming the file and the key.

    Examples:
        >>> from pool2d import load_table
        >>> table = load_table("pool-9ft", {"cloth.mu_roll": 0.008})
        >>> table.title, table.knobs.cloth.mu_roll
        ('Pool, 9 ft', 0.008)
        >>> len(table.rack("eight-ball", seed=7))
        16
    """
    try:
        preset = read_preset(str(name), conditions)
        return Table(preset.source, preset.title, preset.knobs, preset.furniture, overrides, conditions)
    except InputError as error:
        raise _located(error, overrides or {}) from None


def _located(error: InputError, overrides: Mapping[str, Any]) -> InputError:
    """The complaint with the line of the file that it is about, where that can be told."""
    if not error.key or error.key in overrides:
        return error
    try:
        line = line_of(preset_path(error.source), error.key)
    except InputError:
        return error
    return InputError(error.source, error.key, error.value, error.allowed, line)


def presets() -> list[str]:
    """The names of all presets, the shipped ones first, then the user's own."""
    return catalogue.shipped(catalogue.TABLES) + catalogue.own(catalogue.TABLES)


def conditions() -> list[str]:
    """The names of all conditions, the shipped ones first, then the user's own."""
    return catalogue.shipped(catalogue.CONDITIONS) + catalogue.own(catalogue.CONDITIONS)


def preset_path(name: str) -> Path:
    """The file behind a preset's name or path; raises InputError for an unknown name."""
    return catalogue.find(catalogue.TABLES, name)


def preset_files(table: Table) -> list[Path]:
    """The files that a table was read from: its preset, the bases, the conditions."""
    bases = [preset_path(source) for source, _ in _chain(table.source)]
    return bases + [catalogue.find(catalogue.CONDITIONS, name) for name in table.conditions]


def title_of(name: str) -> str:
    """The title of a preset; its name where it cannot be read."""
    try:
        return read_preset(name).title
    except InputError:
        return name


def read_preset(name: str, conditions: Sequence[str] = ()) -> Preset:
    """A preset with its bases and conditions; raises InputError, naming the file and the key."""
    chain = _chain(name)
    knobs, merged, origins = Knobs(), dict[str, Any](), dict[str, str]()
    for source, data in reversed(chain):
        values = _dotted({key: data[key] for key in data if key in _GROUPS or key == "gravity"})
        knobs = apply(knobs, values, source)
        for key, value in data.items():
            if isinstance(value, dict):
                merged.setdefault(key, {}).update(value)
                origins.update({f"{key}.{inner}": source for inner in value})
            else:
                merged[key] = value
                origins[key] = source
    try:
        furniture = read_furniture(merged, knobs.table.length, knobs.table.width, name)
    except InputError as error:
        # What is wrong may stand in a base.
        raise error.at(_origin(error.key, origins) or name) from None
    for condition in conditions:
        values = _condition(condition)
        knobs = apply(knobs, values, condition)
        origins.update(dict.fromkeys(values, f"conditions {condition}"))
    title = chain[0][1].get("name", preset_path(name).stem)
    return Preset(name, title, knobs, furniture, origins)


def condition_title(name: str) -> str:
    """The title of conditions; raises InputError."""
    data = read_toml(catalogue.find(catalogue.CONDITIONS, name))
    _check(data, name, ("name", *_CONDITIONS), ("name",))
    return str(data.get("name", name))


def differences(table: Table) -> dict[str, float | str]:
    """The knobs that conditions or hands have turned away from the table's preset; raises InputError."""
    plain = {name: value for name, _, value in walk(read_preset(table.source).knobs)}
    return {name: value for name, _, value in walk(table.knobs) if value != plain[name]}


def save_preset(name: str, base: str, overrides: Mapping[str, float | str], title: str) -> Path:
    """Keep a table as the user's own preset `name`: a base, and dotted knobs that differ from it.

    Returns the file. Raises InputError for a name that is not a plain file name or is a shipped one,
    and for what no table can be built of; nothing is written then.
    """
    path = catalogue.own_path(catalogue.TABLES, name)
    if not title.isprintable() or len(title) > _LONGEST_TITLE:
        allowed = f"allowed is a text of up to {_LONGEST_TITLE} printable characters"
        raise InputError("save", "title", title, allowed)
    load_table(base, overrides)
    chain, below = _chain(base), _same(preset_path(base), path)
    if not below and any(_same(preset_path(source), path) for source, _ in chain):
        raise InputError("save", "name", name, f"allowed is another name; {base} builds on this one")
    if below:
        # Saved over itself: it keeps what it has, and its own base.
        data = {key: dict(value) if isinstance(value, dict) else value for key, value in chain[0][1].items()}
    else:
        data = {"base": Path(base).absolute().as_posix() if base.endswith(".toml") else base}
    data = {"name": title, **{key: value for key, value in data.items() if key != "name"}}
    for dotted, value in overrides.items():
        group, dot, key = dotted.partition(".")
        if dot:
            data.setdefault(group, {})[key] = value
        else:
            data[dotted] = value
    write_text(path, to_toml(data))
    return path


def _chain(name: str) -> list[tuple[str, dict[str, Any]]]:
    """A preset's file and its bases, nearest first, as (name or path, content)."""
    chain: list[tuple[str, dict[str, Any]]] = []
    seen: list[Path] = []
    source, path = name, preset_path(name)
    while True:
        data = read_toml(path)
        _check(data, source, (*_PLAIN, *_GROUPS, *SECTIONS), _PLAIN)
        chain.append((source, data))
        seen.append(path)
        base = data.get("base")
        if base is None:
            return chain
        path = _base_path(base, source, path)
        source = str(path) if base.endswith(".toml") else base
        if len(chain) > _MOST_BASES:
            raise InputError(chain[-1][0], "base", base, f"allowed are up to {_MOST_BASES} bases below each other")
        if any(_same(path, other) for other in seen):
            raise InputError(chain[-1][0], "base", base, "allowed is none that builds on this file itself")


def _base_path(base: Any, source: str, path: Path) -> Path:
    if not isinstance(base, str):
        raise InputError(source, "base", base, "allowed is a preset's name or a path to a .toml file")
    if base.endswith(".toml"):
        return path.parent / base
    try:
        return preset_path(base)
    except InputError as error:
        raise InputError(source, "base", base, error.allowed) from None


def _same(a: Path, b: Path) -> bool:
    """Whether two paths lead to the same file, there or not."""
    try:
        return os.path.realpath(a) == os.path.realpath(b)
    except (OSError, ValueError):
        return False


def _condition(name: Any) -> dict[str, Any]:
    """The knobs of conditions, dotted."""
    if not isinstance(name, str):
        raise InputError("conditions", "conditions", name, "allowed is a name")
    data = read_toml(catalogue.find(catalogue.CONDITIONS, name))
    _check(data, name, ("name", *_CONDITIONS), ("name",))
    return _dotted({key: value for key, value in data.items() if key != "name"})


def _check(data: Mapping[str, Any], source: str, known: Sequence[str], plain: Sequence[str]) -> None:
    """Raises InputError for an unknown key, a section that is none, or a name that is no text."""
    for key, value in data.items():
        if key not in known:
            raise InputError(source, key, value, suggest(key, known))
        if key not in plain and not isinstance(value, dict):
            raise InputError(source, key, value, "allowed is a section of keys and values")
    title = data.get("name", "")
    if not isinstance(title, str) or not title.isprintable() or len(title) > _LONGEST_TITLE:
        allowed = f"allowed is a text of up to {_LONGEST_TITLE} characters on one line"
        raise InputError(source, "name", title, allowed)
    if isinstance(data.get("gravity"), dict):
        raise InputError(source, "gravity", data["gravity"], "allowed is a number")


def _dotted(data: Mapping[str, Any]) -> dict[str, Any]:
    """Sections and keys as dotted knob names."""
    flat: dict[str, Any] = {}
    for key, value in data.items():
        flat.update(
            {f"{key}.{name}": inner for name, inner in value.items()} if isinstance(value, dict) else {key: value}
        )
    return flat


def _origin(key: str, origins: Mapping[str, str]) -> str | None:
    """Which file holds the value that a complaint's key is about."""
    part = key.partition("[")[0]
    while part and part not in origins:
        part = part.rpartition(".")[0]
    return origins.get(part)
