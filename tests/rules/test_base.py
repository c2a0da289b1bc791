"""What holds of every game: states are values, choices are checked, a table is asked what it has."""

from __future__ import annotations

import json

import pytest

from pool2d import InputError, load_table
from pool2d.game.rules import GAMES, PLACE, Choice, game, games_for
from pool2d.game.rules.words import Note, say

from .notation import after, only, report

TABLE = load_table("pool-9ft")


@pytest.mark.parametrize("name", GAMES)
def test_a_state_comes_back_from_json(name: str) -> None:
    tables = [load_table(table) for table in ("pool-9ft", "snooker-12ft", "carom-10ft", "english-7ft")]
    rules = game(name, next(table for table in tables if name in games_for(table)))
    state = rules.start(breaker=rules.players - 1, seed=3).state
    assert rules.state(json.loads(json.dumps(state.as_dict()))) == state


def test_a_state_with_a_strange_key_is_refused() -> None:
    with pytest.raises(InputError, match="did you mean turn"):
        game("practice", TABLE).state({"tunr": 1})


def test_an_unknown_game_is_refused() -> None:
    with pytest.raises(InputError, match="unknown; did you mean practice"):
        game("practise", TABLE)


def test_an_unknown_option_is_refused() -> None:
    with pytest.raises(InputError, match="speed"):
        game("practice", TABLE, {"speed": 1})


def test_a_choice_that_is_not_asked_for_is_refused() -> None:
    ruling = game("practice", TABLE).start()
    with pytest.raises(InputError, match="allowed is place"):
        game("practice", TABLE).choose(ruling.state, ruling.layout, Choice("re-rack"))


def test_practice_places_counts_and_racks_again() -> None:
    rules = game("practice", TABLE)
    ruling = rules.start()
    shot = report("cue-1 1> cue>")
    ruling = rules.judge(ruling.state, after(ruling.layout, shot), shot)
    assert (ruling.ask.kind, ruling.points, ruling.state.scores) == (PLACE, (1,), (1,))
    with pytest.raises(InputError, match="allowed is anywhere on the table, clear of other balls"):
        rules.choose(ruling.state, ruling.layout, Choice("place", 1.905 + 0.0577 * 3, 0.635))
    ruling = rules.choose(ruling.state, ruling.layout, Choice("place", 0.4, 0.4))
    assert (ruling.layout["cue"].x, ruling.layout["cue"].y) == (0.4, 0.4)
    assert ruling.ask.kind == "aim"
    shot = report("cue-2 2>")
    ruling = rules.judge(ruling.state, after(only(ruling.layout, "2"), shot), shot)
    assert len(ruling.layout.on_table()) == 16


def test_a_note_is_a_sentence() -> None:
    assert say(Note("foul.wrong-ball", ball="red7")) == "The red was hit first, and it was not on."
    assert say(Note("in-hand.kitchen", 1), ("Ann", "Bob")) == "Bob has the cue ball in hand, behind the head string."
