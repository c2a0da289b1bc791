"""Snooker: its clauses, the choices after a foul, where colours are spotted, and what counts as a snooker."""

from __future__ import annotations

import math
from typing import Any

import pytest

from pool2d import InputError, Layout, Shot, load_table, simulate
from pool2d.game.referee import observe
from pool2d.game.rules import Choice, Ruling, State
from pool2d.game.rules.sight import sees, sees_full, snookered
from pool2d.game.rules.snooker.snooker import Snooker, SnookerState, needed, points_left
from pool2d.game.rules.snooker.snooker_fouls import COLOR, ORDER, RED, SnookerPhase
from pool2d.game.rules.snooker.snooker_spots import COLORS, spot_colors, spot_of
from pool2d.game.rules.spotting import put

from .cases import Case, rows
from .notation import only, without
from .rule_scenes import Scene, judged, told

TABLE = load_table("snooker-12ft")
RULES: Any = Snooker(TABLE)
START = RULES.start().layout
HIDDEN = "balls red1 yellow black, at red1 2.5 0.5, at yellow 1.5 0.5, at cue 1.0 0.5"
IN_SIGHT = "balls red1 black, at red1 2.5 0.5, at cue 1.0 0.5"


def asks(rules: Any, state: Any, layout: Layout, scene: Scene) -> State:
    found: State = rules.aiming(state, layout, 0, scene.where, state.free)
    return found


def ruled(given: str, shot: str = "") -> Ruling:
    return judged("snooker", TABLE, Case("", "", given, "", shot, ""), asks)[1]


def result(name: str, case: Case) -> str:
    return told(judged(name, TABLE, case, asks)[1], "phase")


@rows("snooker")
def test_clause(case: Case) -> None:
    assert result("snooker", case) == case.ruling


def chosen(ruling: Ruling, key: str) -> Ruling:
    found: Ruling = RULES.choose(ruling.state, ruling.layout, Choice(key))
    return found


def misses(ruling: Ruling) -> int:
    assert isinstance(ruling.state, SnookerState)
    return ruling.state.misses


def test_a_free_ball_is_nominated() -> None:
    """3.12 (a)"""
    ruling = chosen(ruled(HIDDEN), "play")
    assert (ruling.ask.player, ruling.ask.call, ruling.ask.on) == (1, "ball", ("red1", "yellow", "black"))


def test_who_plays_again_has_no_free_ball() -> None:
    """3.11 (h), 3.12 (f)"""
    ruling = chosen(ruled(HIDDEN), "play-again")
    assert (ruling.ask.player, ruling.ask.call, ruling.ask.on) == (0, "", ("red1",))


def test_a_cue_ball_that_fell_is_placed_in_the_d() -> None:
    """3.11 (f), 2.9"""
    ruling = chosen(ruled(IN_SIGHT, "cue-red1 cue>"), "play")
    assert (ruling.ask.kind, ruling.ask.where) == ("place", "d")
    line, middle = spot_of(TABLE, "brown")
    for place in ((line + 0.001, middle), (line - 0.21, middle + 0.21), (line, middle - 0.293)):
        with pytest.raises(InputError, match="allowed is in the D"):
            RULES.choose(ruling.state, ruling.layout, Choice("place", *place))
    placed = RULES.choose(ruling.state, ruling.layout, Choice("place", line - 0.2, middle + 0.2))
    assert (placed.ask.kind, placed.ask.where) == ("aim", "d")


def test_after_a_miss_everything_goes_back() -> None:
    """3.14 (b): the balls, and what was on."""
    missed = ruled(f"{IN_SIGHT}, phase color", "cue-red1 black>")
    back = chosen(missed, "put-back")
    assert (back.ask.player, back.ask.call, back.ask.on) == (0, "ball", ("black",))
    assert back.state.scores == (0, 7)
    assert [(back.layout[ball].x, back.layout[ball].y) for ball in ("cue", "red1")] == [(1.0, 0.5), (2.5, 0.5)]
    assert {ball.id for ball in back.layout.on_table()} == {"cue", "red1", "black"}


def test_a_player_is_warned_before_the_third_miss() -> None:
    """3.14 (d)"""
    missed = ruled(f"{IN_SIGHT}, misses 1")
    assert misses(missed) == 2
    assert "warned" in [note.key for note in chosen(missed, "put-back").notes]
    assert misses(chosen(missed, "put-back")) == 2
    assert misses(chosen(missed, "play-again")) == 0


@pytest.mark.parametrize("shot", ["cue-red1", "cue-red1 red1>", "cue-red1 cue>"])
def test_what_is_no_miss_ends_the_row_of_misses(shot: str) -> None:
    """3.14 (d) speaks of misses in a row: a red that is met, fair or with the cue ball down, begins anew."""
    assert misses(ruled(f"{IN_SIGHT}, misses 2", shot)) == 0
    assert misses(ruled(f"{IN_SIGHT}, misses 1", shot)) == 0


def test_a_frame_is_claimed_or_conceded() -> None:
    """2.1 (a), (b): only the striker may concede."""
    ahead = ruled("phase order, balls pink black, scores 60 50", "cue-pink pink>")
    assert chosen(ahead, "claim").state.winner == 0
    assert RULES.conceded(ahead.state, ahead.layout, 0).state.winner == 1
    with pytest.raises(InputError, match="concede = 1: allowed is 0, whose turn it is"):
        RULES.conceded(ahead.state, ahead.layout, 1)


@pytest.mark.parametrize(("key", "player"), [("play", 1), ("pass", 0)])
def test_who_wins_the_lots_says_who_plays_at_the_black(key: str, player: int) -> None:
    """3.4 (b)"""
    tie = ruled("phase order, balls black, scores 43 50", "cue-black black>")
    assert (tie.layout["black"].x, tie.layout["black"].y) == spot_of(TABLE, "black")
    ruling = chosen(tie, key)
    assert (ruling.ask.kind, ruling.ask.player, ruling.ask.where, ruling.ask.on) == ("place", player, "d", ("black",))


@pytest.mark.parametrize(
    ("scores", "phase", "balls", "left", "snookers"),
    [
        ((0, 0), RED, ("red1", "red2", *COLORS), 43, (0, 0)),
        ((0, 44), RED, ("red1", "red2", *COLORS), 43, (1, 0)),
        ((0, 43), RED, ("red1", "red2", *COLORS), 43, (0, 0)),
        ((52, 0), RED, ("red1", "red2", *COLORS), 43, (0, 3)),
        ((0, 0), COLOR, COLORS, 34, (0, 0)),
        ((20, 0), ORDER, ("pink", "black"), 13, (0, 2)),
        ((19, 0), ORDER, ("pink", "black"), 13, (0, 1)),
    ],
)
def test_snookers_needed(
    scores: tuple[int, int], phase: SnookerPhase, balls: tuple[str, ...], left: int, snookers: tuple[int, int]
) -> None:
    layout = only(START, *balls)
    assert points_left(phase, layout) == left
    state = RULES.aiming(SnookerState(scores=scores, phase=phase), layout, 0)
    assert (state.left, state.snookers) == (left, snookers)


def test_a_full_frame_holds_147() -> None:
    assert points_left(RED, START) == 147
    assert needed((0, 148), 147, RED, ("red1",)) == (1, 0)


def places(layout: Layout, *balls: str) -> dict[str, tuple[float, float]]:
    return dict(spot_colors(TABLE, without(layout, *balls), balls)[1])


def test_a_color_whose_spot_is_occupied_takes_the_highest_free_one() -> None:
    """3.7 (d), (e): the black goes before the pink."""
    layout = without(START, "green")
    layout = put(put(layout, "red1", spot_of(TABLE, "black")), "red2", spot_of(TABLE, "pink"))
    assert places(layout, "black", "pink", "blue") == {
        "blue": spot_of(TABLE, "blue"),
        "black": spot_of(TABLE, "green"),
        "pink": pytest.approx((spot_of(TABLE, "pink")[0] + 0.0526, 0.889)),
    }
    assert places(without(layout, "yellow"), "pink", "black") == {
        "black": spot_of(TABLE, "green"),
        "pink": spot_of(TABLE, "yellow"),
    }


def test_with_all_spots_occupied_a_color_goes_towards_the_top_cushion() -> None:
    """3.7 (f): as near as may be to its own spot, touching nothing."""
    layout = put(START, "red1", spot_of(TABLE, "blue"))
    (x, y) = places(layout, "blue")["blue"]
    assert y == 0.889
    assert 0.0525 < x - spot_of(TABLE, "blue")[0] < 0.0527


def test_without_room_there_it_goes_the_other_way() -> None:
    """3.7 (g)"""
    layout, (x, y) = START, spot_of(TABLE, "black")
    for ball, way in zip(
        (f"red{i}" for i in range(1, 8)), (0.0, 0.05251, 0.10502, 0.15753, 0.21004, 0.26255, 0.29), strict=True
    ):
        layout = put(layout, ball, (x + way, y))
    (found, _) = places(layout, "black")["black"]
    assert -0.0527 < found - x < -0.0525


def scene_of(*others: tuple[str, float, float]) -> Layout:
    """The cue ball at (1, 0.5), a red at (2.5, 0.5), and other balls."""
    layout = only(START, "red1", *(name for name, _, _ in others))
    layout = put(put(layout, "cue", (1.0, 0.5)), "red1", (2.5, 0.5))
    for name, x, y in others:
        layout = put(layout, name, (x, y))
    return layout


# A ball half-way reaches into the line to an edge of the red where it is less than a ball and a half from the middle.
@pytest.mark.parametrize(
    ("y", "hidden", "any_part", "full"),
    [
        (0.5, True, False, False),
        (0.5 + 0.026, True, False, False),
        (0.5 + 0.0270, True, True, False),
        (0.5 + 0.0524, True, True, False),
        (0.5 + 0.0526, True, True, True),
        (0.5 + 0.0785, True, True, True),
        (0.5 + 0.0790, False, True, True),
        (0.5 - 0.0785, True, True, True),
        (0.5 - 0.0790, False, True, True),
    ],
)
def test_a_ball_half_way_to_the_red(y: float, hidden: bool, any_part: bool, full: bool) -> None:
    """2.17: both edges have to be open; 3.14: any part, and the middle."""
    layout = scene_of(("yellow", 1.75, y))
    assert snookered(TABLE, layout, layout["cue"], ("red1",)) is hidden
    assert sees(TABLE, layout, layout["cue"], ("red1",)) is any_part
    assert sees_full(TABLE, layout, layout["cue"], ("red1",)) is full


def test_another_red_at_both_edges_is_enough() -> None:
    layout = put(scene_of(("yellow", 1.75, 0.5)).put(START["red2"]), "red2", (1.0, 1.2))
    assert not snookered(TABLE, layout, layout["cue"], ("red1", "red2"))


def test_balls_behind_the_red_or_the_cue_ball_hide_nothing() -> None:
    layout = scene_of(("yellow", 2.56, 0.5), ("black", 0.94, 0.5))
    assert not snookered(TABLE, layout, layout["cue"], ("red1",))


def test_two_balls_between_which_nothing_passes() -> None:
    layout = scene_of(("yellow", 1.75, 0.5 + 0.0300), ("green", 1.75, 0.5 - 0.0300))
    assert not sees(TABLE, layout, layout["cue"], ("red1",))


def test_a_touching_ball_is_no_snooker() -> None:
    layout = put(scene_of(("yellow", 1.75, 0.5)), "red1", (1.0, 0.5 + 0.0525))
    assert not snookered(TABLE, layout, layout["cue"], ("red1",))


def test_a_jaw_nearer_than_the_ball_in_the_way_is_no_snooker() -> None:
    """2.17 (e): cue ball in the jaws of a middle pocket, red along the cushion, yellow in between."""
    layout = only(START, "red1", "yellow")
    pocket = next(pocket for pocket in TABLE.geometry.pockets if pocket.name == "bottom-side")
    layout = put(put(layout, "cue", (pocket.x, 0.0)), "red1", (pocket.x + 0.9, 0.03))
    assert not snookered(TABLE, put(layout, "yellow", (pocket.x + 0.45, 0.03)), layout["cue"], ("red1",))
    assert snookered(TABLE, put(layout, "yellow", (pocket.x + 0.05, 0.02)), layout["cue"], ("red1",))


def test_the_frame_begins_in_the_d() -> None:
    start = RULES.start(breaker=1)
    assert (start.ask.kind, start.ask.player, start.ask.where) == ("aim", 1, "d")
    assert set(start.ask.on) == {f"red{i}" for i in range(1, 16)}
    rollout = simulate(TABLE, start.layout, Shot(angle=math.degrees(math.atan2(-0.06, 2.0)), speed=3.0))
    ruling = RULES.judge(start.state, rollout.layout(), observe(TABLE, rollout))
    assert ruling.state.shots == 1
