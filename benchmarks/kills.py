"""Whether a kill loses a finished shot: `python -m benchmarks.kills [--kills 1000] [--seed 0]`.

A process plays random matches on record and tells each action once it has returned; it is killed at a random
moment. Then the record has to be whole up to the last action told, and is gone on with by the next process;
each match is verified to the bit when it has grown long. Prints what was lost; the exit status is 1 if anything.
"""

from __future__ import annotations

import argparse
import os
import random
import signal
import sys
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import NoReturn

from pool2d import InputError
from pool2d.game.records.record import Record, load
from pool2d.game.records.recorder import Recorder, record, resume
from pool2d.game.records.replaying import verify
from pool2d.game.rules import GAMES

from .random_play import new_match, random_action

# A match with so many lines is verified, and a new one begun.
LONG = 60
# The longest that a process lives, s, beside what it takes to take up the match.
LIFE = 0.12


@dataclass
class Count:
    """What came of the kills."""

    told: int = 0
    torn: int = 0
    untold: int = 0
    matches: int = 0
    faults: list[str] = field(default_factory=list)


def child(path: Path, seed: int, pipe: int) -> NoReturn:
    """Play on at a record, or begin it, and tell of each action that has returned; ends by being killed."""
    rng = random.Random(seed)
    while True:
        recorder = _taken_up(path, seed)
        os.write(pipe, b"r")
        while not recorder.match.over and len(recorder.match.history) < 4 * LONG:
            recorder.play(random_action(recorder.match, rng))
            os.write(pipe, b"p")
            if rng.random() < 0.1:
                recorder.undo()
                os.write(pipe, b"p")
        time.sleep(60.0)


def _taken_up(path: Path, seed: int) -> Recorder:
    if path.exists() and path.read_bytes().count(b"\n"):
        return resume(path)
    path.unlink(missing_ok=True)
    games = list(GAMES)
    return record(new_match(games[seed % len(games)], seed, race=3), path)


def kill_once(path: Path, seed: int, rng: random.Random) -> tuple[int, int]:
    """Start a process and kill it; how many lines were there before, and how many actions it told of."""
    before = path.read_bytes().count(b"\n") if path.exists() else 0
    out, into = os.pipe()
    process = os.fork()
    if process == 0:
        os.close(out)
        try:
            child(path, seed, into)
        finally:
            os._exit(3)
    os.close(into)
    wait, told = rng.uniform(0.0, LIFE), b""
    if rng.random() < 0.9:
        # Most are killed while they play, some while they take the match up.
        told = os.read(out, 1)
    time.sleep(wait)
    os.kill(process, signal.SIGKILL)
    _, status = os.waitpid(process, 0)
    while part := os.read(out, 4096):
        told += part
    os.close(out)
    if not os.WIFSIGNALED(status):
        raise SystemExit(f"seed {seed}: the process ended by itself; see above")
    return before, told.count(b"p")


def examine(path: Path, before: int, told: int, count: Count, seed: int) -> Record | None:
    """Look at what a kill has left; None where that is nothing yet."""
    count.told += told
    content = path.read_bytes() if path.exists() else b""
    if not before and not content.count(b"\n") and not told:
        return None
    count.torn += not content.endswith(b"\n")
    try:
        left = load(path, torn=True)
    except InputError as error:
        count.faults.append(f"seed {seed}: {error}")
        return None
    # The line of a new match comes on top; one that was being written may be there or not.
    grown = len(left.entries) + 1 - max(before, 1)
    count.untold += grown - told
    if not told <= grown <= told + 1:
        count.faults.append(f"seed {seed}: {told} actions were told of, {grown} are recorded")
    return left


def main(kills: int, seed: int) -> int:
    rng, count, begun = random.Random(seed), Count(), time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{seed}.jsonl"
        for number in range(seed, seed + kills):
            before, told = kill_once(path, number, rng)
            left = examine(path, before, told, count, number)
            if count.faults:
                break
            if left is not None and (left.over or len(left.entries) > LONG or number == seed + kills - 1):
                resume(path).close()
                found = verify(load(path))
                if found is not None:
                    count.faults.append(f"seed {number}: {found}")
                count.matches += 1
                path.unlink()
    for fault in count.faults:
        print(fault, file=sys.stderr)
    print(
        f"{kills} kills, {count.told} finished actions told of, {len(count.faults)} faults; {count.torn} torn lines,"
        f" {count.untold} actions on the disk that were not told of yet; {count.matches} matches verified;"
        f" {time.perf_counter() - begun:.0f} s"
    )
    return 1 if count.faults else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    chosen = parser.parse_args()
    sys.exit(main(chosen.kills, chosen.seed))
