"""The facings of pockets: ends of cushions of other stuff than the cushion."""

from __future__ import annotations

import math
import random
from itertools import takewhile

import pytest

from pool2d import Ball, Event, Layout, Rollout, Table, load_table, simulate
from pool2d.config.knobs import walk
from pool2d.physics.materials import materials

TABLE = load_table("pool-9ft", {"facing.restitution": 1.0, "facing.tangential": 0.0, "facing.friction": 1.0})
RADIUS = TABLE.knobs.ball.radius
# A facing that is like the cushion in nothing, and a cushion that is as this facing is.
OTHER = TABLE.with_knobs({"facing.restitution": 0.5, "facing.tangential": 0.3, "facing.friction": 2.0})
LIKE = TABLE.with_knobs({"cushion.restitution": 0.5 * 0.92, "cushion.tangential": 0.3, "cushion.friction": 2.0 * 0.17})


def rolling(x: float, y: float, vx: float, vy: float) -> Ball:
    return Ball("1", x, y, vx, vy, -vy / RADIUS, vx / RADIUS)


def into_the_mouth(table: Table, beside: float, angle: float, speed: float) -> Ball:
    """A ball that rolls to the pocket at the origin, to pass its middle at a distance."""
    deep, way = table.knobs.corner.mouth / math.sqrt(8.0), math.radians(225.0 + angle)
    ux, uy = math.cos(way), math.sin(way)
    return rolling(deep - 0.3 * ux - uy * beside, deep - 0.3 * uy + ux * beside, speed * ux, speed * uy)


def first_touch(rollout: Rollout) -> Event:
    return next(event for event in rollout.events if event.rails)


@pytest.mark.parametrize("beside", [-0.036, -0.03, 0.02, 0.03, 0.036])
def test_a_jaw_is_of_the_facing(beside: float) -> None:
    """A ball leaves it as it leaves a cushion of that restitution and friction, its rounding and its straight part."""
    ball = into_the_mouth(TABLE, beside, 10.0, 2.0)
    here, like, cushion = (first_touch(simulate(table, Layout([ball]))) for table in (OTHER, LIKE, TABLE))
    assert here.where == "bottom-left jaw"
    assert here.after["1"] == like.after["1"] != cushion.after["1"]


def test_what_springs_back_along_a_facing_is_on_top_of_what_does_along_a_cushion() -> None:
    ball = into_the_mouth(TABLE, 0.03, 10.0, 2.0)
    outs = []
    for cushion, facing in ((0.2, 0.3), (0.5, 0.0), (0.8, 0.4), (1.0, 0.0)):
        table = TABLE.with_knobs({"cushion.tangential": cushion, "facing.tangential": facing, "cushion.friction": 1.0})
        outs.append(first_touch(simulate(table, Layout([ball]))).after["1"])
        assert materials(table.knobs).facing.tangential == pytest.approx(min(1.0, cushion + facing))
    assert outs[0] == outs[1] != outs[2] == outs[3]


def test_a_cushion_is_not_of_the_facing() -> None:
    ball = rolling(0.6, 0.3, 0.5, -1.0)
    here, cushion = (first_touch(simulate(table, Layout([ball]))) for table in (OTHER, TABLE))
    assert here.where == "bottom-left"
    assert here.after["1"] == cushion.after["1"]


def test_a_ball_on_both_jaws_of_a_pocket_is_of_the_facings_too() -> None:
    """Two contacts at once, which are solved as a cluster of springs."""
    tables = [table.with_knobs({"corner.mouth": 0.05, "corner.angle": 137.0}) for table in (OTHER, LIKE, TABLE)]
    ball = into_the_mouth(tables[0], 0.0, 0.0, 1.0)
    here, like, cushion = (first_touch(simulate(table, Layout([ball]))) for table in tables)
    assert here.kind == "cluster" and len(here.rails) == 2
    assert here.after["1"] == like.after["1"] != cushion.after["1"]


def test_energy_falls_at_a_facing_whatever_it_is_of() -> None:
    rng = random.Random(15)
    met = 0
    for _ in range(150):
        knobs = {
            name: rng.uniform(knob.lo, knob.hi) for name, knob, _ in walk(TABLE.knobs) if name.startswith("facing.")
        }
        table = TABLE.with_knobs(knobs)
        ball = into_the_mouth(table, rng.uniform(-0.06, 0.06), rng.uniform(-30.0, 30.0), rng.uniform(0.2, 6.0))
        spun = ball._replace(
            wx=rng.uniform(-200.0, 200.0), wy=rng.uniform(-200.0, 200.0), wz=rng.uniform(-200.0, 200.0)
        )
        for event in simulate(table, Layout([spun]), events=12).events:
            if event.rails:
                met += 1
                assert energy(event.after["1"]) <= energy(event.before["1"]) * (1.0 + 1e-12)
    assert met > 150


def energy(ball: Ball) -> float:
    """Twice that of a ball by its mass."""
    spin = ball.wx * ball.wx + ball.wy * ball.wy + ball.wz * ball.wz
    return ball.vx * ball.vx + ball.vy * ball.vy + 0.4 * RADIUS * RADIUS * spin


@pytest.mark.parametrize("angle", [0.0, 15.0, 38.0])
def test_a_pocket_is_its_own_mirror_image(angle: float) -> None:
    """What comes beside the axis on one side goes as what comes as far on the other."""
    for beside in (-0.045, -0.03, -0.01, 0.02, 0.033):
        left = in_the_mouth(into_the_mouth(OTHER, beside, angle, 1.5))
        right = in_the_mouth(into_the_mouth(OTHER, -beside, -angle, 1.5))
        assert [event.kind for event in left] == [event.kind for event in right]
        for one, other in zip(left, right, strict=True):
            here, there = one.after["1"], other.after["1"]
            assert (here.x, here.y, here.vx, here.vy) == pytest.approx((there.y, there.x, there.vy, there.vx), abs=1e-6)


def in_the_mouth(ball: Ball) -> list[Event]:
    """What comes of a ball until it is out of the pocket again: the rest of the table is no mirror image."""
    events = simulate(OTHER, Layout([ball])).events
    return list(takewhile(lambda event: math.hypot(event.after["1"].x, event.after["1"].y) < 0.4, events))
