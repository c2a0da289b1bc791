"""Player files, shipped or the user's own.

A player is a TOML file in `assets/players` or the user's own `players` folder. Each key is a knob of `Player`; what is
not said is as it is there:

    name = "Ann"
    title = "C"                 # beginner, D, C, B, A, professional, machine
    rank = 40                   # where among the others, the weakest at 0
    words.en = "A line or two."
    words.de = "Eine Zeile oder zwei."

    [hand]                      # errors, as multiples of those that computer tournaments play with
    aim = 2.0

    [judgement]                 # how much is seen, and how long it is weighed: counts
    ways = 4

    [taste]
    attack = 0.1

    [measured]                  # written by `pool2d players --measure NAME --save`
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from typing import Any

from ..config import catalogue
from ..config.files import to_toml, write_text
from ..config.knobs import apply, walk
from ..config.reader import read_bytes, read_toml
from ..errors import InputError
from .player import Player, Rates

# What a file says of rates, in a section of its own or in keys above the sections.
_MEASURED = re.compile(r"^\[measured\][^\n]*\n(?:(?!\[)[^\n]*\n)*|^measured\b[^\n]*=[^\n]*\n", re.MULTILINE)


def player_names() -> list[str]:
    """The names of all players' files, the weakest first; those that cannot be read come last."""
    names = catalogue.shipped(catalogue.PLAYERS) + catalogue.own(catalogue.PLAYERS)
    return sorted(names, key=lambda name: (_rank(name), name))


def load_player(name: str) -> Player:
    """A player by the name of a file, or from a path to one; raises InputError."""
    path = catalogue.find(catalogue.PLAYERS, name)
    player = apply(Player(), {"name": path.stem[:40], **dict(_flat(read_toml(path)))}, str(path))
    if not player.name.strip():
        raise InputError(str(path), "name", player.name, "allowed is a text of 1 to 40 characters")
    return player


def save_measured(name: str, measured: Rates) -> None:
    """Write what was measured of a player into the file; all else that stands there stays as it is, word by word."""
    path = catalogue.find(catalogue.PLAYERS, name)
    text = _MEASURED.sub("", read_bytes(path).decode("utf-8-sig") + "\n").rstrip()
    rates = {key: value for key, _, value in walk(measured)}
    write_text(path, f"{text}\n\n{to_toml({'measured': rates}).strip()}\n".lstrip())


def _rank(name: str) -> float:
    try:
        return load_player(name).rank
    except InputError:
        return math.inf


def _flat(data: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, object]]:
    """What a file holds by dotted names; a table that no knob lies below is left whole, and so is refused."""
    for key, value in data.items():
        if isinstance(value, dict) and value:
            yield from _flat(value, f"{prefix}{key}.")
        else:
            yield prefix + key, value
