"""How many racks of nine-ball a player runs out: `python -m benchmarks.run_outs ada --racks 100`.

The player breaks; the cue ball is in hand after it, whatever the break was, and the first shot that does not go on ends
the rack. A rack whose nine falls on the break counts for nothing.
"""

from __future__ import annotations

import argparse
import time
from dataclasses import replace

from pool2d import load_table
from pool2d.game import Match, Setup
from pool2d.game.rules import Ruling
from pool2d.game.rules.spotting import ANYWHERE
from pool2d.opponent.deciding import decide
from pool2d.opponent.player import Player
from pool2d.opponent.player_file import load_player
from pool2d.opponent.playing import by_hand

GAME, LAST = "nine-ball", "9"
# No rack takes more strokes of one visit.
LONGEST = 40


def turn(match: Match, player: Player, seed: str) -> None:
    """What the player does where the match stands."""
    for action in decide(match.judge, match.now.ruling, player, seed).actions:
        match.play(by_hand(match, action, player, seed))


def run_out(table_name: str, player: Player, seed: int) -> bool | None:
    """Whether a player runs a rack out from cue ball in hand after the break; None where the break ended it."""
    match = Match(load_table(table_name), Setup(GAME, breaker=0, seed=seed))
    turn(match, player, f"{seed} break")
    moment, rules = match.now, match.rules
    if moment.state.over or LAST not in rules.on_table(moment.layout):
        return None
    state = replace(moment.state, shots=1, turn=0)
    ask = replace(
        rules.start(0, seed).ask, where=ANYWHERE, on=(min(rules.on_table(moment.layout), key=int),), options=()
    )
    match.accept(replace(moment, ruling=Ruling(replace(state, ask=ask), moment.layout)), instead=True)
    for stroke in range(LONGEST):
        turn(match, player, f"{seed} {stroke}")
        if match.state.over or match.ask.player:
            break
    return match.state.winner == 0


def main() -> None:
    """Play racks, and say how many were run out."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("player")
    parser.add_argument("--racks", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--table", default="pool-9ft")
    given = parser.parse_args()
    player, begun = load_player(given.player), time.process_time()
    found = [run_out(given.table, player, given.seed + number) for number in range(given.racks)]
    counted = [won for won in found if won is not None]
    spent = (time.process_time() - begun) / max(1, given.racks)
    print(f"{player.name}: {sum(counted)} of {len(counted)} racks run out; {spent:.1f} s of CPU a rack")


if __name__ == "__main__":
    main()
