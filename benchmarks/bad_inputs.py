"""Bad files by the thousand: whatever they hold, an answer of one line within a second.

    python -m benchmarks.bad_inputs --inputs 10000

Good presets, conditions, scenarios, studies and their results, positions, records, settings, drills, players and best
results are spoiled: cut, noise put in, lines lost or repeated, values put in place of others. Each goes through the
command line or the reader that the window uses. Nothing but InputError may come of it: a status of 0, 1 or 2, no more
than one line of complaint, and nothing printed that a terminal would obey.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import json
import os
import random
import re
import sys
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from pool2d import Ball, InputError, Layout, Shot, load_table, simulate_many
from pool2d.cli import main as command
from pool2d.config.catalogue import CONDITIONS, DRILLS, PLAYERS, TABLES, find, shipped
from pool2d.config.settings import Store
from pool2d.game.actions import Concede, Stroke
from pool2d.game.drills import best_results, drill_file
from pool2d.game.match import Match
from pool2d.game.records.record import seal
from pool2d.game.records.recorder import record
from pool2d.game.rules.report import Call
from pool2d.game.setup import Setup
from pool2d.opponent.player_file import load_player
from pool2d.study.results import Results, header
from pool2d.study.study_file import load_study
from pool2d.table.position_text import write

_STUDY = b"""rack = "nine-ball"
seed = 3
[shot]
speed = 8.0
[grid]
angle = { from = -1.0, to = 1.0, count = 5 }
side = [-0.1, 0.0, 0.1]
[noise]
speed = 0.2
[study]
shots = 10
seed = 1
map = ["angle", "speed"]
outcome = "potted.9"
"""
# In processor time, s, so that a busy machine is no fault.
_SLOW = 1.0
_WORDS = (
    "nan", "inf", "-1", "0", "1e300", "true", "null", "'x'", '""', "[]", "{}", "[[]]", "[1, 2]", "[nan, 1]",
    "{ a = 1 }", "1979-05-27", "9" * 30, "0x" + "f" * 4000, "1" + "0" * 400, "9" * 5000, "[" * 60 + "]" * 60,
    '"' + "x" * 50_000 + '"',
    '"a\\u0000b"', '"\\u202eabc"', '"\\u200b"', '"\\u001b[2J"', '"\\ud800"', '"  "', '"pool-9ft"', '"cue"',
    '"none.toml"',
    '"cue@1,1 cue@1,1"', '"x cue@0.6,0.6 1@0.6,0.6"', '"a=1 a=1"', '"cue:nan,1"', '"cue@1,1,r9"', '"%00@1,1"', "1e-320",
)  # fmt: skip
_TEXTS = ("\0", "\x1b[31m", "\u202e", "\u200b", "\n", " ", "=", "@", ":", ",", "!", "%ff", "%00", "+", "9" * 400, "nan")


class Fault(NamedTuple):
    """An input that was not answered as it should be."""

    kind: str
    content: bytes
    what: str


def spoiled(content: bytes, rng: random.Random) -> bytes:
    """A file with some of it cut, overwritten, lost, repeated, or given other values."""
    way, at = rng.randrange(7), rng.randrange(len(content))
    if way == 0:
        return content[:at]
    if way == 1:
        return content[:at] + rng.randbytes(rng.randrange(1, 8)) + content[at + rng.randrange(8) :]
    if way == 2:
        return content[:at] + rng.choice(_TEXTS).encode() + content[at:]
    lines = content.split(b"\n")
    row = rng.randrange(len(lines))
    if way == 3:
        return b"\n".join(lines[:row] + lines[row + rng.randrange(1, 4) :])
    if way == 4:
        return b"\n".join([*lines, *lines[row : row + rng.randrange(1, 9)]])
    # A value, or a key, of TOML or of JSON.
    values = list(re.finditer(rb'(?<=[=:\[,])\s*("[^"\n]*"|[-+.\w]+)', content)) or list(re.finditer(rb"\S+", content))
    for match in sorted(rng.sample(values, min(len(values), rng.randrange(1, 4))), key=lambda one: -one.start()):
        content = content[: match.start()] + b" " + rng.choice(_WORDS).encode() + content[match.end() :]
    return content


def resealed(content: bytes) -> bytes:
    """A record with good sums, so that what its lines hold is looked at."""
    total, lines = "", []
    for line in content.split(b"\n"):
        try:
            body = json.loads(line)
            body.pop("sum", None)
            sealed, total = seal(body, total)
        except (ValueError, AttributeError, TypeError, RecursionError):
            sealed = line + b"\n"
        lines.append(sealed)
    return b"".join(lines)


class Inputs:
    """Good inputs of every kind, and what takes each of them; files are written below `folder`."""

    def __init__(self, folder: Path, rng: random.Random) -> None:
        self.folder = folder
        self.rng = rng
        self.table = table = load_table("pool-9ft")
        self.layout = Layout([Ball("cue", 0.6, 0.6), Ball("1", 1.9, 0.6)])
        self.position = write(table.rack("nine-ball", 1), Shot(angle=3.0, speed=4.0), table)
        self.takers: dict[str, tuple[str, list[bytes], Callable[[Path], int]]] = {
            "preset": (".toml", self._files(TABLES), lambda path: command(["tables", "--check", str(path)])),
            "shown": (".toml", self._files(TABLES), lambda path: command(["tables", str(path)])),
            "conditions": (".toml", self._files(CONDITIONS), self._condition),
            "scenario": (".toml", self._scenarios(), self._simulate),
            "json": (".json", [json.dumps(table.scenario(table.rack("nine-ball"), Shot())).encode()], self._simulate),
            "study": (".toml", [_STUDY], self._study),
            "results": (".csv", [self._results()], self._go_on),
            "position": (".txt", [self.position.encode()], self._position),
            "record": (".jsonl", [self._record()], self._replay),
            "settings": (".toml", [_SETTINGS], self._settings),
            "drill": (".toml", self._files(DRILLS), self._drill),
            "player": (".toml", self._files(PLAYERS), self._player),
            "best": (".json", [b'{"stop-shot": 3, "draw": 5}'], self._best),
        }

    def one(self) -> tuple[str, Path, Callable[[Path], int]]:
        """A kind of input, a spoiled file of it, and what takes it."""
        kind = self.rng.choice(list(self.takers))
        ending, good, take = self.takers[kind]
        content = spoiled(self.rng.choice(good), self.rng)
        if kind == "record" and self.rng.random() < 0.7:
            content = resealed(content)
        path = self.folder / f"input{ending}"
        path.write_bytes(content)
        return kind, path, take

    def _files(self, folder: str) -> list[bytes]:
        return [find(folder, name).read_bytes() for name in shipped(folder)]

    def _scenarios(self) -> list[bytes]:
        ball = '[[balls]]\nid = "{}"\nx = {}\ny = 0.6\n'
        plain = ball.format("cue", 0.6) + ball.format("1", 1.9) + '[shot]\nangle = 1\nspeed = 3.0\nball = "cue"\n'
        told = f'position = "{self.position}"\nset = {{ "cloth.mu_roll" = 0.02 }}\nconditions = ["heated"]\n'
        return [plain.encode(), told.encode()]

    def _results(self) -> bytes:
        path = self.folder / "good.csv"
        with Results(path, self._nothing(), "abc") as results:
            results.add(simulate_many(self.table, self.layout, [Shot(speed=1.0), Shot(ball="9"), Shot(angle=30.0)]))
        return path.read_bytes()

    def _nothing(self) -> tuple[str, ...]:
        return header(simulate_many(self.table, self.layout, []))

    def _record(self) -> bytes:
        path = self.folder / "good.jsonl"
        match = Match(load_table("pool-9ft"), Setup("nine-ball", names=("Ann", "Bo"), breaker=0, seed=2))
        with record(match, path) as recorder:
            recorder.play(Stroke(Shot(angle=0.5, speed=7.0), Call(push=False)))
            recorder.undo()
            recorder.redo()
            recorder.play(Concede(match.ask.player))
        return path.read_bytes()

    def _condition(self, path: Path) -> int:
        return command(["tables", "pool-9ft", "--conditions", str(path)])

    def _simulate(self, path: Path) -> int:
        return command(["simulate", "--events", "5", str(path)])

    def _study(self, path: Path) -> int:
        next(load_study(path, {}, []).sweep.shots())
        return 0

    def _go_on(self, path: Path) -> int:
        with Results(path, self._nothing(), "abc"):
            return 0

    def _position(self, path: Path) -> int:
        words = path.read_bytes().decode("utf-8", "surrogateescape")
        return command(["simulate", "--events", "5", "--position", words])

    def _replay(self, path: Path) -> int:
        return command(["replay", str(path), self.rng.choice(["--list", "--verify"])])

    def _settings(self, path: Path) -> int:
        store = Store(path)
        for error in store.complaints:
            print(error)
        store.save()
        return 0

    def _drill(self, path: Path) -> int:
        drill_file.load(str(path))
        return 0

    def _player(self, path: Path) -> int:
        load_player(str(path))
        return 0

    def _best(self, path: Path) -> int:
        place = Path(os.environ["POOL2D_DATA"]) / DRILLS / "best.json"
        place.parent.mkdir(parents=True, exist_ok=True)
        os.replace(path, place)
        best_results.best("draw")
        best_results.keep("draw", 6)
        return 0


def tried(kind: str, path: Path, take: Callable[[Path], int]) -> tuple[int, float, str]:
    """The exit status, the time of the processor, s, and what was wrong with the answer, or nothing."""
    out, err, wrong, status = io.StringIO(), io.StringIO(), "", 2
    start = time.process_time()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            status = take(path)
        except InputError as error:
            print(error, file=err)
        except SystemExit:
            wrong = "the program would end"
        except BaseException:
            wrong = traceback.format_exc(limit=-3)
    took = time.process_time() - start
    said = err.getvalue()
    if not wrong and status not in (0, 1, 2):
        wrong = f"exit status {status}"
    if not wrong and (said.count("\n") != (status == 2) or (status == 0 and said)):
        wrong = f"exit status {status} with {said.count(chr(10))} lines of complaint"
    if not wrong and not all(line.isprintable() for line in (out.getvalue() + said).split("\n")):
        wrong = "what was printed would steer a terminal"
    if not wrong and took > _SLOW:
        wrong = f"{took:.1f} s"
    return status, took, wrong


def run(inputs: int, seed: int) -> tuple[list[Fault], Counter[str], float]:
    """The faults, how many inputs there were of each kind and status, and the longest time, s."""
    faults: list[Fault] = []
    seen: Counter[str] = Counter()
    longest = 0.0
    kept = dict(os.environ)
    with tempfile.TemporaryDirectory() as name:
        os.environ.update(POOL2D_DATA=f"{name}/data", POOL2D_CONFIG=f"{name}/config", POOL2D_CACHE=f"{name}/cache")
        try:
            rng = random.Random(seed)
            given = Inputs(Path(name), rng)
            for _ in range(inputs):
                kind, path, take = given.one()
                content = path.read_bytes()
                status, took, wrong = tried(kind, path, take)
                longest = max(longest, took)
                seen[f"{kind}, status {status}"] += 1
                if wrong:
                    faults.append(Fault(kind, content, wrong))
        finally:
            os.environ.clear()
            os.environ.update(kept)
    return faults, seen, longest


_SETTINGS = b"""[aiming]
guide = "line"
[sound]
volume = 0.5
mute = true
[players]
first = "Ann"
[keys]
guide = ["H", "Ctrl+G"]
[later]
x = 1
"""


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--inputs", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    faults, seen, longest = run(arguments.inputs, arguments.seed)
    for kind, content, what in faults[:20]:
        print(f"{kind}: {content[:300]!r}\n  {what}", file=sys.stderr)
    for name in sorted(seen):
        print(f"{name:24} {seen[name]}")
    print(f"{arguments.inputs} inputs, {len(faults)} faults; the longest took {longest:.2f} s of the processor")
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main())
