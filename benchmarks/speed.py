"""How fast pool2d is: `python -m benchmarks.speed [--save FILE] [--against FILE] [--tree PATH] [--peer]`.

Times are of the processor, told in loops of a million additions of floats, one of which is run right before and after
each sample: so one machine can be compared with another, and with itself when it is busy. Beside the median stands how
far the middle half of the samples lies apart. The compiled engine, where it is there, and the interpreted one run in
processes of their own, by turns, and so does the package of another folder; `--against` puts a saved run beside them.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from . import speed_peer
from .machine import loop

HERE = Path(__file__).resolve().parent.parent
# How long a case is sampled in one turn, s of the processor, and how often at least.
_TURN, _LEAST = 0.2, 3
_MEMORY = "memory, MiB"
# By case, its samples in loops; that of the loop itself in s.
Samples = dict[str, list[float]]


class Column(NamedTuple):
    """One way to run: its heading, the folder that holds the package, and whether sources alone may run."""

    name: str
    tree: Path
    interpreted: bool


def columns(tree: Path | None) -> list[Column]:
    """The ways to run that there are here."""
    from pool2d.compiled import is_compiled

    found = [Column("interpreted", HERE, True)]
    if is_compiled():
        found.append(Column("compiled", HERE, False))
    if tree is not None:
        found.append(Column(tree.resolve().name, tree.resolve(), True))
    return found


def measured(ways: list[Column], turns: int, names: list[str]) -> dict[str, Samples]:
    """The samples of each column, taken by turns."""
    found: dict[str, Samples] = {way.name: {} for way in ways}
    for turn in range(turns):
        for way in ways:
            print(f"turn {turn + 1} of {turns}, {way.name}", file=sys.stderr)
            with _surroundings(way) as env:
                command = [sys.executable, "-m", __spec__.name, "--worker", str(way.tree), str(turn), *names]
                done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, cwd=HERE, env=env)
            for name, samples in json.loads(done.stdout.splitlines()[-1]).items():
                found[way.name].setdefault(name, []).extend(samples)
    return found


@contextmanager
def _surroundings(way: Column) -> Iterator[dict[str, str]]:
    """The environment of a worker: no screen, nothing of the player's, compiled code kept as it is for a player."""
    with tempfile.TemporaryDirectory() as folder:
        env = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
        env.update(SDL_VIDEODRIVER="dummy", SDL_AUDIODRIVER="dummy", PYGAME_HIDE_SUPPORT_PROMPT="1")
        env.update(POOL2D_CACHE=folder, POOL2D_CONFIG=folder, POOL2D_DATA=folder, PYTHONPYCACHEPREFIX=folder)
        env.update(POOL2D_INTERPRETED="1" if way.interpreted else "0")
        yield env


def work(tree: Path, turn: int, names: list[str]) -> Samples:
    """What a worker does: the samples of one turn of the package in a folder."""
    # The cases and their scenes are those of this folder, whatever package is timed.
    import tests  # noqa: F401

    sys.path.insert(0, str(tree))
    from .speed_cases import cases, held

    found: Samples = {"loop": [loop()]}
    for name, prepare in cases(tree).items():
        if names and name not in names:
            continue
        try:
            sample = prepare()
            sample(0)
        except Exception:
            if tree == HERE:
                raise
            # An older package may lack what a case takes.
            continue
        found[name] = []
        number, end = 1000 * turn, time.process_time() + _TURN
        before = loop()
        while len(found[name]) < _LEAST or time.process_time() < end:
            number += 1
            took = sample(number)
            after = loop()
            found["loop"].append(after)
            found[name].append(took / (0.5 * (before + after)))
            before = after
    if not names:
        found[_MEMORY] = [held(tree)]
    return found


def table(found: Mapping[str, Samples]) -> str:
    """The samples as text: a line for a case, two figures for a column, and what it is to the first column."""
    heads = list(found)
    names = [name for name in found[heads[0]] if name != "loop"]
    wide = max(map(len, names))
    speed = 1e3 * statistics.median(sample for samples in found.values() for sample in samples.get("loop", []))
    lines = [
        f"In loops of a million steps, {speed:.1f} ms here, and how far the middle half of the samples is apart.",
        " " * wide + "".join(f"  {head[-20:]:>20}" + (" " * 8 if i else "") for i, head in enumerate(heads)),
    ]
    for name in names:
        first = _median(found[heads[0]].get(name))
        line = f"{name:<{wide}}"
        for i, head in enumerate(heads):
            here = _median(found[head].get(name))
            told = "-" if here is None else f"{here:.4g} {_spread(found[head][name]):4.0f} %"
            line += f"  {told:>20}"
            if i:
                line += " " * 8 if here is None or not first else f"{here / first:7.2f}x"
        lines.append(line)
    return "\n".join(lines)


def _median(samples: list[float] | None) -> float | None:
    return statistics.median(samples) if samples else None


def _spread(samples: list[float]) -> float:
    """By how much the middle half of the samples lies apart, in per cent of the median."""
    if len(samples) < 2:
        return 0.0
    low, middle, high = statistics.quantiles(samples, n=4)
    return 100.0 * (high - low) / middle if middle else 0.0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--turns", type=int, default=5, help="how often each column has its turn")
    parser.add_argument("--only", nargs="*", default=[], metavar="CASE", help="no more than these")
    parser.add_argument("--tree", type=Path, metavar="PATH", help="time the package in this folder too")
    parser.add_argument("--save", type=Path, metavar="FILE", help="keep the samples")
    parser.add_argument("--against", type=Path, metavar="FILE", help="show a saved run beside this one")
    parser.add_argument("--peer", action="store_true", help="time pooltool too, where it is installed")
    parser.add_argument("--worker", nargs="+", help=argparse.SUPPRESS)
    chosen = parser.parse_args()
    if chosen.worker:
        tree, turn, *names = chosen.worker
        print(json.dumps(work(Path(tree), int(turn), names)))
        return 0
    from .speed_cases import cases

    unknown = set(chosen.only) - set(cases(HERE))
    if unknown:
        parser.error(f"no such case: {', '.join(sorted(unknown))}; there are {', '.join(cases(HERE))}")
    found = measured(columns(chosen.tree), chosen.turns, chosen.only)
    if chosen.save:
        chosen.save.write_text(json.dumps(found), encoding="utf-8")
    if chosen.against:
        saved: dict[str, Samples] = json.loads(chosen.against.read_text(encoding="utf-8"))
        found.update({f"{name}, saved": samples for name, samples in saved.items()})
    if chosen.peer:
        peer = speed_peer.samples()
        if peer is None:
            print("pooltool is not installed: pip install pooltool-billiards")
        else:
            found["pooltool"] = peer
    print(table(found))
    return 0


if __name__ == "__main__":
    sys.exit(main())
