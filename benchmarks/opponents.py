"""What players make on tables without pockets: `python -m benchmarks.opponents --game three-cushion --aim 1`.

A player plays itself. Points in an inning, the longest run and the processor's time for a stroke are told.
"""

from __future__ import annotations

import argparse
import time
from itertools import islice

from pool2d import load_table
from pool2d.game import Match, Setup
from pool2d.opponent.player import Judgement, Player
from pool2d.opponent.playing import played_out
from pool2d.opponent.stray import Hand


def main() -> None:
    """Play a match, and say what came of it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--table", default="carom-10ft")
    parser.add_argument("--game", default="three-cushion")
    parser.add_argument("--aim", type=float, default=1.0, help="all errors of the hand, in published units")
    parser.add_argument("--cannons", type=float, default=Judgement().cannons, help="how many strokes are tried")
    parser.add_argument("--innings", type=float, default=10.0)
    parser.add_argument("--strokes", type=int, default=200, help="no more than so many")
    parser.add_argument("--seed", default="1")
    given = parser.parse_args()
    player = Player("measured", hand=Hand(*[given.aim] * 4), judgement=Judgement(cannons=given.cannons))
    match = Match(
        load_table(given.table),
        Setup(given.game, options={"points": 1000, "innings": given.innings}, breaker=0, seed=1),
    )
    began = time.process_time()
    strokes = sum(1 for _ in islice(played_out(match, (player, player), given.seed), given.strokes))
    spent = time.process_time() - began
    told(match, strokes, spent)


def told(match: Match, strokes: int, spent: float) -> None:
    """One line of what a match came to."""
    data = match.state.as_dict()
    points, innings = sum(data["scores"]), sum(data["innings"])
    print(
        f"{match.rules.title}: {points} points in {innings} innings, {points / max(1, innings):.2f} an inning, "
        f"longest run {max(data['best'])}; {strokes} strokes, {spent / strokes:.2f} s each"
    )


if __name__ == "__main__":
    main()
