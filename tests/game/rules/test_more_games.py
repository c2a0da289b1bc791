"""Blackball, six-red snooker, Korean four-ball and free pyramid: their clauses, and what follows from the choices."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from pool2d import InputError, Layout, Shot, load_table, simulate
from pool2d.game.actions import Stroke
from pool2d.game.match import Match
from pool2d.game.referee import observe
from pool2d.game.rules import Choice, State, games_for
from pool2d.game.rules.carom.four_ball import FourBall
from pool2d.game.rules.pool.blackball import Blackball
from pool2d.game.rules.pool.free_pyramid import FreePyramid
from pool2d.game.rules.snooker.six_red import SixRed, SixRedState
from pool2d.game.rules.snooker.snooker import points_left
from pool2d.game.rules.spotting import CLEAR, put
from pool2d.game.setup import Setup
from pool2d.physics.values import POCKETED
from pool2d.table.preset import presets

from .cases import Case, rows
from .notation import only, report, without
from .rule_scenes import Scene, judged, told

ENGLISH, SNOOKER, CAROM = load_table("english-7ft"), load_table("snooker-12ft"), load_table("carom-10ft")
PYRAMID = load_table("pyramid-12ft")
BLACKBALL: Any = Blackball(ENGLISH)
SIX: Any = SixRed(SNOOKER)
FOUR: Any = FourBall(CAROM)
FREE: Any = FreePyramid(PYRAMID)


def shoots(rules: Any, state: Any, layout: Layout, scene: Scene) -> State:
    """Player 0 is asked to shoot as the game itself asks."""
    if isinstance(rules, Blackball):
        found: State = rules.next(state, layout, 0, scene.where, options=())
    elif isinstance(rules, SixRed):
        found = rules.aiming(state, layout, 0, scene.where, state.free)
    elif isinstance(rules, FourBall):
        found = rules.opened(state, 0) if "opening" in scene.state else rules.aim(replace(state, opening=False), 0)
    elif scene.where:
        found = rules.to_play(state, layout, 0, scene.where)
    else:
        found = rules._aiming(state, layout, 0)
    return found


def result(name: str, table: Any, case: Case, *names: str) -> str:
    return told(judged(name, table, case, shoots)[1], *names)


@rows("blackball")
def test_blackball(case: Case) -> None:
    assert result("blackball", ENGLISH, case, "groups", "free") == case.ruling


@rows("six-red")
def test_six_red(case: Case) -> None:
    assert result("six-red", SNOOKER, case, "phase", "called") == case.ruling


@rows("four-ball")
def test_four_ball(case: Case) -> None:
    assert result("four-ball", CAROM, case, "scores", "innings", "run") == case.ruling


@rows("free-pyramid")
def test_free_pyramid(case: Case) -> None:
    assert result("free-pyramid", PYRAMID, case, "scores") == case.ruling


@pytest.mark.parametrize(
    ("said", "balls"),
    [
        ("cue-5 cue>", ("cue",)),
        ("cue-5 5> cue>", ("5", "cue")),
        ("cue-5 5|", ()),
        ("cue-5 cue^ 5>", ()),
        ("5> cue>", ()),
    ],
)
def test_every_ball_that_counts_is_a_pot_at_free_pyramid(said: str, balls: tuple[str, ...]) -> None:
    rules, ruling = judged("free-pyramid", PYRAMID, Case("", "", "", "", said, ""), shoots)
    assert set(rules.pots(0, report(said), ruling)) == set(balls)


@pytest.mark.parametrize("name", presets())
def test_every_shipped_table_has_a_game(name: str) -> None:
    assert set(games_for(load_table(name))) - {"practice"} or name == "l-shape"


# Blackball.


def test_a_free_shot_may_be_taken_from_baulk() -> None:
    start = BLACKBALL.start()
    layout = put(start.layout, "cue", (1.0, 0.1))
    state = replace(BLACKBALL.next(replace(start.state, shots=3), layout, 0), groups=("red", "yellow"))
    fouled = BLACKBALL.judge(state, layout, report("cue|", start=layout))
    assert fouled.ask.options == ("baulk",) and fouled.state.free and fouled.ask.player == 1
    assert set(fouled.ask.on) == {ball.id for ball in layout.on_table()} - {"cue"}
    moved = BLACKBALL.choose(fouled.state, fouled.layout, Choice("baulk"))
    assert (moved.ask.kind, moved.ask.where, moved.state.free) == ("place", "kitchen", True)
    placed = BLACKBALL.choose(moved.state, moved.layout, Choice("place", 0.2, 0.3))
    assert placed.ask.kind == "aim" and placed.state.free


def test_after_a_break_that_is_none_the_balls_may_be_racked_again() -> None:
    start = BLACKBALL.start()
    weak = BLACKBALL.judge(start.state, start.layout, report("cue-red1", start=start.layout))
    assert weak.ask.options == ("baulk", "re-rack")
    again = BLACKBALL.choose(weak.state, weak.layout, Choice("re-rack"))
    assert (again.ask.player, again.state.shots, again.state.free, again.state.racks) == (1, 0, True, 2)


@pytest.mark.parametrize("way", [-1.0, 1.0])
def test_a_ball_is_over_the_middle_with_its_whole_width(way: float) -> None:
    layout = Layout(ball for ball in BLACKBALL.start().layout.values() if ball.id in ("cue", "red1"))
    middle, told = 0.5 * ENGLISH.knobs.table.length, set()
    layout = put(put(layout, "cue", (middle - way * 0.45, 0.45)), "red1", (middle - way * 0.25, 0.45))
    for speed in [0.3 + 0.02 * i for i in range(30)]:
        rollout = simulate(ENGLISH, layout, Shot(angle=0.0 if way > 0.0 else 180.0, speed=speed))
        places = [way * (rollout.at(0.01 * i)["red1"].x - middle) for i in range(int(100 * rollout.duration) + 2)]
        seen = observe(ENGLISH, rollout)
        found = ("red1" in seen.passed, "red1" in seen.cleared)
        assert found == (max(places) > 0.0, max(places) > 0.0254)
        told.add(found)
    assert told == {(False, False), (True, False), (True, True)}


# Six-red.


def test_six_reds_hold_75() -> None:
    start = SIX.start()
    assert points_left("red", start.layout) == start.state.left == 75
    assert sum(ball.id.startswith("red") for ball in start.layout.on_table()) == 6


def missing(times: int) -> Any:
    """The red behind the yellow missed, and the balls put back, that many times."""
    layout = only(SIX.start().layout, "red1", "red2", "yellow", "black")
    for ball, place in {"cue": (1.0, 0.5), "red1": (2.5, 0.5), "red2": (2.5, 0.6), "yellow": (1.75, 0.52)}.items():
        layout = put(layout, ball, place)
    state = SIX.aiming(replace(SIX.start().state, shots=4), layout, 0)
    ruling = SIX.judge(state, layout, report("cue|", start=layout))
    for _ in range(times - 1):
        ruling = SIX.choose(ruling.state, ruling.layout, Choice("put-back"))
        ruling = SIX.judge(ruling.state, ruling.layout, report("cue|", start=ruling.layout))
    return ruling


def test_after_five_misses_the_cue_ball_goes_anywhere() -> None:
    fourth = missing(4)
    assert fourth.ask.options == ("play", "play-again", "put-back")
    back = SIX.choose(fourth.state, fourth.layout, Choice("put-back"))
    assert "last-miss" in [note.key for note in back.notes] and back.ask.player == 0
    fifth = missing(5)
    assert fifth.ask.options == ("play", "play-again", "anywhere")
    placed = SIX.choose(fifth.state, fifth.layout, Choice("anywhere"))
    assert (placed.ask.player, placed.ask.kind, placed.ask.where) == (1, "aim", "anywhere")
    assert isinstance(placed.state, SixRedState) and (placed.state.called, placed.state.misses) == (0, 0)
    there = SIX.choose(placed.state, placed.layout, Choice("place", 2.0, 1.2))
    assert (there.layout["cue"].x, there.layout["cue"].y) == (2.0, 1.2)


@pytest.mark.parametrize(("scores", "offered"), [((0, 0), True), ((0, 60), False)])
def test_not_where_snookers_are_required(scores: tuple[int, int], offered: bool) -> None:
    layout = only(SIX.start().layout, "red1", "black")
    layout = put(put(layout, "cue", (1.0, 0.5)), "red1", (2.5, 0.5))
    state = replace(SIX.start().state, shots=9, scores=scores, called=4, misses=1)
    ruling = SIX.judge(SIX.aiming(state, layout, 0), layout, report("cue|", start=layout))
    assert ruling.state.called == 5
    assert ruling.ask.options == ("play", "play-again", *(("anywhere",) if offered else ()))


def test_playing_on_ends_the_row_of_misses() -> None:
    third = missing(3)
    played = SIX.choose(third.state, third.layout, Choice("play-again"))
    assert isinstance(played.state, SixRedState) and played.state.called == 0


# Korean four-ball.


def test_the_opening_of_four_ball() -> None:
    start, spots = FOUR.start(1), CAROM.furniture.spots
    assert (start.ask.player, start.ask.ball, start.ask.on, start.ask.options) == (1, "cue", ("red2",), ())
    assert {ball.id: (ball.x, ball.y) for ball in start.layout.values()} == {
        "cue": spots["right"], "yellow": spots["far"], "red": spots["head"], "red2": spots["foot"],
    }  # fmt: skip
    missed = FOUR.judge(start.state, start.layout, report("cue-red2 cue|", start=start.layout))
    assert (missed.ask.player, missed.ask.ball, missed.ask.on) == (0, "yellow", ("red", "red2"))


# Free pyramid.


def test_any_ball_may_be_struck_after_the_break() -> None:
    start = FREE.start()
    assert (start.ask.ball, start.ask.cues, start.ask.where) == ("cue", (), "kitchen")
    next_one = FREE.judge(start.state, start.layout, report("cue-1 1| 2| 3|", start=start.layout))
    assert set(next_one.ask.cues) == {ball.id for ball in start.layout.on_table()}
    struck = report("7-3 3>", cue="7", start=next_one.layout)
    ruling = FREE.judge(next_one.state, next_one.layout.put(next_one.layout["3"]._replace(phase=POCKETED)), struck)
    assert (ruling.ask.player, ruling.ask.ball) == (1, "7") and "3" not in ruling.ask.cues
    assert ruling.points == (0, 1)


def test_a_match_takes_a_stroke_with_any_ball() -> None:
    match = Match(PYRAMID, Setup("free-pyramid", breaker=0, seed=2))
    with pytest.raises(InputError, match="allowed is cue"):
        match.play(Stroke(Shot(0.0, 5.0, ball="3")))
    match.play(Stroke(Shot(0.5, 9.0)))
    while match.ask.kind == "choose":
        match.play(Choice("accept"))
    other = next(ball for ball in match.ask.cues if ball != match.ask.ball)
    moment = match.play(Stroke(Shot(40.0, 3.0, ball=other)))
    assert moment.report is not None and moment.report.cue == other
    with pytest.raises(InputError, match="allowed is "):
        match.play(Stroke(Shot(0.0, 5.0, ball="nine")))


def test_a_struck_ball_that_falls_is_told_and_stays_down() -> None:
    layout = FREE.start().layout
    state = FREE._aiming(replace(FREE.start().state, shots=3), layout, 0)
    down = layout.put(layout["cue"]._replace(phase=POCKETED))
    ruling = FREE.judge(state, down, report("cue-1 cue>", start=layout))
    assert ruling.layout["cue"].phase == POCKETED and "cue" not in ruling.ask.cues
    assert "own-ball" in [note.key for note in ruling.notes]
    back = FREE.judge(state, down, report("cue>", start=layout))
    assert [note.ball for note in back.notes if note.key == "spotted"] == ["colored"]


def test_what_fell_by_a_foul_is_spotted_behind_the_foot_spot_or_else_before_it_touching_nothing() -> None:
    """General rules of pyramid."""
    foot, touch = PYRAMID.furniture.spots["foot"], 2.0 * PYRAMID.knobs.ball.radius
    row = [f"{i}" for i in range(1, 16)]
    layout = FREE.start().layout
    for i, ball in enumerate(row):
        # Ten balls from the spot to the foot leave no room for another; the rest lie at the head.
        layout = put(layout, ball, (foot[0] + 1.3 * touch * i, foot[1]) if i < 10 else (0.1 * i, 0.1))
    state = FREE._aiming(replace(FREE.start().state, shots=3), layout, 0)
    ruling = FREE.judge(state, without(layout, "15"), report("15> cue|", start=layout))
    ((ball, place),) = ruling.spotted
    assert ball == "15" and place[1] == foot[1]
    assert place[0] == pytest.approx(foot[0] - touch - CLEAR, abs=1e-8)
    free = without(layout, *row[:10])
    ruling = FREE.judge(FREE._aiming(state, free, 0), without(free, "14", "15"), report("14> 15>", start=free))
    assert [place for _, place in ruling.spotted] == [foot, pytest.approx((foot[0] + touch + CLEAR, foot[1]), abs=1e-8)]


@pytest.mark.parametrize(
    ("key", "player", "where", "racks"),
    [("accept", 1, "", 1), ("re-rack", 1, "kitchen", 2), ("opponent-breaks", 0, "kitchen", 2)],
)
def test_after_a_foul_at_the_break_the_other_player_chooses(key: str, player: int, where: str, racks: int) -> None:
    """General rules of pyramid: the point stays, whoever breaks anew."""
    start = FREE.start()
    fouled = FREE.judge(start.state, start.layout, report("cue-1 1|", start=start.layout))
    ruling = FREE.choose(fouled.state, fouled.layout, Choice(key))
    assert (ruling.ask.player, ruling.ask.where, ruling.state.racks) == (player, where, racks)
    assert (ruling.state.scores, ruling.state.shots) == ((0, 1), 1 if key == "accept" else 0)
    assert ruling.state.breaker == (player if where else 0)
    assert bool(ruling.ask.cues) == (key == "accept")
