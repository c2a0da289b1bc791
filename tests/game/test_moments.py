"""Where a match stands, written as a line of a record and read again."""

from __future__ import annotations

import json
import random
from dataclasses import replace
from typing import Any

import pytest

from benchmarks.random_play import new_match, random_action
from pool2d import InputError, Shot, load_table
from pool2d.game.actions import Stroke
from pool2d.game.match import Match, lagged
from pool2d.game.records import moments
from pool2d.game.rules import GAMES
from pool2d.game.setup import LAG, Setup

# Moments.


@pytest.mark.parametrize("game", GAMES)
@pytest.mark.parametrize("breaker", [0, LAG])
def test_every_moment_comes_back_from_its_line(game: str, breaker: int) -> None:
    try:
        played_match = new_match(game, 2, race=2)
        played_match = Match(played_match.table, replace(played_match.setup, breaker=breaker, names=()))
    except InputError:
        return  # Nobody lags alone.
    rng = random.Random(f"{game} {breaker}")
    for _ in range(30):
        now = played_match.now
        line = json.loads(json.dumps(moments.as_dict(now)))
        back = moments.moment_of(line, played_match, "line")
        assert back == replace(now, action=None, rollout=None, report=None)
        assert repr(back.layout) == repr(now.layout)
        if played_match.over:
            break
        ask = played_match.ask
        lagging = lagged(played_match.state) and ask.kind == "aim"
        stroke = Stroke(Shot(0.0, rng.uniform(1.2, 1.8), ball=ask.ball))
        played_match.play(stroke if lagging else random_action(played_match, rng))


@pytest.mark.parametrize(
    "change",
    [
        {"balls": 3}, {"balls": "cue@x"}, {"balls": ""}, {"game": None}, {"game": {"turn": "x"}}, {"game": {"luck": 1}},
        {"game": {"turn": 2}}, {"game": {"ask": 3}}, {"game": {"ask": {"kind": "aim", "who": 3}}},
        {"game": {"ask": {"kind": "aim", "who": 0, "ball": "x"}}}, {"game": {"ask": {"kind": "fly", "who": 0}}},
        {"game": {"scores": [1]}}, {"game": {"scores": [0, None]}}, {"tallies": []}, {"tallies": [{}]},
        {"tallies": [{"frames": 1.5}, {}]}, {"tallies": [{"luck": 1}, {}]}, {"turn": [0, 0]}, {"turn": [0, 0, 7]},
        {"turn": [0, 0, True]}, {"notes": 3}, {"notes": [3]}, {"notes": [{"key": 3}]}, {"notes": [{"who": 3}]},
        {"spotted": [["9"]]}, {"spotted": [["9", ["a", 1]]]}, {"points": [1]}, {"points": "12"},
    ],
)  # fmt: skip
def test_what_is_no_moment_is_refused(change: dict[str, Any]) -> None:
    game = Match(load_table("pool-9ft"), Setup("nine-ball", breaker=0))
    line = json.loads(json.dumps(moments.as_dict(game.now)))
    if isinstance(change.get("game"), dict):
        change = {"game": {**line["game"], **change["game"]}}
    with pytest.raises(InputError, match=r"^line: "):
        moments.moment_of({**line, **change}, game, "line")


def test_who_is_asked_keeps_the_name_that_records_have_for_it() -> None:
    game = Match(load_table("pool-9ft"), Setup("nine-ball", breaker=0))
    line = json.loads(json.dumps(moments.as_dict(game.now)))
    ask = line["game"]["ask"]
    assert list(ask)[:2] == ["kind", "who"] and "player" not in ask
    refused: list[tuple[dict[str, Any], str]] = [({"who": "x"}, "game.who"), ({"player": 0}, "player")]
    for change, key in refused:
        with pytest.raises(InputError, match=rf"^line: {key} = "):
            moments.moment_of({**line, "game": {**line["game"], "ask": {**ask, **change}}}, game, "line")


def test_a_note_that_this_version_has_no_words_for_is_left_out() -> None:
    game = Match(load_table("pool-9ft"), Setup("nine-ball", breaker=0))
    line = moments.as_dict(game.now)
    back = moments.moment_of({**line, "notes": [{"key": "foul.talking"}, *line["notes"]]}, game, "line")
    assert back.ruling.notes == game.now.ruling.notes
