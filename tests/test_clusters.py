"""Many balls touching at once, and balls that touch cushions."""

from __future__ import annotations

import math
import random
from itertools import pairwise

import pytest

from pool2d import Ball, Event, Layout, Rollout, Shot, Table, load_table, simulate
from pool2d.physics import cluster
from pool2d.physics.contact import Contacts
from pool2d.physics.motion import Body
from pool2d.physics.values import ROLLING

from .checks import assert_sound, energy

TABLE = load_table("pool-9ft")
SMOOTH = TABLE.with_knobs({"ball.restitution": 1.0, "ball.law": "frictionless"})
RADIUS = TABLE.knobs.ball.radius
SPEED = 8.0


def tight_rack(speed: float = SPEED, gap: float = 0.0, cue: float = 0.635) -> Layout:
    """Fifteen balls in a triangle, and a cue ball on its way to the first."""
    balls = [Ball("cue", 1.2, cue, vx=speed, wy=speed / RADIUS)]
    pitch = 2.0 * RADIUS + gap
    for i in range(5):
        for j in range(i + 1):
            x, y = 1.905 + i * pitch * math.sqrt(0.75), 0.635 + (j - i / 2.0) * pitch
            balls.append(Ball(f"r{i}{j}", x, y))
    return Layout(balls)


def mirror(name: str) -> str:
    """The ball that stands opposite another in the rack."""
    return name if name == "cue" else f"r{name[1]}{int(name[1]) - int(name[2])}"


def first(rollout: Rollout, *kinds: str) -> Event:
    return next(event for event in rollout.events if event.kind in kinds)


def row(count: int, gap: float, speed: float) -> Layout:
    """Balls in line along x, the first one moving; the first two touch."""
    places = [0.6 + i * 2.0 * RADIUS + max(0, i - 1) * gap for i in range(count)]
    balls = [Ball(str(i), x, 0.635) for i, x in enumerate(places)]
    return Layout([balls[0]._replace(vx=speed), *balls[1:]])


def velocities(rollout: Rollout, count: int) -> list[float]:
    """Along the line, when all contacts of the first 10 ms are over."""
    last = max(event.t for event in rollout.events if event.t < 0.01 and event.kind in ("ball_ball", "cluster"))
    return [rollout.ball_at(str(i), last).vx for i in range(count)]


@pytest.mark.parametrize("table", [TABLE, SMOOTH], ids=["preset", "smooth"])
def test_a_square_break_is_symmetric(table: Table) -> None:
    """Right after it, and until chaos has made much of the last digits."""
    rollout = simulate(table, tight_rack())
    event = first(rollout, "cluster")
    assert len(event.balls) == 16
    for name, ball in event.after.items():
        other = event.after[mirror(name)]
        assert (ball.vx, ball.vy) == pytest.approx((other.vx, -other.vy), abs=1e-9 * SPEED)
        assert (ball.wx, ball.wy, ball.wz) == pytest.approx((-other.wx, other.wy, -other.wz), abs=1e-7)
    later = rollout.at(event.t + 0.25)
    for name, ball in later.items():
        other = later[mirror(name)]
        assert (ball.x, ball.y - 0.635) == pytest.approx((other.x, 0.635 - other.y), abs=1e-6)


def test_a_break_takes_hundreds_of_events_not_thousands() -> None:
    for cue in (0.635, 0.6375, 0.65):
        rollout = simulate(TABLE, tight_rack(12.0, cue=cue))
        assert len(rollout.events) < 400
        assert_sound(TABLE, rollout)


def test_the_order_of_the_balls_is_of_no_consequence_to_the_bit() -> None:
    layout = tight_rack(cue=0.64)
    expected = simulate(TABLE, layout).digest()
    balls = list(layout.values())
    for seed in range(5):
        random.Random(seed).shuffle(balls)
        assert simulate(TABLE, Layout(balls)).digest() == expected


@pytest.mark.parametrize("gap", [0.0, 2e-5, 1e-4])
@pytest.mark.parametrize("law", ["alciatore", "impulse", "frictionless", "mathavan2014"])
def test_a_cluster_keeps_momentum_and_gains_no_energy(law: str, gap: float) -> None:
    table = TABLE.with_knobs({"ball.law": law})
    event = first(simulate(table, tight_rack(gap=gap, cue=0.638)), "cluster")
    for part in ("vx", "vy"):
        before = sum(getattr(ball, part) for ball in event.before.values())
        assert sum(getattr(ball, part) for ball in event.after.values()) == pytest.approx(
            before, abs=1e-12 * SPEED * 16
        )
    assert energy(table, event.after.values()) <= energy(table, event.before.values())


def test_newtons_cradle_passes_the_blow_on() -> None:
    after = [v / 2.0 for v in velocities(simulate(SMOOTH, row(5, 0.0, 2.0)), 5)]
    assert after[-1] > 0.98
    assert sum(after) == pytest.approx(1.0)


@pytest.mark.parametrize("speed", [0.3, 0.5])
def test_a_tenth_of_a_millimetre_makes_it_one_after_another(speed: float) -> None:
    table = SMOOTH.with_knobs({"cloth.mu_slide": 0.01})
    after = velocities(simulate(table, row(4, 1e-4, speed)), 4)
    assert [v / speed for v in after] == pytest.approx([0.0, 0.0, 0.0, 1.0], abs=1e-3)


def test_what_a_gap_does_is_gradual() -> None:
    third = [velocities(simulate(SMOOTH, row(3, gap, 1.0)), 3)[0] for gap in (0.0, 1e-5, 2e-5, 5e-5, 1e-4)]
    assert third == sorted(third)
    assert third[0] == pytest.approx(-0.0709, abs=1e-3)
    assert all(b - a < 0.03 for a, b in pairwise(third))


@pytest.mark.parametrize("restitution", [0.5, 0.8, 0.95, 1.0])
@pytest.mark.parametrize("cut", [0.0, 30.0, 60.0])
def test_a_lone_pair_comes_out_as_by_its_law(restitution: float, cut: float) -> None:
    physics = TABLE.with_knobs({"ball.restitution": restitution}).physics
    angle = math.radians(cut)

    def pair() -> tuple[Body, Body]:
        cue = Ball("cue", 0.0, 0.0, vx=2.0, wy=20.0, wz=15.0)
        one = Ball("1", 2.0 * RADIUS * math.cos(angle), 2.0 * RADIUS * math.sin(angle))
        return Body(cue, 0, RADIUS, 0.17), Body(one, 1, RADIUS, 0.17)

    (a, b), (c, d) = pair(), pair()
    cluster.solve([(a, b, 0.0)], 2.0 * math.cos(angle), physics)
    Contacts(physics).ball_law(c, d, physics)
    for sprung, struck in ((a, c), (b, d)):
        assert (sprung.vx, sprung.vy) == pytest.approx((struck.vx, struck.vy), abs=0.012)


def test_a_ball_frozen_to_a_cushion_is_driven_into_it_and_comes_back() -> None:
    reach = TABLE.reach(RADIUS)
    balls = [Ball("cue", 1.0, 0.4, vy=-2.0), Ball("1", 1.0, reach)]
    rollout = simulate(TABLE, Layout(balls))
    kinds = [event.kind for event in rollout.events[:5] if event.t < 0.2]
    assert kinds[:3] == ["sliding_rolling", "ball_ball", "ball_cushion"] or kinds[:2] == ["ball_ball", "ball_cushion"]
    assert rollout.layout()["cue"].y > 0.1
    assert_sound(TABLE, rollout)


def test_a_ball_struck_along_the_cushion_it_is_frozen_to_stays_on_it() -> None:
    low = TABLE.reach(RADIUS)
    rollout = simulate(TABLE, Layout([Ball("cue", 0.7, low)]), Shot(angle=0.0, speed=0.6))
    end = rollout.layout()["cue"]
    assert end.x > 1.0
    assert end.y == pytest.approx(low, abs=1e-6)


def test_three_balls_squeezed_against_a_rail() -> None:
    low = TABLE.reach(RADIUS)
    up = low + 2.0 * RADIUS * math.sqrt(0.75)
    balls = [
        Ball("1", 1.0 - RADIUS, low),
        Ball("2", 1.0 + RADIUS, low),
        Ball("3", 1.0, up),
        Ball("cue", 1.0, 0.5, vy=-3.0),
    ]
    rollout = simulate(TABLE, Layout(balls))
    assert_sound(TABLE, rollout)
    assert len(rollout.events) < 200
    end = rollout.at(first(rollout, "cluster").t + 0.1)
    assert end["1"].x - 1.0 == pytest.approx(1.0 - end["2"].x, abs=1e-6)


def test_a_ball_wedged_in_the_jaws() -> None:
    """A ball as wide as a side pocket's mouth is driven between the jaws."""
    table = TABLE.with_knobs({"side.mouth": 0.07, "side.drop_radius": 0.06})
    wide = Ball("1", 1.27, 0.2, vy=-1.5, radius=0.0345)
    rollout = simulate(table, Layout([wide]))
    assert len(rollout.events) < 300
    assert not rollout.truncated
    assert math.isfinite(rollout.layout()["1"].y)


def test_frozen_balls_of_unequal_size() -> None:
    a, b = Ball("1", 1.0, 0.6), Ball("2", 1.0 + 2.0 * math.sqrt(RADIUS * 0.024), 0.6, radius=0.024, mass=0.1)
    cue = Ball("cue", 0.7, 0.6, vx=2.0)
    rollout = simulate(TABLE, Layout([cue, a, b]))
    assert first(rollout, "cluster").balls == ("1", "2", "cue")
    assert_sound(TABLE, rollout)


def test_a_ball_follows_another_into_the_pocket() -> None:
    pocket = next(one for one in TABLE.geometry.pockets if one.name == "bottom-left")
    size = math.hypot(0.3 - pocket.x, 0.3 - pocket.y)
    ux, uy = (pocket.x - 0.3) / size, (pocket.y - 0.3) / size
    balls = [Ball("1", 0.3, 0.3), Ball("2", 0.3 - 2.2 * RADIUS * ux, 0.3 - 2.2 * RADIUS * uy)]
    moving = [ball._replace(vx=ux, vy=uy, wx=-uy / RADIUS, wy=ux / RADIUS) for ball in balls]
    rollout = simulate(TABLE, Layout(moving))
    assert [event.balls for event in rollout.events if event.kind == "ball_pocket"] == [("1",), ("2",)]


def test_a_fast_ball_at_a_bad_angle_is_refused() -> None:
    shot = Shot(angle=-20.0, speed=6.0)
    layout = Layout([Ball("cue", 1.05, 0.125)])
    rollout = simulate(TABLE, layout, shot)
    jaws = [event for event in rollout.events if event.where == "bottom-side jaw"]
    assert jaws
    assert rollout.layout()["cue"].phase != "pocketed" or rollout.events[-1].where != "bottom-side"


def test_a_slow_ball_hangs_on_the_shelf() -> None:
    """It rolls into the mouth of a corner pocket and stops before the slate ends."""
    pocket = next(one for one in TABLE.geometry.pockets if one.name == "top-right")
    size = math.hypot(2.2 - pocket.x, 0.93 - pocket.y)
    way = size - pocket.radius - 0.01
    speed = math.sqrt(2.0 * 0.01 * 9.81 * way)
    ux, uy = (pocket.x - 2.2) / size, (pocket.y - 0.93) / size
    ball = Ball("1", 2.2, 0.93, speed * ux, speed * uy, -speed * uy / RADIUS, speed * ux / RADIUS)
    rollout = simulate(TABLE, Layout([ball]))
    assert first(rollout, "rolling_resting").before["1"].phase == ROLLING
    end = rollout.layout()["1"]
    assert end.phase == "resting"
    assert math.hypot(end.x - pocket.x, end.y - pocket.y) == pytest.approx(pocket.radius + 0.01, abs=1e-6)
    assert TABLE.knobs.table.length - end.x < TABLE.reach(RADIUS)
