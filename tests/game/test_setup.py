"""What is agreed before a match: how far it goes, what is refused, and that it is kept."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from benchmarks.random_play import new_match
from pool2d import InputError, Table
from pool2d.game.match import Match
from pool2d.game.setup import WINNER, Setup, setup_of


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"game": "nineball"}, "did you mean nine-ball"),
        ({"options": {"ten": "wins"}}, "ten"),
        ({"race": 0}, "race = 0.*from 1 to 100"),
        ({"race": 1.5}, "race = 1.5"),
        ({"seed": "x"}, "seed = 'x'"),
        ({"breaks": "often"}, "breaks = 'often'"),
        ({"breaker": 2}, "breaker = 2: allowed is 0 to 1, -1 for a coin and -2 for a lag"),
        ({"names": ("Ann",)}, "allowed are 2 names"),
        ({"names": ("Ann", "B\nb")}, "printable"),
        ({"names": ("Ann", " ")}, "printable"),
        ({"players": ("club",)}, "players = .*allowed are 2 names, or none"),
        ({"players": ("", "a\nb")}, "players = .*printable"),
    ],
)
def test_bad_setups_are_refused(table: Table, changed: dict[str, object], words: str) -> None:
    with pytest.raises(InputError, match=words):
        Match(table, replace(Setup("nine-ball"), **changed))  # type: ignore[arg-type]


def test_a_setup_comes_back_from_json() -> None:
    setup = Setup("nine-ball", {"three_foul": "no"}, ("Ann", "Bob"), 5, WINNER, 1, 7)
    assert setup_of(json.loads(json.dumps(setup.as_dict())), "header") == setup
    with pytest.raises(InputError, match="players = 3"):
        setup_of({"players": ["", 3]}, "header")
    with pytest.raises(InputError, match="did you mean race"):
        setup_of({"racee": 1}, "header")
    with pytest.raises(InputError, match="names = 3"):
        setup_of({"names": 3}, "header")


def test_who_is_no_person_is_kept_and_people_are_not_spoken_of(table: Table) -> None:
    setup = Match(table, Setup("nine-ball", players=("", "club"))).setup
    assert setup_of(json.loads(json.dumps(setup.as_dict())), "header") == setup
    assert [setup.is_person(player) for player in (-1, 0, 1)] == [False, True, False]
    assert not setup.watched
    assert replace(setup, players=("club", "club")).watched
    people = Match(table, Setup("nine-ball", players=("", ""))).setup
    assert people.players == () and "players" not in people.as_dict()
    assert people.is_person(1) and not people.watched


@pytest.mark.parametrize(
    ("allowed", "refused"),
    [
        ({"race": 1}, {"race": 0}),
        ({"race": 100}, {"race": 101}),
        ({"seed": -(10**15)}, {"seed": -(10**15) - 1}),
        ({"seed": 10**15}, {"seed": 10**15 + 1}),
        ({"breaker": -2}, {"breaker": -3}),
        ({"breaker": 1}, {"breaker": 2}),
        ({"names": ("A" * 40, "B")}, {"names": ("A" * 41, "B")}),
        ({"names": ("A", "B")}, {"names": ("A", "B", "C")}),
    ],
)
def test_a_setup_goes_as_far_as_it_may(table: Table, allowed: dict[str, Any], refused: dict[str, Any]) -> None:
    setup = replace(Setup("nine-ball"), **allowed)
    assert Match(table, setup).setup == replace(setup, names=setup.names or ("Player 1", "Player 2"))
    with pytest.raises(InputError, match=r"allowed (is|are)"):
        Match(table, replace(setup, **refused))


@settings(max_examples=20)
@given(st.integers(0, 10_000))
def test_players_are_named(seed: int) -> None:
    match = new_match("nine-ball", seed)
    assert match.names == ("Player 1", "Player 2")
