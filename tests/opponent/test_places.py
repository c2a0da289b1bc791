"""Where a cue ball in hand is put."""

from __future__ import annotations

import math
from dataclasses import replace

from pool2d import Ball, Layout, load_table
from pool2d.game import Match, Setup
from pool2d.game.rules.spotting import ANYWHERE
from pool2d.opponent.candidates.places import places
from pool2d.opponent.pot_lines import pot_lines
from pool2d.opponent.stray import Hand

TABLE = load_table("pool-9ft")
ASK = replace(Match(TABLE, Setup("nine-ball", breaker=0, seed=1)).ask, where=ANYWHERE, on=("1",), options=())
HAND = Hand()


def found(*balls: Ball) -> list[tuple[float, float]]:
    return list(places(TABLE, Layout([Ball("cue", 1.0, 0.2), *balls]), ASK, ["1"], HAND))


def test_behind_a_ball_that_leaves_little_room_it_is_put_close() -> None:
    """The ball lies 10 cm from a cushion, and goes only to the pockets away from that."""
    one = Ball("1", 0.13, 0.33)
    others = (Ball("2", 0.06, 0.97), Ball("5", 0.06, 0.1))
    stands = found(one, *others)

    def best(x: float, y: float) -> float:
        cue = Ball("cue", x, y)
        lines = pot_lines(TABLE, Layout([cue, one, *others]), cue, ("1",), HAND)
        return next((line.chance for line in lines), 0.0)

    assert max(best(x, y) for x, y in stands) > 0.5


def test_where_nothing_can_be_potted_it_is_put_about_the_ball() -> None:
    radius = TABLE.knobs.ball.radius
    one = Ball("1", 1.27, 0.635)
    ring = [
        Ball(str(number), one.x + 2.002 * radius * math.cos(way), one.y + 2.002 * radius * math.sin(way))
        for number, way in enumerate((math.tau * part / 6 for part in range(6)), 2)
    ]
    stands = found(one, *ring)
    assert len(stands) >= 8
    assert all(0.2 < math.hypot(x - one.x, y - one.y) < 0.6 for x, y in stands)
