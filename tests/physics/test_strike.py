"""The cue's strike, from level to upright, from the centre to the edge of the ball."""

from __future__ import annotations

import math

import pytest
from hypothesis import assume, given

from pool2d import Ball, InputError, Layout, Shot, load_table, simulate
from pool2d.physics.body import Body
from pool2d.physics.params import Cue
from pool2d.physics.strike import miscue_limit
from pool2d.physics.strike import strike as strike_law

from ..plays import between, shots
from ..scenes import open_table

RADIUS, MASS = 0.028575, 0.17
LIMIT = miscue_limit(Cue().tip_friction)


def struck(shot: Shot, cue: Cue | None = None) -> Body:
    body = Body(Ball("cue", 1.0, 0.6), 0, RADIUS, MASS)
    strike_law(body, shot, cue or Cue())
    return body


def state(body: Body) -> tuple[float, ...]:
    return body.vx, body.vy, RADIUS * body.wx, RADIUS * body.wy, RADIUS * body.wz


def test_level_centre_hit_sends_the_ball_along_the_aim_without_spin() -> None:
    for angle in (0.0, 30.0, -135.0):
        vx, vy, *spin = state(struck(Shot(angle=angle, speed=2.0)))
        # Momentum and restitution: m v = J, V' = V - J/M, v - V' = e V.
        speed = (1.0 + Cue().tip_restitution) * 2.0 / (1.0 + MASS / Cue().mass)
        assert (vx, vy) == pytest.approx(
            (speed * math.cos(math.radians(angle)), speed * math.sin(math.radians(angle))), abs=1e-12
        )  # fmt: skip
        assert spin == pytest.approx([0.0, 0.0, 0.0], abs=1e-12)


@pytest.mark.parametrize(
    ("shot", "signs"),
    [
        (Shot(height=0.3), {"wy": 1}),
        (Shot(height=-0.3), {"wy": -1}),
        (Shot(side=0.3), {"wz": 1}),
        (Shot(side=-0.3), {"wz": -1}),
        (Shot(side=0.3, elevation=40.0), {"wz": 1, "wx": 1, "vy": 1}),
        (Shot(side=-0.3, elevation=40.0), {"wz": -1, "wx": -1, "vy": -1}),
    ],
)
def test_offset_gives_the_spin_it_is_named_for(shot: Shot, signs: dict[str, int]) -> None:
    """Follow, draw, right-hand and left-hand english; an elevated cue adds the spin that makes a masse."""
    body = struck(shot)
    assert body.vx > 0.0
    for name in ("wx", "wy", "wz"):
        value = getattr(body, name)
        if name in signs:
            assert value * signs[name] > 1.0
        elif shot.elevation == 0.0 and name != "wx":
            assert value == pytest.approx(0.0, abs=1e-9)
    if "vy" in signs:
        assert body.vy * signs["vy"] > 0.0


@given(between(-1.0, 1.0), between(-1.0, 1.0), between(0.0, 90.0), between(0.0, 360.0))
def test_ball_never_has_more_energy_than_the_cue_had(
    side: float, height: float, elevation: float, angle: float
) -> None:
    assume(math.hypot(side, height) <= 1.0)
    for cue in (Cue(), Cue(tip_restitution=1.0), Cue(tip_restitution=1.0, tip_friction=10.0)):
        body = struck(Shot(angle, 3.0, side, height, elevation), cue)
        assert all(map(math.isfinite, state(body)))
        assert body.energy() <= 0.5 * cue.mass * 3.0**2 * (1.0 + 1e-12)


@given(shots(), between(0.1, 3.0))
def test_strike_scales_with_speed_turns_with_the_aim_and_mirrors(shot: Shot, factor: float) -> None:
    plain = state(struck(Shot(0.0, 1.0, shot.side, shot.height, shot.elevation)))
    scaled = state(struck(Shot(0.0, factor, shot.side, shot.height, shot.elevation)))
    assert scaled == pytest.approx([factor * value for value in plain], abs=1e-9)
    left = state(struck(Shot(0.0, 1.0, -shot.side, shot.height, shot.elevation)))
    vx, vy, wx, wy, wz = plain
    assert left == pytest.approx((vx, -vy, -wx, wy, -wz), abs=1e-9)
    quarter = state(struck(Shot(90.0, 1.0, shot.side, shot.height, shot.elevation)))
    assert quarter == pytest.approx((-vy, vx, -wy, wx, wz), abs=1e-9)


@pytest.mark.parametrize("elevation", [0.0, 30.0, 80.0])
@pytest.mark.parametrize("way", [0.0, 60.0, 90.0, 200.0])
def test_miscue_begins_where_the_clean_hit_ends(elevation: float, way: float) -> None:
    """No jump in speed, direction or spin as the tip passes the limit of friction."""
    turn = math.radians(way)
    inside, outside = (
        struck(Shot(0.0, 3.0, limit * math.cos(turn), limit * math.sin(turn), elevation))
        for limit in (LIMIT - 1e-9, LIMIT + 1e-9)
    )
    assert state(inside) == pytest.approx(state(outside), abs=1e-6)


def test_miscue_loses_speed_and_turns_from_the_tip() -> None:
    speeds, turns = [], []
    for side in (LIMIT, 0.7, 0.9, 1.0):
        body = struck(Shot(speed=3.0, side=side), Cue(end_mass=0.0))
        speeds.append(math.hypot(body.vx, body.vy))
        turns.append(math.degrees(math.atan2(body.vy, body.vx)))
    assert speeds == sorted(speeds, reverse=True)
    assert turns == sorted(turns)
    assert turns[-1] > 30.0
    assert speeds[-1] > 0.0


@pytest.mark.parametrize(("side", "height"), [(0.3, 0.2), (0.8, 0.0), (-0.6, 0.6), (0.0, -0.9), (0.5, -0.8)])
def test_spin_is_the_moment_of_the_push_at_the_tip(side: float, height: float) -> None:
    """Of a level cue, clean or slipping: the push is a line through the tip, along the cue or on the friction cone."""
    body = struck(Shot(speed=2.0, side=side, height=height), Cue(end_mass=0.0))
    offset, limit = math.hypot(side, height), math.atan(Cue().tip_friction)
    # How far the push is turned from the cue's line: the normal leans by asin(offset), the cone is `limit` wide.
    lean = max(0.0, math.asin(offset) - limit)
    ahead, aside = math.cos(lean), math.sin(lean) / offset
    push = (ahead, aside * side, -aside * height)
    tip = (-math.sqrt(1.0 - offset * offset), -side, height)
    moment = (
        tip[1] * push[2] - tip[2] * push[1], tip[2] * push[0] - tip[0] * push[2], tip[0] * push[1] - tip[1] * push[0],
    )  # fmt: skip
    vx, vy, *spin = state(body)
    assert vy / vx == pytest.approx(push[1] / push[0], abs=1e-12)
    assert spin == pytest.approx([2.5 * vx / push[0] * part for part in moment], abs=1e-12)


def test_upright_cue_presses_and_does_not_push() -> None:
    body = struck(Shot(speed=2.0, elevation=90.0))
    assert state(body) == pytest.approx((0.0,) * 5, abs=1e-12)
    masse = struck(Shot(speed=2.0, elevation=90.0, side=0.3))
    assert state(masse)[2] > 0.1


def test_shot_through_the_engine_is_the_first_event() -> None:
    table = open_table()
    layout = Layout([Ball("cue", 3.0, 2.0), Ball("1", 4.0, 2.5)])
    roll = simulate(table, layout, Shot(angle=30.0, speed=2.0, height=0.2))
    first = roll.events[0]
    assert (first.t, first.kind, first.balls, first.where) == (0.0, "cue_ball", ("cue",), None)
    assert first.before["cue"] == Ball("cue", 3.0, 2.0)
    body = struck(Shot(angle=30.0, speed=2.0, height=0.2))
    after = first.after["cue"]
    assert (after.vx, after.vy, after.wx, after.wy, after.wz) == (body.vx, body.vy, body.wx, body.wy, body.wz)
    other = simulate(table, layout, Shot(speed=2.0, ball="1"))
    assert other.events[0].balls == ("1",)
    assert other.layout()["cue"] == layout["cue"]


def test_no_speed_is_no_shot() -> None:
    assert simulate(open_table(), Layout([Ball("cue", 3.0, 2.0)]), Shot(speed=0.0)).events == []


@pytest.mark.parametrize(
    ("shot", "key"),
    [
        (Shot(angle=math.nan), "shot.angle"),
        (Shot(speed=math.inf), "shot.speed"),
        (Shot(speed=-1.0), "shot.speed"),
        (Shot(speed=51.0), "shot.speed"),
        (Shot(angle=10**400), "shot.angle"),
        (Shot(elevation=-1.0), "shot.elevation"),
        (Shot(elevation=91.0), "shot.elevation"),
        (Shot(side=1.1), "shot.side"),
        (Shot(side=0.8, height=0.8), "shot.side, shot.height"),
        (Shot(ball="9"), "shot.ball"),
    ],
)
def test_shots_that_cannot_be_made(shot: Shot, key: str) -> None:
    with pytest.raises(InputError) as caught:
        simulate(load_table("pool-9ft"), Layout([Ball("cue", 1.0, 0.6)]), shot)
    assert caught.value.key == key
