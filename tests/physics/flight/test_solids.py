"""What balls off the cloth come to: noses, jaws, rails' tops, pockets, the edge; and layouts that begin in the air."""

from __future__ import annotations

import math
import random
from itertools import pairwise
from typing import Any

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from pool2d import Ball, InputError, Layout, Rollout, Shot, load_table, simulate
from pool2d.physics.body import Body
from pool2d.physics.flight.holes import Rim
from pool2d.physics.flight.solids import RoundNose, Solid, StraightNose

from ...checks import assert_sound

POOL, CAROM, SNOOKER = (load_table(name) for name in ("pool-9ft", "carom-10ft", "snooker-12ft"))
R, NOSE = POOL.knobs.ball.radius, POOL.knobs.cushion.nose_height
NUMBER = st.floats(-1.0, 1.0)


def of(kind: type[Solid], table: str = "pool-9ft") -> list[Solid]:
    solids = {"pool-9ft": POOL, "snooker-12ft": SNOOKER}[table].bed.solids
    return [solid for solid in solids if type(solid) is kind]


@pytest.mark.parametrize("kind", [StraightNose, RoundNose, Rim])
@example(1, 0.0, 0.5, 0.0, -1.0, 0.0, 0.0)
@given(st.integers(0, 1000), NUMBER, NUMBER, NUMBER, NUMBER, NUMBER, st.floats(0.0, 0.12))
def test_no_contact_is_missed(
    kind: type[Solid], number: int, x: float, y: float, vx: float, vy: float, vz: float, z: float
) -> None:
    """Up to the time that is found a ball is nowhere in it; there it touches."""
    solids = of(kind)
    solid = solids[number % len(solids)]
    middle = (0.5 * (solid.left + solid.right), 0.5 * (solid.bottom + solid.top))
    ball = Ball("cue", middle[0] + 0.2 * x, middle[1] + 0.2 * y, vx=2.0 * vx, vy=2.0 * vy, z=z, vz=2.0 * vz)
    motion = POOL.bed.fall(Body(ball, 0, R, 0.17), 0.0)

    def gap(t: float) -> float:
        at = motion.at(t)
        if isinstance(solid, StraightNose):
            along = (at.x - solid.ax) * solid.dx + (at.y - solid.ay) * solid.dy
            # Its ends are others: jaws, and points.
            if not 0.0 <= along <= solid.length:
                return math.inf
        return solid.gap(at.x, at.y, at.z + R, R)

    if gap(0.0) <= 0.0 or POOL.bed.room(ball.x, ball.y, ball.z, R)[0] < 0.0:
        return
    end = motion.t1
    t = min(solid.time(motion, R, end), end)
    gaps = [gap(t * step / 400.0) for step in range(400)]
    if any(math.isinf(before) and after < 0.0 for before, after in pairwise(gaps)):
        # Over the end of a nose, which is another's to stop it at, it has come in from the side.
        return
    assert all(room > -1e-6 for room in gaps)
    if t < end and math.isfinite(gap(t)):
        assert gap(t) == pytest.approx(0.0, abs=1e-9)


def test_a_nose_is_met_by_what_has_been_in_its_line_beyond_its_end() -> None:
    """A ball that hops out of a pocket's mouth, over the line of a nose, and comes down on the nose itself.

    Once only the first time that a ball came into the line was looked at: these went through the nose.
    """
    table = load_table("l-shape")
    roll = simulate(
        table, Layout([Ball("1", 1.2904635588, 0.0296875465, vx=-1.3259731643, vy=-0.2705427469, vz=0.8351698367)])
    )
    assert_sound(table, roll)
    assert (roll.events[0].kind, roll.events[0].where) == ("ball_cushion", "bottom-left")


def test_a_pockets_facings_may_be_as_far_apart_as_its_hole_is_wide() -> None:
    """What closes the pocket beside them has no length then: such a table could not be played on."""
    shape = {"side.angle": 90.0, "side.mouth": 0.11, "side.drop_radius": 0.055, "side.jaw_radius": 0.002}
    table = load_table("pool-9ft", shape)
    assert "bottom-side back" in {solid.name for solid in table.bed.solids}
    for x in (1.255, 1.27, 1.285):
        roll = simulate(table, Layout([Ball("cue", x, 0.3)]), Shot(-90.0, 6.0))
        assert_sound(table, roll)
        assert roll.layout()["cue"].phase == "pocketed"


def flown(table_name: str = "pool-9ft", **ball: Any) -> Rollout:
    table = {"pool-9ft": POOL, "carom-10ft": CAROM}[table_name]
    roll = simulate(table, Layout([Ball(**{"id": "cue", **ball})]))
    assert_sound(table, roll)
    return roll


def test_a_ball_flies_over_the_rail_and_is_off() -> None:
    roll = flown(x=2.2, y=0.4, vx=4.0, z=0.1, vz=1.0)
    event = roll.events[-1]
    assert (event.kind, event.where, event.after["cue"].phase) == ("ball_off", "right", "off")
    assert event.before["cue"].x == pytest.approx(2.54 + POOL.knobs.rail.width, abs=1e-9)
    assert event.before["cue"].vx == 4.0
    assert roll.layout().on_table() == []


def test_what_rests_on_a_rails_top_is_off_the_table() -> None:
    roll = flown(x=2.60, y=0.4, vy=0.02, wx=-0.02 / R, z=NOSE)
    assert [(event.kind, event.where) for event in roll.events] == [("ball_off", "right")]


def test_a_ball_runs_along_the_rails_top_and_comes_back() -> None:
    roll = flown(x=2.60, y=0.4, vx=-0.2, vy=0.3, wx=-0.3 / R, wy=-0.2 / R, z=NOSE)
    assert roll.at(0.1)["cue"].phase == "rolling"
    assert roll.at(0.1)["cue"].z == NOSE
    end = roll.layout()["cue"]
    assert (end.phase, end.z) == ("resting", 0.0)
    assert end.x < 2.54 - R / 2.0


def test_a_ball_comes_down_on_the_rails_top() -> None:
    roll = flown(x=2.60, y=0.4, z=0.1)
    assert [(event.kind, event.where) for event in roll.events[:2]] == [("ball_slate", "right")] * 2
    assert roll.events[0].after["cue"].vz == pytest.approx(0.5 * math.sqrt(2.0 * 9.81 * (0.1 - NOSE)), rel=1e-9)


def test_a_centre_above_the_nose_is_lifted_and_one_below_it_held_down() -> None:
    high, low = (
        next(e for e in flown("carom-10ft", x=0.3, y=0.6, vx=-8.0, z=z).events if e.rails).after["cue"]
        for z in (0.03, 0.003)
    )
    assert high.vz > 0.5
    assert low.vz < -0.1


def test_a_ball_falls_into_a_pocket_from_above() -> None:
    pocket = POOL.geometry.pockets[0]
    roll = flown(x=pocket.x, y=pocket.y, z=0.2)
    assert [(event.kind, event.where) for event in roll.events] == [("ball_pocket", pocket.name)]


def test_a_ball_that_flies_high_goes_over_the_pocket_and_off() -> None:
    roll = flown(x=0.2, y=0.2, vx=-3.0, vy=-3.0, z=0.15, vz=0.3)
    assert roll.events[-1].kind == "ball_off"


@pytest.mark.parametrize("speed", [0.8, 3.0, 8.0, 12.0])
def test_what_rolls_into_a_pocket_stays_there_with_the_presets_back(speed: float) -> None:
    roll = flown(x=0.2, y=0.2, vx=-speed * math.sqrt(0.5), vy=-speed * math.sqrt(0.5))
    assert roll.layout()["cue"].phase == "pocketed"


def test_a_lively_rough_back_throws_a_fast_ball_out_again() -> None:
    """With e 0.3 and friction 0.2 rolling balls come out from 3 m/s: why the presets have another."""
    table = POOL.with_knobs({"pocket.restitution": 0.3, "pocket.friction": 0.2})
    v = 8.0 * math.sqrt(0.5)
    ball = Ball("cue", 0.1, 0.1, vx=-v, vy=-v, wx=v / R, wy=-v / R)
    roll = simulate(table, Layout([ball]))
    assert_sound(table, roll)
    told = [(event.kind, event.where) for event in roll.events]
    assert ("ball_slate", None) in told[told.index(("ball_cushion", "bottom-left back")) :]


def test_what_others_hold_up_for_long_is_off() -> None:
    """Three balls packed into a corner without a pocket, and one that is let down on them."""
    reach, r = CAROM.reach(CAROM.knobs.ball.radius), CAROM.knobs.ball.radius
    three = [Ball("1", reach, reach), Ball("2", reach + 2.0 * r, reach), Ball("3", reach, reach + 2.0 * r)]
    top = Ball("cue", reach + 0.4 * r, reach + 0.4 * r, z=2.2 * r)
    roll = simulate(CAROM, Layout([*three, top]))
    assert len(roll.events) < 20_000
    assert {ball.phase for ball in roll.layout().values()} <= {"resting", "off"}


@pytest.mark.parametrize("seed", range(6))
def test_strokes_with_a_raised_butt_are_sound(seed: int) -> None:
    rng = random.Random(seed)
    layout = Layout([Ball("cue", 0.5, 0.6), *(Ball(str(i), 0.9 + 0.2 * i, 0.3 + 0.1 * i) for i in range(1, 6))])
    shot = Shot(rng.uniform(-30.0, 30.0), rng.uniform(2.0, 8.0), elevation=rng.uniform(5.0, 80.0))
    assert_sound(POOL, simulate(POOL, layout, shot))


def test_mirrored_flights_mirror() -> None:
    """As far as width - y keeps the digits of y."""
    width = CAROM.knobs.table.width
    one = [Ball("cue", 0.5, 0.5, vx=3.0, vy=1.0, z=0.05, vz=0.5, wx=30.0), Ball("1", 0.9, 0.64)]
    two = [b._replace(y=width - b.y, vy=-b.vy, wx=-b.wx, wz=-b.wz) for b in one]
    a, b = (simulate(CAROM, Layout(balls), events=8) for balls in (one, two))
    for first, second in zip(a.events, b.events, strict=True):
        assert first.kind == second.kind
        assert first.t == pytest.approx(second.t, abs=1e-9)
        for name, ball in first.after.items():
            other = second.after[name]
            assert (other.x, other.y, other.z) == pytest.approx((ball.x, width - ball.y, ball.z), abs=1e-9)
            assert (other.vx, other.vy, other.vz) == pytest.approx((ball.vx, -ball.vy, ball.vz), abs=1e-7)


@pytest.mark.parametrize(
    ("ball", "what"),
    [
        (Ball("2", 1.0, 0.6, z=0.02), "ball 1"),
        (Ball("2", 2.60, 0.6, z=0.02), "the right rail"),
        (Ball("2", 2.53, 0.6, z=0.03), "right"),
        (Ball("2", 2.9, 0.6, z=0.2), "off the table"),
        (Ball("2", 1.4, 0.6, z=11.0), "allowed is a number from 0 to 10 m"),
    ],
)
def test_where_a_ball_in_the_air_may_not_begin(ball: Ball, what: str) -> None:
    with pytest.raises(InputError, match=r"balls\.2") as caught:
        simulate(POOL, Layout([Ball("1", 1.0, 0.6), ball]))
    assert what in str(caught.value)


def test_a_ball_that_is_struck_in_the_air_has_no_slate_under_it() -> None:
    """Its downward speed was once given back in mid-air."""
    event = simulate(POOL, Layout([Ball("cue", 0.6, 0.6, z=0.2)]), Shot(speed=2.0, elevation=40.0)).events[0]
    assert (event.kind, event.after["cue"].z) == ("cue_ball", 0.2)
    assert event.after["cue"].vz < -1.0


def test_a_raised_rail_has_an_upright_face() -> None:
    """A centre between the nose and the rail's top meets it a radius away, as a wall."""
    table = POOL.with_knobs({"rail.height": 0.03})
    event = simulate(table, Layout([Ball("cue", 2.3, 0.4, vx=8.0, z=0.025)])).events[0]
    assert (event.kind, event.where) == ("ball_cushion", "right")
    assert event.after["cue"].x == pytest.approx(2.54 - R, abs=1e-9)
    assert event.after["cue"].vx == pytest.approx(-8.0 * table.knobs.cushion.restitution, rel=1e-9)


def test_a_ball_above_two_that_meet_is_none_of_them() -> None:
    balls = [Ball("cue", 0.5, 0.6, vx=2.0), Ball("1", 0.6, 0.6), Ball("2", 0.61, 0.6, z=0.3)]
    event = simulate(POOL, Layout(balls)).events[0]
    assert (event.kind, event.pairs) == ("ball_ball", (("1", "cue"),))


@pytest.mark.parametrize(("speed", "rim"), [(0.4, True), (4.0, False)])
def test_a_slow_ball_is_in_the_pocket_at_its_rim_whatever_the_back(speed: float, rim: bool) -> None:
    """Below the root of g R it rolls off the edge."""
    table, pocket = POOL.with_knobs({"pocket.friction": 0.2}), POOL.geometry.pockets[0]
    v = -speed * math.sqrt(0.5)
    ball = Ball("cue", pocket.x + 0.05, pocket.y + 0.05, vx=v, vy=v, wx=-v / R, wy=v / R)
    event = next(e for e in simulate(table, Layout([ball])).events if e.kind == "ball_pocket")
    at = event.before["cue"]
    assert (math.dist((at.x, at.y), (pocket.x, pocket.y)) == pytest.approx(pocket.radius, abs=1e-9)) == rim


def test_what_a_hole_has_hardly_room_for_is_in_once_it_is_over_it() -> None:
    pocket = POOL.geometry.pockets[0]
    for radius, fall in ((0.05, 0.1), (R, 0.1 + R)):
        ball = Body(Ball("big", pocket.x, pocket.y, z=0.1), 0, radius, 0.17)
        expected = (math.sqrt(2.0 * fall / 9.81), -radius)
        assert POOL.bed.ground.landing(ball, POOL.bed.hz) == pytest.approx(expected, rel=1e-9)


def test_on_the_rail_a_ball_falls_into_a_pocket_only_where_it_is_open() -> None:
    """Beside the facings the rail covers the hole; a ball that rolled there once sank into it."""
    table = load_table("pool-7ft")
    ball = Ball("cue", 1.83709, -0.0428, vx=0.46818, vy=-0.09058, wx=0.09058 / R, wy=0.46818 / R, z=NOSE)
    assert_sound(table, simulate(table, Layout([ball])))


def test_round_the_back_of_a_pocket_a_ball_hops_a_few_times() -> None:
    pocket = next(pocket for pocket in POOL.geometry.pockets if pocket.name == "bottom-side")
    far, v = (pocket.radius - R - 1e-4) * math.sqrt(0.5), 3.0 * math.sqrt(0.5)
    ball = Ball("cue", pocket.x - far, pocket.y - far, vx=v, vy=-v, z=0.02)
    told = [event.where for event in simulate(POOL, Layout([ball])).events]
    assert 3 < told.count("bottom-side back") < 40
