"""How often an eight-ball break succeeds, by where it is played from: `python -m benchmarks.breaks`.

Professionals pocketed a ball and did not foul in 82 of 124 breaks, 66 of 100, on a Diamond table of 7 feet whose
corner pockets were some 4 1/16 in wide (AtLarge's break statistics of the Ultimate Pool USA Colorado Shootout,
September 2024, on azbilliards.com). Here a hand that errs a little breaks as hard as they do, from the middle of the
head string and from beside the long cushion, at the ball in front. It succeeds where a ball falls and the cue ball
does not.
"""

from __future__ import annotations

import argparse
import math
import random
from collections.abc import Mapping
from dataclasses import replace
from multiprocessing import Pool
from typing import NamedTuple

from pool2d import Shot, Table, load_table, simulate
from pool2d.physics.values import POCKETED

INCH = 0.0254
CORNER = {"corner.mouth": 4.0625 * INCH}
# From the middle of the head string, or so far from the long cushion, m.
PLACES = {"middle": None, "cushion": 0.15}
# Degrees by which the aim errs, and the speed of the cue ball, m/s: 20 miles an hour, and by how much it errs.
_AIM, _SPEED, _VARIES = 0.3, 9.0, 0.4


class Break(NamedTuple):
    """What came of a break: how many balls fell beside the cue ball, and whether that fell."""

    fell: int
    scratch: bool

    @property
    def succeeded(self) -> bool:
        return self.fell > 0 and not self.scratch


def break_of(table: Table, place: float | None, gap: float | None, seed: int) -> Break:
    """One break of a rack with this gap between its balls, m, or the preset's own, by a hand that errs."""
    rng = random.Random(f"break {seed}")
    rack = table.furniture.racks["eight-ball"]
    layout = table.rack("eight-ball", seed, rack if gap is None else replace(rack, gap=gap))
    cue = layout["cue"]
    y = 0.5 * table.knobs.table.width if place is None else place
    layout = table.settle(layout.put(cue._replace(y=y)))
    front = min((ball for ball in layout.values() if ball.id != "cue"), key=lambda ball: ball.x)
    aim = math.degrees(math.atan2(front.y - y, front.x - cue.x))
    shot = Shot(angle=rng.gauss(aim, _AIM), speed=rng.gauss(_SPEED, _VARIES))
    end = simulate(table, layout, shot).layout()
    fell = [ball.id for ball in end.values() if ball.phase == POCKETED]
    return Break(len(fell) - ("cue" in fell), "cue" in fell)


def _job(job: tuple[str, Mapping[str, float | str], float | None, float | None, int]) -> Break:
    name, knobs, place, gap, seed = job
    return break_of(load_table(name, knobs), place, gap, seed)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--table", default="pool-7ft", help="a preset (pool-7ft), given such corner pockets")
    parser.add_argument("--breaks", type=int, default=200, help="breaks from each place (200)")
    parser.add_argument("--gaps", type=float, nargs="+", metavar="MM", help="between balls; the preset's own")
    parser.add_argument("--set", action="append", default=[], metavar="KNOB=VALUE", help="a knob of the table")
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args()
    knobs = {**CORNER, **{name: float(value) for name, _, value in (entry.partition("=") for entry in arguments.set)}}
    gaps = [None] if arguments.gaps is None else [gap / 1000.0 for gap in arguments.gaps]
    print(f"{'from':10}{'gap, mm':>9}{'balls':>8}{'some fall':>11}{'scratch':>9}{'success':>9}{'+-':>5}  of 100")
    with Pool(arguments.jobs) as pool:
        for where, place in PLACES.items():
            for gap in gaps:
                jobs = [(arguments.table, knobs, place, gap, seed) for seed in range(arguments.breaks)]
                played = pool.map(_job, jobs)
                count = len(played)
                good = sum(one.succeeded for one in played) / count
                print(
                    f"{where:10}{'own' if gap is None else f'{1000.0 * gap:g}':>9}"
                    f"{sum(one.fell for one in played) / count:8.2f}"
                    f"{100.0 * sum(one.fell > 0 for one in played) / count:11.0f}"
                    f"{100.0 * sum(one.scratch for one in played) / count:9.0f}"
                    f"{100.0 * good:9.0f}{100.0 * math.sqrt(good * (1.0 - good) / count):5.0f}",
                    flush=True,
                )


if __name__ == "__main__":
    main()
