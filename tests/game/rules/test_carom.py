"""Three-cushion and straight rail: their clauses, what is put on which spot, and what is read from the engine."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from pool2d import Layout, Shot, load_table, simulate
from pool2d.game.referee import observe
from pool2d.game.rules import Choice, State
from pool2d.game.rules.carom.carom import cushions_before_last
from pool2d.game.rules.carom.straight_rail import StraightRail
from pool2d.game.rules.carom.three_cushion import ThreeCushion
from pool2d.game.rules.corners import corner_of
from pool2d.game.rules.report import Report
from pool2d.game.rules.spotting import put

from .cases import Case, rows
from .notation import report
from .rule_scenes import Scene, judged, told

TABLE = load_table("carom-10ft")
SPOTS = TABLE.furniture.spots
THREE: Any = ThreeCushion(TABLE)


def asks(rules: Any, state: Any, layout: Layout, scene: Scene) -> State:
    opening = "opening" in scene.state
    found: State = rules.opened(state, 0) if opening else rules.aim(replace(state, opening=False), 0)
    return found


def result(name: str, case: Case) -> str:
    ruling = judged(name, TABLE, case, asks)[1]
    return told(ruling, "innings", "run", *(("zone",) if name == "straight-rail" else ()))


@rows("three-cushion")
def test_three_cushion(case: Case) -> None:
    assert result("three-cushion", case) == case.ruling


@rows("straight-rail")
def test_straight_rail(case: Case) -> None:
    assert result("straight-rail", case) == case.ruling


def where(layout: Layout) -> dict[str, tuple[float, float]]:
    return {ball.id: (ball.x, ball.y) for ball in layout.values()}


@pytest.mark.parametrize("breaker", [0, 1])
def test_the_opening(breaker: int) -> None:
    """Art. 23: who begins has the white, on one of two spots."""
    start = THREE.start(breaker)
    assert (start.ask.player, start.ask.ball, start.ask.on) == (breaker, "cue", ("red",))
    assert where(start.layout) == {"cue": SPOTS["right"], "yellow": SPOTS["head"], "red": SPOTS["foot"]}
    moved = THREE.choose(start.state, start.layout, Choice("start-spot:left"))
    assert where(moved.layout)["cue"] == SPOTS["left"]
    assert moved.ask.options == ("start-spot:right",)
    missed = THREE.judge(moved.state, moved.layout, report("cue-red", start=moved.layout))
    assert (missed.ask.player, missed.ask.ball, missed.ask.on) == (1 - breaker, "yellow", ("cue", "red"))


def test_the_last_inning_begins_in_the_starting_position() -> None:
    state = replace(THREE.start().state, scores=(39, 0), opening=False)
    seen = report("cue-red cue| cue| cue| cue-yellow")
    layout = put(THREE.start().layout, "red", (1.0, 1.0))
    last = THREE.judge(THREE.aim(state, 0), layout, seen)
    assert (last.ask.player, last.ask.ball, last.ask.on) == (1, "yellow", ("red",))
    assert where(last.layout) == {"yellow": SPOTS["right"], "cue": SPOTS["head"], "red": SPOTS["foot"]}


@pytest.mark.parametrize(
    ("places", "spots"),
    [
        # The player's ball goes to the head spot, the opponent's to the centre, the red to the foot.
        ({"cue": (1.0, 0.3), "red": (1.0, 0.3615), "yellow": (2.0, 1.2)}, {"cue": "head", "red": "foot"}),
        ({"cue": (1.0, 0.3), "yellow": (1.0, 0.3615), "red": (2.0, 1.2)}, {"cue": "head", "yellow": "center"}),
        # The spot is occupied: the spot of the ball on it.
        ({"cue": (1.0, 0.3), "red": (1.0, 0.3615), "yellow": SPOTS["foot"]}, {"cue": "head", "red": "center"}),
        ({"cue": (1.0, 0.3), "red": (1.0, 0.3615), "yellow": SPOTS["head"]}, {"cue": "center", "red": "foot"}),
        ({"cue": (1.0, 0.3), "yellow": (1.0, 0.3615), "red": SPOTS["head"]}, {"cue": "foot", "yellow": "center"}),
        ({"cue": (1.0, 0.3), "yellow": (1.0, 0.3615), "red": (1.42, 0.76)}, {"cue": "head", "yellow": "foot"}),
        # Both touch the player's.
        (
            {"cue": (1.0, 0.3), "yellow": (1.0, 0.3615), "red": (1.0, 0.2385)},
            {"cue": "head", "yellow": "center", "red": "foot"},
        ),
    ],
)
def test_touching_balls_are_spotted(places: dict[str, tuple[float, float]], spots: dict[str, str]) -> None:
    """Art. 27 (4) (b)"""
    layout = THREE.start().layout
    for ball, place in places.items():
        layout = put(layout, ball, place)
    state = THREE.aim(replace(THREE.start().state, opening=False, shots=3), 0, "respot")
    ruling = THREE.choose(state, layout, Choice("respot"))
    assert where(ruling.layout) == {**places, **{ball: SPOTS[spot] for ball, spot in spots.items()}}
    assert dict(ruling.spotted) == {ball: SPOTS[spot] for ball, spot in spots.items()}
    assert ruling.ask.options == ()


def played(angle: float, speed: float, **places: tuple[float, float]) -> Report:
    layout = THREE.start().layout
    for ball, place in places.items():
        layout = put(layout, ball, place)
    return observe(TABLE, simulate(TABLE, layout, Shot(angle=angle, speed=speed)))


def test_a_ball_shot_into_its_cushion_is_seen() -> None:
    reach = TABLE.reach(0.03075)
    on_the_rail = {"cue": (1.0, reach), "yellow": (1.5, 0.5), "red": (2.0, 0.5)}
    assert played(-80.0, 2.0, **on_the_rail).jammed == ("bottom",)
    assert played(80.0, 3.0, **on_the_rail).jammed == ()


def test_cushions_are_counted_from_a_shot() -> None:
    """A ball along the table: foot cushion, head cushion, foot cushion, and then the red beside its way."""
    seen = played(0.0, 5.0, cue=(1.0, 0.2), yellow=(0.5, 1.2), red=(2.0, 1.2))
    assert cushions_before_last(seen) >= 3


def test_a_ball_that_leaves_a_corner_is_seen() -> None:
    corner = {"cue": (2.4, 0.23), "red": (2.7, 0.2), "yellow": (2.75, 0.1)}
    assert corner_of(TABLE, 2.7, 0.2) == corner_of(TABLE, 2.75, 0.1) == "foot right"
    assert "red" in played(0.0, 3.0, **corner).strayed
    assert played(0.0, 0.3, **corner).strayed == ()


@pytest.mark.parametrize(
    ("x", "y", "corner"),
    [
        (0.0, 0.355, "head right"),
        (0.0, 0.356, ""),
        (0.71, 0.0, "head right"),
        (0.711, 0.0, ""),
        (0.355, 0.1775, "head right"),
        (0.2, 1.3, "head left"),
        (2.7, 1.3, "foot left"),
        (2.7, 0.1, "foot right"),
        (1.42, 0.71, ""),
    ],
)
def test_the_corners(x: float, y: float, corner: str) -> None:
    """Art. 52: 71 cm along the long cushion, 35.5 along the short; who lies on the line is in (53)."""
    assert corner_of(TABLE, x, y) == corner


STRAIGHT: Any = StraightRail(TABLE)


def test_who_touches_at_straight_rail_may_have_all_balls_spotted() -> None:
    """Art. 27 (1), (4) (a): or play away; the starting position is in no corner."""
    layout = STRAIGHT.start().layout
    for ball, place in {"cue": (2.64, 0.1), "red": (2.7, 0.1), "yellow": (2.7, 0.25)}.items():
        layout = put(layout, ball, place)
    layout = put(layout, "cue", (2.7 - 0.0615, 0.1))
    state = STRAIGHT.aim(replace(STRAIGHT.start().state, opening=False, shots=3), 0)
    ruling = STRAIGHT.judge(state, layout, report("cue-red cue-yellow", start=layout))
    assert (ruling.ask.kind, ruling.ask.player, ruling.ask.options, ruling.state.zone) == ("aim", 0, ("respot",), 2)
    assert ruling.layout == layout
    spotted = STRAIGHT.choose(ruling.state, ruling.layout, Choice("respot"))
    assert where(spotted.layout) == {"cue": SPOTS["right"], "yellow": SPOTS["head"], "red": SPOTS["foot"]}
    assert (spotted.ask.player, spotted.ask.options, spotted.state.zone) == (0, (), -1)


@pytest.mark.parametrize(
    ("shot", "words"),
    [
        ("", "No ball was met."),
        ("cue-red cue|", "Only the red was met."),
        ("cue-yellow", "Only the yellow was met."),
        ("cue-red cue-yellow cue|", "No cushion before the second ball."),
        ("cue-red cue| cue-yellow", "One cushion before the second ball."),
        ("cue| cue-red cue| cue-yellow", "Two cushions before the second ball."),
    ],
)
def test_a_missed_cannon_says_why(shot: str, words: str) -> None:
    state = THREE.aim(replace(THREE.start().state, opening=False, shots=3), 0)
    ruling = THREE.judge(state, THREE.start().layout, report(shot))
    assert (ruling.notes[0].text, ruling.foul, ruling.ask.player) == (words, False, 1)


def test_only_the_first_stroke_is_a_break() -> None:
    start = THREE.start()
    assert start.notes[-1].key == "break"
    assert THREE.judge(start.state, start.layout, report("cue-red")).notes[-1].key == "turn"
