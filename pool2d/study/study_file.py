"""A study as a TOML file describes it: a scenario, and what is swept over on top of it."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from ..config.fields import check_keys
from ..config.knobs import Knob
from ..config.reader import read_toml
from ..errors import InputError, suggest
from ..physics.values import SHOT_RANGES, Layout, Shot
from ..table.scenario import KEYS, Scenario, load_scenario, read_scenario
from ..table.table import Table
from ..table.table_data import as_data
from .measure import Outcome, outcome_of
from .sweep import SWEPT, Sweep

_SECTIONS = ("grid", "noise", "study")
_STUDY_KEYS = ("shots", "seed", "map", "outcome")
_STEPS = ("from", "to", "count")
# Values along one side of a grid, and shots altogether.
_LONGEST = 10_000
_MOST = 100_000_000
# A deviation beyond this would be no error of a hand, but of the file.
_WIDEST = {"angle": 360.0, "speed": 50.0, "side": 1.0, "height": 1.0, "elevation": 90.0}
# Changes whenever the rows of the results do.
_FORMAT = 1


@dataclass(frozen=True, slots=True)
class Study:
    """What is played and looked at: the `axes` of the map, None where fewer than two are swept, and its `outcome`."""

    table: Table
    layout: Layout
    sweep: Sweep
    axes: tuple[str, str] | None
    outcome: Outcome

    def stamp(self, engine: Sequence[str]) -> str:
        """A name for all that decides how the rows come out, `engine` too; results bear it, so that none are mixed."""
        told = {
            "format": _FORMAT,
            "engine": list(engine),
            "table": {**as_data(self.table), "name": ""},
            "layout": list(self.layout.values()),
            "sweep": asdict(self.sweep),
        }
        return hashlib.sha256(json.dumps(told).encode()).hexdigest()[:12]


def load_study(path: Path, overrides: Mapping[str, Any], conditions: Sequence[str]) -> Study:
    """Read a study; `overrides` and `conditions` go on top of its scenario's own.

    Raises InputError naming the file, the key, the value and what is allowed.
    """
    source = str(path)
    if path.suffix != ".toml":
        raise InputError(source, "", None, "a study's name ends in .toml")
    data = read_toml(path)
    check_keys(data, ("scenario", *KEYS, *_SECTIONS), source)
    sections = {name: _section(data.pop(name, {}), name, source) for name in _SECTIONS}
    scenario = _scenario(data, path, overrides, conditions)
    if scenario.shot is None:
        raise InputError(source, "shot", None, "missing; needed is the shot that the study varies")
    wanted = sections["study"]
    check_keys(wanted, _STUDY_KEYS, source, "study.")
    sweep = _sweep(scenario.shot, sections, source)
    usual = "potted" if scenario.table.geometry.pockets else f"cushions.{scenario.shot.ball}"
    name = wanted.get("outcome", usual)
    if not isinstance(name, str):
        raise InputError(source, "study.outcome", name, "allowed is a text such as 'potted' or 'potted.8'")
    outcome = outcome_of(name, tuple(scenario.layout), source, "study.outcome")
    return Study(scenario.table, scenario.layout, sweep, _axes(wanted, sweep, source), outcome)


def _scenario(data: dict[str, Any], path: Path, overrides: Mapping[str, Any], conditions: Sequence[str]) -> Scenario:
    """The scenario that a study's file names, or holds."""
    if "scenario" not in data:
        return read_scenario(data, str(path), overrides, conditions)
    name = data.pop("scenario")
    if not isinstance(name, str) or not name:
        raise InputError(str(path), "scenario", name, "allowed is a path to a scenario, .toml or .json")
    for key, value in data.items():
        raise InputError(str(path), key, value, f"allowed is in {name}, which the key scenario names")
    beside = path.parent / name
    return load_scenario(beside if os.path.isfile(beside) else name, overrides, conditions)


def _section(value: Any, name: str, source: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise InputError(source, name, value, f"allowed is a section [{name}]")
    return value


def _sweep(base: Shot, sections: Mapping[str, dict[str, Any]], source: str) -> Sweep:
    wanted = sections["study"]
    grid = {name: _values(name, given, source) for name, given in sections["grid"].items()}
    noise = {name: _deviation(name, given, source) for name, given in sections["noise"].items()}
    if not grid and not noise:
        raise InputError(source, "", None, "nothing is swept; needed is a section [grid] or [noise]")
    if noise and not grid and "shots" not in wanted:
        raise InputError(source, "study.shots", None, f"missing; needed is a whole number from 1 to {_MOST}")
    shots = _whole(wanted.get("shots", 1), 1, _MOST, "study.shots", source)
    if shots > 1 and not noise:
        raise InputError(source, "study.shots", shots, "without [noise] all would be alike; allowed is 1")
    seed = _whole(wanted.get("seed", 0), 0, (1 << 63) - 1, "study.seed", source)
    sweep = Sweep(base, grid, noise, shots, seed)
    if len(sweep) > _MOST:
        raise InputError(source, "study.shots", shots, f"the study has {len(sweep)} shots; allowed are {_MOST}")
    return sweep


def _known(name: str, given: Any, section: str, source: str) -> Knob:
    """What a swept number may be; raises InputError for a name that is none."""
    if name not in SWEPT:
        raise InputError(source, f"{section}.{name}", given, suggest(name, SWEPT))
    low, high, unit = SHOT_RANGES[name]
    return Knob(0.0, low, high, unit.strip(), "")


def _deviation(name: str, given: Any, source: str) -> float:
    unit = _known(name, given, "noise", source).unit
    return float(Knob(0.0, 0.0, _WIDEST[name], unit, "").check(given, source, f"noise.{name}"))


def _values(name: str, given: Any, source: str) -> tuple[float, ...]:
    """The values of one side of the grid: a list of them, or so many between two."""
    knob = _known(name, given, "grid", source)
    key = f"grid.{name}"
    if isinstance(given, list):
        if not 1 <= len(given) <= _LONGEST:
            raise InputError(source, key, given, f"allowed are 1 to {_LONGEST} values")
        values = tuple(float(knob.check(value, source, f"{key}[{i}]")) for i, value in enumerate(given))
        if len(set(values)) < len(values):
            raise InputError(source, key, given, "a value is there twice")
        return values
    if not isinstance(given, dict):
        raise InputError(source, key, given, "allowed is a list of values, or { from = 1.0, to = 2.0, count = 11 }")
    check_keys(given, _STEPS, source, f"{key}.")
    for step in _STEPS:
        if step not in given:
            raise InputError(source, f"{key}.{step}", None, "missing; needed are from, to and count")
    low, high = (float(knob.check(given[end], source, f"{key}.{end}")) for end in ("from", "to"))
    count = _whole(given["count"], 2, _LONGEST, f"{key}.count", source)
    if low == high:
        raise InputError(source, f"{key}.to", high, "allowed is another number than from")
    # Rounded to what a person would write, as far as that changes nothing.
    return tuple(round(low + (high - low) * i / (count - 1), 12) for i in range(count))


def _whole(value: Any, low: int, high: int, key: str, source: str) -> int:
    if type(value) is not int or not low <= value <= high:
        raise InputError(source, key, value, f"allowed is a whole number from {low} to {high}")
    return value


def _axes(wanted: Mapping[str, Any], sweep: Sweep, source: str) -> tuple[str, str] | None:
    """What the map lies over: as it is wanted, else the first two that are swept."""
    swept = list(dict.fromkeys([*sweep.grid, *(name for name, deviation in sweep.noise.items() if deviation > 0.0)]))
    given = wanted.get("map", swept[:2])
    if "map" in wanted:
        right = isinstance(given, list) and len(given) == 2 and all(name in swept for name in given)
        if not right or given[0] == given[1]:
            raise InputError(source, "study.map", given, f"allowed are two of {', '.join(swept)}")
    return (given[0], given[1]) if len(given) == 2 else None
