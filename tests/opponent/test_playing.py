"""Players do what is asked of them in every game, whatever that is, and the same again for the same seed."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

import pytest

from pool2d import load_table
from pool2d.game import GAMES, Match, Setup, games_for
from pool2d.game.rules.pool.nine_ball import NineBall
from pool2d.game.rules.spotting import ANYWHERE
from pool2d.opponent.deciding import agrees
from pool2d.opponent.player import Judgement, Player
from pool2d.opponent.playing import played_out
from pool2d.opponent.stray import Hand
from pool2d.physics.values import POCKETED

QUICK = Judgement(
    ways=1, paces=1, heights=1, sides=1, few=1, runs=1, safeties=2, kicks=24, banks=1, combinations=1, cannons=20
)
PLAYERS = (Player("quick", hand=Hand(2.0), judgement=QUICK), Player("slow", hand=Hand(0.5), judgement=QUICK))
TABLES = ("pool-9ft", "snooker-12ft", "carom-10ft", "english-7ft", "pyramid-12ft", "l-shape")
GAMES_ON = [(table, game) for table in TABLES for game in games_for(load_table(table)) if game != "practice"]


def test_every_game_is_played_somewhere() -> None:
    assert {game for _, game in GAMES_ON} >= set(GAMES) - {"practice"}


def test_who_has_an_open_table_does_not_agree_to_begin_again_and_who_looks_on_does() -> None:
    rules = NineBall(load_table("pool-9ft"))
    start = rules.start(0, 3)
    layout = start.layout.put(*(start.layout[ball]._replace(phase=POCKETED) for ball in "1234567"))
    ruling = rules.ruled(rules.next(replace(start.state, shots=9), layout, 0, ANYWHERE), layout)
    assert [agrees(rules, ruling, PLAYERS[1], me) for me in (0, 1)] == [False, True]


def test_who_leads_by_much_where_points_are_counted_does_not_agree_to_begin_again() -> None:
    rules = Match(load_table("snooker-12ft"), Setup("snooker", breaker=0, seed=3)).rules
    start = rules.start(0, 3)
    ahead = start._replace(state=replace(start.state, shots=9, scores=(0, 40)))
    assert [agrees(rules, ahead, PLAYERS[1], me) for me in (0, 1)] == [True, False]


@pytest.mark.parametrize(("table", "game"), GAMES_ON)
def test_at_any_moment_of_any_game_a_player_agrees_to_begin_again_or_does_not(table: str, game: str) -> None:
    match = Match(load_table(table), Setup(game, breaker=0, seed=3))
    for _ in islice(played_out(match, PLAYERS, "a"), 3):
        if not match.state.over:
            assert all(isinstance(agrees(match.rules, match.now.ruling, PLAYERS[0], me), bool) for me in (0, 1))


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
