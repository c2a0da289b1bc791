"""What a benchmark asks of the machine it runs on: how fast it is at this moment, and what a process has held."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable

# The steps of the loop that times are told in.
STEPS = 1_000_000


def took(work: Callable[[], object]) -> float:
    """The time of the processor that some work takes, s."""
    start = time.process_time()
    work()
    return time.process_time() - start


def loop() -> float:
    """The time of the processor that STEPS additions of floats take just now, s."""
    return took(_steps)


def _steps() -> float:
    total = 0.0
    for _ in range(STEPS):
        total += 1.0
    return total


def memory() -> float:
    """The most memory that this process has held, MiB; where the system does not say, 0."""
    try:
        import resource
    except ImportError:
        return 0.0
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return float(most) / (1 << 20 if sys.platform == "darwin" else 1 << 10)
