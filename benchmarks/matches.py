"""Random matches through the engine and the rules: `python -m benchmarks.matches --games all --matches 200`.

A player who aims at a ball and a pocket with an unsteady hand, and sometimes anywhere or to jump, plays each game. A
match has to end with a winner or, where it is given up after many strokes, in a legal state: the balls stand
where they may, the balls on are on the table, what is asked can be answered, the state comes back from JSON.
Prints a line per game; the exit status is 1 where a match failed.
"""

from __future__ import annotations

import argparse
import json
import math
import random
import sys
import time
import traceback
from collections.abc import Iterator
from dataclasses import dataclass, field
from multiprocessing import Pool
from typing import Any

from pool2d import Shot, Table, load_table, simulate
from pool2d.config.knobs import walk
from pool2d.game.referee import observe
from pool2d.game.rules import AIM, CHOOSE, GAMES, OVER, PLACE, Choice, Rules, Ruling, game, games_for, label, say
from pool2d.game.rules.report import Call
from pool2d.game.rules.spotting import may_place
from pool2d.physics.values import GONE, Ball, Layout

TABLES = ("pool-9ft", "snooker-12ft", "carom-10ft", "english-7ft", "pyramid-12ft")
# Games to a score are played to less, so that they end.
SHORT = {
    "straight": {"target": 8.0},
    "three-cushion": {"points": 2.0},
    "straight-rail": {"points": 3.0},
    "four-ball": {"points": 3.0},
}
# After so many strokes a match is given up.
STROKES = 300
# How many of the strokes are played with a raised butt.
RAISED = 0.15
# Practice never ends.
PRACTICE = "practice"
LIMITS = {PRACTICE: 50}


@dataclass
class Result:
    """A match: its winner, None where it was given up; strokes, faults, and how long each ruling took, s."""

    game: str
    seed: int
    winner: int | None = None
    strokes: int = 0
    faults: list[str] = field(default_factory=list)
    rulings: list[float] = field(default_factory=list)


def table_for(name: str) -> Table:
    """A shipped table on which a game can be played."""
    return next(table for table in map(load_table, TABLES) if name in games_for(table))


def play(name: str, seed: int, strokes: int = STROKES) -> Result:
    """One match, by dice."""
    strokes = min(strokes, LIMITS.get(name, strokes))
    rng = random.Random(f"{name} {seed}")
    table = table_for(name)
    rules = game(name, table, {**drawn(name, rng), **SHORT.get(name, {})})
    result = Result(name, seed)
    ruling = rules.start(seed % rules.players, seed)
    result.faults += faults(rules, ruling)
    # A table that is cleared in practice stays so.
    while (
        ruling.ask.kind != OVER
        and result.strokes < strokes
        and not result.faults
        and any(ball.id != table.furniture.cue for ball in ruling.layout.on_table())
    ):
        ask, state, layout = ruling.ask, ruling.state, ruling.layout
        if ask.kind == AIM:
            shot, call = stroke(table, ruling, rng)
            rollout = simulate(table, layout, shot)
            report, layout = observe(table, rollout, call, shot.ball), rollout.layout()
            result.strokes += 1
            begun = time.thread_time()
            ruling = rules.judge(state, layout, report)
            result.rulings.append(time.thread_time() - begun)
            if rules.judge(state, layout, report) != ruling:
                result.faults.append("two rulings on one shot differ")
        else:
            choice = place(table, ruling, rng) if ask.kind == PLACE else Choice(rng.choice(ask.options))
            ruling = rules.choose(state, layout, choice)
        result.faults += faults(rules, ruling)
    result.winner = ruling.state.winner
    return result


def drawn(name: str, rng: random.Random) -> dict[str, object]:
    """Options of a game, by dice: those that are one of a few."""
    knobs = walk(GAMES[name].options_type())
    return {option: rng.choice(knob.choices) for option, knob, _ in knobs if knob.choices}


def stroke(table: Table, ruling: Ruling, rng: random.Random) -> tuple[Shot, Call]:
    """A shot at the easiest of a few balls and pockets, or anywhere, and what is called."""
    ask, layout = ruling.ask, ruling.layout
    struck = rng.choice(ask.cues) if ask.cues else ask.ball
    balls = [layout[ball] for ball in ask.on] or layout.on_table()
    on = [ball for ball in balls if ball.id != struck]
    cue, speed = layout[struck], rng.uniform(1.0, 6.0)
    if not ruling.state.shots:
        speed = rng.uniform(7.0, 10.0)
    ways = [
        (*way(table, cue, ball, pocket.x, pocket.y), ball, pocket.name)
        for ball in on
        for pocket in table.geometry.pockets
    ]
    if not on:
        # A player who lags after a ball that fell is alone on the table.
        return Shot(angle=rng.uniform(0.0, 360.0), speed=speed, ball=struck), Call()
    if not ways or rng.random() < 0.1:
        target = rng.choice(on)
        angle, ball, pocket = math.degrees(math.atan2(target.y - cue.y, target.x - cue.x)), target, ""
        angle += rng.gauss(0.0, 2.0)
    else:
        _, angle, ball, pocket = min(ways, key=lambda found: found[0])
        angle += rng.gauss(0.0, 0.3)
    call = Call(ball.id if ask.call else "", pocket if ask.call == "pocket" else "")
    for said in ask.may:
        if rng.random() < 0.2:
            call = Call(safety=said == "safety", push=said == "push")
    if rng.random() < RAISED:
        # Balls jump, and some leave the table.
        tip, butt = rng.uniform(-0.7, 0.3), rng.uniform(5.0, 50.0)
        return Shot(angle, rng.uniform(2.0, 9.0), height=tip, elevation=butt, ball=struck), call
    return Shot(angle=angle, speed=speed, ball=struck), call


def way(table: Table, cue: Ball, ball: Ball, x: float, y: float) -> tuple[float, float]:
    """How thin a cut is, in degrees, that sends a ball to a point, and the angle of the shot."""
    touch, far = table.touch(cue, ball), math.hypot(x - ball.x, y - ball.y)
    ghost_x, ghost_y = ball.x - touch * (x - ball.x) / far, ball.y - touch * (y - ball.y) / far
    angle = math.degrees(math.atan2(ghost_y - cue.y, ghost_x - cue.x))
    cut = (angle - math.degrees(math.atan2(y - ball.y, x - ball.x)) + 180.0) % 360.0 - 180.0
    return abs(cut), angle


def place(table: Table, ruling: Ruling, rng: random.Random) -> Choice:
    """Somewhere in the area of the cue ball in hand."""
    size, ask = table.knobs.table, ruling.ask
    while True:
        x, y = rng.uniform(0.0, size.length), rng.uniform(0.0, size.width)
        if may_place(table, ruling.layout, ask.ball, ask.where, x, y):
            return Choice("place", x, y)


def faults(rules: Rules[Any], ruling: Ruling) -> Iterator[str]:
    """Whatever is wrong with a ruling, in words."""
    state, layout, ask = ruling.state, ruling.layout, ruling.ask
    rules.table.settle(layout)
    if rules.state(json.loads(json.dumps(state.as_dict()))) != state:
        yield "the state does not come back from JSON"
    if ask.kind == AIM and layout[ask.ball].phase in GONE:
        yield "the cue ball is not on the table"
    if any(layout[ball].phase in GONE for ball in ask.on):
        yield f"a ball on is off the table: {ask.on}"
    if ask.kind == AIM and not ask.on and len(layout.on_table()) > 1:
        yield "no ball is on"
    if ask.kind == CHOOSE and not ask.options:
        yield "nothing can be chosen"
    if not -1 <= ask.player < rules.players:
        yield f"nobody is number {ask.player}"
    if any(not text for text in (*(say(note) for note in ruling.notes), *(label(key) for key in ask.options))):
        yield "something is not said"
    if balls(layout) != balls(rules.start().layout):
        yield "a ball has gone missing"


def balls(layout: Layout) -> list[str]:
    return sorted(layout)


def attempt(job: tuple[str, int]) -> Result:
    """A match whose errors are faults."""
    try:
        return play(*job)
    except Exception:
        return Result(*job, faults=[traceback.format_exc()])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--games", default="all", help="names of games, with commas; all of them by default")
    parser.add_argument("--matches", type=int, default=20)
    parser.add_argument("--seed", type=int, default=0, help="of the first match")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    names = list(GAMES) if options.games == "all" else options.games.split(",")
    failed = 0
    with Pool(options.jobs) as pool:
        for name in names:
            begun = time.perf_counter()
            jobs = [(name, options.seed + i) for i in range(options.matches)]
            results = list(pool.imap_unordered(attempt, jobs))
            failed += show(name, results, time.perf_counter() - begun)
    return 1 if failed else 0


def show(name: str, results: list[Result], seconds: float) -> int:
    """Print how a game's matches went; how many failed."""
    bad = [result for result in results if result.faults]
    for result in bad:
        print(f"--games {name} --seed {result.seed} --matches 1: {result.faults[0]}")
    rulings = sorted(took for result in results for took in result.rulings) or [0.0]
    wins = [sum(result.winner == player for result in results) for player in (0, 1)]
    middle, high, most = (1e3 * rulings[int(part * (len(rulings) - 1))] for part in (0.5, 0.99, 1.0))
    print(
        f"{name:16} {len(results)} matches, {len(bad)} failed, {sum(wins)} won ({wins[0]} : {wins[1]}),"
        f" {sum(result.strokes for result in results)} strokes, {seconds:.0f} s;"
        f" a ruling took {middle:.3f} ms, 99 of 100 less than {high:.3f} ms, the longest {most:.3f} ms",
        flush=True,
    )
    return len(bad)


if __name__ == "__main__":
    sys.exit(main())
