"""What holds of every shot under every law, looked for in random play with balls frozen to balls and rails."""

from __future__ import annotations

import random
from collections.abc import Callable

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from pool2d import Ball, Layout, Rollout, Shot, Table, load_table, simulate
from pool2d.physics.laws.registry import BALL_LAWS, CUSHION_LAWS
from pool2d.physics.motion import STILL

from ..checks import assert_sound
from ..plays import plays
from ..scenes import Play

TABLE = load_table("pool-9ft")
TABLES = {
    (ball, cushion): TABLE.with_knobs({"ball.law": ball, "cushion.law": cushion})
    for ball in BALL_LAWS
    for cushion in CUSHION_LAWS
}
ANY_TABLE = st.sampled_from(list(TABLES)).map(TABLES.__getitem__)
# Each contact with what is round, a ball or a jaw, makes some twenty times of a difference; after this many it is
# still to be told from one.
CONTACTS = 5


@settings(max_examples=200)
@given(plays(TABLE, most=10), ANY_TABLE)
def test_play_under_any_law_is_sound(play: Play, table: Table) -> None:
    """Energy never rises, nothing overlaps or leaves the table, and it ends."""
    assert_sound(table, simulate(table, *play))


@settings(max_examples=100)
@given(plays(TABLE, most=8, own_sizes=True), ANY_TABLE)
def test_balls_of_all_sizes_under_any_law_are_sound(play: Play, table: Table) -> None:
    assert_sound(table, simulate(table, *play))


@pytest.mark.parametrize("laws", TABLES, ids=" ".join)
def test_break_under_any_law_is_sound(laws: tuple[str, str]) -> None:
    layout = TABLES[laws].rack("eight-ball", seed=1)
    assert_sound(TABLES[laws], simulate(TABLES[laws], layout, Shot(angle=0.2, speed=9.0)), samples=5)


@settings(max_examples=100)
@given(plays(TABLE, own_sizes=True), ANY_TABLE)
def test_balls_that_meet_keep_their_momentum(play: Play, table: Table) -> None:
    """Except where the cloth has a hand in it, in `mathavan2014` or under a ball that is pressed down, or the tip."""
    assume(table.knobs.ball.law != "mathavan2014")
    layout, shot = play
    events = simulate(table, layout, shot).events
    meetings = [event for event in events if event.pairs and not event.rails and event.kind != "cue_ball"]
    meetings = [event for event in meetings if all(ball.z == ball.vz == 0.0 for ball in event.before.values())]
    assume(meetings)
    for event in meetings:
        # A slip or speed below STILL after it is nought: that much the cloth takes of a ball that rolls or rests.
        taken = sum(
            STILL * table.body_of(layout[ball.id])[1] for ball in event.after.values() if ball.phase != "sliding"
        )
        for part in ("vx", "vy"):
            before, after = (
                sum(table.body_of(layout[name])[1] * getattr(ball, part) for name, ball in balls.items())
                for balls in (event.before, event.after)
            )
            assert after == pytest.approx(before, abs=1e-12 + taken)


@settings(max_examples=100)
@given(plays(TABLE, most=10), ANY_TABLE, st.randoms(use_true_random=False))
def test_order_and_looking_are_of_no_consequence(play: Play, table: Table, rng: random.Random) -> None:
    """To the bit: balls given in another order, or looked at on the way, or the shot played again."""
    layout, shot = play
    roll = simulate(table, layout, shot)
    digest = roll.digest()
    for _ in range(5):
        roll.at(rng.uniform(0.0, roll.duration))
    balls = list(layout.values())
    rng.shuffle(balls)
    other = simulate(table, Layout(balls), shot)
    assert digest == roll.digest() == other.digest()
    assert [event.as_dict() for event in roll.events] == [event.as_dict() for event in other.events]


def along(ball: Ball) -> Ball:
    """A ball seen in a mirror along the table."""
    return ball._replace(y=1.27 - ball.y, vy=-ball.vy, wx=-ball.wx, wz=-ball.wz)


def across(ball: Ball) -> Ball:
    """A ball seen in a mirror across the table."""
    return ball._replace(x=2.54 - ball.x, vx=-ball.vx, wy=-ball.wy, wz=-ball.wz)


def until_chaos(roll: Rollout) -> float:
    """The time up to which a last digit has not become one that counts."""
    jaws = [event.t for event in roll.events for _, name in event.rails if name.endswith("jaw")]
    hits = sorted(jaws + [event.t for event in roll.events for _ in event.pairs])
    return hits[CONTACTS] - 1e-6 if len(hits) > CONTACTS else roll.duration + 1e-6


@pytest.mark.parametrize(("mirror", "angle"), [(along, 0.0), (across, 180.0)], ids=["along", "across"])
@settings(max_examples=100)
@given(play=plays(TABLE, most=8), table=ANY_TABLE)
def test_mirrored_play_is_the_mirror_of_play(
    mirror: Callable[[Ball], Ball], angle: float, play: Play, table: Table
) -> None:
    layout, shot = play
    roll = simulate(table, layout, shot)
    other = shot and Shot(angle - shot.angle, shot.speed, -shot.side, shot.height, shot.elevation)
    seen = simulate(table, Layout(map(mirror, layout.values())), other)
    end = until_chaos(roll)
    kinds = [[(event.kind, event.balls) for event in one.events if event.t < end] for one in (roll, seen)]
    assert sorted(kinds[0]) == sorted(kinds[1])
    for i in range(11):
        t = end * i / 10
        for name, ball in roll.at(t).items():
            image = mirror(seen.ball_at(name, min(t, seen.duration)))
            assert (ball.x, ball.y) == pytest.approx((image.x, image.y), abs=1e-6)
