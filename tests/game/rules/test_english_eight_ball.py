"""English eight-ball by the World Rules: its clauses, and what follows from the choices."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from pool2d import Layout, load_table
from pool2d.game.rules import Choice, Ruling, State
from pool2d.game.rules.pool.english_eight_ball import EnglishEightBall
from pool2d.physics.values import POCKETED

from .cases import Case, rows
from .rule_scenes import Scene, judged, told

TABLE = load_table("english-7ft")
RULES: Any = EnglishEightBall(TABLE)


def asks(rules: Any, state: Any, layout: Layout, scene: Scene) -> State:
    more = {"on": rules.on_table(layout), "call": "ball"} if state.free else {}
    found: State = rules.next(state, layout, 0, scene.where, **more)
    return found


def result(name: str, case: Case) -> str:
    return told(judged(name, TABLE, case, asks)[1], "groups", "visits")


@rows("english-eight-ball")
def test_clause(case: Case) -> None:
    assert result("english-eight-ball", case) == case.ruling


@pytest.mark.parametrize("shot", ["cue-red1 red1>", "cue-red1 red1|", "cue-yellow1 yellow1|"])
def test_a_ball_is_free_for_one_stroke(shot: str) -> None:
    after = judged("english-eight-ball", TABLE, Case("", "", "free", "", shot, ""), asks)[1]
    assert not after.foul
    assert not after.state.free  # type: ignore[attr-defined]


def broken(shot: str) -> Ruling:
    return judged("english-eight-ball", TABLE, Case("", "", "shots 0, where kitchen", "", shot, ""), asks)[1]


@pytest.mark.parametrize(
    ("shot", "color", "groups", "trial"),
    [
        ("cue-red1 red3>", "red", ("red", "yellow"), ""),
        ("cue-red1 red3>", "yellow", ("", ""), "yellow"),
        ("cue-red1 red3> yellow2>", "red", ("red", "yellow"), ""),
        ("cue-red1 red3> yellow2>", "yellow", ("yellow", "red"), ""),
    ],
)
def test_a_color_is_nominated_after_the_break(shot: str, color: str, groups: tuple[str, str], trial: str) -> None:
    """H (2) (c), (3) (b): a colour of which a ball fell is one's own; of the other one has to be potted."""
    asked = broken(shot)
    ruling = RULES.choose(asked.state, asked.layout, Choice(f"group:{color}"))
    assert (ruling.state.groups, ruling.state.trial, ruling.ask.player) == (groups, trial, 0)
    assert {ball.rstrip("0123456789") for ball in ruling.ask.on} == {color}


def test_who_is_foul_snookered_may_go_to_baulk() -> None:
    """P (3), (4): and has no free ball where a way is open from there."""
    given = "groups yellow red, balls red1 yellow1 black, at red1 1.4 0.3, at yellow1 0.9 0.3, at cue 0.4 0.3"
    fouled = judged("english-eight-ball", TABLE, Case("", "", given, "", "cue-red1 cue|", ""), asks)[1]
    assert (fouled.ask.options, fouled.ask.call, len(fouled.ask.on)) == (("baulk",), "ball", 3)
    ruling = RULES.choose(fouled.state, fouled.layout, Choice("baulk"))
    assert (ruling.ask.kind, ruling.ask.where, ruling.ask.on, ruling.ask.call) == ("place", "kitchen", ("red1",), "")
    assert ruling.notes[-1].key == "in-hand.baulk"
    assert ruling.state.visits == 2


def test_spotted_balls_stand_behind_each_other() -> None:
    """S: on the spot, then towards the far cushion, touching nothing."""
    layout = RULES.start().layout
    off = ("red1", "yellow1", "black")
    gone = layout.put(*(layout[ball]._replace(phase=POCKETED) for ball in layout if ball != "cue"))
    placed, spotted = RULES.spot(gone, off)
    assert [ball for ball, _ in spotted] == ["black", "red1", "yellow1"]
    assert [round(x, 3) for _, (x, _) in spotted] == [1.373, 1.423, 1.474]
    assert placed["red1"].x - placed["black"].x > 2 * 0.0254


def test_the_black_is_on_when_ones_color_is_gone() -> None:
    """C (3), D (1)"""
    start = RULES.start()
    state = replace(start.state, groups=("red", "yellow"), shots=3)
    reds = tuple(TABLE.furniture.groups["red"])
    assert RULES.on(state, start.layout, 0) == reds
    layout = start.layout.put(*(start.layout[ball]._replace(phase=POCKETED) for ball in reds))
    assert RULES.on(state, layout, 0) == ("black",)
    assert set(RULES.on(state, layout, 1)) == set(TABLE.furniture.groups["yellow"])
