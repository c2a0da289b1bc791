"""Records of matches: files of one JSON line for the match and one for each action.

A line holds its number `n`, what was done, and `sum`, a checksum that runs on from the line before: what is
cut off, swapped or edited is found, and where. A stroke also holds the `digest` of its rollout, and every
action that of the `state` it led to, so that a replay can be verified to the bit. Lines are only ever
appended, each flushed to the disk before the game goes on: a kill loses at most the line being written.
What was undone stays in the record, with the undoing as an action after it.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from .._version import __version__
from ..errors import BudgetError, InputError
from ..folders import data_folder
from ..physics.rollout import Rollout
from ..preset import load_table
from ..reader import parse_json, read_bytes
from ..table import Table
from .actions import as_dict, from_dict
from .match import Match, Moment
from .setup import Setup, setup_of

FORMAT = 1
FOLDER, ENDING = "matches", ".jsonl"
UNDO, REDO = "undo", "redo"
_LARGEST = 64 << 20
_SEAL = re.compile(rb',"sum":"([0-9a-f]{16})"}')
_SEALED = len(b',"sum":"0123456789abcdef"}')


class Entry(NamedTuple):
    """A line of a record after the first: its number in the file, counted from 1, and what it holds."""

    line: int
    data: dict[str, Any]


class Divergence(NamedTuple):
    """Where a replay first differs from its record."""

    line: int
    what: str


@dataclass(frozen=True, slots=True)
class Record:
    """What a file holds: the match's setup, its table, its entries.

    `size` is how many bytes its whole lines take, and `sum` the checksum to go on from.
    """

    path: Path
    setup: Setup
    place: Mapping[str, Any]
    start: str
    entries: tuple[Entry, ...]
    size: int
    sum: str

    def table(self) -> Table:
        """The table it was played on; raises InputError where there is none such any more."""
        return load_table(self.place["name"], self.place["set"], self.place["conditions"])

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
        setup, place = setup_of(head["setup"], source), _place(head["table"], source)
        start = str(head["state"])
    except (KeyError, TypeError, AttributeError) as error:
        raise InputError(source, "", None, f"the header is not whole: {error}", 1) from None
    entries = tuple(Entry(number, body) for number, body in enumerate(bodies[1:], 2))
    for entry in entries:
        if not isinstance(entry.data.get("do"), str):
            raise InputError(source, "do", entry.data.get("do"), "allowed is an action", entry.line)
    return Record(path, setup, place, start, entries, len(content) - len(rest), total)


def _place(data: Mapping[str, Any], source: str) -> Mapping[str, Any]:
    """The table of a header; raises InputError, KeyError or TypeError where it is not one."""
    kinds = {"name": str, "conditions": list, "set": dict}
    for key, kind in kinds.items():
        if not isinstance(data[key], kind):
            raise InputError(source, f"table.{key}", data[key], f"allowed is a {kind.__name__}", 1)
    return data


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
    table = match.table
    name = Path(table.source).absolute().as_posix() if table.source.endswith(".toml") else table.source
    place = {"name": name, "conditions": list(table.conditions), "set": dict(table.set)}
    setup = match.setup.as_dict()
    return {"pool2d": FORMAT, "version": __version__, "setup": setup, "table": place, "state": digest(match)}


def body_of(match: Match, do: str = "") -> dict[str, Any]:
    """What a line holds of the action that led to the match's present moment, or of a `do` that is none."""
    moment = match.now
    body: dict[str, Any] = {"do": do} if do else as_dict(moment.action)  # type: ignore[arg-type]
    if not do and moment.rollout is not None:
        body["digest"] = moment.rollout.digest()
    body["state"] = digest(match)
    if match.setup.race > 1 or match.over:
        body["frames"] = list(match.frames)
    return {**body, "over": True} if match.over else body


def digest(match: Match) -> str:
    """A fingerprint of where a match stands: the state of the game, every bit of the balls, the tallies."""
    now = match.now
    told = (json.dumps(now.state.as_dict(), sort_keys=True), list(map(tuple, now.layout.values())), now.tallies)
    return hashlib.sha256(repr(told).encode()).hexdigest()[:16]


def replayed(record: Record) -> Iterator[tuple[Entry, Match]]:
    """The match as it stands after each entry. It is one match, which goes on with the iteration.

    Raises InputError where an entry's action is refused.
    """
    match = Match(record.table(), record.setup)
    for entry in record.entries:
        try:
            _redo(match, entry, str(record.path))
        except (InputError, BudgetError) as error:
            what = f"{entry.data['do']} is refused: {error}"
            raise InputError(str(record.path), "", None, what, entry.line) from error
        yield entry, match


def _redo(match: Match, entry: Entry, source: str) -> None:
    """Do to a match what an entry says; raises InputError."""
    do = entry.data["do"]
    if do not in (UNDO, REDO):
        match.play(from_dict(entry.data, source))
    elif (do == UNDO and not match.undo()) or (do == REDO and not match.redo()):
        raise InputError(source, "do", do, "there is nothing to go to")


def verify(record: Record) -> Divergence | None:
    """Play a record through the engine and the rules; the first line that does not come out as it says.

    Raises InputError where its table or setup is none.
    """
    return _diverges(Match(record.table(), record.setup), record)


def _diverges(match: Match, record: Record) -> Divergence | None:
    """Play a record in a match that has not begun; where it first does not come out as it says."""
    if digest(match) != record.start:
        return Divergence(1, "the balls do not start as recorded")
    for entry in record.entries:
        try:
            _redo(match, entry, str(record.path))
        except (InputError, BudgetError) as error:
            return Divergence(entry.line, f"{entry.data['do']} is refused: {error}")
        now = body_of(match, entry.data["do"] if entry.data["do"] in (UNDO, REDO) else "")
        for key, what in (("digest", "the shot does not roll"), ("state", "the game does not stand")):
            if now.get(key) != entry.data.get(key):
                return Divergence(entry.line, f"{what} as recorded after this {entry.data['do']}")
    return None


def restored(record: Record) -> Match:
    """The match as a record left it; raises InputError where it does not play as recorded."""
    match = Match(record.table(), record.setup)
    found = _diverges(match, record)
    if found is not None:
        allowed = f"{found.what}; the table or pool2d has changed since"
        raise InputError(str(record.path), "", None, allowed, found.line)
    return match


class Take(NamedTuple):
    """A stroke of a record, to be looked at: its number, counted from 1, its line, and the moment it led to.

    `before` is the moment in which it was played; `same` whether it rolls as it was recorded.
    """

    number: int
    line: int
    match: Match
    before: Moment
    moment: Moment
    rollout: Rollout
    same: bool


def strokes(record: Record) -> Iterator[Take]:
    """Every stroke of a record in its order, also those that were undone, each worked out when it is asked for.

    Raises InputError where an entry's action is refused.
    """
    number = 0
    for entry, match in replayed(record):
        rollout = match.now.rollout
        if entry.data["do"] == "stroke" and rollout is not None:
            number += 1
            same = rollout.digest() == entry.data.get("digest")
            yield Take(number, entry.line, match, match.history[-2], match.now, rollout, same)


def takes(record: Record) -> list[Take]:
    """Every stroke of a record; raises InputError."""
    return list(strokes(record))
