"""Whether the chances that an opponent sees are true: `python -m benchmarks.chances`.

Balls are put down at random, and a pot that lies open is played on the engine at a random pace and with random spin,
again and again with the errors of a hand drawn at random: how often does the ball fall, where `opponent.pot_chance`
gives it so many in a hundred? Only pots count that come off without errors, as players look at no others. Printed are
the pots by what was foretold, the mean square of what was foretold less what came of each stroke (Brier's score), and
its floor, which who knew each pot's true share would have. With `--fit` the constants are found anew, as those that
make what fell likeliest; that needs scipy, of the extra "fit".
"""

from __future__ import annotations

import argparse
import math
import random
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from multiprocessing import Pool
from typing import NamedTuple

import numpy as np

from pool2d import Ball, Event, Layout, Shot, Table, load_table, simulate
from pool2d.opponent.candidates.pots import PACES, spins, stroked
from pool2d.opponent.mouths import mouths, windows
from pool2d.opponent.pot_chance import SPREAD, Spread, strays, within
from pool2d.opponent.pot_lines import PotLine, pot_lines
from pool2d.opponent.stray import Hand, strayed

TABLES = ("pool-9ft", "pool-7ft", "snooker-12ft", "pyramid-12ft")
# Hands from the least to the most, as multiples of the units; each error by itself up to twice more, or less.
LEAST, MOST = 0.2, 4.0
# No chance is nearer to 0 or 1 than this where likelihoods are summed.
_SURE = 0.005


class Tried(NamedTuple):
    """A pot that was played: by whom, half of the pocket's window, and how often it fell of how many times."""

    table: str
    hand: Hand
    radius: float
    half: float
    line: PotLine
    shot: Shot
    fell: int
    runs: int

    def foretold(self, fitted: Spread = SPREAD) -> float:
        """The chance that the model gives it."""
        spread = strays(self.hand, self.radius, np.array(self.line.lead), np.array(self.line.cut), fitted)
        return within(self.half, float(spread))

    @property
    def share(self) -> float:
        return self.fell / self.runs


def tried(index: int, seed: int = 0, runs: int = 50) -> Tried:
    """The pot of a number."""
    rng = random.Random(f"chances {seed} {index}")
    name = TABLES[index % len(TABLES)]
    table = _table(name)
    while True:
        layout, hand = _balls(table, rng), _hand(rng)
        found = _pot(table, layout, hand, rng)
        if found is not None:
            line, shot = found
            fell = sum(_falls(table, layout, strayed(table, layout, shot, hand, rng), line) for _ in range(runs))
            return Tried(name, hand, table.knobs.ball.radius, _half(table, layout, line), line, shot, fell, runs)


@lru_cache
def _table(name: str) -> Table:
    """A table that is built, and whose pockets are looked at, once."""
    return load_table(name)


def _balls(table: Table, rng: random.Random) -> Layout:
    """A cue ball and another, anywhere."""
    size, radius = table.knobs.table, table.knobs.ball.radius
    layout = Layout()
    while len(layout) < 2:
        x, y = rng.uniform(0.0, size.length), rng.uniform(0.0, size.width)
        if table.has_room(x, y, radius, layout):
            layout = layout.put(Ball("1" if layout else "cue", x, y))
    return layout


def _hand(rng: random.Random) -> Hand:
    level = LEAST * (MOST / LEAST) ** rng.random()
    return Hand(*(level * 2.0 ** rng.uniform(-1.0, 1.0) for _ in range(4)))


def _pot(table: Table, layout: Layout, hand: Hand, rng: random.Random) -> tuple[PotLine, Shot] | None:
    """A pot that lies open and comes off where nothing goes wrong, and the shot; None where one that is drawn fails."""
    lines = list(pot_lines(table, layout, layout["cue"], ("1",), hand))
    if not lines:
        return None
    line = rng.choice(lines)
    (height, side), pace = rng.choice(spins(3, 3)), rng.choice(PACES)
    shot = next(stroked(table, layout, "cue", line, height, side, (pace,)), None)
    return (line, shot) if shot is not None and _falls(table, layout, shot, line) else None


def _falls(table: Table, layout: Layout, shot: Shot, line: PotLine) -> bool:
    def over(event: Event) -> bool:
        return line.ball in event.balls and event.kind in ("ball_pocket", "ball_off", "rolling_resting")

    last = simulate(table, layout, shot, until=over).events[-1]
    return last.kind == "ball_pocket" and last.where == line.pocket and last.balls == (line.ball,)


def _half(table: Table, layout: Layout, line: PotLine) -> float:
    seen, ball = mouths(table), layout[line.ball]
    _, half = windows(seen, np.array([(ball.x, ball.y)]), table.reach(table.knobs.ball.radius))
    return float(half[0, seen.names.index(line.pocket)])


def brier(pots: Sequence[Tried], fitted: Spread = SPREAD) -> tuple[float, float]:
    """Brier's score of the model over all strokes, and its floor."""
    scores = [(pot.foretold(fitted) - pot.share) ** 2 for pot in pots]
    floors = [pot.share * (1.0 - pot.share) * pot.runs / max(1, pot.runs - 1) for pot in pots]
    unsure = [pot.share * (1.0 - pot.share) for pot in pots]
    return float(np.mean(scores) + np.mean(unsure)), float(np.mean(floors))


def bins(pots: Iterable[Tried], fitted: Spread = SPREAD) -> Iterator[tuple[int, float, float]]:
    """Of the pots in each tenth of what was foretold: how many, and what was foretold and what fell, in the mean."""
    told = [(pot.foretold(fitted), pot.share) for pot in pots]
    for part in range(10):
        inside = [pair for pair in told if min(9, int(10.0 * pair[0])) == part]
        if inside:
            foretold, fell = np.mean(np.array(inside), axis=0)
            yield len(inside), float(foretold), float(fell)


def fit(pots: Sequence[Tried]) -> Spread:
    """The constants with which what fell is likeliest."""
    from scipy.optimize import minimize

    def unlikely(logs: Sequence[float]) -> float:
        fitted = Spread(*map(math.exp, logs))
        return -sum(_log_likelihood(pot.foretold(fitted), pot.share) for pot in pots)

    start = [math.log(value) for value in SPREAD]
    return Spread(*map(math.exp, minimize(unlikely, start, method="Nelder-Mead", options={"xatol": 0.02}).x))


def _log_likelihood(chance: float, share: float) -> float:
    sure = min(max(chance, _SURE), 1.0 - _SURE)
    return share * math.log(sure) + (1.0 - share) * math.log(1.0 - sure)


def _print(title: str, pots: Sequence[Tried], fitted: Spread) -> None:
    print(f"\n{title}: {len(pots)} pots; Brier {{:.4f}}, floor {{:.4f}}".format(*brier(pots, fitted)))
    print("   pots  foretold    fell")
    for count, foretold, fell in bins(pots, fitted):
        print(f"{count:7}{100.0 * foretold:10.1f}{100.0 * fell:8.1f}", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pots", type=int, default=2000, metavar="N")
    parser.add_argument("--runs", type=int, default=50, metavar="N", help="how often each is played")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--fit", action="store_true", help="find the constants anew")
    parser.add_argument("--processes", type=int, default=2, metavar="N")
    arguments = parser.parse_args()
    with Pool(arguments.processes) as pool:
        calls = [(index, arguments.seed, arguments.runs) for index in range(arguments.pots)]
        pots = pool.starmap(tried, calls, chunksize=20)
    fitted = fit(pots) if arguments.fit else SPREAD
    print(fitted)
    _print("all", pots, fitted)
    for name in TABLES:
        _print(name, [pot for pot in pots if pot.table == name], fitted)
    for kind in ("corner", "side"):
        _print(f"{kind} pockets", [pot for pot in pots if ("side" in pot.line.pocket) == (kind == "side")], fitted)


if __name__ == "__main__":
    main()
