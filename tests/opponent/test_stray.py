"""Hands stray as normal distributions do, and more where a stroke is awkward."""

from __future__ import annotations

import math
import random
import statistics

import pytest

from pool2d import Ball, Layout, Shot, load_table
from pool2d.opponent.stray import AIM, ELEVATION, SPEED, TIP, Hand, awkward

RADIUS = 0.028575
TABLE = load_table("pool-9ft")
OPEN = Layout([Ball("cue", 0.6, 0.635)])


def spreads(hand: Hand, shot: Shot, widened: float = 1.0) -> dict[str, float]:
    rng = random.Random(1)
    strokes = [hand.stray(shot, RADIUS, widened, rng) for _ in range(4000)]
    names = ("angle", "speed", "side", "height", "elevation")
    return {name: statistics.pstdev(getattr(stroke, name) for stroke in strokes) for name in names}


def test_a_hand_at_one_strays_by_the_published_units() -> None:
    found = spreads(Hand(), Shot(30.0, 3.0, 0.1, -0.1, 20.0))
    assert found["angle"] == pytest.approx(AIM, rel=0.05)
    assert found["speed"] == pytest.approx(SPEED, rel=0.05)
    assert found["side"] == pytest.approx(TIP / RADIUS, rel=0.05)
    assert found["height"] == pytest.approx(TIP / RADIUS, rel=0.05)
    # Downward it does not stray, as the cue would go through what it has just been raised for.
    assert 0.5 * ELEVATION < found["elevation"] < 0.7 * ELEVATION


def test_errors_widen_each_by_its_own_multiple() -> None:
    plain, wide = spreads(Hand(), Shot()), spreads(Hand(aim=3.0, tip=2.0, speed=0.5), Shot())
    assert wide["angle"] == pytest.approx(3.0 * plain["angle"])
    assert wide["side"] == pytest.approx(2.0 * plain["side"])
    assert wide["speed"] == pytest.approx(0.5 * plain["speed"])
    twice = spreads(Hand(), Shot(), widened=2.0)
    assert twice["angle"] == pytest.approx(2.0 * plain["angle"])


def test_a_steady_hand_plays_what_was_meant_and_a_level_cue_stays_level() -> None:
    shot = Shot(12.0, 3.0, 0.2, 0.1)
    assert Hand(0.0, 0.0, 0.0, 0.0).stray(shot, RADIUS, 5.0, random.Random(0)) == shot
    assert Hand().stray(shot, RADIUS, 5.0, random.Random(0)).elevation == 0.0


def test_no_stroke_leaves_its_range() -> None:
    wild, rng = Hand(50.0, 50.0, 50.0, 50.0), random.Random(2)
    for _ in range(300):
        wild.stray(Shot(10.0, 0.1, 0.6, 0.3, 10.0), RADIUS, 3.0, rng).check()


@pytest.mark.parametrize(
    ("cue", "shot"),
    [
        pytest.param(Ball("cue", 2.0, 0.635), Shot(0.0, 2.0), id="stretch"),
        pytest.param(Ball("cue", 0.05, 0.635), Shot(0.0, 2.0), id="rail under the bridge"),
        pytest.param(Ball("cue", 0.6, 0.635), Shot(0.0, 2.0, elevation=30.0), id="raised butt"),
        pytest.param(Ball("cue", 0.6, 0.635), Shot(0.0, 8.0), id="hard"),
    ],
)
def test_awkward_strokes_widen_the_errors(cue: Ball, shot: Shot) -> None:
    assert awkward(TABLE, OPEN, Shot(0.0, 2.0)) == 1.0
    wider = awkward(TABLE, Layout([cue]), shot)
    assert wider > 1.2
    assert awkward(TABLE, Layout([cue]), shot, strain=0.0) == 1.0
    assert awkward(TABLE, Layout([cue]), shot, strain=2.0) == pytest.approx(2.0 * wider - 1.0)


@pytest.mark.parametrize("far", [0.05, 0.5])
def test_a_stroke_whose_butt_is_over_a_pocket_is_no_endless_stretch(far: float) -> None:
    """Behind a ball in a mouth there may be nothing at all: the error was infinite, and so was the angle."""
    for pocket in TABLE.geometry.pockets:
        inward = math.atan2(pocket.uy, pocket.ux)
        for aside in (-30.0, 0.0, 30.0):
            way = inward + math.radians(aside)
            layout = Layout([Ball("cue", pocket.x + far * math.cos(way), pocket.y + far * math.sin(way))])
            for turn in (-60.0, 0.0, 60.0):
                assert awkward(TABLE, layout, Shot(angle=math.degrees(inward) + turn, speed=1.0)) < 5.0
