"""A table as plain data, whole: every knob and all furniture, so that it needs no preset to be built again.

The furniture is told in a preset's own sections, which `read_furniture` reads and checks; nothing is left to a base.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..config.knobs import apply, walk
from ..errors import InputError, suggest
from .furniture import Furniture, Rack
from .furniture_file import SECTIONS, read_furniture
from .outline import Corner
from .table import Table
from .table_knobs import Knobs

# What a table's data may lack only all together: before it was kept, a table was told by its names alone.
WHOLE = ("title", "knobs", "furniture")
_NAMES: dict[str, type] = {"name": str, "conditions": list, "set": dict}
_KINDS: dict[str, type] = {**_NAMES, "title": str, "knobs": dict, "furniture": dict}


def as_data(table: Table) -> dict[str, Any]:
    """The table in JSON's types; `table_of` builds it again, equal to the bit."""
    source = table.source
    return {
        "name": Path(source).absolute().as_posix() if source.endswith(".toml") else source,
        "conditions": list(table.conditions),
        "set": dict(table.set),
        "title": table.title,
        "knobs": {name: value for name, _, value in walk(table.base)},
        "furniture": _sections(table.furniture),
    }


def check(data: Mapping[str, Any], source: str) -> Mapping[str, Any]:
    """The data of a table, whole or by its names alone; raises InputError, naming the key, where it is neither."""
    if not isinstance(data, dict):
        raise InputError(source, "table", data, "allowed is what a record tells of its table")
    for key, kind in (_KINDS if is_whole(data) else _NAMES).items():
        if not isinstance(data.get(key), kind):
            raise InputError(source, f"table.{key}", data.get(key), f"allowed is a {kind.__name__}")
    return data


def is_whole(data: Mapping[str, Any]) -> bool:
    """Whether the data tells the table itself, and not its names alone."""
    return any(key in data for key in WHOLE)


def table_of(data: Mapping[str, Any], source: str) -> Table:
    """The table that `as_data` made it of; raises InputError naming `source` and the key."""
    check(data, source)
    if not data["title"].isprintable():
        raise InputError(source, "table.title", data["title"], "allowed is a text of printable characters")
    for name, section in data["furniture"].items():
        if name not in (*SECTIONS, "outline"):
            raise InputError(source, f"table.furniture.{name}", section, suggest(name, (*SECTIONS, "outline")))
    knobs = apply(Knobs(), data["knobs"], source)
    furniture = read_furniture(data["furniture"], knobs.table.length, knobs.table.width, source)
    try:
        return Table(data["name"], data["title"], knobs, furniture, data["set"], data["conditions"])
    except InputError as error:
        raise error.at(source) from None


def _sections(furniture: Furniture) -> dict[str, Any]:
    """The furniture as the sections of a preset that has no base."""
    marks = {
        "d_radius": furniture.d_radius,
        "sights": furniture.sights,
        "sight_inset": furniture.sight_inset,
        "spots": {name: list(place) for name, place in furniture.spots.items()},
    }
    if furniture.head_string is not None:
        marks["head_string"] = furniture.head_string
    return {
        "outline": [_corner(corner) for corner in furniture.outline],
        "marks": marks,
        "finish": {"cloth": furniture.finish.cloth, "wood": furniture.finish.wood},
        "balls": {"cue": furniture.cue, **{name: list(balls) for name, balls in furniture.groups.items()}},
        "sizes": {ball: {"radius": radius, "mass": mass} for ball, (radius, mass) in furniture.sizes.items()},
        "looks": {
            ball: {"color": look.color, "stripe": look.stripe, "dots": look.dots, "number": look.number}
            for ball, look in furniture.looks.items()
        },
        "racks": {name: _rack(rack) for name, rack in furniture.racks.items()},
    }


def _corner(corner: Corner) -> dict[str, Any]:
    pocket = {"pocket": corner.kind, "name": corner.pocket} if corner.pocket else {}
    return {"x": corner.x, "y": corner.y, "cushion": corner.cushion, **pocket}


def _rack(rack: Rack) -> dict[str, Any]:
    return {
        "cue": list(rack.cue),
        "spot": list(rack.spot),
        "on": rack.on,
        "rows": [list(row) for row in rack.rows],
        "balls": list(rack.balls),
        "gap": rack.gap,
        "placed": {ball: list(place) for ball, place in rack.placed.items()},
    }
