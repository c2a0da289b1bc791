"""Balls and cushions as one: on a rail, squeezed against it, in a corner, between two jaws."""

from __future__ import annotations

import math
from itertools import pairwise, product

import pytest

from benchmarks.fuzz import play as fuzz
from pool2d import Ball, Event, Layout, Rollout, Shot, Table, load_table, simulate
from pool2d.config.knobs import apply
from pool2d.physics import springs
from pool2d.physics.body import Body
from pool2d.physics.cluster import Group, solve
from pool2d.physics.detect import NOISE, Rail
from pool2d.physics.laws.registry import CUSHION_LAWS
from pool2d.physics.materials import materials
from pool2d.physics.params import CushionKnobs, Physics

from ..checks import assert_sound
from ..hits import collide_cushion

TABLE = load_table("pool-9ft")
RADIUS = TABLE.knobs.ball.radius
PITCH, LOW = 2.0 * RADIUS, TABLE.reach(RADIUS)


def cluster(roll: Rollout) -> Event:
    """The first event of several contacts."""
    return next(event for event in roll.events if len(event.pairs) + len(event.rails) > 1)


def played(*balls: Ball, shot: Shot, table: Table = TABLE, most: int = 60) -> Rollout:
    roll = simulate(table, Layout(balls), shot)
    assert_sound(table, roll, samples=200)
    assert len(roll.events) < most
    return roll


def test_ball_on_a_rail_driven_straight_into_it() -> None:
    roll = played(Ball("cue", 0.8, 0.6), Ball("1", 0.8, LOW), shot=Shot(angle=-90.0, speed=3.0))
    hit = cluster(roll)
    assert (hit.pairs, hit.rails, hit.where) == ((("1", "cue"),), (("1", "bottom-left"),), "bottom-left")
    # The ball in between hands the blow to the rail, and back to the cue ball.
    assert hit.after["cue"].vy > 0.7 * -hit.before["cue"].vy
    # It meets the cue ball while it still has some of the rubber's push to come.
    assert 0.0 < hit.after["1"].vy < 0.1 * -hit.before["cue"].vy
    assert all(abs(x - 0.8) < 1e-9 for ball in ("cue", "1") for _, x, _ in roll.path(ball, 0.01))


def test_ball_on_a_rail_sent_along_it() -> None:
    roll = played(Ball("cue", 0.25, LOW), Ball("1", 0.5, LOW), shot=Shot(speed=2.0))
    first = next(event for event in roll.events if event.kind == "ball_ball")
    assert first.after["1"].vx > 1.5
    assert max(y for _, x, y in roll.path("1", 0.005) if x < 1.0) < LOW + 1e-9


def test_ball_on_a_rail_cut_thinly_runs_along_it() -> None:
    roll = played(Ball("cue", 0.4, 0.2), Ball("1", 0.8, LOW), shot=Shot(angle=-20.0, speed=2.0))
    first = cluster(roll)
    assert first.rails == (("1", "bottom-left"),)
    assert first.after["1"].vx > 0.5
    assert first.after["1"].vy > 0.0


@pytest.mark.parametrize("height", [-0.4, 0.0, 0.4])
def test_three_squeezed_against_a_rail(height: float) -> None:
    balls = [Ball("cue", 0.8, LOW + 2.0 * PITCH), Ball("1", 0.8, LOW + PITCH), Ball("2", 0.8, LOW)]
    roll = played(*balls, shot=Shot(angle=-90.0, speed=4.0, height=height), most=100)
    assert cluster(roll) is roll.events[0]
    back = max(event.after["cue"].vy for event in roll.events if "cue" in event.balls)
    # The tip is still there when they come back, and takes a part of it.
    assert 0.4 < back < 2.0
    assert all(abs(x - 0.8) < 1e-9 for ball in ("cue", "1", "2") for _, x, _ in roll.path(ball, 0.01))


def test_ball_between_the_jaws_of_a_pocket() -> None:
    """A pocket too narrow for it holds a ball by both jaws; it is struck there, and comes out."""
    table = TABLE.with_knobs({"corner.mouth": 0.05, "corner.drop_radius": 0.03})
    way = table.cast(0.3, 0.3, -1.0, -1.0, Layout())[0] / math.sqrt(2.0)
    wedged = Ball("1", 0.3 - way, 0.3 - way)
    for angle in (-135.0, -130.0):
        for speed in (0.5, 4.0, 12.0):
            cue = Ball(
                "cue", wedged.x - 0.4 * math.cos(math.radians(angle)), wedged.y - 0.4 * math.sin(math.radians(angle))
            )
            roll = played(cue, wedged, shot=Shot(angle=angle, speed=speed), table=table, most=120)
            assert cluster(roll).rails == (("1", "bottom-left jaw"),) * 2
            assert math.hypot(roll.layout()["1"].x, roll.layout()["1"].y) > math.hypot(wedged.x, wedged.y)


@pytest.mark.parametrize("law", CUSHION_LAWS)
@pytest.mark.parametrize("speed", [0.3, 3.0, 9.0])
def test_a_ball_sent_into_a_corner_comes_back_the_way_it_came(law: str, speed: float) -> None:
    """Both cushions at once, so that neither is the first: one after the other would turn it off the diagonal."""
    table = load_table("carom-10ft", {"cushion.law": law})
    ball = Ball("white", 0.4, 0.4, -speed, -speed)
    hit = cluster(simulate(table, Layout([ball])))
    assert hit.rails == (("white", "bottom"), ("white", "left"))
    after = hit.after["white"]
    assert after.vx > 0.0
    assert after.vx == pytest.approx(after.vy, rel=1e-12)
    assert after.wx == pytest.approx(-after.wy, rel=1e-12)
    assert abs(after.wz) < 1e-9


def test_a_corner_met_a_little_to_one_side_is_met_nearly_so() -> None:
    """There is no jump between both cushions at once and one just before the other."""
    table = load_table("carom-10ft")

    def way(aside: float) -> float:
        roll = simulate(table, Layout([Ball("white", 0.4 + aside, 0.4, -3.0, -3.0)]))
        hits = [event.t for event in roll.events if event.rails]
        after = roll.at(next(t for t in reversed(hits) if t < hits[0] + 0.02))["white"]
        return math.degrees(math.atan2(after.vy, after.vx))

    ways = [way(aside) for aside in (0.0, 1e-6, 1e-5, 1e-4, 5e-4, 1e-3)]
    assert ways[0] == pytest.approx(45.0, abs=1e-9)
    assert max(abs(b - a) for a, b in pairwise(ways)) < 6.0
    assert abs(ways[1] - ways[0]) < 0.1


def test_two_jaws_at_once_send_it_straight_back() -> None:
    table = TABLE.with_knobs({"corner.mouth": 0.05, "corner.drop_radius": 0.03})
    roll = simulate(table, Layout([Ball("cue", 0.3, 0.3, -2.0, -2.0)]))
    assert cluster(roll).rails == (("cue", "bottom-left jaw"),) * 2
    after = cluster(roll).after["cue"]
    assert after.vx > 0.2
    assert after.vx == pytest.approx(after.vy, rel=1e-9)


def test_a_row_of_two_pressed_on_a_rail_is_a_mirror_of_itself() -> None:
    """The cue ball drives in between two balls frozen to a rail and to each other."""
    x = 0.9
    balls = [Ball("a", x - RADIUS, LOW), Ball("b", x + RADIUS, LOW), Ball("cue", x, 0.5, 0.0, -4.0)]
    event = cluster(simulate(TABLE, Layout(balls)))
    assert {name for name, _ in event.rails} == {"a", "b"}
    a, b, cue = (event.after[name] for name in ("a", "b", "cue"))
    assert (a.vx, a.vy) == pytest.approx((-b.vx, b.vy), rel=1e-12)
    assert (a.wx, a.wy, a.wz) == pytest.approx((b.wx, -b.wy, -b.wz), rel=1e-9)
    assert a.vx < 0.0 < a.vy
    assert abs(cue.vx) < 1e-12


def test_a_ball_alone_leaves_the_spring_as_it_leaves_the_law() -> None:
    """The spring of a cushion is `mathavan2010` in time: it gives back e^2 of the work, with the same friction."""
    rail = Rail("top", 1.0, 0.0, -1.0, 0.0)
    for e, along, incidence, topspin, english in product(
        (0.0, 0.5, 0.92, 0.98), (0.0, 0.3, 1.0), (5, 45, 90), (-1.0, 0.0, 1.0, 1.5), (-2, 0, 1)
    ):
        physics, turn = Physics(cushion=CushionKnobs(restitution=e, tangential=along)), math.radians(incidence)
        vx, vy = math.cos(turn), math.sin(turn)
        ball = Ball("1", 0.0, -LOW, vx, vy, -topspin * vy / RADIUS, topspin * vx / RADIUS, english / RADIUS)
        one, two = Body(ball, 0, RADIUS, 0.17), Body(ball, 0, RADIUS, 0.17)
        collide_cushion("mathavan2010", one, 0.0, 1.0, physics)
        solve(Group([], [(two, rail, 0.0)]), vy, materials(physics))
        # A dead cushion stops the ball within a step of the spring, not to the last digit; and what the steps
        # of its friction differ by, rubber that springs back gives once more.
        more = 1.0 + 1.2 * along
        assert (two.vx, two.vy) == pytest.approx((one.vx, one.vy), abs=more * (3e-3 if e > 0.0 else 5e-2))
        for name in ("wx", "wy", "wz"):
            assert RADIUS * getattr(two, name) == pytest.approx(
                RADIUS * getattr(one, name), abs=more * (3e-2 if e > 0.0 else 0.1)
            )


@pytest.mark.parametrize("aim", [-90.0, -70.0, -40.0])
def test_how_soft_a_cushion_is_hardly_counts(monkeypatch: pytest.MonkeyPatch, aim: float) -> None:
    """Only that it is much softer than a ball."""
    turn = math.radians(aim)
    cue = Ball("cue", 0.8 - 0.3 * math.cos(turn), LOW - 0.3 * math.sin(turn))
    after = []
    for rubber in (springs.RUBBER, springs.RUBBER / 4.0):
        monkeypatch.setattr(springs, "RUBBER", rubber)
        after.append(cluster(simulate(TABLE, Layout([cue, Ball("1", 0.8, LOW)]), Shot(aim, 3.0))).after)
    for name in ("cue", "1"):
        one, two = (states[name] for states in after)
        assert (two.vx, two.vy) == pytest.approx((one.vx, one.vy), abs=0.1)


def test_a_ball_squeezed_by_a_dead_cushion_comes_to_an_end() -> None:
    """Once, at these knobs, a ball between another and a rail bounced on and on until the budget was used up."""
    knobs = {"cushion.restitution": 0.0, "ball.restitution": 0.0, "cloth.mu_slide": 1.0, "cushion.friction": 1.0}
    result = fuzz(TABLE.with_knobs(knobs), 5, 189)
    assert result.faults == []
    assert result.events < 2000


@pytest.mark.parametrize("restitution", [0.0, 0.9])
@pytest.mark.parametrize(("half", "friction"), [(3.0, 0.2), (6.0, 0.2), (15.0, 0.5), (15.0, 0.2), (40.0, 0.5)])
def test_a_ball_driven_into_a_wedge_stays_where_friction_holds_it(
    half: float, friction: float, restitution: float
) -> None:
    """It holds itself where the wedge is narrower than the angle of friction, and comes out of a wider one."""
    turn = math.radians(half)
    walls = [
        Rail("upper", math.cos(turn), 0.0, 0.0, math.sin(turn)),
        Rail("lower", 0.0, -math.sin(turn), math.cos(turn), 0.0),
    ]
    ball = Body(Ball("1", 0.0, 0.0, 0.05, 0.0, 30.0, -40.0, 5.0), 0, RADIUS, 0.17)
    before = ball.energy()
    knobs: dict[str, object] = {"cushion.restitution": restitution, "cushion.friction": friction}
    group = Group([], [(ball, wall, 0.0) for wall in walls])
    solve(group, 0.05 * math.sin(turn), materials(apply(Physics(), knobs, "test")))
    closing = [ball.vx * nx + ball.vy * ny for nx, ny in (wall.normal(0.0, 0.0) for wall in walls)]
    assert max(closing) <= NOISE
    assert (ball.vx == 0.0) == (math.tan(turn) < friction)
    assert ball.energy() <= before


@pytest.mark.parametrize("apart", [1.4, 1.5, 1.95])
@pytest.mark.parametrize("order", [(0, 1, 2), (2, 1, 0), (1, 2, 0)])
def test_a_ball_that_goes_on_into_two_wedged_ones_is_stopped_by_both(apart: float, order: tuple[int, ...]) -> None:
    """Once by one after the other, so that it went on into the first: again and again, each time by half as much."""
    turn = math.radians(3.0)
    walls = [
        Rail("upper", math.cos(turn), 0.0, 0.0, math.sin(turn)),
        Rail("lower", 0.0, -math.sin(turn), math.cos(turn), 0.0),
    ]
    side = apart * RADIUS
    balls = [Ball("0", -math.sqrt(PITCH**2 - side**2), 0.0, 0.05, 0.0, 0.0, 30.0, 5.0)]
    balls += [Ball("1", 0.0, side), Ball("2", 0.0, -side)]
    heavy, one, two = (
        Body(ball, index, RADIUS, mass) for ball, index, mass in zip(balls, order, (2.0, 0.01, 0.01), strict=True)
    )
    before = heavy.energy()
    solve(
        Group([(heavy, one, 0.0), (heavy, two, 0.0)], [(ball, wall, 0.0) for ball in (one, two) for wall in walls]),
        0.05,
        materials(Physics()),
    )
    assert (one.vx, one.vy, two.vx, two.vy) == (0.0, 0.0, 0.0, 0.0)
    for ball in (one, two):
        assert (heavy.vx * (ball.x - heavy.x) + heavy.vy * (ball.y - heavy.y)) / PITCH <= NOISE
    assert heavy.energy() <= before
    assert (one.mass, two.mass) == (0.01, 0.01)
