"""Finds strokes that reach the goals of drills: `python -m benchmarks.solve [--tries N] [NAME ...]`.

A drill file holds a solution, which the tests play. When the physics changes, this finds others: strokes by dice
round the line of each pot, of which the steadiest is taken, and the one that leaves the next ball best. Prints a
`solution` for the file; the exit status is 1 where none was found.
"""

from __future__ import annotations

import argparse
import math
import random
import sys
from collections.abc import Iterator, Sequence
from dataclasses import replace

from benchmarks.matches import way
from pool2d import BudgetError, Shot, simulate
from pool2d.game.drills.drill import ANY, Drill, Standing, judge, start
from pool2d.game.drills.drill_file import drills, load
from pool2d.physics.values import Ball
from pool2d.table.position_text import write_shot

# Of so many strokes that do it, the best is taken.
FEW = 4
# How much a hand shakes: degrees, and a part of the speed.
SHAKES = [(0.02, 0.0), (-0.02, 0.0), (0.0, 0.01), (0.0, -0.01), (0.05, 0.01), (-0.05, -0.01)]
Found = tuple[float, Shot, Standing]


def after(drill: Drill, standing: Standing, shot: Shot) -> Standing:
    """What a stroke makes of an attempt; one that never ends ends it."""
    try:
        return judge(drill, standing, simulate(drill.table, standing.layout, shot))
    except BudgetError:
        return standing._replace(over=True)


def wanted(drill: Drill, standing: Standing, name: str) -> list[Ball]:
    """The balls on the table that a step names."""
    balls = [ball for ball in standing.layout.on_table() if ball.id != drill.table.furniture.cue]
    group = drill.table.furniture.groups.get(name, (name,))
    return balls if name in ("", ANY) else [ball for ball in balls if ball.id in group]


def lines(drill: Drill, standing: Standing) -> list[tuple[float, float]]:
    """How thin the cut of each pot is that the next step may be, and the angle of the stroke; the fullest first."""
    step, cue = drill.steps[standing.done], standing.layout[drill.table.furniture.cue]
    return sorted(
        way(drill.table, cue, ball, pocket.x, pocket.y)
        for ball in wanted(drill, standing, step.pot)
        for pocket in drill.table.geometry.pockets
        if step.pocket in ("", pocket.name)
    )


def guesses(drill: Drill, standing: Standing, rng: random.Random) -> Iterator[Shot]:
    """Strokes that may do the next step, without end."""
    step, cue = drill.steps[standing.done], standing.layout[drill.table.furniture.cue]
    direct = bool(step.pot) and step.pot != ANY and not step.banks and step.first in ("", step.pot)
    best = [angle for cut, angle in lines(drill, standing) if cut < 75.0][:4] if direct else []
    targets = wanted(drill, standing, step.first or step.pot)
    while True:
        if best:
            angle = rng.choice(best) + rng.gauss(0.0, 0.5)
        elif (step.rails and rng.random() < 0.7) or not targets:
            angle = rng.uniform(-180.0, 180.0)
        else:
            ball = rng.choice(targets)
            half = math.asin(min(1.0, drill.table.touch(cue, ball) / math.dist((cue.x, cue.y), (ball.x, ball.y))))
            angle = math.degrees(math.atan2(ball.y - cue.y, ball.x - cue.x) + half * rng.uniform(-1.0, 1.0))
        if step.over:
            # What has to fly over a ball is struck from well above, without english.
            speed, elevation, jump = rng.uniform(2.0, 6.0), rng.uniform(25.0, 70.0), rng.random() < 0.7
            yield Shot(round(angle, 3), round(speed, 2), 0.0, 0.0, round(elevation, 1), cue.id, jump=jump)
            continue
        side, height = (rng.choice([0.0, rng.uniform(-0.4, 0.4)]) for _ in range(2))
        speed = math.exp(rng.uniform(math.log(0.7), math.log(9.0)))
        yield Shot(round(angle, 3), round(speed, 3), round(side, 2), round(height, 2), ball=cue.id)


def steady(drill: Drill, standing: Standing, shot: Shot) -> float:
    """How many of a few shaken strokes do it too, as a part of them."""
    shaken = (replace(shot, angle=shot.angle + turn, speed=shot.speed * (1.0 + more)) for turn, more in SHAKES)
    return sum(after(drill, standing, one).done > standing.done for one in shaken) / len(SHAKES)


def worth(drill: Drill, standing: Standing, shot: Shot, then: Standing) -> float:
    """How good a stroke is that does the step: steady, and with a full pot next."""
    value = 2.0 * steady(drill, standing, shot)
    if then.over or drill.steps[then.done].layout is not None or not drill.steps[then.done].pot:
        return value
    return value - min((cut for cut, _ in lines(drill, then)), default=90.0) / 45.0


def solve(drill: Drill, rng: random.Random, tries: int) -> list[Shot]:
    """Strokes from the start to the goal; none where they were not found."""
    standing, shots = start(drill), list[Shot]()
    while standing.done < drill.goal:
        found: list[Found] = []
        for shot, _ in zip(guesses(drill, standing, rng), range(tries), strict=False):
            then = after(drill, standing, shot)
            if then.done > standing.done:
                found.append((worth(drill, standing, shot, then), shot, then))
                if len(found) == FEW:
                    break
        if not found:
            return []
        _, shot, standing = max(found, key=lambda one: one[0])
        shots.append(shot)
    return shots


def main(names: Sequence[str], tries: int, again: int) -> int:
    status = 0
    for name in names:
        drill = load(name)
        solutions = (solve(drill, random.Random(f"{name} {seed}"), tries) for seed in range(again))
        solution = next((shots for shots in solutions if shots), [])
        status |= not solution
        print(f"{name}: solution = {[write_shot(shot) for shot in solution]}".replace("'", '"'), flush=True)
    return status


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--tries", type=int, default=1500, help="strokes tried for each step")
    parser.add_argument("--again", type=int, default=8, help="attempts at a drill")
    chosen = parser.parse_args()
    sys.exit(main(chosen.names or drills(), chosen.tries, chosen.again))
