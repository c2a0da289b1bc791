"""Scenario files: a table, balls and perhaps a shot, as TOML or JSON, or as one line of text (see `position_text`)."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from ..config.fields import check_keys
from ..config.reader import read_json, read_toml
from ..errors import InputError, suggest
from ..physics.rollout import Rollout
from ..physics.simulate import simulate
from ..physics.values import MOTION_FIELDS, SHOT_RANGES, Ball, Layout, Shot
from .clearance import least_elevation
from .placing import MOST_BALLS, RANGES, check_id
from .position_text import Position
from .position_text import read as read_position
from .preset import load_table, read_preset
from .table import Table

KEYS = ("table", "conditions", "set", "position", "rack", "seed", "balls", "shot", "cue")
_BALL_KEYS = ("id", *MOTION_FIELDS, "radius", "mass")
_SHOT_KEYS = tuple(Shot.__dataclass_fields__)
# What is not a number of a shot's, and what it is.
_SHOT_KINDS: dict[str, tuple[tuple[type, ...], str]] = {
    "ball": ((str,), "a ball"),
    "easy": ((bool,), "true or false"),
    "jump": ((bool,), "true or false"),
}


@dataclass(frozen=True, slots=True)
class Scenario:
    """A table, the balls on it and a shot, if any."""

    table: Table
    layout: Layout
    shot: Shot | None

    def simulate(self, events: int | None = None) -> Rollout:
        """Play it; see `pool2d.simulate`."""
        return simulate(self.table, self.layout, self.shot, events=events)


def load_scenario(
    path: str | Path, overrides: Mapping[str, Any] | None = None, conditions: Sequence[str] = ()
) -> Scenario:
    """Read a scenario file; `overrides` sets dotted knobs, and `conditions` come, on top of the file's own.

    Raises InputError naming the file, the key, the value and what is allowed.
    """
    return read_scenario(_read(Path(path)), str(path), overrides or {}, conditions)


def read_scenario(
    data: Mapping[str, Any], source: str, overrides: Mapping[str, Any], conditions: Sequence[str]
) -> Scenario:
    """The scenario that the content of a file tells; `source` names the file. Raises InputError as `load_scenario`."""
    try:
        return _scenario(data, source, overrides, conditions)
    except InputError as error:
        # A table named in the file is a file of its own, and speaks for itself.
        raise error if error.source.endswith(".toml") and error.source != source else error.at(source) from None


def scenario_of(
    position: Position, overrides: Mapping[str, Any] | None = None, conditions: Sequence[str] = ()
) -> Scenario:
    """The scenario that a position tells, on the table it names, else pool-9ft; raises InputError.

    `overrides` and `conditions` come on top of the position's own.
    """
    table = load_table(
        position.table or "pool-9ft",
        {**position.set, **(overrides or {})},
        (*position.conditions, *conditions),
    )
    layout = table.settle(position.layout)
    return Scenario(table, layout, _on(position.shot, layout, "position"))


def _read(path: Path) -> dict[str, Any]:
    if path.suffix == ".toml":
        return read_toml(path)
    if path.suffix != ".json":
        raise InputError(str(path), "", None, "a scenario's name ends in .toml or .json")
    data = read_json(path)
    if not isinstance(data, dict):
        raise InputError(str(path), "", None, "allowed is a JSON object with " + ", ".join(KEYS))
    return data


def _scenario(
    data: Mapping[str, Any], source: str, overrides: Mapping[str, Any], conditions: Sequence[str]
) -> Scenario:
    """What the keys of a file say; raises InputError."""
    check_keys(data, KEYS, source)
    text = data.get("position")
    if text is not None and not isinstance(text, str):
        raise InputError(source, "position", text, "allowed is a text such as 'pool-9ft cue@0.6,0.3 1@1.9,0.6'")
    position = Position() if text is None else read_position(text, source)
    table = _table(data, position, source, overrides, conditions)
    layout = table.settle(_layout(data, position, table, source))
    shot = _shot(data["shot"], layout, source) if "shot" in data else _on(position.shot, layout, source)
    if _is_clear(data.get("cue", {}), source) and shot is not None:
        needed = least_elevation(table, layout, shot)
        if needed.elevation is None:
            raise InputError(source, "cue.clear", True, f"no elevation takes the cue to this tip over {needed.over}")
        shot = replace(shot, elevation=needed.elevation)
    return Scenario(table, layout, shot)


def _is_clear(entry: Any, source: str) -> bool:
    """Whether the butt is to be raised until the cue goes through nothing; raises InputError for any other key."""
    if not isinstance(entry, dict):
        raise InputError(source, "cue", entry, "allowed is a section with clear")
    check_keys(entry, ("clear",), source, "cue.")
    clear = entry.get("clear", False)
    if not isinstance(clear, bool):
        raise InputError(source, "cue.clear", clear, "allowed is true or false")
    return clear


def _table(
    data: Mapping[str, Any], position: Position, source: str, overrides: Mapping[str, Any], conditions: Sequence[str]
) -> Table:
    """The table that a file names, or its position does, with what both lay over it; raises InputError."""
    name = data.get("table", position.table or "pool-9ft")
    if not isinstance(name, str):
        raise InputError(source, "table", name, "allowed is a preset's name or a path to a .toml file")
    if name.endswith(".toml") and not Path(name).is_absolute():
        beside = Path(source).parent / name
        name = str(beside) if os.path.isfile(beside) else name  # unlike Path.is_file, False for any odd name
    if position.table not in ("", name):
        # It is overruled, but has to be one.
        read_preset(position.table)
    own = data.get("set", {})
    if not isinstance(own, dict):
        raise InputError(source, "set", own, "allowed is a section of dotted knob names and values")
    given = data.get("conditions", [])
    if not isinstance(given, list) or not all(isinstance(one, str) for one in given):
        raise InputError(source, "conditions", given, "allowed is a list of names")
    return load_table(name, {**position.set, **own, **overrides}, (*position.conditions, *given, *conditions))


def _layout(data: Mapping[str, Any], position: Position, table: Table, source: str) -> Layout:
    """The balls of a file, and those of its position or rack; raises InputError where there are none, or one twice."""
    if not any(key in data for key in ("table", "position", "rack", "balls")):
        raise InputError(source, "", None, "an empty scenario; needed are balls, a position or a rack")
    entries = data.get("balls", [])
    if not isinstance(entries, list) or (not entries and "balls" in data and not position.layout):
        raise InputError(source, "balls", entries, "allowed is a list of balls, one or more")
    if len(entries) > MOST_BALLS:
        raise InputError(source, "balls", len(entries), f"allowed are up to {MOST_BALLS} balls")
    balls, racked = dict(position.layout), _racked(data, position, table, source)
    for number, entry in enumerate(entries):
        ball = _ball(entry, source, f"balls[{number}]")
        if ball.id in balls:
            raise InputError(source, f"balls[{number}].id", ball.id, "another ball has this id")
        balls[ball.id] = ball
    # A ball that the file places is not where its rack has it.
    return Layout({**racked, **balls}.values())


def _racked(data: Mapping[str, Any], position: Position, table: Table, source: str) -> Layout:
    """The balls as the rack that a file names has them; none where it names none. Raises InputError."""
    name, seed = data.get("rack"), data.get("seed", 0)
    if type(seed) is not int or seed < 0:
        raise InputError(source, "seed", seed, "allowed is a whole number from 0")
    if name is None and "seed" not in data:
        return Layout()
    if name is None:
        raise InputError(source, "seed", seed, "allowed is only with a rack")
    if not isinstance(name, str) or name not in table.furniture.racks:
        raise InputError(source, "rack", name, suggest(str(name), table.furniture.racks))
    if position.layout:
        raise InputError(source, "rack", name, "allowed is a rack or a position's balls, not both")
    return table.rack(name, seed)


def _ball(entry: Any, source: str, key: str) -> Ball:
    if not isinstance(entry, dict):
        raise InputError(source, key, entry, "allowed is a ball: " + ", ".join(_BALL_KEYS))
    check_keys(entry, _BALL_KEYS, source, key + ".")
    name = check_id(entry.get("id"), source, f"{key}.id")
    for needed in ("x", "y"):
        if needed not in entry:
            raise InputError(source, f"{key}.{needed}", None, f"missing; needed is {RANGES[needed].allowed()}")
    numbers = {
        field: RANGES[field].check(value, source, f"{key}.{field}") for field, value in entry.items() if field != "id"
    }
    return Ball(name, **numbers)  # type: ignore[arg-type]


def _shot(entry: Any, layout: Layout, source: str) -> Shot:
    if not isinstance(entry, dict):
        raise InputError(source, "shot", entry, "allowed is a section with " + ", ".join(_SHOT_KEYS))
    check_keys(entry, _SHOT_KEYS, source, "shot.")
    for key, value in entry.items():
        kinds, allowed = _SHOT_KINDS.get(key, ((int, float), "a number"))
        if type(value) not in kinds:
            raise InputError(source, f"shot.{key}", value, f"allowed is {allowed}")
    if "speed" not in entry:
        low, high, unit = SHOT_RANGES["speed"]
        raise InputError(source, "shot.speed", None, f"missing; needed is a number from {low:g} to {high:g}{unit}")
    shot = Shot(**entry)
    shot.check(source)
    _on(shot, layout, source)
    return shot


def _on(shot: Shot | None, layout: Layout, source: str) -> Shot | None:
    """The shot; raises InputError where its ball is not there."""
    if shot is not None and shot.ball not in layout:
        raise InputError(source, "shot.ball", shot.ball, suggest(shot.ball, layout))
    return shot
