"""Whether the same shots end in the same bits: `python -m benchmarks.bits [--shots N] [--against PYTHON ...]`.

Prints one digest over the rollouts of N random shots, from number `--first` on, played on every preset in turn. Each
further interpreter named, one that has pool2d's dependencies, plays them too, and so does the interpreted engine where
the compiled one runs; the exit status is 1 where a digest differs. One machine only:
the last bits of a sine are its C library's.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import platform
import subprocess
import sys
from dataclasses import replace

from pool2d import load_table, simulate
from pool2d.compiled import INTERPRETED, engine, is_compiled
from pool2d.table.preset import presets

from .fuzz import scene


def digest(first: int, shots: int, level: bool = False) -> str:
    """One digest of them all; `level` lays every cue level, and has the tip strike once."""
    tables = [load_table(name) for name in presets()]
    sha = hashlib.sha256()
    for number in range(first, first + shots):
        table = tables[number % len(tables)]
        layout, shot = scene(table, f"bits {number}")
        shot = replace(shot, elevation=0.0, easy=True) if level else shot
        sha.update(simulate(table, layout, shot).digest().encode())
    return sha.hexdigest()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--shots", type=int, default=500)
    parser.add_argument("--against", nargs="*", default=[], metavar="PYTHON")
    options = parser.parse_args()
    lines = [f"{platform.python_version()} {engine()} {digest(options.first, options.shots)}"]
    others = [(python, dict(os.environ)) for python in options.against]
    if is_compiled():
        others.append((sys.executable, {**os.environ, INTERPRETED: "1"}))
    for python, environment in others:
        command = [python, "-m", "benchmarks.bits", "--first", str(options.first), "--shots", str(options.shots)]
        done = subprocess.run(command, check=True, capture_output=True, text=True, env=environment)
        lines += done.stdout.splitlines()
    print("\n".join(lines))
    return int(len({line.split()[-1] for line in lines}) > 1)


if __name__ == "__main__":
    sys.exit(main())
