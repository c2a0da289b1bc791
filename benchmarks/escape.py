"""Whether a ball on the cloth ever gets off a table: `python -m benchmarks.escape [--shots N] [--seed S] [NAME ...]`.

Plays random shots on every preset, balls strewn over its cloth, and looks at every event and rest for
what `tests.checks` calls misplaced. Prints a line for each preset, and how to play again what went wrong.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Sequence

from pool2d import BudgetError, Layout, Shot, Table, load_table, simulate
from pool2d.physics.values import GONE
from pool2d.table.preset import presets
from tests.checks import misplaced
from tests.scenes import random_shot


def escapes(table: Table, layout: Layout, shot: Shot | None) -> list[str]:
    """What goes wrong in a shot: balls where none can be, or no end."""
    try:
        roll = simulate(table, layout, shot)
    except BudgetError as error:
        return [str(error)]
    wrong = [
        f"{event.kind} at {event.t} s: {state} is off the table"
        for event in roll.events
        for state in event.after.values()
        if state.z == 0.0 and state.phase not in GONE and not table.on_cloth(state.x, state.y)
    ]
    return wrong + misplaced(table, roll.layout())


def main(names: Sequence[str], shots: int, seed: int) -> int:
    status = 0
    for name in names:
        table = load_table(name)
        start, failed = time.perf_counter(), 0
        for number in range(seed, seed + shots):
            layout, shot = random_shot(table, number, 2 + number % 15)
            wrong = escapes(table, layout, shot)
            if wrong:
                failed += 1
                print(f"{name}, seed {number}: {wrong[0]}; {json.dumps(table.scenario(layout, shot))}", file=sys.stderr)
        print(f"{name:<20} {shots} shots, {failed} failed, {time.perf_counter() - start:.0f} s", flush=True)
        status |= failed > 0
    return status


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--shots", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=0)
    chosen = parser.parse_args()
    sys.exit(main(chosen.names or presets(), chosen.shots, chosen.seed))
