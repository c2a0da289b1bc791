"""How long each preset takes to open: `python -m benchmarks.presets`.

Prints the median and the longest time of reading the file with its bases and building the table.
"""

from __future__ import annotations

import statistics
import time

from pool2d import load_table
from pool2d.table.preset import presets

_TIMES = 30


def main() -> None:
    for name in presets():
        times = []
        for _ in range(_TIMES):
            start = time.perf_counter()
            load_table(name)
            times.append(1e3 * (time.perf_counter() - start))
        print(f"{name:<20} {statistics.median(times):6.2f} ms median, {max(times):6.2f} ms longest")


if __name__ == "__main__":
    main()
