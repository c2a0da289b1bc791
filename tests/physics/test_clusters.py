"""Balls in contact as springs: racks under every law, cradles, balls on a rail, pairs, balls of several sizes."""

from __future__ import annotations

import math
import random
from collections.abc import Iterable
from itertools import pairwise

import pytest

from pool2d import Ball, Event, Layout, Rollout, Shot, Table, load_table, simulate
from pool2d.physics.body import Body
from pool2d.physics.cluster import Group, linked, solve
from pool2d.physics.crowd import Crowd
from pool2d.physics.laws.registry import BALL_LAWS
from pool2d.physics.materials import materials
from pool2d.physics.motion import start
from pool2d.physics.params import BallKnobs, Physics

from ..checks import assert_sound, energy
from ..hits import collide_balls
from ..scenes import open_table

TABLE = load_table("pool-9ft")
RADIUS = TABLE.knobs.ball.radius
PITCH = 2.0 * RADIUS
MIDDLE = 0.635
# Names of the balls of a rack by row and place, and each one's mirror image.
NAMES = [f"{row}{place}" for row in range(5) for place in range(row + 1)]
MIRROR = {"cue": "cue", **{name: f"{name[0]}{int(name[0]) - int(name[1])}" for name in NAMES}}
LAWS = pytest.mark.parametrize("law", BALL_LAWS)


def rack(names: Iterable[str] = NAMES) -> Layout:
    """Fifteen balls that touch, and the cue ball in line with them."""
    balls = [Ball("cue", 1.0, MIDDLE)]
    for place, name in zip(NAMES, names, strict=True):
        row, step = int(place[0]), int(place[1])
        balls.append(Ball(name, 1.9 + row * PITCH * math.sqrt(0.75), MIDDLE + (step - row / 2.0) * PITCH))
    return Layout(balls)


def cluster(roll: Rollout) -> Event:
    """The first event of many balls."""
    return next(event for event in roll.events if event.kind == "cluster")


def with_law(law: str, table: Table = TABLE) -> Table:
    return table.with_knobs({"ball.law": law})


@LAWS
@pytest.mark.parametrize("shot", [Shot(speed=8.0), Shot(speed=8.0, height=0.3), Shot(speed=3.0, height=-0.3)])
def test_rack_broken_square_stays_a_mirror_of_itself(law: str, shot: Shot) -> None:
    table = with_law(law)
    roll = simulate(table, rack(), shot)
    first = cluster(roll).after
    assert set(first) == set(MIRROR)
    for name, image in MIRROR.items():
        a, b = first[name], first[image]
        velocity = (b.vx, -b.vy, -RADIUS * b.wx, RADIUS * b.wy, -RADIUS * b.wz)
        found = (a.vx, a.vy, RADIUS * a.wx, RADIUS * a.wy, RADIUS * a.wz)
        assert found == pytest.approx(velocity, abs=1e-9 * shot.speed)
    # And through the whole shot, wherever the balls are.
    for i in range(101):
        now = roll.at(roll.duration * i / 100)
        for name, image in MIRROR.items():
            a, b = now[name], now[image]
            assert (a.x, a.y) == pytest.approx((b.x, 2.0 * MIDDLE - b.y), abs=1e-6), now


@LAWS
def test_names_of_the_balls_are_of_no_consequence(law: str) -> None:
    """Another name sorts a ball elsewhere, so that sums may differ by their rounding, and by no more."""
    table, shot = with_law(law), Shot(angle=2.0, speed=8.0, side=0.2)
    first = cluster(simulate(table, rack(), shot, events=2)).after
    names = list(NAMES)
    random.Random(4).shuffle(names)
    other = cluster(simulate(table, rack(names), shot, events=2)).after
    for place, name in zip(NAMES, names, strict=True):
        a, b = first[place], other[name]
        assert (b.vx, b.vy) == pytest.approx((a.vx, a.vy), abs=1e-11)
        assert (b.wx, b.wy, b.wz) == pytest.approx((a.wx, a.wy, a.wz), abs=1e-9)


@pytest.mark.parametrize("gap", [0.0, 1e-6, 1e-5, 1e-4])
@pytest.mark.parametrize("restitution", [0.0, 0.5, 0.95, 1.0])
@LAWS
def test_cluster_keeps_momentum_and_adds_no_energy(law: str, restitution: float, gap: float) -> None:
    table = with_law(law).with_knobs({"ball.restitution": restitution, "ball.cling": 3.0})
    layout = Layout(
        ball._replace(x=1.0 + (ball.x - 1.0) * (1.0 + gap / PITCH)) if ball.id != "cue" else ball
        for ball in rack().values()
    )
    roll = simulate(table, layout, Shot(angle=3.0, speed=8.0, side=0.4, height=-0.4))
    for event in roll.events:
        if event.kind == "cluster":
            old, new = event.before, event.after
            assert energy(table, new.values()) <= energy(table, old.values()) * (1.0 + 1e-12)
            if not event.rails:
                for name in ("vx", "vy"):
                    before, after = (sum(getattr(ball, name) for ball in balls.values()) for balls in (old, new))
                    assert after == pytest.approx(before, abs=1e-12)
    assert sum(event.kind == "cluster" for event in roll.events) >= (gap < 1e-4)


def approach(a: Ball, b: Ball) -> float:
    """How fast two balls near each other, m/s."""
    dx, dy = b.x - a.x, b.y - a.y
    return ((a.vx - b.vx) * dx + (a.vy - b.vy) * dy) / math.hypot(dx, dy)


def row(count: int, gap: float, moving: int = 1, v: float = 0.5, e: float = 1.0) -> list[float]:
    """Velocities over `v` after the first balls of a row, `moving` of them, have run into the others."""
    table = open_table(ball__law="frictionless", ball__restitution=e)
    # The ones that move arrive from so near that the cloth has no time to act.
    places = [2.0 + i * (PITCH + gap) + (gap - 1e-9 if i < moving else 0.0) for i in range(count)]
    balls = [Ball(str(i), x, 2.0, v if i < moving else 0.0) for i, x in enumerate(places)]
    roll = simulate(table, Layout(balls))
    last = [event.t for event in roll.events if event.kind in ("ball_ball", "cluster") and event.t < 0.01][-1]
    return [roll.at(last)[str(i)].vx / v for i in range(count)]


@pytest.mark.parametrize(("count", "moving"), [(2, 1), (3, 1), (5, 1), (3, 2), (5, 2), (5, 3)])
def test_a_tenth_of_a_millimetre_makes_a_cradle(count: int, moving: int) -> None:
    """Balls a hair apart meet one after the other: as many leave as came."""
    expected = [0.0] * (count - moving) + [1.0] * moving
    # The cloth takes 0.08 % on the way through each gap.
    assert row(count, 1e-4, moving) == pytest.approx(expected, abs=1e-3 * (count - 2 if count > 2 else 1))


def test_between_touching_and_apart_there_is_no_jump() -> None:
    """The wider the gaps the more the last ball takes."""
    taken = [row(3, gap)[2] for gap in (0.0, 1e-7, 1e-6, 3e-6, 1e-5, 2e-5, 3e-5, 4e-5)]
    assert taken == sorted(taken)
    assert max(b - a for a, b in pairwise(taken)) < 2.5e-3


@pytest.mark.parametrize(("e", "spread"), [(0.0, 0.03), (0.1, 0.2)])
def test_balls_that_hardly_rebound_go_on_together(e: float, spread: float) -> None:
    found = row(3, 0.0, e=e)
    assert found == sorted(found)
    assert found[2] - found[0] < spread


@pytest.mark.parametrize("law", BALL_LAWS)
@pytest.mark.parametrize("restitution", [0.1, 0.5, 0.9, 0.95, 1.0])
@pytest.mark.parametrize("cut", [0.0, 20.0, 45.0, 70.0])
@pytest.mark.parametrize("topspin", [0.0, 25.0])
def test_pair_alone_leaves_the_springs_as_it_leaves_the_law(
    law: str, restitution: float, cut: float, topspin: float
) -> None:
    physics, turn = Physics(ball=BallKnobs(restitution=restitution, law=law)), math.radians(cut)
    nx, ny = math.cos(turn), math.sin(turn)

    def pair() -> tuple[Body, Body]:
        cue, other = Ball("a", 0.0, 0.0, 2.0, wy=topspin, wz=-20.0), Ball("b", PITCH * nx, PITCH * ny, wz=5.0)
        return Body(cue, 0, RADIUS, 0.17), Body(other, 1, RADIUS, 0.17)

    (a, b), (c, d) = pair(), pair()
    collide_balls(law, a, b, physics)
    solve(Group([(c, d, 0.0)], []), 2.0 * nx, materials(physics))
    assert (d.vx - c.vx) * nx + (d.vy - c.vy) * ny == pytest.approx(restitution * 2.0 * nx, rel=1e-6)
    # The slate holds the balls down, so that slip up and down ends later than the laws reckon, by 5/2
    # against 7/2 of the friction. The springs go through that; without such slip they agree.
    speed, spin = (1e-6, 1e-6) if topspin == 0.0 else (6e-3, 3e-2)
    for one, two in ((a, c), (b, d)):
        assert (two.vx, two.vy) == pytest.approx((one.vx, one.vy), abs=2.0 * speed)
        for name in ("wx", "wy", "wz"):
            assert RADIUS * getattr(two, name) == pytest.approx(RADIUS * getattr(one, name), abs=2.0 * spin)


# Two frozen balls, and balls of several sizes.


@pytest.mark.parametrize("aim", [0.0, 20.0, 40.0])
def test_second_of_two_frozen_balls_goes_where_they_point(aim: float) -> None:
    turn = math.radians(aim)
    table = open_table(ball__law="frictionless")
    second = Ball("2", 3.0 + PITCH * math.cos(turn), 2.0 + PITCH * math.sin(turn))
    roll = simulate(table, Layout([Ball("cue", 2.5, 2.0), Ball("1", 3.0, 2.0), second]), Shot(speed=3.0))
    # The pair that set it off comes first.
    assert cluster(roll).pairs == (("1", "cue"), ("1", "2"))
    after = cluster(roll).after
    assert math.degrees(math.atan2(after["2"].vy, after["2"].vx)) == pytest.approx(aim, abs=1e-5)
    # What the second ball takes of the first one's way along the line is what restitution leaves it.
    along = after["1"].vx * math.cos(turn) + after["1"].vy * math.sin(turn)
    assert along < 0.25 * math.hypot(after["2"].vx, after["2"].vy)


def test_a_pair_pushed_from_the_side_is_thrown() -> None:
    """Friction on the first of two frozen balls carries the second off the line (Alciatore, frozen throw)."""
    turn = math.radians(40.0)
    second = Ball("2", 3.0 + PITCH * math.cos(turn), 2.0 + PITCH * math.sin(turn))
    layout = Layout([Ball("cue", 2.5, 2.0), Ball("1", 3.0, 2.0), second])
    after = cluster(simulate(open_table(), layout, Shot(speed=1.0))).after
    thrown = 40.0 - math.degrees(math.atan2(after["2"].vy, after["2"].vx))
    assert 2.0 < thrown < 7.0


@LAWS
def test_balls_of_several_sizes(law: str) -> None:
    table = with_law(law)
    rng = random.Random(5)
    sizes = [(0.0255, 0.12), (0.028575, 0.17), (0.034, 0.28)]
    for _ in range(40):
        balls: list[Ball] = []
        for i in range(4):
            radius, mass = rng.choice(sizes)
            x = 1.2 if not balls else balls[-1].x + 2.0 * math.sqrt(radius * (balls[-1].radius or RADIUS))
            balls.append(Ball(str(i), x, 0.6, radius=radius, mass=mass))
        wx, wy, wz = (rng.gauss(0.0, 50.0) for _ in range(3))
        cue = Ball("cue", 1.0, 0.6 + rng.uniform(-0.03, 0.03), 3.0, 0.0, wx, wy, wz)
        roll = simulate(table, Layout([cue, *balls]))
        assert_sound(table, roll, samples=20)
        for event in roll.events:
            if event.kind == "cluster":
                momenta = [
                    [sum(getattr(ball, name) * table.body_of(roll.start[ball.id])[1] for ball in balls.values())
                     for name in ("vx", "vy")]
                    for balls in (event.before, event.after)
                ]  # fmt: skip
                assert momenta[0] == pytest.approx(momenta[1], abs=1e-12)


def test_a_break_takes_hundreds_of_events_not_thousands() -> None:
    for aim in (0.0, 0.11, 0.6):
        rollout = simulate(TABLE, rack(), Shot(angle=aim, speed=9.0))
        assert len(rollout.events) < 400
        assert_sound(TABLE, rollout)


def test_the_order_of_the_balls_is_of_no_consequence_to_the_bit() -> None:
    layout, shot = rack(), Shot(angle=0.2, speed=8.0)
    expected = simulate(TABLE, layout, shot).digest()
    balls = list(layout.values())
    for seed in range(5):
        random.Random(seed).shuffle(balls)
        assert simulate(TABLE, Layout(balls), shot).digest() == expected


def test_a_group_is_the_same_from_whichever_of_its_balls_it_is_found() -> None:
    bodies = [Body(ball, index, RADIUS, 0.17) for index, ball in enumerate(rack().values())]
    crowd = Crowd(bodies, [start(body, 0.0, materials(Physics()).cloth) for body in bodies])
    for motion in crowd.motion:
        crowd.put(motion)
    touching = [
        (a.index, b.index)
        for a in bodies
        for b in bodies
        if a.index < b.index and math.dist((a.x, a.y), (b.x, b.y)) < 1.01 * PITCH
    ]
    assert len(touching) == 30
    for body in bodies[1:]:
        found = linked([body], crowd, 1e-6, 0.0)
        assert [(a.index, b.index) for a, b, _ in found] == touching
        assert max(gap for _, _, gap in found) < 1e-12
    assert linked(bodies[:1], crowd, 1e-6, 0.0) == []
