"""From the sections of a preset to a table's furniture, checked."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from ..config.knobs import Knob
from ..errors import InputError, suggest
from ..physics.params import BallKnobs
from .furniture import Finish, Furniture, Look, Rack
from .outline import RECTANGLE, Corner, Point
from .placing import check_id

SECTIONS = ("marks", "finish", "balls", "sizes", "looks", "racks")

_PLACE = Knob(0.0, -10.0, 10.0, "m", "")
_PART = Knob(0.0, 0.0, 1.0, "", "")
_GAP = Knob(0.0, 0.0, 0.01, "m", "")
_COUNT = Knob(0.0, 0.0, 100.0, "", "")
_MARKS = ("head_string", "d_radius", "sights", "sight_inset", "spots")
_RACK = ("spot", "on", "rows", "balls", "gap", "placed", "cue")
_FINISH = ("cloth", "wood")
_LOOK = ("color", "stripe", "dots", "number")
_CORNER = ("x", "y", "pocket", "name", "cushion")
_MOST_CORNERS = 60
_MOST_SLOTS = 120
_MOST_NAMES = 250
_LONGEST_NAME = 40


def read_furniture(data: Mapping[str, Any], length: float, width: float, source: str) -> Furniture:
    """The furniture that a preset's sections describe, for a table of that size in m.

    A table without a head spot gets one, and a table without a rack one of the cue ball alone.
    Raises InputError, naming the key.
    """
    marks = _section(data, "marks", _MARKS, source)
    line = marks.get("head_string")
    spots = {
        name: _point(place, source, f"marks.spots.{name}")
        for name, place in _table(marks.get("spots", {}), source, "marks.spots").items()
    }
    spots.setdefault("head", (length / 4.0, width / 2.0))
    cue, groups = _balls(data, source)
    racks = {
        name: _rack(rack, groups, cue, spots, source, f"racks.{name}")
        for name, rack in _table(data.get("racks", {}), source, "racks").items()
    }
    known = (cue, *groups, *(ball for group in groups.values() for ball in group))
    return Furniture(
        outline=_outline(data["outline"], source) if "outline" in data else RECTANGLE,
        head_string=None if line is None else _number(_PLACE, line, source, "marks.head_string"),
        d_radius=_number(_PLACE, marks.get("d_radius", 0.0), source, "marks.d_radius"),
        sights=int(_number(_COUNT, marks.get("sights", 0), source, "marks.sights")),
        sight_inset=_number(_PLACE, marks.get("sight_inset", 0.0), source, "marks.sight_inset"),
        spots=spots,
        finish=_finish(data, source),
        cue=cue,
        groups=groups,
        sizes=_each(data, "sizes", _size, known, groups, source),
        looks=_each(data, "looks", _look, known, groups, source),
        racks=racks or {"cue-ball": Rack(spots["head"])},
    )


def read_rack(data: Mapping[str, Any], furniture: Furniture, source: str) -> Rack:
    """A rack of a table's balls on its spots that is described as a preset's are; raises InputError."""
    return _rack(data, furniture.groups, furniture.cue, furniture.spots, source, "rack")


def _finish(data: Mapping[str, Any], source: str) -> Finish:
    given = _section(data, "finish", _FINISH, source)
    return Finish(**{name: _color(value, source, f"finish.{name}") for name, value in given.items()})


def _balls(data: Mapping[str, Any], source: str) -> tuple[str, dict[str, tuple[str, ...]]]:
    """The cue ball's id, and the groups of the others."""
    balls = dict(_table(data.get("balls", {}), source, "balls"))
    cue = balls.pop("cue", "cue")
    try:
        check_id(cue, source, "balls.cue")
    except InputError as error:
        raise InputError(source, "balls.cue", cue, error.allowed.replace("a text", "a ball's id", 1)) from None
    groups = {name: _ids(ids, source, f"balls.{name}") for name, ids in balls.items()}
    every = [cue, *(ball for ids in groups.values() for ball in ids)]
    if len(every) > _MOST_SLOTS:
        raise InputError(source, "balls", len(every), f"allowed are {_MOST_SLOTS} balls")
    for ball in every:
        if every.count(ball) > 1:
            raise InputError(source, "balls", ball, "more than one ball has this id")
        check_id(ball, source, "balls")
    return cue, groups


def _each(
    data: Mapping[str, Any], section: str, read: Any, known: tuple[str, ...], groups: Mapping[str, tuple[str, ...]],
    source: str,
) -> dict[str, Any]:  # fmt: skip
    """What a section says of balls or groups, by ball; what it says of a ball itself goes first."""
    found: dict[str, Any] = {}
    entries = _table(data.get(section, {}), source, section)
    for name, entry in entries.items():
        if name not in known:
            raise InputError(source, f"{section}.{name}", entry, suggest(name, known))
        for ball in groups.get(name, (name,)):
            if ball == name or ball not in entries:
                found[ball] = read(entry, ball, source, f"{section}.{name}")
    return found


def _size(data: Any, ball: str, source: str, key: str) -> tuple[float, float]:
    data = _keys(data, ("radius", "mass"), source, key)
    knobs = BallKnobs.__dataclass_fields__
    for name in ("radius", "mass"):
        if name not in data:
            raise InputError(source, f"{key}.{name}", None, "missing; a size is { radius = m, mass = kg }")
    radius, mass = (
        _number(knobs[name].metadata["knob"], data[name], source, f"{key}.{name}") for name in ("radius", "mass")
    )
    return radius, mass


def _look(data: Any, ball: str, source: str, key: str) -> Look:
    data = _keys(data, _LOOK, source, key)
    color = _color(data.get("color"), source, f"{key}.color")
    for name in ("stripe", "dots"):
        if not isinstance(data.get(name, False), bool):
            raise InputError(source, f"{key}.{name}", data[name], "allowed is true or false")
    number = data.get("number", False)
    if isinstance(number, bool):
        number = ball if number else ""
    if not isinstance(number, str) or len(number) > 3 or not number.isprintable():
        raise InputError(source, f"{key}.number", number, "allowed is true, false or a text of up to 3 characters")
    return Look(color, data.get("stripe", False), data.get("dots", False), number)


def _outline(data: Any, source: str) -> tuple[Corner, ...]:
    if not isinstance(data, list) or len(data) > _MOST_CORNERS:
        value = len(data) if isinstance(data, list) else data
        raise InputError(source, "outline", value, f"allowed is a list of up to {_MOST_CORNERS} corners")
    return tuple(_corner(corner, i + 1, source, f"outline[{i}]") for i, corner in enumerate(data))


def _corner(data: Any, number: int, source: str, key: str) -> Corner:
    """A corner; a cushion or pocket without a name has its corner's number."""
    data = _keys(data, _CORNER, source, key)
    for name in ("x", "y"):
        if name not in data:
            raise InputError(source, f"{key}.{name}", None, f"missing; needed is {_PART.allowed()}")
    x, y = (_number(_PART, data[name], source, f"{key}.{name}") for name in ("x", "y"))
    kind = data.get("pocket", "")
    if kind not in ("", "corner", "side"):
        raise InputError(source, f"{key}.pocket", kind, "allowed is corner or side, or no pocket key")
    names = {"name": f"pocket-{number}" if kind else "", "cushion": f"cushion-{number}"}
    for name in names:
        text = data.get(name, names[name])
        if text or name in data:
            check_id(text, source, f"{key}.{name}")
        names[name] = text
    if "name" in data and not kind:
        raise InputError(source, f"{key}.name", names["name"], "a name is the pocket's, and there is none here")
    return Corner(x, y, names["cushion"], names["name"], kind or "corner")


def _rack(
    data: Any, groups: Mapping[str, tuple[str, ...]], cue: str, spots: Mapping[str, Point], source: str, key: str
) -> Rack:
    data = _keys(data, _RACK, source, key)
    every = tuple(ball for group in groups.values() for ball in group)
    balls = _ids(data["balls"], source, f"{key}.balls") if "balls" in data else every
    placed = {
        ball: _spot(place, spots, source, f"{key}.placed.{ball}")
        for ball, place in _table(data.get("placed", {}), source, f"{key}.placed").items()
    }
    for ball in (*balls, *placed):
        if ball not in every:
            raise InputError(source, f"{key}.balls", ball, suggest(ball, every))
        if balls.count(ball) > 1:
            raise InputError(source, f"{key}.balls", ball, "this ball is named twice")
    rows = data.get("rows", [])
    if not isinstance(rows, list) or len(rows) > _MOST_SLOTS:
        raise InputError(source, f"{key}.rows", rows, f"allowed is a list of rows of slots, up to {_MOST_SLOTS}")
    filled = tuple(_ids(row, source, f"{key}.rows") for row in rows)
    _check_slots([slot for row in filled for slot in row], balls, placed, groups, source, f"{key}.rows")
    spot = _spot(data.get("spot"), spots, source, f"{key}.spot") if "spot" in data or filled else (0.0, 0.0)
    on = int(_number(Knob(1.0, 1.0, max(1.0, len(filled)), "", ""), data.get("on", 1), source, f"{key}.on"))
    gap = _number(_GAP, data.get("gap", 0.0), source, f"{key}.gap")
    place = _spot(data.get("cue", "head"), spots, source, f"{key}.cue")
    return Rack(place, spot, on, filled, balls, gap, placed)


def _check_slots(
    slots: list[str], balls: tuple[str, ...], placed: Mapping[str, Point], groups: Mapping[str, tuple[str, ...]],
    source: str, key: str,
) -> None:  # fmt: skip
    """Raises InputError for a slot that names nothing, and where a group or the set runs out."""
    free = [ball for ball in balls if ball not in placed]
    known = ("any", *groups, *free)
    if len(slots) > _MOST_SLOTS:
        raise InputError(source, key, len(slots), f"allowed are {_MOST_SLOTS} slots")
    for slot in slots:
        if slot not in known:
            raise InputError(source, key, slot, suggest(slot, known))
        if slots.count(slot) > 1 and slot in free and slot not in groups:
            raise InputError(source, key, slot, "more than one slot names this ball")
    for name, group in groups.items():
        spare = [ball for ball in group if ball in free and ball not in slots]
        if slots.count(name) > len(spare):
            raise InputError(source, key, name, f"more slots than the {len(spare)} balls left in the group")
    if len(slots) > len(free):
        raise InputError(source, key, len(slots), f"more slots than the {len(free)} balls under [balls]")


def _spot(value: Any, spots: Mapping[str, Point], source: str, key: str) -> Point:
    """A spot by name, or a place."""
    if isinstance(value, list):
        return _point(value, source, key)
    if not isinstance(value, str) or value not in spots:
        raise InputError(source, key, value, "not a spot under marks.spots")
    return spots[value]


def _section(data: Mapping[str, Any], key: str, names: tuple[str, ...], source: str) -> Mapping[str, Any]:
    return _keys(data.get(key, {}), names, source, key)


def _keys(data: Any, names: tuple[str, ...], source: str, key: str) -> Mapping[str, Any]:
    """A section that has no other keys than these."""
    section = _table(data, source, key)
    for name in section:
        if name not in names:
            raise InputError(source, f"{key}.{name}", section[name], suggest(name, names))
    return section


def _table(value: Any, source: str, key: str) -> Mapping[str, Any]:
    """A section, of names that can be told."""
    if not isinstance(value, dict):
        raise InputError(source, key, value, "allowed is a section of keys and values")
    if len(value) > _MOST_NAMES:
        raise InputError(source, key, len(value), f"allowed are up to {_MOST_NAMES} names")
    for name in value:
        if not name.strip() or not name.isprintable() or len(name) > _LONGEST_NAME:
            allowed = f"allowed is a name of up to {_LONGEST_NAME} printable characters"
            raise InputError(source, key, name, allowed)
    return value


def _point(value: Any, source: str, key: str) -> Point:
    if not isinstance(value, list) or len(value) != 2:
        raise InputError(source, key, value, "allowed is [x, y] in m")
    return _number(_PLACE, value[0], source, key), _number(_PLACE, value[1], source, key)


def _color(value: Any, source: str, key: str) -> str:
    if not isinstance(value, str) or not re.fullmatch(r"#[0-9a-fA-F]{6}", value):
        raise InputError(source, key, value, 'allowed is a colour such as "#d02030"')
    return value


def _number(knob: Knob, value: Any, source: str, key: str) -> float:
    return float(knob.check(value, source, key))


def _ids(value: Any, source: str, key: str) -> tuple[str, ...]:
    if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
        raise InputError(source, key, value, "allowed is a list of texts")
    return tuple(value)
