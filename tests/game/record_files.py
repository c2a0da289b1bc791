"""Records for tests: matches played at random, and lines rewritten."""

from __future__ import annotations

import json
import random
from pathlib import Path
from typing import Any

from pool2d.game.match import Match
from pool2d.game.records import moments
from pool2d.game.records.earlier import digest
from pool2d.game.records.record import Record, load, seal
from pool2d.game.records.recorder import Recorder, record

from ..random_play import new_match, random_action


def go_on(recorder: Recorder, actions: int, seed: int, undone: float = 0.15) -> Recorder:
    """The recorder after random actions, so many parts of which were undone, and half of those done again."""
    rng = random.Random(seed)
    for _ in range(actions):
        if recorder.match.over:
            break
        recorder.play(random_action(recorder.match, rng))
        if rng.random() < undone and recorder.undo() and rng.random() < 0.5:
            recorder.redo()
    return recorder


def played(path: Path, game: str = "nine-ball", seed: int = 3, actions: int = 16) -> Match:
    """A match on record, some of whose actions were undone and done again."""
    with record(new_match(game, seed, race=2), path) as recorder:
        return go_on(recorder, actions, seed, undone=0.2).match


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
