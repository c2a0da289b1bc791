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
from pool2d.game.rules import GAMES, Choice
from pool2d.game.rules.report import Call
from pool2d.game.setup import LAG, Setup
from pool2d.physics.values import OFF

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


# Balls that left the table.

OVER_THE_RAIL = Shot(angle=0.0, speed=8.0, elevation=35.0)


def off_the_table(game: str = "nine-ball") -> Match:
    """A match whose first stroke drives the cue ball over the foot rail."""
    match = Match(load_table("pool-9ft"), Setup(game, breaker=0))
    match.play(Stroke(OVER_THE_RAIL))
    assert match.now.report is not None and match.now.report.left == {"cue": "right"}
    return match


def test_a_cue_ball_off_the_table_is_in_hand_and_the_ruling_says_where_it_went() -> None:
    match = off_the_table()
    ruling = match.now.ruling
    assert match.layout["cue"].phase == OFF and ruling.ask.kind == "place"
    assert ruling.fouls[0].text == "The cue ball left the table over the right cushion."
    match.play(Choice("place", 0.6, 0.6))
    ball = match.layout["cue"]
    assert (ball.phase, ball.z, ball.x, ball.y) == ("resting", 0.0, 0.6, 0.6)
    assert match.undo() and match.undo()
    assert [ball.id for ball in match.layout.on_table()].count("cue") == 1
    assert match.redo() and "cue" not in [ball.id for ball in match.layout.on_table()]


def test_a_ball_off_the_table_comes_back_from_a_line() -> None:
    match = off_the_table()
    line = json.loads(json.dumps(moments.as_dict(match.now)))
    assert line["off"] == [["cue", "right"]] and line["fouls"][0] == {"key": "foul.cue-over", "where": "right"}
    back = moments.moment_of(line, match, "line")
    assert back == replace(match.now, action=None, rollout=None, report=None)


def test_a_stroke_that_cannot_be_played_again_shows_the_ball_leave() -> None:
    match = off_the_table()
    line = json.loads(json.dumps(moments.as_dict(match.now)))
    stroke = match.now.action
    assert isinstance(stroke, Stroke)
    after = moments.unplayed(match.history[0], match.now, stroke, line, match.table, "line")
    assert after.rollout is not None and after.report is not None
    events = [event for event in after.rollout.events if event.kind == "ball_off"]
    assert [(event.balls, event.where) for event in events] == [(("cue",), "right")]
    assert after.report.left == {"cue": "right"} and not after.report.scratch


def test_an_object_ball_that_stays_off_stays_off_in_the_next_strokes() -> None:
    """WPA 4.7: at eight-ball it is not spotted; it is on the table again where the stroke is undone."""
    match = Match(load_table("pool-9ft"), Setup("eight-ball", breaker=0))
    now = match.now
    flying = now.layout["3"]._replace(x=1.0, y=0.635, z=0.06, vx=6.0, vz=1.5)
    match.accept(replace(now, ruling=now.ruling._replace(layout=now.layout.put(flying))), instead=True)
    match.play(Stroke(Shot(angle=0.0, speed=8.0)))
    assert match.now.report is not None and match.now.report.off == ("3",)
    assert "foul.over" in [foul.key for foul in match.now.ruling.fouls]
    while match.ask.kind == "choose":
        match.play(Choice(match.ask.options[0]))
    match.play(Stroke(Shot(angle=90.0, speed=1.0), Call(safety=True)))
    assert match.layout["3"].phase == OFF and "3" not in [ball.id for ball in match.layout.on_table()]
    assert [tally.pots for tally in match.now.tallies].count(0) >= 1
    while match.undo():
        pass
    assert match.layout["3"].phase != OFF
