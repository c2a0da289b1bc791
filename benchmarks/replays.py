"""Whether matches come back: `python -m benchmarks.replays [--games all] [--matches 200] [--jobs 1]`.

Random matches on record, some actions undone and done again. Each record is verified to the bit, and taken up by
`resume`; then everything is undone and done again, each moment being the one it was. A match ends with a winner, or
after many actions where it stands. Prints a line per game; the exit status is 1 where anything differed.
"""

from __future__ import annotations

import argparse
import random
import sys
import tempfile
import time
import traceback
from multiprocessing import Pool
from pathlib import Path

from pool2d.game.match import Match
from pool2d.game.records.earlier import digest
from pool2d.game.records.record import load
from pool2d.game.records.recorder import record, resume
from pool2d.game.records.replaying import verify
from pool2d.game.rules import GAMES

from .random_play import go_on, new_match

# After so many actions a match is left as it stands; practice never ends.
LONG = 120


def play(game: str, seed: int, path: Path) -> Match:
    """One match by dice, on record."""
    rng = random.Random(f"{game} {seed}")
    with record(new_match(game, seed), path) as recorder:
        go_on(recorder, LONG, rng, undone=0.1)
        recorder.match.table.settle(recorder.match.layout)
        return recorder.match


def faults(game: str, seed: int) -> tuple[str, bool]:
    """What differed about one match, "" where nothing did, and whether somebody has won it."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "match.jsonl"
        match = play(game, seed, path)
        found = verify(load(path))
        if found is not None:
            return f"line {found.line}: {found.what}", match.over
        with resume(path) as again:
            if digest(again.match) != digest(match) or again.match.over != match.over:
                return "another state after resuming", match.over
    history = match.history
    while match.undo():
        if match.now is not history[len(match.history) - 1]:
            return "another moment after undo", match.over
    again_so_far = new_match(game, seed)
    for moment in history[1:]:
        assert moment.action is not None
        replayed = again_so_far.play(moment.action)
        alike = (replayed.ruling, replayed.tallies) == (moment.ruling, moment.tallies)
        if not match.redo() or match.now is not moment or not alike:
            return "another moment after redo", match.over
    return "", match.over


def attempt(job: tuple[str, int]) -> tuple[str, bool]:
    try:
        return faults(*job)
    except Exception:
        return traceback.format_exc(), False


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--games", default="all", help="names of games, with commas; all of them by default")
    parser.add_argument("--matches", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0, help="of the first match")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    bad = 0
    with Pool(options.jobs) as pool:
        for name in list(GAMES) if options.games == "all" else options.games.split(","):
            begun = time.perf_counter()
            jobs = [(name, options.seed + i) for i in range(options.matches)]
            results = pool.map(attempt, jobs)
            wrong = [(job, what) for job, (what, _) in zip(jobs, results, strict=True) if what]
            for (_, seed), what in wrong:
                print(f"--games {name} --seed {seed} --matches 1: {what}")
            bad += len(wrong)
            won = sum(over for _, over in results)
            took = time.perf_counter() - begun
            print(f"{name:16} {len(jobs)} matches, {won} won, {len(wrong)} differed, {took:.0f} s", flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
