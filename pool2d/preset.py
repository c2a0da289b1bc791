"""Table presets: TOML files under `assets/tables`, or anywhere."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from .assets import asset, assets
from .errors import InputError, suggest
from .knobs import Knob, apply, walk
from .racks import Furniture, Rack
from .table import Knobs, Table

_PARTS = ("name", "marks", "balls", "racks")


def load_table(name: str | Path, overrides: Mapping[str, Any] | None = None) -> Table:
    """A table by preset name ("pool-9ft"), or from a .toml file.

    `overrides` sets dotted knobs on top. Raises InputError, naming the file and the key.
    """
    source, path = str(name), preset_path(str(name))
    if not source.endswith(".toml") and source not in presets():
        raise InputError("table", "table", source, f"{suggest(source, presets())}; or a path to a .toml file")
    data = read_toml(path)
    groups = {name.partition(".")[0] for name, _, _ in walk(Knobs())}
    for key in data:
        if key not in groups and key not in _PARTS:
            raise InputError(source, key, data[key], suggest(key, (*groups, *_PARTS)))
    knobs = apply(Knobs(), _dotted({key: data[key] for key in data if key in groups}, source), source)
    title = data.get("name", path.stem)
    if not isinstance(title, str):
        raise InputError(source, "name", title, "allowed is a text")
    return Table(source, title, knobs, _furniture(data, source), overrides)


def preset_path(name: str) -> Path:
    """The file behind a preset's name or path."""
    return Path(name) if name.endswith(".toml") else asset("tables", name + ".toml")


def presets() -> list[str]:
    """The names of the shipped presets."""
    return sorted(path.stem for path in assets("tables", ".toml"))


def read_toml(path: Path) -> dict[str, Any]:
    """A TOML file's content; raises InputError where it cannot be read or is not TOML."""
    try:
        return tomllib.loads(path.read_bytes().decode("utf-8"))
    except OSError as error:
        raise InputError(str(path), "", None, f"cannot be read: {error.strerror}") from error
    except (ValueError, RecursionError) as error:
        raise InputError(str(path), "", None, f"not a TOML file: {error}") from error


def _dotted(data: Mapping[str, Any], source: str) -> dict[str, Any]:
    """Sections and keys as dotted knob names."""
    flat: dict[str, Any] = {}
    for key, value in data.items():
        if isinstance(value, dict):
            flat.update({f"{key}.{name}": inner for name, inner in value.items()})
        else:
            flat[key] = value
    return flat


_PLACE = Knob(0.0, -10.0, 10.0, "m", "")
_GAP = Knob(0.0, 0.0, 0.01, "m", "")
_COUNT = Knob(0.0, 0.0, 100.0, "", "")


def _furniture(data: Mapping[str, Any], source: str) -> Furniture:
    marks = _section(data, "marks", ("head_string", "sights", "sight_inset", "spots"), source)
    line = marks.get("head_string")
    spots = {
        name: _spot(place, source, f"marks.spots.{name}")
        for name, place in _table(marks.get("spots", {}), source, "marks.spots").items()
    }
    balls = dict(_table(data.get("balls", {}), source, "balls"))
    cue = balls.pop("cue", "cue")
    if not isinstance(cue, str):
        raise InputError(source, "balls.cue", cue, "allowed is a ball's id")
    groups = {name: _ids(ids, source, f"balls.{name}") for name, ids in balls.items()}
    every = [cue, *(ball for ids in groups.values() for ball in ids)]
    for ball in every:
        if every.count(ball) > 1:
            raise InputError(source, "balls", ball, "more than one ball has this id")
    furniture = Furniture(
        None if line is None else float(_PLACE.check(line, source, "marks.head_string")),
        int(_COUNT.check(marks.get("sights", 0), source, "marks.sights")),
        float(_PLACE.check(marks.get("sight_inset", 0.0), source, "marks.sight_inset")),
        spots,
        cue,
        groups,
    )
    for name, rack in _table(data.get("racks", {}), source, "racks").items():
        furniture.racks[name] = _rack(rack, furniture, source, f"racks.{name}")
    return furniture


def _rack(data: Any, furniture: Furniture, source: str, key: str) -> Rack:
    data = _table(data, source, key)
    for name in data:
        if name not in ("spot", "gap", "rows"):
            raise InputError(source, f"{key}.{name}", data[name], suggest(name, ("spot", "gap", "rows")))
    spot = data.get("spot")
    for needed in (spot, "head"):
        if needed not in furniture.spots:
            raise InputError(source, f"{key}.spot", needed, "not a spot under marks.spots")
    rows = data.get("rows")
    if not isinstance(rows, list):
        raise InputError(source, f"{key}.rows", rows, "allowed is a list of rows, each a list of slots")
    filled = tuple(_ids(row, source, f"{key}.rows") for row in rows)
    _check_slots([slot for row in filled for slot in row], furniture, source, f"{key}.rows")
    return Rack(spot, filled, float(_GAP.check(data.get("gap", 0.0), source, f"{key}.gap")))


def _check_slots(slots: list[str], furniture: Furniture, source: str, key: str) -> None:
    """Raises InputError for a slot that names nothing, and where a group or the set runs out."""
    balls, groups = furniture.balls, furniture.groups
    for slot in slots:
        if slot not in ("any", *groups, *balls):
            raise InputError(source, key, slot, suggest(slot, ("any", *groups, *balls)))
        if slots.count(slot) > 1 and slot in balls and slot not in groups:
            raise InputError(source, key, slot, "more than one slot names this ball")
    for name, group in groups.items():
        spare = [ball for ball in group if ball not in slots]
        if slots.count(name) > len(spare):
            raise InputError(source, key, name, f"more slots than the {len(spare)} balls left in the group")
    if len(slots) > len(balls):
        raise InputError(source, key, len(slots), f"more slots than the {len(balls)} balls under [balls]")


def _section(data: Mapping[str, Any], key: str, names: tuple[str, ...], source: str) -> Mapping[str, Any]:
    section = _table(data.get(key, {}), source, key)
    for name in section:
        if name not in names:
            raise InputError(source, f"{key}.{name}", section[name], suggest(name, names))
    return section


def _table(value: Any, source: str, key: str) -> Mapping[str, Any]:
    if not isinstance(value, dict):
        raise InputError(source, key, value, "allowed is a section of keys and values")
    return value


def _spot(value: Any, source: str, key: str) -> tuple[float, float]:
    if not isinstance(value, list) or len(value) != 2:
        raise InputError(source, key, value, "allowed is [x, y] in m")
    return float(_PLACE.check(value[0], source, key)), float(_PLACE.check(value[1], source, key))


def _ids(value: Any, source: str, key: str) -> tuple[str, ...]:
    if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
        raise InputError(source, key, value, "allowed is a list of texts")
    return tuple(value)


def save_preset(name: str, base: str, overrides: Mapping[str, Any], title: str) -> Path:
    raise InputError(name, "", None, "not yet")
