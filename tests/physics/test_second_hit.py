"""The tip runs on after the hit: where it meets the ball again, and where it does not."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pool2d import Ball, Event, Layout, Rollout, Shot, Table, load_table, simulate
from pool2d.physics.cue.push import push
from pool2d.physics.cue.tip import OFTEN, ROUND
from pool2d.physics.values import PUSH
from tests.checks import assert_sound, energy

TABLE = load_table("pool-9ft")
CUE = TABLE.knobs.cue
RADIUS, MASS = TABLE.knobs.ball.radius, TABLE.knobs.ball.mass


def layout(gap: float, cut: float = 0.0) -> Layout:
    """An object ball that far off, m, met by the cue ball of a shot at 0 degrees with that cut, degrees."""
    across = 2.0 * RADIUS * math.sin(math.radians(cut))
    return Layout(
        [Ball("cue", 0.7, 0.6), Ball("1", 0.7 + math.sqrt((2.0 * RADIUS + gap) ** 2 - across**2), 0.6 + across)]
    )


def hits(roll: Rollout) -> list[Event]:
    return [event for event in roll.events if event.kind == "cue_ball"]


def is_double(gap: float, shot: Shot, cut: float = 0.0, table: Table = TABLE) -> bool:
    return len(hits(simulate(table, layout(gap, cut), shot))) > 1


def largest_cut(gap: float, speed: float, table: Table = TABLE) -> float:
    """The largest cut with a second hit, degrees."""
    least, most = 0.0, 60.0
    while most - least > 0.1:
        middle = 0.5 * (least + most)
        least, most = (middle, most) if is_double(gap, Shot(speed=speed), middle, table) else (least, middle)
    return least


@pytest.mark.parametrize("gap", [0.002, 0.01, 0.025, 0.06, 0.1])
def test_of_a_level_full_stun_the_tip_hits_again_after_1_03_gaps(gap: float) -> None:
    first, second = hits(simulate(TABLE, layout(gap), Shot(speed=3.0)))
    onward = 3.0 * 0.586
    assert onward * second.t == pytest.approx(1.03 * gap, rel=0.01)
    # What it brings is the tip's: the ball goes on at no more than twice the speed of what strikes it.
    before, after = second.before["cue"], second.after["cue"]
    assert 0.0 < before.vx < 0.2 < onward < after.vx < 2.0 * onward
    assert first.t == 0.0


@pytest.mark.parametrize(("gap", "least"), [(0.002, 37.0), (0.01, 29.0), (0.025, 22.0), (0.06, 14.5), (0.1, 10.5)])
def test_a_cut_avoids_it(gap: float, least: float) -> None:
    """Worked out for a tip with a flat end and no throw: a round one slips by a little sooner, throw keeps it on."""
    assert largest_cut(gap, 3.0) == pytest.approx(least, abs=3.0)


def misses_by(gap: float, cut: float, tip: Callable[[float, float], float]) -> float:
    """How far a tip stays from a ball cut at that angle, degrees, that no friction throws or slows; negative: it hits.

    `tip` gives its distance from a point so far ahead of its end and beside its axis, m.
    """
    e, turn = TABLE.knobs.ball.restitution, math.radians(cut)
    way = math.sqrt((2.0 * RADIUS + gap) ** 2 - (2.0 * RADIUS * math.sin(turn)) ** 2) - 2.0 * RADIUS * math.cos(turn)
    # In units of the ball's speed: the cue's is 0.586 / 1.316 of it.
    cue, taken = 0.586 / 1.316, 0.5 * (1.0 + e) * math.cos(turn)
    vx, vy = 1.0 - taken * math.cos(turn), taken * math.sin(turn)
    steps = [0.0005 * i for i in range(800)]
    return min(tip(RADIUS + (1.0 - cue) * way + (vx - cue) * s, vy * s) - RADIUS for s in steps)


def flat(ahead: float, beside: float) -> float:
    beside = max(0.0, beside - ROUND)
    return math.hypot(ahead, beside) if ahead > 0.0 else beside


def rounded(ahead: float, beside: float) -> float:
    return math.hypot(ahead + ROUND, beside) - ROUND


@pytest.mark.parametrize(("gap", "least"), [(0.002, 37.0), (0.01, 29.0), (0.025, 22.0)])
def test_the_cut_is_the_references_but_for_throw_and_the_tips_end(gap: float, least: float) -> None:
    smooth = TABLE.with_knobs({"ball.law": "frictionless", "cloth.mu_slide": 0.01})
    found = largest_cut(gap, 3.0, smooth)
    assert misses_by(gap, found - 0.5, rounded) < 0.0 < misses_by(gap, found + 0.5, rounded)
    assert misses_by(gap, least - 0.5, flat) < 0.0 < misses_by(gap, least + 0.5, flat)
    # What throw does is to keep the ball before the tip.
    assert 0.0 < largest_cut(gap, 3.0) - found < 2.0


def test_ten_millimetres_from_the_ball() -> None:
    level = Shot(speed=2.5)
    assert is_double(0.01, level)
    assert not is_double(0.01, replace(level, elevation=50.0))
    assert not is_double(0.01, level, 35.0)
    assert not is_double(0.01, replace(level, easy=True))
    assert not is_double(0.25, Shot(speed=2.0, height=-0.4))


@pytest.mark.parametrize(
    ("elevation", "speed", "most", "none"),
    [(20.0, 2.0, 40, 90), (20.0, 3.0, 25, 50), (20.0, 4.0, 20, 40), (30.0, 2.0, 20, 40), (30.0, 4.0, 15, 30)],
)
def test_a_raised_butt_narrows_the_gap(elevation: float, speed: float, most: float, none: float) -> None:
    shot = Shot(speed=speed, elevation=elevation)
    assert is_double(1e-3 * most, shot)
    assert not is_double(1e-3 * none, shot)


@pytest.mark.parametrize("elevation", [40.0, 45.0, 50.0])
def test_under_a_steep_cue_what_is_hit_full_stops_the_ball_at_the_tip_and_what_is_grazed_does_not(
    elevation: float,
) -> None:
    """The slate throws the ball back at the tip: that alone is no second hit, nor is it with a ball that is grazed."""
    shot = Shot(speed=3.0, elevation=elevation)
    assert is_double(5e-4, shot)
    assert is_double(5e-4, shot, 30.0)
    assert not is_double(5e-4, shot, 45.0)
    assert not is_double(5e-4, shot, 80.0)


def test_what_others_do_while_the_tip_is_on_its_ball_is_nothing_to_it() -> None:
    shot = Shot(speed=3.0, elevation=50.0)
    far = [Ball("2", 1.5, 0.6), Ball("3", 1.5 + 2.0 * RADIUS + 1e-5, 0.6, vx=-2.0, phase="sliding")]
    alone, among = (Layout([Ball("cue", 0.7, 0.6), *others]) for others in ([], far))
    one, two = (simulate(TABLE, balls, shot).tracks["cue"] for balls in (alone, among))
    assert [motion.phase for motion in one[:4]] == [motion.phase for motion in two[:4]]
    assert len(hits(simulate(TABLE, among, shot))) == 1


@pytest.mark.parametrize("elevation", [0.0, 20.0, 45.0, 60.0, 80.0])
@pytest.mark.parametrize("height", [-0.45, 0.0, 0.45])
@pytest.mark.parametrize("speed", [0.2, 1.0, 3.0, 8.0])
def test_a_ball_with_nothing_near_it_is_struck_once(elevation: float, height: float, speed: float) -> None:
    shot = Shot(10.0, speed, 0.0, height, elevation)
    start = Layout([Ball("cue", 0.7, 0.6)])
    roll = simulate(TABLE, start, shot)
    assert len(hits(roll)) == 1
    assert roll.digest() == simulate(TABLE, start, replace(shot, easy=True)).digest()


def test_a_tip_that_stays_with_the_ball_pushes_it() -> None:
    second = hits(simulate(TABLE, layout(0.0001), Shot(speed=0.05)))[1]
    assert second.where == PUSH


def test_a_cue_that_is_taken_away_at_once_strikes_once() -> None:
    table = TABLE.with_knobs({"cue.follow_through": 0.0})
    assert len(hits(simulate(table, layout(0.01), Shot(speed=3.0)))) == 1


SHOTS = st.builds(
    Shot,
    st.floats(-60.0, 60.0),
    st.floats(0.02, 12.0),
    st.floats(-0.5, 0.5),
    st.floats(-0.5, 0.5),
    st.one_of(st.just(0.0), st.floats(0.0, 80.0)),
)


@given(SHOTS, st.floats(1e-4, 0.15))
def test_it_ends_and_the_cue_alone_brings_energy(shot: Shot, gap: float) -> None:
    roll = simulate(TABLE, layout(gap), shot)
    assert_sound(TABLE, roll)
    struck = hits(roll)
    assert len(struck) <= OFTEN + 1
    added = sum(
        energy(TABLE, event.after.values(), roll.start) - energy(TABLE, event.before.values(), roll.start)
        for event in struck
    )
    assert added <= 0.5 * CUE.mass * shot.speed**2 * (1.0 + 1e-9)


@given(SHOTS, st.floats(1e-4, 0.05))
def test_left_is_as_right(shot: Shot, gap: float) -> None:
    other = replace(shot, angle=-shot.angle, side=-shot.side)
    one, two = (hits(simulate(TABLE, layout(gap), played)) for played in (shot, other))
    assert [(event.t, event.where) for event in one] == [(event.t, event.where) for event in two]
    for a, b in zip(one, two, strict=True):
        assert (a.after["cue"].vx, a.after["cue"].vy) == (b.after["cue"].vx, -b.after["cue"].vy)


BALLS = st.tuples(*[st.floats(-3.0, 3.0)] * 2, *[st.floats(-80.0, 80.0)] * 3).map(lambda v: Ball("cue", 0.7, 0.6, *v))


@given(BALLS, st.floats(0.0, 5.0), st.floats(-1.5, 1.5), st.floats(-0.7, 0.7), st.floats(0.0, 1.0))
def test_tip_and_ball_part_and_none_gains_energy(ball: Ball, speed: float, turn: float, tilt: float, e: float) -> None:
    (body,) = TABLE.bodies([ball])
    n = (math.cos(turn) * math.cos(tilt), math.sin(turn) * math.cos(tilt), math.sin(tilt))
    cue = (1.0, 0.0, 0.0)
    if speed * n[0] <= body.vx * n[0] + body.vy * n[1]:
        return
    before = body.energy() + 0.5 * CUE.mass * speed**2
    onward, parting = push(body, n, cue, speed, CUE.mass, e, math.atan(CUE.tip_friction))
    assert parting >= 0.0
    assert body.vx * n[0] + body.vy * n[1] + body.vz * n[2] - onward * n[0] == pytest.approx(parting, abs=1e-9)
    assert body.energy() + 0.5 * CUE.mass * onward**2 <= before * (1.0 + 1e-12)
