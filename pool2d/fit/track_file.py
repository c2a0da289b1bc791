"""Reading tracked shots: a table of rows as CSV, or JSON that may say more."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from ..config.fields import check_keys, number_in
from ..config.knobs import Knob
from ..config.reader import parse_json, read_bytes
from ..errors import InputError
from ..table.placing import MOST_BALLS, RANGES, check_id
from .tracks import Floats, Track, TrackedShot, TrackFile

COLUMNS = ("shot", "time", "ball", "x", "y")
# What a column may be called as well.
_ALSO = {"t": "time"}
_KEYS = ("table", "radius", "shots")
_SHOT_KEYS = ("shot", "tracks")
# Bytes, points and shots of one file: some thousands of shots at 50 pictures a second.
_LARGEST = 1 << 26
_MOST_POINTS = 2_000_000
_MOST_SHOTS = 10_000
_LONGEST_NAME = 60
_TIME = Knob(0.0, -1e6, 1e6, "s", "when a ball was seen")
_PLACE = RANGES["x"]

# The name of the shot of a file that tells of one alone.
_ONE = "1"

# A ball's points as they are read: time, x, y.
_Points = list[tuple[float, float, float]]
_Seen = dict[str, dict[str, _Points]]


def read_tracks(path: Path) -> TrackFile:
    """The shots of a file, .csv or .json, in its order.

    Raises InputError naming the file, the line or key, the value and what is allowed.
    """
    source = str(path)
    if path.suffix.lower() == ".csv":
        return TrackFile(_shots(_of_rows(read_bytes(path, _LARGEST), source), source))
    if path.suffix.lower() == ".json":
        return _of_json(parse_json(read_bytes(path, _LARGEST), source, values=5 * _MOST_POINTS), source)
    raise InputError(source, "", None, "tracked shots are in a file whose name ends in .csv or .json")


def _of_rows(content: bytes, source: str) -> _Seen:
    """The rows of a CSV file; their order is of no consequence."""
    try:
        rows = csv.reader(io.StringIO(content.decode("utf-8-sig"), newline=""), strict=True)
        places = _places([_ALSO.get(name.strip(), name.strip()) for name in next(rows, [])], source)
        seen: _Seen = {}
        for count, row in enumerate(rows):
            if count == _MOST_POINTS:
                raise InputError(source, "", None, f"too many rows; allowed are {_MOST_POINTS}")
            if row:
                _take(seen, row, places, source, rows.line_num)
        return seen
    except InputError:
        raise
    except (ValueError, csv.Error) as error:
        raise InputError(source, "", None, f"not a CSV file: {error}") from error


def _places(header: list[str], source: str) -> list[int]:
    """Where each of the columns stands, -1 for shots where there is but one; others are left alone."""
    needed = COLUMNS if "shot" in header else COLUMNS[1:]
    for name in needed:
        if header.count(name) != 1:
            found = "is there twice" if name in header else f"missing; the first line has to name {', '.join(COLUMNS)}"
            raise InputError(source, name, None, found, 1)
    return [header.index(name) if name in needed else -1 for name in COLUMNS]


def _take(seen: _Seen, row: list[str], places: list[int], source: str, line: int) -> None:
    """One row of a CSV file."""
    if len(row) <= max(places):
        raise InputError(source, "", None, f"has {len(row)} values; needed are {', '.join(COLUMNS)}", line)
    shot, time, ball, x, y = (row[place].strip() if place >= 0 else _ONE for place in places)
    try:
        point = (
            _number(_TIME, time, source, "time"),
            _number(_PLACE, x, source, "x"),
            _number(_PLACE, y, source, "y"),
        )
        seen.setdefault(_name(shot, source, "shot"), {}).setdefault(check_id(ball, source, "ball"), []).append(point)
    except InputError as error:
        raise InputError(source, error.key, error.value, error.allowed, line) from None


def _number(knob: Knob, text: str, source: str, key: str) -> float:
    return float(knob.check(number_in(text), source, key))


def _name(name: object, source: str, key: str) -> str:
    """A shot's name."""
    if not _names(name):
        raise InputError(source, key, name, f"allowed is a name or number of up to {_LONGEST_NAME} characters")
    return str(name)


def _names(name: object) -> bool:
    """Whether something may be a shot's name: a text that can be read, or a number."""
    return type(name) is int or (isinstance(name, str) and name.isprintable() and 0 < len(name) <= _LONGEST_NAME)


def _of_json(data: Any, source: str) -> TrackFile:
    if isinstance(data, list):
        return TrackFile(_shots(_of_objects(data, source), source))
    if not isinstance(data, dict):
        raise InputError(
            source, "", None, f"allowed is an object with {', '.join(_KEYS)}, or a list of objects with those of a row"
        )
    check_keys(data, _KEYS, source)
    return TrackFile(
        _shots(_of_entries(data.get("shots"), source), source), _table(data, source), _radius(data, source)
    )


def _of_objects(rows: list[Any], source: str) -> _Seen:
    """A list of points, each an object with what a row of a CSV file has."""
    seen: _Seen = {}
    for number, row in enumerate(rows):
        key = f"[{number}]"
        if not isinstance(row, dict):
            raise InputError(source, key, row, f"allowed is an object with {', '.join(COLUMNS)}")
        point: dict[str, Any] = {_ALSO.get(str(name), str(name)): value for name, value in row.items()}
        check_keys(point, COLUMNS, source, f"{key}.")
        shot = _name(point.get("shot", _ONE), source, f"{key}.shot")
        ball = check_id(point.get("ball"), source, f"{key}.ball")
        seen.setdefault(shot, {}).setdefault(ball, []).append(_point(point, source, key))
    return seen


def _point(point: dict[str, Any], source: str, key: str) -> tuple[float, float, float]:
    """Time, x and y of a point that is an object."""
    t, x, y = (
        float(knob.check(point.get(name), source, f"{key}.{name}"))
        for name, knob in (("time", _TIME), ("x", _PLACE), ("y", _PLACE))
    )
    return t, x, y


def _table(data: dict[str, Any], source: str) -> str | None:
    """The table that a JSON file names."""
    if "table" in data and not isinstance(data["table"], str):
        raise InputError(source, "table", data["table"], "allowed is a preset's name or a path to a .toml file")
    return data.get("table")


def _radius(data: dict[str, Any], source: str) -> float | None:
    """The balls' radius, m, where a JSON file names it."""
    return float(RANGES["radius"].check(data["radius"], source, "radius")) if "radius" in data else None


def _of_entries(shots: Any, source: str) -> _Seen:
    if not isinstance(shots, list):
        raise InputError(source, "shots", shots, "allowed is a list of shots")
    seen: _Seen = {}
    for number, entry in enumerate(shots):
        name, tracks = _entry(entry, source, f"shots[{number}]")
        if name in seen:
            raise InputError(source, f"shots[{number}].shot", name, "another shot has this name")
        seen[name] = tracks
    return seen


def _entry(entry: Any, source: str, key: str) -> tuple[str, dict[str, _Points]]:
    """One shot of a JSON file: its name, and the points of each ball."""
    if not isinstance(entry, dict):
        raise InputError(source, key, entry, f"allowed is a shot: {', '.join(_SHOT_KEYS)}")
    check_keys(entry, _SHOT_KEYS, source, f"{key}.")
    tracks = entry.get("tracks")
    if not isinstance(tracks, dict) or not tracks:
        raise InputError(source, f"{key}.tracks", tracks, "allowed are lists of [time, x, y] by the ids of the balls")
    named = {check_id(ball, source, f"{key}.tracks"): (ball, points) for ball, points in tracks.items()}
    return _name(entry.get("shot"), source, f"{key}.shot"), {
        ball: list(_points(points, source, f"{key}.tracks.{written}")) for ball, (written, points) in named.items()
    }


def _points(points: Any, source: str, key: str) -> Iterator[tuple[float, float, float]]:
    if not isinstance(points, list):
        raise InputError(source, key, points, "allowed is a list of [time, x, y]")
    for number, point in enumerate(points):
        if not isinstance(point, list) or len(point) != 3:
            raise InputError(source, f"{key}[{number}]", point, "allowed is [time, x, y]")
        time, x, y = (
            float(knob.check(value, source, f"{key}[{number}]"))
            for knob, value in zip((_TIME, _PLACE, _PLACE), point, strict=True)
        )
        yield time, x, y


def _shots(seen: _Seen, source: str) -> tuple[TrackedShot, ...]:
    """The shots as they are kept; raises InputError where there are none, or one cannot be what was seen."""
    if not 1 <= len(seen) <= _MOST_SHOTS:
        raise InputError(source, "", None, f"has {len(seen)} shots; allowed are 1 to {_MOST_SHOTS}")
    return tuple(TrackedShot(name, dict(_tracks(name, balls, source))) for name, balls in seen.items())


def _tracks(name: str, balls: dict[str, _Points], source: str) -> Iterable[tuple[str, Track]]:
    if len(balls) > MOST_BALLS:
        raise InputError(source, f"shot {name}", len(balls), f"allowed are up to {MOST_BALLS} balls")
    for ball, points in balls.items():
        if not points:
            raise InputError(source, f"shot {name}, ball {ball}", [], "needed is one place of the ball at least")
        t, x, y = (np.array(column) for column in zip(*sorted(points), strict=True))
        if (twice := _twice(t)) is not None:
            raise InputError(source, f"shot {name}, ball {ball}, time", twice, "the ball was seen twice at this time")
        yield ball, Track(t, x, y)


def _twice(t: Floats) -> float | None:
    """A time that is there twice."""
    same = np.flatnonzero(np.diff(t) == 0.0)
    return float(t[same[0]]) if same.size else None
