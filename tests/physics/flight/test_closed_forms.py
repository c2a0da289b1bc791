"""What is known of flight in closed form: drops, bounces, hops, two balls in the air, a ball over another."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pool2d import Ball, Layout, Shot, load_table, simulate
from pool2d.physics.flight.impact import LEAST
from pool2d.physics.strike import hop

TABLE = load_table("carom-10ft", {"ball.radius": 0.028575, "ball.mass": 0.17, "ball.law": "impulse"})
R, E, MU, G = 0.028575, TABLE.knobs.cloth.bounce, TABLE.knobs.cloth.bounce_friction, TABLE.knobs.gravity
KNOBS = TABLE.knobs
near = pytest.approx


@given(st.floats(0.001, 2.0))
def test_a_ball_that_is_dropped(height: float) -> None:
    roll = simulate(TABLE, Layout([Ball("cue", 1.0, 0.6, z=height)]))
    landings = [event for event in roll.events if event.kind == "ball_slate"]
    speed = math.sqrt(2.0 * G * height)
    t = speed / G
    for event in landings:
        assert event.t == near(t, rel=1e-9)
        assert event.before["cue"].vz == near(-speed, rel=1e-9)
        speed = E * speed if E * speed >= LEAST else 0.0
        assert event.after["cue"].vz == near(speed, rel=1e-9)
        t += 2.0 * speed / G
    assert speed == 0.0
    # All its hops take 2 vz0 e / (1 - e) / g; those that are left out are over within 2 LEAST / (1 - e) / g.
    whole = math.sqrt(2.0 * height / G) * (1.0 + 2.0 * E / (1.0 - E))
    assert roll.duration == near(whole, abs=2.0 * LEAST / (1.0 - E) / G)


NUMBERS = st.floats(-3.0, 3.0)
SPINS = st.floats(-150.0, 150.0)


@given(NUMBERS, NUMBERS, st.floats(-4.0, -0.1), SPINS, SPINS, SPINS)
def test_a_bounce_grips_or_slips(vx: float, vy: float, vz: float, wx: float, wy: float, wz: float) -> None:
    roll = simulate(TABLE, Layout([Ball("cue", 1.0, 0.6, vx=vx, vy=vy, wx=wx, wy=wy, wz=wz, vz=vz)]))
    ball = roll.events[0].after["cue"]
    ux, uy = vx - R * wy, vy + R * wx
    slip = math.hypot(ux, uy)
    taken = min(MU * (1.0 + E) * -vz, 2.0 / 7.0 * slip)
    ex, ey = (ux / slip, uy / slip) if slip > 0.0 else (0.0, 0.0)
    assert (ball.vx, ball.vy) == near((vx - taken * ex, vy - taken * ey), abs=1e-9)
    assert (ball.wx, ball.wy, ball.wz) == near((wx - 2.5 / R * taken * ey, wy + 2.5 / R * taken * ex, wz), abs=1e-7)
    assert ball.vz == near(-E * vz, abs=1e-12)
    # What ends in the end is natural roll, whatever the bounces take: v - 2/7 u.
    rolls = next((event.after["cue"] for event in roll.events if event.after["cue"].phase == "rolling"), None)
    if rolls is not None and not any(event.rails for event in roll.events if event.t <= roll.duration):
        assert math.atan2(rolls.vy, rolls.vx) == near(math.atan2(vy - 2.0 * uy / 7.0, vx - 2.0 * ux / 7.0), abs=1e-6)


def test_spin_and_way_are_kept_in_flight() -> None:
    ball = Ball("cue", 1.0, 0.6, vx=1.0, vy=0.2, wx=90.0, wy=-120.0, wz=50.0, z=0.01, vz=1.5)
    roll = simulate(TABLE, Layout([ball]))
    seen = roll.at(0.2)["cue"]
    assert (seen.wx, seen.wy, seen.wz, seen.vx, seen.vy) == (90.0, -120.0, 50.0, 1.0, 0.2)
    assert (seen.x, seen.y) == near((1.2, 0.64), abs=1e-12)
    assert (seen.z, seen.vz) == near((0.01 + 0.3 - 0.5 * G * 0.04, 1.5 - 0.2 * G), abs=1e-12)
    assert seen.phase == "airborne"


@pytest.mark.parametrize("cut", [0.0, 0.3, 0.7])
def test_two_balls_in_the_air_meet_as_on_the_level(cut: float) -> None:
    """Both fall alike, so seen from one the other flies straight: where they meet is a chord of a circle."""
    gap, speed, z = 0.3, 2.0, 1.0
    offset = 2.0 * R * cut
    roll = simulate(TABLE, Layout([Ball("a", 0.5, 0.6, vx=speed, z=z), Ball("b", 0.5 + gap, 0.6, z=z + offset)]))
    event = roll.events[0]
    way = gap - math.sqrt(4.0 * R * R - offset * offset)
    assert event.kind == "ball_ball"
    assert event.t == near(way / speed, abs=1e-9)
    a, b = event.before["a"], event.before["b"]
    n = (math.sqrt(1.0 - cut * cut), cut)
    assert (b.x - a.x, b.z - a.z) == near((2.0 * R * n[0], offset), abs=1e-10)
    along = speed * n[0]
    j = 0.5 * (1.0 + KNOBS.ball.restitution) * along
    slip = speed * n[1]
    rub = min(KNOBS.ball.friction * KNOBS.ball.cling * j, slip / 7.0) if slip > 0.0 else 0.0
    after = event.after["b"]
    drop = G * event.t
    assert after.vx == near(j * n[0] + rub * n[1], abs=1e-9)
    assert after.vz + drop == near(j * n[1] - rub * n[0], abs=1e-9)


@pytest.mark.parametrize(("z", "degrees"), [(0.005, 30.1), (0.010, 30.5), (0.020, 32.3), (0.030, 36.0)])
def test_a_flying_cue_ball_cuts_thinner_than_it_looks(z: float, degrees: float) -> None:
    """sin c = b / sqrt(4 R^2 - z^2) for the offset b in plan of a cut of 30 degrees."""
    # Fast, that it falls by no more than 0.1 mm on the way.
    cue = Ball("cue", 0.9, 0.6, vx=20.0, z=z)
    ball = Ball("1", 1.0, 0.6 - 2.0 * R * math.sin(math.radians(30.0)))
    event = simulate(TABLE.with_knobs({"ball.law": "frictionless"}), Layout([cue, ball])).events[0]
    after = event.after["1"]
    assert math.degrees(math.atan2(-after.vy, after.vx)) == near(degrees, abs=0.11)


HOPS = [(2.0, 2.0, 0.0001075), (4.0, 5.0, 0.002681), (8.0, 5.0, 0.0107), (4.0, 20.0, 0.041), (4.0, 45.0, 0.177)]


@pytest.mark.parametrize(("speed", "degrees", "height"), HOPS)
def test_a_raised_butt_makes_the_ball_hop(speed: float, degrees: float, height: float) -> None:
    """Two impacts, the tip's on a free ball and the slate's (J = (1 + e) V / (1/M + 1/m))."""
    shot = Shot(speed=speed, elevation=degrees)
    table = TABLE.with_knobs({"cue.mass": 0.54, "cue.tip_restitution": 0.73})
    ball = simulate(table, Layout([Ball("cue", 0.3, 0.6)]), shot, events=1).events[0].after["cue"]
    assert ball.vz**2 / (2.0 * G) == near(height, rel=0.01)
    up, apex, _, _ = hop(shot, 0.17, table.knobs)
    assert (ball.vz, ball.vz**2 / (2.0 * G)) == near((up, apex), rel=1e-9)
    assert ball.phase == "airborne"


LEAST_SPEEDS = [(150, 45, 3.0), (200, 30, 5.9), (200, 45, 3.1), (300, 30, 4.3), (300, 45, 3.4), (500, 20, 6.2)]


@pytest.mark.parametrize(("distance", "degrees", "speed"), LEAST_SPEEDS)
def test_the_least_speed_that_clears_a_ball(distance: float, degrees: float, speed: float) -> None:
    """The ball's speed along the cue, m/s, for a full ball so far ahead, mm."""
    table = TABLE.with_knobs({"cue.mass": 0.54, "cue.tip_restitution": 0.73})
    layout = Layout([Ball("cue", 0.3, 0.6), Ball("1", 0.3 + 1e-3 * distance, 0.6)])
    per = 1.73 / (1.0 / 0.54 + 1.0 / 0.17) / 0.17

    def clears(along: float) -> bool:
        roll = simulate(table, layout, Shot(speed=along / per, elevation=degrees))
        hit = next((event for event in roll.events if event.pairs), None)
        return hit is None or hit.before["cue"].x > layout["1"].x

    assert clears(1.03 * speed)
    assert not clears(0.95 * speed)


def test_a_hard_tip_and_a_light_cue_hop_more_for_the_cue_ball_s_speed() -> None:
    layout = Layout([Ball("cue", 0.3, 0.6)])
    soft, hard = (
        simulate(TABLE.with_knobs({"cue.tip_restitution": e}), layout, Shot(speed=3.0, elevation=40.0), events=1)
        for e in (0.71, 0.87)
    )
    assert hard.events[0].after["cue"].vz > 1.05 * soft.events[0].after["cue"].vz


def test_a_tip_that_digs_under_the_ball_scoops_it_up() -> None:
    event = simulate(
        TABLE, Layout([Ball("cue", 0.3, 0.6)]), Shot(speed=3.0, height=-0.9, elevation=5.0), events=1
    ).events[0]
    assert event.where == "miscue"
    assert event.after["cue"].vz > 0.2
