"""What a referee sees of balls in the air: jumps, balls that leave the table, tips that scoop or strike again.

The shots are the engine's; a tip that strikes again is put among the events by hand.
"""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from pool2d import Ball, Layout, Rollout, Shot, load_table, simulate
from pool2d.game.jumps import COVERED
from pool2d.game.referee import TIP_TIME, observe
from pool2d.game.rules import GAMES, Choice
from pool2d.game.rules.report import BALL, OFF, RAIL, TOP, Contact, Report
from pool2d.physics.event import Event
from pool2d.physics.values import EventKind

TABLE = load_table("pool-9ft")
RADIUS = TABLE.knobs.ball.radius
LENGTH, WIDTH = TABLE.knobs.table.length, TABLE.knobs.table.width
RAIL_TOP = TABLE.knobs.cushion.nose_height + TABLE.knobs.rail.height
ASIDE = Ball("cue", 0.6, 0.3)
BLOCKED = (Ball("cue", 0.6, 0.635), Ball("1", 0.9, 0.635), Ball("2", 1.9, 0.66))


def seen(*balls: Ball, **shot: float) -> Report:
    """The report of a shot; without one balls fly as they are given."""
    return observe(TABLE, simulate(TABLE, Layout(balls), Shot(**{"speed": 0.0, **shot})))  # type: ignore[arg-type]


@pytest.mark.parametrize(("elevation", "first", "over"), [(40.0, "2", ("1",)), (20.0, "1", ()), (0.0, "1", ())])
def test_a_jump_over_a_blocker(elevation: float, first: str, over: tuple[str, ...]) -> None:
    """A butt that is too low drives the cue ball into the ball that it was to clear."""
    report = seen(*BLOCKED, speed=3.5, elevation=elevation)
    assert (report.first, report.over) == ((first,), over)
    assert report.airborne == (elevation > 0.0)
    assert report.stroke == () and report.vaulted == ()


@pytest.mark.parametrize("height", [0.02, 0.04, 0.056])
@pytest.mark.parametrize(("part", "passed"), [(0.0, True), (0.5, True), (0.999, True), (1.001, False), (2.0, False)])
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_a_ball_is_passed_over_where_any_part_of_it_is_covered(
    height: float, part: float, passed: bool, side: float
) -> None:
    """A ball on the cloth goes by two radii away at least; one that is `height` above it need not."""
    least, most = math.sqrt(4.0 * RADIUS**2 - height**2) + 1e-5, 2.0 * RADIUS - COVERED
    # It is at its highest where it goes by.
    speed, rise = 6.0, 0.5 * TABLE.physics.gravity / 6.0
    low = height - 0.5 * rise * 0.5 / speed
    y = 0.635 + side * (least + part * (most - least))
    report = seen(Ball("cue", 0.6, y, vx=speed, vz=rise, z=max(low, 0.0)), Ball("1", 1.1, 0.635))
    assert report.over == (("1",) if passed else ())


def test_balls_passed_over_after_the_first_contact_are_told_apart() -> None:
    flying = Ball("cue", 0.6, 0.6, vx=3.0, vz=1.4, z=0.03)
    before = seen(flying, Ball("1", 0.9, 0.6), Ball("2", 1.1, 0.6))
    assert (before.over, before.over_later, before.airborne) == (("1", "2"), (), False)
    # A ball in the air beside the way is grazed at first.
    grazed = Ball("3", 0.66, 0.6 + 1.98 * RADIUS, z=0.058)
    after = seen(grazed, flying, Ball("1", 0.9, 0.6), Ball("2", 1.1, 0.6))
    assert after.first == ("3",) and after.airborne
    assert after.over == () and set(after.over_later) >= {"1"}


def test_a_ball_that_flies_over_the_cue_ball_is_not_jumped() -> None:
    hopping = Ball("cue", 1.0, 0.6, vz=0.4)
    report = seen(hopping, Ball("1", 0.8, 0.6, vx=4.0, vz=0.6, z=0.12))
    assert report.over == ()


@pytest.mark.parametrize(("height", "vaulted"), [(0.01, False), (0.03, False), (0.055, True)])
def test_a_ball_that_is_struck_from_above_is_vaulted_where_the_cue_ball_lands_beyond_it(
    height: float, vaulted: bool
) -> None:
    report = seen(Ball("cue", 0.6, 0.635, vx=2.5, z=height), Ball("1", 0.675, 0.635))
    assert (report.first, report.over, report.airborne) == (("1",), (), True)
    assert report.vaulted == (("1",) if vaulted else ())


def test_a_ball_is_not_vaulted_by_a_cue_ball_that_meets_another_before_it_lands() -> None:
    """2.20 (c) of snooker's rules; as above, but another ball comes down in its way."""
    above = Ball("cue", 0.6, 0.635, vx=2.5, z=0.055)
    assert seen(above, Ball("1", 0.675, 0.635)).vaulted == ("1",)
    report = seen(above, Ball("1", 0.675, 0.635), Ball("2", 0.8, 0.635, z=0.13))
    assert report.first == ("1",) and Contact(BALL, "cue", "2") in report.contacts and report.vaulted == ()


def test_the_cue_ball_leaves_the_table_over_a_cushion() -> None:
    report = seen(Ball("cue", 0.6, 0.635), Ball("1", 0.3, 0.3), speed=8.0, elevation=35.0)
    assert report.contacts == (Contact(OFF, "cue", "right"),)
    assert report.cue_off and report.cue_gone and not report.scratch
    assert report.off == () and report.on_rail == ()


@pytest.mark.parametrize(
    ("angle", "cushion"), [(0.0, "right"), (180.0, "left"), (80.0, "top-left"), (-80.0, "bottom-left")]
)
def test_an_object_ball_leaves_the_table(angle: float, cushion: str) -> None:
    way = math.radians(angle)
    flying = Ball("1", 0.9, 0.635, vx=6.0 * math.cos(way), vy=6.0 * math.sin(way), vz=1.5, z=0.06)
    report = seen(ASIDE, flying)
    assert report.left == {"1": cushion} and report.off == ("1",)
    assert not report.cue_off and report.on_rail == ()


def test_a_ball_that_leaves_is_driven_to_a_rail() -> None:
    """WPA 8.4; here after the cue ball has met it."""
    flying = Ball("1", LENGTH - 0.5, 0.635, vx=6.0, vz=1.0, z=0.1)
    report = seen(Ball("cue", LENGTH - 0.62, 0.635, vx=9.0, vz=1.0, z=0.1), flying)
    assert report.first == ("1",) and report.off == ("1",) and "1" in report.driven


@pytest.mark.parametrize("along", [0.05, -0.1])
def test_a_ball_at_rest_on_a_rail_is_off_the_table(along: float) -> None:
    report = seen(ASIDE, Ball("1", LENGTH + 0.06, 0.635, vx=along, z=RAIL_TOP))
    assert report.left == {"1": "right"} and report.on_rail == ("1",)


def test_a_ball_that_rolls_over_the_edge_of_a_rail_is_off_the_table_and_not_on_it() -> None:
    report = seen(ASIDE, Ball("1", LENGTH + 0.06, 0.635, vx=1.0, z=RAIL_TOP))
    assert report.left == {"1": "right"} and report.on_rail == ()


def test_a_ball_that_comes_back_from_a_rail_is_on_the_table_and_has_met_the_rail() -> None:
    """WPA 8.1, 8.4."""
    report = seen(ASIDE, Ball("1", LENGTH + 0.09, 0.635, vx=-0.5, z=RAIL_TOP + 0.03))
    assert Contact(TOP, "1", "right") in report.contacts
    assert all(contact.kind != RAIL for contact in report.contacts[:1])
    assert report.left == {}


def test_balls_meet_at_the_same_moment_in_space() -> None:
    """A ball above another is not met with it, however near it is in plan."""
    flying = Ball("cue", 0.6, 0.635, vx=2.0, z=0.3, vz=0.0)
    report = seen(flying, Ball("1", 0.78, 0.635, z=0.285), Ball("2", 0.78, 0.635))
    assert report.first == ("1",)


SCOOPED = {"speed": 6.0, "elevation": 4.0, "height": -0.8}


def test_a_tip_that_digs_under_the_cue_ball_scoops_it() -> None:
    report = seen(*BLOCKED, **SCOOPED)
    assert report.stroke == ("miscue", "scoop") and report.over[0] == "1"


@pytest.mark.parametrize(
    "other",
    [
        # A miscue that does not lift the ball, one above its centre, one to its side; a jump that is no miscue.
        {"elevation": 0.0},
        {"height": 0.8, "elevation": 20.0},
        {"height": 0.0, "elevation": 20.0, "side": 0.8},
        {"height": -0.2, "elevation": 40.0},
    ],
)
def test_other_strokes_are_no_scoops(other: dict[str, float]) -> None:
    report = seen(*BLOCKED, **{**SCOOPED, **other})
    assert "scoop" not in report.stroke
    assert ("miscue" in report.stroke) == (other.get("height", -0.8) != -0.2)


def struck_again(*times: float) -> Rollout:
    """A stroke along the table, with the tip at the cue ball again at these times."""
    roll = simulate(TABLE, Layout([Ball("cue", 0.5, 0.635), Ball("1", 1.0, 0.635)]), Shot(speed=1.0))
    kind: EventKind = "cue_ball"
    motion = roll.tracks["cue"][1]
    more = [Event(t, kind, None, [motion], [motion]) for t in times]
    return Rollout(roll.start, roll.tracks, sorted([*roll.events, *more], key=lambda event: event.t), False)


@pytest.mark.parametrize(
    ("times", "stroke"),
    [
        ((), ()),
        ((0.004,), ("second-hit",)),
        ((0.3 * TIP_TIME,), ("second-hit",)),
        ((0.01, 0.02), ("second-hit",)),
        ((0.3 * TIP_TIME, 0.6 * TIP_TIME), ("push",)),
        ((0.05, 0.05 + 0.4 * TIP_TIME, 0.05 + 0.8 * TIP_TIME), ("push",)),
    ],
)
def test_a_tip_that_strikes_the_cue_ball_again(times: tuple[float, ...], stroke: tuple[str, ...]) -> None:
    """WPA 3.7, 3.8: once more is a double hit, again and again within the time of one contact a push."""
    report = observe(TABLE, struck_again(*times))
    assert report.stroke == stroke and report.first == ("1",)


def test_a_ball_that_meets_the_back_of_its_pocket_is_obvious_all_the_same() -> None:
    contacts = (
        Contact(BALL, "cue", "1"),
        Contact(RAIL, "1", "top-left jaw"),
        Contact(RAIL, "1", "top-left back"),
        Contact(TOP, "1", "top-left"),
        Contact("pocket", "1", "top-left"),
    )
    assert Report(contacts, first=("1",)).called() == "1"
    off_another = (contacts[0], Contact(RAIL, "1", "top-right back"), contacts[-1])
    assert Report(off_another, first=("1",)).called() == ""


# From flights to rulings.

JUMPS = [
    ("nine-ball", "pool-9ft", "2", "1", ()),
    ("eight-ball", "pool-9ft", "2", "1", ()),
    ("one-pocket", "pool-9ft", "2", "1", ()),
    ("straight", "pool-9ft", "2", "1", ()),
    ("snooker", "snooker-12ft", "green", "red1", ("foul.jump",)),
    ("six-red", "snooker-12ft", "green", "red1", ("foul.jump",)),
    ("english-eight-ball", "english-7ft", "yellow1", "red1", ("foul.jump",)),
    ("blackball", "english-7ft", "yellow1", "red1", ("foul.jump",)),
    ("three-cushion", "carom-10ft", "yellow", "red", ()),
    ("free-pyramid", "pyramid-12ft", "2", "1", ()),
]


@pytest.mark.parametrize(("name", "table", "blocker", "target", "fouls"), JUMPS)
def test_a_jump_is_legal_where_the_game_has_it_so(
    name: str, table: str, blocker: str, target: str, fouls: tuple[str, ...]
) -> None:
    """The cue ball flies over a ball and meets the one that is on."""
    on = load_table(table)
    rules, start = GAMES[name](on), GAMES[name](on).start()
    if start.ask.kind == "choose":
        start = rules.choose(start.state, start.layout, Choice(start.ask.options[0]))
    y = 0.5 * on.knobs.table.width
    flying = start.layout["cue"]._replace(x=0.4, y=y, z=0.01, vx=2.4, vz=1.4)
    standing = {blocker: 0.7, target: 1.5}
    places = [start.layout[ball].still()._replace(x=x, y=y) for ball, x in standing.items()]
    # What else there is is out of the way.
    others = [ball._replace(phase="pocketed") for ball in start.layout.values() if ball.id not in {*standing, "cue"}]
    layout = start.layout.put(flying, *places, *others)
    roll = simulate(on, layout, Shot(speed=0.0))
    report = observe(on, roll)
    assert (report.first, report.over) == ((target,), (blocker,))
    ruling = rules.judge(replace(start.state, shots=5), roll.layout(), report)
    assert tuple(note.key for note in ruling.fouls if note.key in ("foul.jump", "foul.wrong-ball")) == fouls


@pytest.mark.parametrize(
    ("name", "lost", "what"),
    [
        ("eight-ball", "8", "loss.eight-off"),
        ("eight-ball", "3", "foul.over"),
        ("nine-ball", "9", "spotted"),
        ("straight", "3", "spotted"),
        ("one-pocket", "3", "spotted"),
    ],
)
def test_a_ball_that_flies_off_the_table_is_ruled_by_the_game(name: str, lost: str, what: str) -> None:
    rules, start = GAMES[name](TABLE), GAMES[name](TABLE).start()
    if start.ask.kind == "choose":
        start = rules.choose(start.state, start.layout, Choice(start.ask.options[0]))
    flying = start.layout[lost]._replace(x=0.5, y=0.635, z=0.06, vx=-6.0, vz=1.2)
    roll = simulate(TABLE, start.layout.put(flying), Shot(angle=0.0, speed=3.0))
    report = observe(TABLE, roll)
    assert report.left == {lost: "left"}
    ruling = rules.judge(replace(start.state, shots=5), roll.layout(), report)
    assert what in [note.key for note in ruling.notes]
    assert (lost in dict(ruling.spotted)) == (what == "spotted")
    assert (lost in [ball.id for ball in ruling.layout.on_table()]) == (what == "spotted")
