"""What the engine must not know: left from right, when it is looked at, who was named first."""

from __future__ import annotations

import math
import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pool2d import Ball, Event, Layout, Shot, Table, load_table, simulate
from pool2d.physics.balls import BALL_LAWS
from pool2d.physics.cushions import CUSHION_LAWS

from .checks import assert_sound
from .plays import plays
from .scenes import Play, random_shot

TABLE = load_table("pool-9ft")
# Chaos doubles a last digit with every contact: after so many events mirrored shots still agree.
EVENTS = 14


def flipped(ball: Ball, width: float) -> Ball:
    """A ball seen in a mirror along the table."""
    return ball._replace(y=width - ball.y, vy=-ball.vy, wx=-ball.wx, wz=-ball.wz)


def turned(ball: Ball, length: float) -> Ball:
    """A ball seen in a mirror across the table."""
    return ball._replace(x=length - ball.x, vx=-ball.vx, wy=-ball.wy, wz=-ball.wz)


def nearing(event: Event) -> float:
    """How fast the two balls that set an event off near each other, m/s."""
    a, b = (event.before[name] for name in event.pairs[0])
    dx, dy = b.x - a.x, b.y - a.y
    return ((a.vx - b.vx) * dx + (a.vy - b.vy) * dy) / math.hypot(dx, dy)


def agree(table: Table, layout: Layout, shot: Shot, mirrored: Layout, other: Shot, across: bool) -> None:
    """Both shots have the same events at the same times, and end as mirror images."""
    a = simulate(table, layout, shot, events=EVENTS)
    b = simulate(table, mirrored, other, events=EVENTS)
    for ours, theirs in zip(a.events, b.events, strict=True):
        assert ours.t == pytest.approx(theirs.t, abs=1e-6)
    knobs = table.knobs.table
    for name, ball in a.layout().items():
        seen = turned(ball, knobs.length) if across else flipped(ball, knobs.width)
        there = b.layout()[name]
        assert (seen.x, seen.y, seen.vx, seen.vy) == pytest.approx((there.x, there.y, there.vx, there.vy), abs=1e-6)


@pytest.mark.parametrize("law", CUSHION_LAWS)
@pytest.mark.parametrize("seed", range(12))
def test_a_mirror_along_the_table(seed: int, law: str) -> None:
    table = TABLE.with_knobs({"cushion.law": law})
    layout, shot = random_shot(table, seed)
    mirrored = Layout(flipped(ball, 1.27) for ball in layout.values())
    other = Shot(-shot.angle, shot.speed, -shot.side, shot.height, shot.elevation)
    agree(table, layout, shot, mirrored, other, across=False)


@pytest.mark.parametrize("law", BALL_LAWS)
@pytest.mark.parametrize("seed", range(12))
def test_a_mirror_across_the_table(seed: int, law: str) -> None:
    table = TABLE.with_knobs({"ball.law": law})
    layout, shot = random_shot(table, seed)
    mirrored = Layout(turned(ball, 2.54) for ball in layout.values())
    other = Shot(180.0 - shot.angle, shot.speed, -shot.side, shot.height, shot.elevation)
    agree(table, layout, shot, mirrored, other, across=True)


@settings(max_examples=40)
@given(plays(TABLE), st.floats(0.001, 0.5))
def test_looking_changes_nothing(play: Play, step: float) -> None:
    layout, shot = play
    seen, unseen = simulate(TABLE, layout, shot), simulate(TABLE, layout, shot)
    for ball in layout:
        seen.path(ball, max(step, seen.duration / 200.0))
    assert seen.digest() == unseen.digest()
    assert seen.layout() == unseen.layout()


@settings(max_examples=60)
@given(plays(TABLE))
def test_balls_that_meet_keep_their_momentum(play: Play) -> None:
    layout, shot = play
    for event in simulate(TABLE, layout, shot).events:
        if event.kind in ("ball_ball", "cluster"):
            # Pressed balls get the cloth's friction of the next 2 ms with the contact: no more than 0.004 m/s each.
            slack = 1e-12 if nearing(event) > 1e-4 else 0.004
            for part in ("vx", "vy"):
                before, after = (
                    sum(TABLE.body_of(layout[name])[1] * getattr(ball, part) for name, ball in balls.items())
                    for balls in (event.before, event.after)
                )
                assert after == pytest.approx(before, abs=slack)


@pytest.mark.parametrize("ball_law", BALL_LAWS)
@pytest.mark.parametrize("cushion_law", CUSHION_LAWS)
def test_every_pair_of_laws_plays_soundly(ball_law: str, cushion_law: str) -> None:
    table = TABLE.with_knobs({"ball.law": ball_law, "cushion.law": cushion_law})
    for seed in range(6):
        assert_sound(table, simulate(table, *random_shot(table, seed)), samples=5)
    rollout = simulate(table, table.rack("eight-ball", seed=1), Shot(angle=0.2, speed=9.0))
    assert_sound(table, rollout, samples=5)


def test_the_same_shot_twice_is_the_same_to_the_bit() -> None:
    for seed in range(10):
        layout, shot = random_shot(TABLE, seed)
        balls = list(layout.values())
        random.Random(seed).shuffle(balls)
        assert simulate(TABLE, layout, shot).digest() == simulate(TABLE, Layout(balls), shot).digest()
