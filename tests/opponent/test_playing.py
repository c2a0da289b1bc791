"""Players do what is asked of them in every game, whatever that is, and the same again for the same seed."""

from __future__ import annotations

from itertools import islice

import pytest

from pool2d import load_table
from pool2d.game import GAMES, Match, Setup, games_for
from pool2d.opponent.player import Judgement, Player
from pool2d.opponent.playing import played_out
from pool2d.opponent.stray import Hand

QUICK = Judgement(
    ways=1, paces=1, heights=1, sides=1, few=1, runs=1, safeties=2, kicks=24, banks=1, combinations=1, cannons=20
)
PLAYERS = (Player("quick", hand=Hand(2.0), judgement=QUICK), Player("slow", hand=Hand(0.5), judgement=QUICK))
TABLES = ("pool-9ft", "snooker-12ft", "carom-10ft", "english-7ft", "pyramid-12ft", "l-shape")
GAMES_ON = [(table, game) for table in TABLES for game in games_for(load_table(table)) if game != "practice"]


def test_every_game_is_played_somewhere() -> None:
    assert {game for _, game in GAMES_ON} >= set(GAMES) - {"practice"}


@pytest.mark.parametrize(("table", "game"), GAMES_ON)
def test_what_is_asked_is_done(table: str, game: str) -> None:
    match = Match(load_table(table), Setup(game, breaker=0, seed=3))
    turns = list(islice(played_out(match, PLAYERS, "a"), 8))
    assert len(turns) == 8 or match.over


def test_the_same_seed_plays_the_same_match() -> None:
    def strokes(seed: str) -> list[object]:
        match = Match(load_table("pool-9ft"), Setup("nine-ball", breaker=0, seed=3))
        return [moment.action for _, moment in islice(played_out(match, PLAYERS, seed), 6)]

    assert strokes("a") == strokes("a") != strokes("b")
