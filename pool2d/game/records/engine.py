"""What decides how a recorded shot comes out: the engine, the rules, and how the machine rounds.

Each is told by a digest, which needs nobody to remember a number: of the sources for the engine and the rules, of
what a fixed set of sums comes out as for the machine. A record holds them, so that a shot that comes out otherwise
can be laid to what has changed. Sources that differ in a comment have another digest too; that does no harm, as it
is only asked for where a shot has come out otherwise.
"""

from __future__ import annotations

import hashlib
import math
from functools import cache
from importlib import resources
from typing import Any, NamedTuple

from ..._version import __version__

# How balls roll and where they stand at first, by module or package within pool2d.
ENGINE = (
    "physics",
    "physics/cue",
    "physics/flight",
    "physics/laws",
    "table/table_knobs.py",
    "table/geometry.py",
    "config/knobs.py",
    "table/outline.py",
    "table/placing.py",
    "table/furniture.py",
    "table/table.py",
)
# What a shot means.
RULES = (
    "table/arrivals.py",
    "table/flights.py",
    "game/rules",
    "game/rules/pool",
    "game/rules/snooker",
    "game/rules/carom",
    "game/match.py",
    "game/tally.py",
    "game/referee.py",
    "game/jumps.py",
)
_SIZE = 16
# How many numbers each function of the probe is tried with.
_TRIES = 500


class Identity(NamedTuple):
    """Digests of the engine, of the rules, and of how this machine rounds."""

    engine: str
    rules: str
    machine: str


@cache
def identity() -> Identity:
    """What plays shots here and now."""
    return Identity(_digest_of(ENGINE), _digest_of(RULES), _rounding())


def identity_of(data: Any) -> Identity | None:
    """The identity that a record's line tells, as a list of three texts; None where it tells none."""
    whole = isinstance(data, list) and len(data) == 3 and all(isinstance(part, str) for part in data)
    return Identity(*data) if whole else None


def _digest_of(parts: tuple[str, ...]) -> str:
    """A digest of source files; of the version where they cannot be read, as in a frozen program."""
    sha = hashlib.sha256()
    try:
        for part in parts:
            place = resources.files("pool2d").joinpath(part)
            modules = sorted(place.iterdir(), key=lambda file: file.name) if place.is_dir() else [place]
            for module in modules:
                if module.name.endswith(".py"):
                    # Lines end as the system that they were copied to has it.
                    sha.update(module.name.encode() + module.read_bytes().replace(b"\r\n", b"\n"))
    except OSError:
        return f"version {__version__}"
    return sha.hexdigest()[:_SIZE]


def _rounding() -> str:
    """A digest of what the functions that the engine uses come out as, to the bit."""
    sha = hashlib.sha256()
    for i in range(1, _TRIES + 1):
        x = i * 0.0137
        values = (
            math.sin(x), math.cos(x), math.atan2(x, 1.7), math.acos(1.0 / (1.0 + x)), math.exp(-x), math.pow(x, 1.3),
            math.hypot(x, 0.3), math.hypot(x, 0.3, 1.9), math.sqrt(x), math.atan(x), x**3,
        )  # fmt: skip
        sha.update(repr(values).encode())
    return sha.hexdigest()[:_SIZE]
