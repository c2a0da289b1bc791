"""Reports made from rollouts: what a referee would see of a shot on the real table."""

from __future__ import annotations

import math

import pytest

from pool2d import Ball, Layout, Shot, load_table, simulate
from pool2d.game.referee import observe
from pool2d.game.rules.report import BALL, POCKET, RAIL, Call, Contact, Report
from pool2d.physics.motion import span
from pool2d.physics.values import POCKETED

from .rules.notation import report

TABLE = load_table("pool-9ft")
RADIUS = TABLE.knobs.ball.radius
REACH = TABLE.reach(RADIUS)
WIDTH = TABLE.knobs.table.width


def seen(*balls: Ball, **shot: float) -> Report:
    """The report of a shot at some balls."""
    return observe(TABLE, simulate(TABLE, Layout(balls), Shot(**shot)))  # type: ignore[arg-type]


def test_contacts_come_in_their_order() -> None:
    report = seen(Ball("cue", 0.5, 0.635), Ball("1", 1.0, 0.635), angle=0.0, speed=4.0)
    assert report.contacts[:2] == (Contact(BALL, "cue", "1"), Contact(RAIL, "1", "right"))
    assert report.first == ("1",)
    assert report.driven[0] == "1"
    assert (report.touching, report.frozen, report.stroke) == ((), (), ())


def test_a_ball_that_falls_names_its_pocket() -> None:
    report = seen(Ball("cue", 2.2, 0.95), Ball("1", 2.4, 1.14), angle=43.5, speed=2.0)
    assert report.pots == (("1", "top-right"),)
    assert not report.cue_gone
    assert report.driven[-1] == "1"


def test_a_call_holds_where_ball_and_pocket_agree() -> None:
    roll = simulate(TABLE, Layout([Ball("cue", 2.2, 0.95), Ball("1", 2.4, 1.14)]), Shot(angle=43.5, speed=2.0))
    calls = {pocket: observe(TABLE, roll, Call("1", pocket)).called() for pocket in ("top-right", "top-left")}
    assert calls == {"top-right": "1", "top-left": ""}


@pytest.mark.parametrize(
    ("contacts", "called"),
    [
        ("cue-1 1>top-left", "1"),
        ("cue-1 1|top-left_jaw 1>top-left", "1"),
        ("cue|right cue-1 1>top-left", ""),
        ("cue-1 1|right 1>top-left", ""),
        ("cue-1 1-2 2>top-left", ""),
        ("cue-1 1-2 1>top-left", ""),
    ],
)
def test_an_obvious_shot_needs_no_call(contacts: str, called: str) -> None:
    """WPA 1.7: banks, kicks, caroms and combinations are not obvious."""
    assert report(contacts).called() == called


def test_a_scratch_is_not_among_the_pots() -> None:
    report = seen(Ball("cue", 2.4, 1.14), angle=43.5, speed=2.0)
    assert report.scratch
    assert report.cue_gone
    assert report.potted == ()
    assert report.contacts[-1] == Contact(POCKET, "cue", "top-right")
    assert report.first == ()


def test_a_miss_drives_nothing_after_a_hit() -> None:
    report = seen(Ball("cue", 0.5, 0.3), Ball("1", 1.0, 1.0), angle=0.0, speed=1.0)
    assert report.first == ()
    assert report.driven == ()


def test_a_frozen_ball_has_to_leave_its_cushion() -> None:
    """WPA 8.4: a ball touching a rail at the start is driven to it only if it comes back."""
    frozen = Ball("1", 1.0, WIDTH - REACH)
    along = seen(frozen, Ball("cue", 0.6, WIDTH - REACH - 0.9 * RADIUS), angle=0.0, speed=0.5)
    assert along.frozen == (("1", "top-left"),)
    assert along.first == ("1",)
    assert Contact(RAIL, "1", "top-left") not in along.contacts
    pressed = seen(frozen, Ball("cue", 1.0, WIDTH - REACH - 0.2), angle=90.0, speed=0.4)
    assert pressed.first == ("1",)
    assert Contact(RAIL, "1", "top-left") not in pressed.contacts


def test_a_ball_that_comes_back_to_its_cushion_meets_it() -> None:
    report = seen(Ball("cue", 1.0, WIDTH - REACH), angle=-90.0, speed=4.0)
    assert report.frozen == (("cue", "top-left"),)
    assert [contact.other for contact in report.contacts[:2]] == ["bottom-left", "top-left"]


def test_balls_met_at_the_same_moment_are_both_first() -> None:
    report = seen(
        Ball("cue", 0.5, 0.635), Ball("1", 1.0, 0.635 + RADIUS), Ball("2", 1.0, 0.635 - RADIUS), angle=0.0, speed=3.0
    )
    assert sorted(report.first) == ["1", "2"]


def test_of_two_balls_one_after_the_other_the_nearer_is_first() -> None:
    report = seen(Ball("cue", 0.5, 0.635), Ball("1", 1.0, 0.66), Ball("2", 1.002, 0.60), angle=0.0, speed=3.0)
    assert len(report.first) == 1


def test_a_frozen_cue_ball_is_told() -> None:
    balls = Ball("cue", 0.5, 0.635), Ball("1", 0.5 + 2.0 * RADIUS, 0.635)
    into, away = seen(*balls, angle=20.0, speed=2.0), seen(*balls, angle=170.0, speed=1.0)
    assert into.touching == away.touching == ("1",)
    assert into.pressed == ("1",)
    assert into.stroke == ()
    assert away.pressed == ()


@pytest.mark.parametrize(("gap", "angle", "stroke"), [(0.001, 0.0, ("second-hit",)), (0.2, 0.0, ()), (0.001, 70.0, ())])
def test_a_ball_met_while_the_tip_is_on_the_cue_ball(gap: float, angle: float, stroke: tuple[str, ...]) -> None:
    """WPA 6.7; who barely grazes a close ball is given the benefit."""
    close = Ball("1", 0.5 + 2.0 * RADIUS + gap, 0.635)
    assert seen(Ball("cue", 0.5, 0.635), close, angle=angle, speed=2.0).stroke == stroke


@pytest.mark.parametrize("way", [0.0, 37.0, 120.0, 180.0, 250.0, 325.0])
@pytest.mark.parametrize(("cut", "full"), [(0.0, True), (25.0, True), (-25.0, True), (40.0, False), (-40.0, False)])
def test_a_close_ball_is_hit_in_full_or_grazed_whichever_way_it_lies(way: float, cut: float, full: bool) -> None:
    """Thinner than half a ball, which is 30 degrees from the line of centres, is grazed."""
    far = 2.0 * RADIUS + 5e-4
    close = Ball("1", 1.1 + far * math.cos(math.radians(way)), 0.5 + far * math.sin(math.radians(way)))
    told = seen(Ball("cue", 1.1, 0.5), close, angle=(way + cut) % 360.0, speed=2.0)
    assert told.first == ("1",) and told.touching == ()
    assert told.stroke == (("second-hit",) if full else ())


def test_the_tip_of_an_easy_stroke_is_gone_once_it_has_struck() -> None:
    close = Layout([Ball("cue", 0.5, 0.635), Ball("1", 0.501 + 2.0 * RADIUS, 0.635)])
    roll = simulate(TABLE, close, Shot(angle=0.0, speed=2.0, easy=True))
    assert observe(TABLE, roll, easy=True).stroke == ()


@pytest.mark.parametrize("gap", [5e-4, 0.002, 0.006])
def test_a_tip_that_runs_on_strikes_the_ball_again(gap: float) -> None:
    assert seen(Ball("cue", 0.5, 0.635), Ball("1", 0.5 + 2.0 * RADIUS + gap, 0.635), speed=2.0).stroke == (
        "second-hit",
    )


def test_a_tip_that_stays_with_the_ball_pushes_it() -> None:
    assert seen(Ball("cue", 0.5, 0.635), Ball("1", 0.5001 + 2.0 * RADIUS, 0.635), speed=0.05).stroke == ("push",)


@pytest.mark.parametrize("gap", [0.0, 3e-5])
@pytest.mark.parametrize(
    ("x", "y", "rail"),
    [
        (0.6, REACH, "bottom-left"),
        (1.9, REACH, "bottom-right"),
        (0.6, WIDTH - REACH, "top-left"),
        (1.9, WIDTH - REACH, "top-right"),
        (REACH, 0.5, "left"),
        (TABLE.knobs.table.length - REACH, 0.5, "right"),
    ],
)
def test_a_ball_that_lies_on_a_cushion_is_frozen_to_that(x: float, y: float, rail: str, gap: float) -> None:
    """One that a sheet of paper would go behind is not."""
    inward = {"bottom": (0.0, 1.0), "top": (0.0, -1.0), "left": (1.0, 0.0), "right": (-1.0, 0.0)}[rail.split("-")[0]]
    frozen = Ball("1", x + gap * inward[0], y + gap * inward[1])
    told = seen(frozen, Ball("cue", 1.27, 0.7), angle=90.0, speed=0.1)
    assert told.frozen == ((("1", rail),) if gap == 0.0 else ())


def test_what_has_fallen_before_goes_over_no_line() -> None:
    fallen = [Ball("8", 0.0, 0.0, phase=POCKETED), Ball("9", 2.5, 1.2, phase=POCKETED)]
    told = seen(Ball("cue", 0.3, 0.635), Ball("1", 0.5, 0.635), *fallen, angle=0.0, speed=3.0)
    assert told.crossed == told.passed == told.cleared == ("1",)
    assert (told.touching, told.frozen) == ((), ())


def test_a_miscue_is_told() -> None:
    assert seen(Ball("cue", 0.5, 0.635), side=0.9, speed=1.0).stroke == ("miscue",)


@pytest.mark.parametrize(("x", "angle", "kitchen"), [(0.5, 0.0, True), (0.8, 0.0, False), (0.5, 180.0, True)])
def test_the_kitchen(x: float, angle: float, kitchen: bool) -> None:
    cue = Ball("cue", 0.3 if angle == 0.0 else 0.6, 0.635)
    assert seen(cue, Ball("1", x, 0.635), angle=angle, speed=3.0).kitchen == kitchen


def test_a_cue_ball_that_crossed_the_head_string_may_come_back() -> None:
    report = seen(Ball("cue", 0.6, 0.9), Ball("1", 0.4, 0.9), angle=0.0, speed=5.0)
    assert report.first == ("1",)
    assert (report.kitchen, report.stayed) == (False, False)


@pytest.mark.parametrize(("x", "angle", "stayed"), [(0.3, 180.0, True), (0.66, 0.0, False)])
def test_a_cue_ball_that_stays_in_the_kitchen(x: float, angle: float, stayed: bool) -> None:
    """WPA 3.11: it has to leave, or to meet a ball beyond the line."""
    assert seen(Ball("cue", 0.5, 0.3), Ball("1", x, 0.3), angle=angle, speed=0.3).stayed == stayed


def test_lines_that_balls_go_over() -> None:
    report = seen(Ball("cue", 0.3, 0.635), Ball("1", 0.5, 0.635), Ball("2", 1.0, 0.2), angle=0.0, speed=3.0)
    assert report.crossed == report.passed == ("1",)


def test_the_contacts_of_one_ball_are_told_from_its_side() -> None:
    report = Report((Contact(BALL, "cue", "1"), Contact(RAIL, "cue", "top"), Contact(RAIL, "1", "left")))
    assert report.of("1") == (Contact(BALL, "1", "cue"), Contact(RAIL, "1", "left"))


@pytest.mark.parametrize(("side", "low", "high"), [(0.4, 0.6, 0.65), (-0.4, 0.55, 0.6)])
def test_a_curve_goes_furthest_between_its_ends(side: float, low: float, high: float) -> None:
    """A massé that bends back: where it turns lies within one motion, before the first cushion."""
    hand = math.copysign(1.0, side)
    ball = Ball("cue", 0.5, 0.6, vx=3.92, vy=0.431 * hand, wx=163.5 * hand, wy=18.0, wz=138.0 * hand)
    roll = simulate(TABLE, Layout([ball]))
    end = 0.5
    ends = [motion.y for motion in roll.tracks["cue"] if motion.t0 < end] + [roll.at(end)["cue"].y]
    seen = [roll.at(end * step / 4000)["cue"].y for step in range(4001)]
    assert not any(event.rails for event in roll.events if event.t < end)
    assert span(roll.tracks["cue"], end, 0.0, 1.0) == pytest.approx((min(seen), max(seen)), abs=1e-6)
    assert max(seen) - max(ends) > 0.02 or min(ends) - min(seen) > 0.02
    assert min(seen) <= low
    assert max(seen) >= high


def test_a_ball_that_is_pressed_on_meets_its_cushion_once() -> None:
    roll = simulate(TABLE, Layout([Ball("cue", 1.0, 0.9)]), Shot(angle=70.0, speed=2.0))
    events = list(roll.events)
    at = next(i for i, event in enumerate(events) if event.rails)
    again = roll.__class__(roll.start, roll.tracks, [*events[: at + 1], events[at], *events[at + 1 :]], truncated=False)
    assert observe(TABLE, again).contacts == observe(TABLE, roll).contacts
