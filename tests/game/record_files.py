"""Records for tests: matches played at random, and lines rewritten."""

from __future__ import annotations

import json
import random
from pathlib import Path
from typing import Any

from benchmarks.random_play import go_on, new_match
from pool2d.game.match import Match
from pool2d.game.records import moments
from pool2d.game.records.earlier import digest
from pool2d.game.records.record import Record, load, seal
from pool2d.game.records.recorder import Recorder, record


def played_on(recorder: Recorder, actions: int, seed: int) -> Recorder:
    """The recorder after random actions, some of them undone and done again."""
    go_on(recorder, actions, random.Random(seed), undone=0.15)
    return recorder


def played(path: Path, game: str = "nine-ball", seed: int = 3, actions: int = 16) -> Match:
    """A match on record, some of whose actions were undone and done again."""
    with record(new_match(game, seed, race=2), path) as recorder:
        go_on(recorder, actions, random.Random(seed), undone=0.2)
        return recorder.match


def bodies(path: Path) -> list[dict[str, Any]]:
    """What the lines of a record hold besides their sums."""
    return [
        {key: value for key, value in json.loads(line).items() if key != "sum"}
        for line in path.read_text().splitlines()
    ]


def rewrite(path: Path, lines: list[dict[str, Any]]) -> Record:
    """A record with good sums, whatever it says."""
    content, total = b"", ""
    for number, body in enumerate(lines):
        line, total = seal({**body, "n": number}, total)
        content += line
    path.write_bytes(content)
    return load(path)


def stands(a: Match, b: Match) -> bool:
    """Whether two matches are the same to the bit, at every moment."""
    pairs = zip(a.history, b.history, strict=True)
    return digest(a) == digest(b) and all(moments.same(x, y) and x.action == y.action for x, y in pairs)
