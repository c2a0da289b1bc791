"""Whether the same shots end in the same bits: `python -m benchmarks.bits [--shots N] [--against PYTHON ...]`.

Prints one digest over the rollouts of N random shots, played on every preset in turn. Each further interpreter named,
one that has pool2d's dependencies, plays them too; the exit status is 1 where a digest differs. One machine only:
the last bits of a sine are its C library's.
"""

from __future__ import annotations

import argparse
import hashlib
import platform
import subprocess
import sys

from pool2d import load_table, simulate
from pool2d.table.preset import presets

from .fuzz import scene


def digest(shots: int) -> str:
    """One digest of them all."""
    tables = [load_table(name) for name in presets()]
    sha = hashlib.sha256()
    for number in range(shots):
        table = tables[number % len(tables)]
        sha.update(simulate(table, *scene(table, f"bits {number}")).digest().encode())
    return sha.hexdigest()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--shots", type=int, default=500)
    parser.add_argument("--against", nargs="*", default=[], metavar="PYTHON")
    options = parser.parse_args()
    lines = [f"{platform.python_version()} {digest(options.shots)}"]
    for python in options.against:
        command = [python, "-m", "benchmarks.bits", "--shots", str(options.shots)]
        lines.append(subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip())
    print("\n".join(lines))
    return int(len({line.split()[1] for line in lines}) > 1)


if __name__ == "__main__":
    sys.exit(main())
