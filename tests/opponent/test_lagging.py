"""The lag of a player: off the foot cushion once, and back to within a ball of the head cushion."""

from __future__ import annotations

import pytest

from pool2d import load_table
from pool2d.game.match import Match, lagged
from pool2d.game.rules.lag import LagState
from pool2d.game.setup import LAG, Setup
from pool2d.opponent.deciding import decide
from pool2d.opponent.player import Player
from pool2d.opponent.playing import played_out
from pool2d.opponent.stray import Hand

STEADY = Hand(aim=0.0, tip=0.0, speed=0.0, elevation=0.0)


@pytest.mark.parametrize(
    ("game", "table"), [("eight-ball", "pool-7ft"), ("three-cushion", "carom-10ft"), ("snooker", "snooker-12ft")]
)
def test_a_hand_that_never_strays_lags_to_within_two_centimetres(game: str, table: str) -> None:
    match = Match(load_table(table), Setup(game, breaker=LAG, seed=3, players=("a", "b")))
    for _ in range(2):
        match.play(decide(match.judge, match.now.ruling, Player("a", hand=STEADY), "1").actions[-1])
    first = match.history[1].state
    assert isinstance(first, LagState) and 0.0 <= first.rests[0] < 0.02
    notes = [note.key for note in match.now.ruling.notes]
    assert "lag.bad" not in notes and "lag.rest" in notes


def test_a_lag_between_players_leads_to_a_break() -> None:
    match = Match(load_table("pool-9ft"), Setup("nine-ball", breaker=LAG, seed=3, players=("a", "b")))
    players = [Player("a"), Player("b")]
    for _ in played_out(match, players, "1"):
        if not lagged(match.state):
            break
    assert match.state.turn in (0, 1) and match.ask.kind == "aim" and len(match.history) >= 4
