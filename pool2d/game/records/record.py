"""Records of matches: files of one JSON line for the match and one for each action.

A line holds its number `n`, what was done, and `sum`, a checksum that runs on from the line before: what is
cut off, swapped or edited is found, and where. The first holds the whole table and what played (`records/engine.py`), a
stroke the `digest` of its rollout, and every line the moment that it led to (`records/moments.py`): so a replay can be
verified to the bit, and a match is gone on with as it stood where it would come out otherwise (`records/replaying.py`).
Lines are only ever appended, each flushed to the disk before the game goes on: a kill loses at most the line
being written. What was undone stays in the record, with the undoing as an action after it.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final, Literal, NamedTuple

from ..._version import __version__
from ...config.folders import data_folder
from ...config.reader import parse_json, read_bytes
from ...errors import InputError
from ...table.preset import load_table
from ...table.table import Table
from ...table.table_data import as_data, check, is_whole, table_of
from ..actions import ActionKind, as_dict
from ..match import Match
from ..setup import Setup, setup_of
from . import engine, moments
from .engine import Identity, identity_of

FORMAT = 1
FOLDER, ENDING = "matches", ".jsonl"
UNDO: Final = "undo"
REDO: Final = "redo"
# The key of what played, in the first line and wherever that has changed; `Identity` as a list.
PLAYED_BY = "engine"
CHANGED, GONE = "changed", "gone"
_LARGEST = 64 << 20
_SEAL = re.compile(rb',"sum":"([0-9a-f]{16})"}')
_SEALED = len(b',"sum":"0123456789abcdef"}')


class RecordLine(NamedTuple):
    """A line of a record after the first: its number in the file, counted from 1, and what it holds."""

    line: int
    data: dict[str, Any]

    @property
    def do(self) -> ActionKind | Literal["undo", "redo"]:
        """What was done; a line that `load` has read says so."""
        done: ActionKind | Literal["undo", "redo"] = self.data["do"]
        return done


@dataclass(frozen=True, slots=True)
class Record:
    """What a file holds: its first line, the match's setup, its table as data, its entries.

    `size` is how many bytes its whole lines take, and `sum` the checksum to go on from.
    """

    path: Path
    head: RecordLine
    setup: Setup
    table_data: Mapping[str, Any]
    entries: tuple[RecordLine, ...]
    size: int
    sum: str

    def table(self) -> Table:
        """The table as it was when the match began.

        A record of an earlier version tells its names only: then it is as the preset has it now. Raises InputError
        where there is none such.
        """
        return table_of(self.table_data, str(self.path)) if is_whole(self.table_data) else self._preset()

    @property
    def outdated(self) -> str:
        """What the table's preset has become since: CHANGED, GONE where it cannot be read, "" where it is the same."""
        if not is_whole(self.table_data):
            return ""
        try:
            now = as_data(self._preset())
        except InputError:
            return GONE
        # Knobs that have come to be since are as they were when there was no turning them.
        return "" if now == as_data(self.table()) else CHANGED

    @property
    def played_by(self) -> Identity | None:
        """What played the last line, as far as that is told."""
        known = (identity_of(entry.data.get(PLAYED_BY)) for entry in (*self.entries[::-1], self.head))
        return next((one for one in known if one is not None), None)

    def _preset(self) -> Table:
        return load_table(self.table_data["name"], self.table_data["set"], self.table_data["conditions"])

    @property
    def over(self) -> bool:
        """Whether the match has been won."""
        return bool(self.entries) and "over" in self.entries[-1].data

    @property
    def frames(self) -> tuple[int, ...]:
        """How many frames each player had won, without playing it; empty in a race to one that is not won."""
        won = self.entries[-1].data.get("frames", []) if self.entries else []
        whole = isinstance(won, list) and len(won) == 2 and all(type(frames) is int for frames in won)
        return tuple(won) if whole else ()


def matches_folder() -> Path:
    """Where the player's records are kept."""
    return data_folder() / FOLDER


def load(path: Path, torn: bool = False) -> Record:
    """Read a record and check its sums; `torn` allows a last line that a kill has cut off.

    Raises InputError naming the line where the file is cut off, reordered, edited, from a later version or
    not a record at all.
    """
    source = str(path)
    content = read_bytes(path, _LARGEST)
    *lines, rest = content.split(b"\n")
    if not lines and not rest.startswith(b'{"n":0,"pool2d":'):
        raise InputError(source, "", None, "not a record of pool2d", 1)
    bodies, total = _unsealed(lines, source)
    if not lines or (rest and not torn):
        raise InputError(source, "", None, "the file is cut off within this line", len(lines) + 1)
    head = bodies[0]
    try:
        setup, table_data = setup_of(head["setup"], source), check(head["table"], source)
        str(head["state"])
    except (KeyError, TypeError, AttributeError) as error:
        raise InputError(source, "", None, f"the header is not whole: {error}", 1) from None
    entries = tuple(RecordLine(number, body) for number, body in enumerate(bodies[1:], 2))
    for entry in entries:
        if not isinstance(entry.data.get("do"), str):
            raise InputError(source, "do", entry.data.get("do"), "allowed is an action", entry.line)
    return Record(path, RecordLine(1, head), setup, table_data, entries, len(content) - len(rest), total)


def _unsealed(lines: list[bytes], source: str) -> tuple[list[dict[str, Any]], str]:
    """What the lines hold, and the checksum of all; raises InputError at the first that is wrong."""
    bodies: list[dict[str, Any]] = []
    total = ""
    for number, line in enumerate(lines):
        body = _parsed(line, source, number + 1)
        if number == 0:
            _check_format(body, source)
        if type(body.get("n")) is not int or body["n"] != number:
            allowed = f"allowed is {number}; lines are missing or not in their order"
            raise InputError(source, "n", body.get("n"), allowed, number + 1)
        seal = _SEAL.fullmatch(line[-_SEALED:])
        total = _sum(total, line[:-_SEALED])
        if seal is None or seal[1].decode() != total:
            raise InputError(source, "sum", body.get("sum"), "the line has been edited, or the one before", number + 1)
        bodies.append(body)
    return bodies, total


def _parsed(line: bytes, source: str, number: int) -> dict[str, Any]:
    foreign = "not a record of pool2d" if number == 1 else "not a line of a record"
    try:
        body = parse_json(line, source, number)
    except InputError as error:
        # A key is named where it is JSON, but with a value that no record holds.
        raise error if error.key else InputError(source, "", None, foreign, number) from None
    if not isinstance(body, dict):
        raise InputError(source, "", None, foreign, number)
    return body


def _check_format(body: Mapping[str, Any], source: str) -> None:
    """Raises InputError where a header is not one that this version reads."""
    if type(body.get("pool2d")) is not int:
        raise InputError(source, "", None, "not a record of pool2d", 1)
    if body["pool2d"] != FORMAT:
        allowed = f"allowed is format {FORMAT}; the record is from another version of pool2d"
        raise InputError(source, "pool2d", body["pool2d"], allowed, 1)


def seal(body: Mapping[str, Any], before: str) -> tuple[bytes, str]:
    """A record's line, and the checksum that the next one goes on from."""
    text = json.dumps(body, separators=(",", ":"), allow_nan=False).encode()[:-1]
    total = _sum(before, text)
    return text + f',"sum":"{total}"}}\n'.encode(), total


def _sum(before: str, text: bytes) -> str:
    return hashlib.sha256(before.encode() + text).hexdigest()[:16]


def header(match: Match) -> dict[str, Any]:
    """What a record's first line holds besides its number and sum."""
    return {
        "pool2d": FORMAT,
        "version": __version__,
        PLAYED_BY: list(engine.identity()),
        "setup": match.setup.as_dict(),
        "table": as_data(match.table),
        **_standing(match),
    }


def body_of(match: Match, do: str = "") -> dict[str, Any]:
    """What a line holds of the action that led to the match's present moment, or of a `do` that is none."""
    moment = match.now
    body: dict[str, Any] = {"do": do} if do else as_dict(moment.action)  # type: ignore[arg-type]
    if not do and moment.rollout is not None:
        body["digest"] = moment.rollout.digest()
    body |= _standing(match)
    if match.setup.race > 1 or match.over:
        body["frames"] = list(match.frames)
    return {**body, "over": True} if match.over else body


def _standing(match: Match) -> dict[str, Any]:
    """Where a match stands, and a digest of that."""
    where = moments.as_dict(match.now)
    return {**where, "state": moments.stamp(where)}
