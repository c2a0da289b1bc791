"""Whether the tests notice small changes to the code: `python -m benchmarks.mutants --count 200 --seed 0 [--layer ui]`.

First every test is watched once, to know which lines it executes; from Python 3.12 on that costs little. Then small
changes are drawn by the seed, the same number in each layer, and made one at a time in a copy of the tree. Only tests
that execute the changed line are run, the narrowest first, until one fails. Prints each change that none notices, and
the share noticed in each layer; the exit status is 1 where one was missed. `--at pool2d/physics/motion.py:96` makes
changes at a place alone, and `--tests` looks at these tests alone. `--map FILE` keeps what the tests execute for the
next run, of the same tree.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import random
import shutil
import sys
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path
from typing import NamedTuple, TypedDict

from .mutations import Change, sites
from .reach import WAITING, Show, Watch, begin, end, file_of

ROOT = Path(__file__).resolve().parent.parent
# Each file belongs to the layer with the longest folder that holds it.
LAYERS = {"physics": "pool2d/physics", "table": "pool2d", "game": "pool2d/game", "ui": "pool2d/ui"}
# The tests shown to a mutant in one go take so long, s, and each next go twice that; and this in all.
FIRST_GO, PATIENCE = 4.0, 120.0
_LEFT_BEHIND = (".*", "__pycache__", "build", "dist", "*.egg-info")


class Mutant(NamedTuple):
    layer: str
    path: str
    change: Change


class Verdict(NamedTuple):
    """What became of a mutant: the test that noticed it, or None; and how many were shown it, of how many."""

    mutant: Mutant
    noticed: str | None
    shown: int
    able: int
    seconds: float


class Known(TypedDict):
    """By test: how long it took, and the lines of each file that it executes; and which failed."""

    seconds: dict[str, float]
    failed: list[str]
    lines: dict[str, dict[str, list[int]]]


class Map:
    """Which tests execute a line, and how long each takes."""

    def __init__(self, known: Known) -> None:
        # A test that fails by itself tells nothing of a mutant.
        self.seconds = {test: took for test, took in known["seconds"].items() if test not in known["failed"]}
        self._lines = {name: {path: set(those) for path, those in by.items()} for name, by in known["lines"].items()}
        self._breadth = {name: sum(map(len, by.values())) for name, by in self._lines.items()}
        self._of_file: dict[str, list[str]] = {}
        for test in self.seconds:
            self._of_file.setdefault(file_of(test), []).append(test)

    def tests(self, path: str, reach: tuple[int, ...]) -> list[str]:
        """Those that execute one of the lines, or any of the file's where none is given; the narrowest first.

        What only one test of a file executes, or the file itself when it is imported, may be a result that is kept
        for the others: then the whole file counts.
        """
        found: dict[str, list[str]] = {}
        for name, by in self._lines.items():
            if path in by and (not reach or not by[path].isdisjoint(reach)):
                found.setdefault(file_of(name), []).append(name)
        able = {
            test
            for file, names in found.items()
            for test in (self._of_file.get(file, []) if len(names) == 1 or file in names else names)
            if test in self.seconds
        }
        return sorted(able, key=lambda test: (self._breadth.get(test, 0) * (self.seconds[test] + 0.02), test))


def watch(tree: Path, tests: list[str], jobs: int) -> Known:
    """Run the tests in a copy of the tree, and say which lines each executes."""
    files = tests or sorted(path.relative_to(tree).as_posix() for path in (tree / "tests").rglob("test_*.py"))
    running = []
    for number in range(min(jobs, len(files))):
        out, log = (tree.with_name(f"watched-{number}.{kind}") for kind in ("json", "log"))
        running.append((begin(tree, files[number::jobs], Watch(out), log), out, log))
    whole: Known = {"seconds": {}, "failed": [], "lines": {}}
    for process, out, log in running:
        end(process, math.inf)
        if not out.exists():
            raise SystemExit(log.read_text())
        part: Known = json.loads(out.read_text())
        whole["seconds"] |= part["seconds"]
        whole["failed"] += part["failed"]
        whole["lines"] |= part["lines"]
    return whole


def copy_tree(folder: Path) -> Path:
    return Path(shutil.copytree(ROOT, folder / "tree", ignore=shutil.ignore_patterns(*_LEFT_BEHIND)))


class _Worker:
    """What each process keeps: a tree of its own, in which one change at a time is made."""

    tree: Path
    known: Map

    @classmethod
    def prepare(cls, tree: Path, known: Map) -> None:
        cls.tree = Path(shutil.copytree(tree, tree.with_name(f"tree-{os.getpid()}")))
        cls.known = known
        # Python would take a kept bytecode of the same second and size for that of the changed source.
        sys.dont_write_bytecode = True

    @classmethod
    def try_out(cls, mutant: Mutant) -> Verdict:
        begun = time.perf_counter()
        path = cls.tree / mutant.path
        source, before = path.read_bytes(), path.stat()
        changed = mutant.change.made(source)
        assert changed is not None
        able = cls.known.tests(mutant.path, mutant.change.reach)
        noticed, shown, spent = None, 0, 0.0
        path.write_bytes(changed)
        try:
            for go in goes(able, cls.known.seconds):
                shown += len(go)
                noticed = cls._show(go)
                # By what they took when they were watched: a busy machine shows a mutant as many.
                spent += sum(cls.known.seconds[test] for test in go)
                if noticed or spent > PATIENCE:
                    break
        finally:
            path.write_bytes(source)
            os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
        return Verdict(mutant, noticed, shown, len(able), time.perf_counter() - begun)

    @classmethod
    def _show(cls, tests: list[str]) -> str | None:
        """Run these tests; what noticed the change, None where they pass."""
        limits = {test: 10.0 + 3.0 * cls.known.seconds[test] for test in tests}
        out, log = (cls.tree.with_name(f"{cls.tree.name}.{kind}") for kind in ("txt", "log"))
        out.unlink(missing_ok=True)
        files = list(dict.fromkeys(map(file_of, tests)))
        status = end(begin(cls.tree, files, Show(limits, out), log), WAITING * (60.0 + sum(limits.values())))
        if status == 0:
            return None
        return out.read_text() if out.exists() else f"pytest ended with {status}: {log.read_text()[-200:]}"


def goes(tests: list[str], seconds: dict[str, float]) -> Iterator[list[str]]:
    """The tests in parts, each of which takes twice as long as the one before."""
    part: list[str] = []
    room = limit = FIRST_GO
    for test in tests:
        part.append(test)
        room -= seconds[test]
        if room <= 0.0:
            yield part
            part, limit = [], 2.0 * limit
            room = limit
    if part:
        yield part


def layer_of(path: str) -> str:
    return max((layer for layer in LAYERS if path.startswith(LAYERS[layer] + "/")), key=lambda each: len(LAYERS[each]))


def mutants(layers: list[str], count: int, seed: int) -> list[Mutant]:
    """As many changes, drawn from all that there are: the same number in each layer."""
    chosen = []
    for layer in layers:
        files = [path.relative_to(ROOT).as_posix() for path in sorted((ROOT / LAYERS[layer]).rglob("*.py"))]
        chosen += drawn([path for path in files if layer_of(path) == layer], count // len(layers), f"{seed} {layer}")
    return chosen


def drawn(places: list[str], count: int, seed: str) -> list[Mutant]:
    """As many of the changes to these files, or to single lines of them, given as FILE:LINE."""
    every = []
    for place in places:
        path, _, line = place.partition(":")
        changes = sites((ROOT / path).read_bytes())
        every += [Mutant(layer_of(path), path, change) for change in changes if line in ("", str(change.line))]
    random.Random(seed).shuffle(every)
    real = (one for one in every if one.change.made((ROOT / one.path).read_bytes()) is not None)
    return [one for _, one in zip(range(count), real, strict=False)]


def tell(verdict: Verdict, verbose: bool) -> None:
    mutant, shown = verdict.mutant, f"{verdict.shown} of {verdict.able} tests"
    what = f"{mutant.path}:{mutant.change.line}: {mutant.change}"
    if verdict.noticed is None:
        print(f"MISSED {what}   ({shown}, {verdict.seconds:.0f} s)", flush=True)
    elif verbose:
        print(f"noticed {what}   ({verdict.noticed}, {verdict.seconds:.0f} s)", flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--layer", choices=LAYERS, action="append", help="only this layer; may be given again")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--at", nargs="+", default=[], metavar="FILE[:LINE]", help="changes here alone")
    parser.add_argument("--tests", nargs="+", default=[], metavar="FILE", help="look at these tests alone")
    parser.add_argument("--map", type=Path, help="take what the tests execute from this file, or keep it there")
    parser.add_argument("--verbose", action="store_true", help="tell of the changes that are noticed too")
    options = parser.parse_args()
    if options.at:
        tried = drawn(options.at, options.count, str(options.seed))
    else:
        tried = mutants(options.layer or list(LAYERS), options.count, options.seed)
    begun, verdicts = time.perf_counter(), []
    with tempfile.TemporaryDirectory(prefix="mutants-", ignore_cleanup_errors=True) as folder:
        tree = copy_tree(Path(folder))
        if options.map and options.map.exists():
            reached: Known = json.loads(options.map.read_text())
            # Leaves the bytecode of the tests, which each run would else make again.
            end(begin(tree, ["--collect-only", *options.tests], Show({}, tree / "none"), tree / "log"), math.inf)
        else:
            reached = watch(tree, options.tests, options.jobs)
        if options.map:
            options.map.write_text(json.dumps(reached))
        watched = time.perf_counter() - begun
        # Its processes may have children of their own, which tests of many processes need.
        with ProcessPoolExecutor(options.jobs, initializer=_Worker.prepare, initargs=(tree, Map(reached))) as pool:
            for done in as_completed([pool.submit(_Worker.try_out, mutant) for mutant in tried]):
                verdicts.append(done.result())
                tell(verdicts[-1], options.verbose)
    for layer in LAYERS:
        those = [verdict for verdict in verdicts if verdict.mutant.layer == layer]
        if those:
            noticed = sum(verdict.noticed is not None for verdict in those)
            print(f"{layer:8} {noticed:4} of {len(those)} noticed, {100.0 * noticed / len(those):.1f} %")
    spent = time.perf_counter() - begun - watched
    print(f"{watched:.0f} s to watch the tests, {spent / max(1, len(verdicts)):.1f} s for a change")
    return 0 if all(verdict.noticed for verdict in verdicts) else 1


if __name__ == "__main__":
    sys.exit(main())
