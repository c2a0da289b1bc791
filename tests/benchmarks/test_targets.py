"""How large pockets play, against Alciatore's technical proofs TP 3.5 and TP 3.6."""

from __future__ import annotations

import pytest

from benchmarks.targets import CORNER, INCH, MIRROR, SIDE, TP_3_5, TP_3_6, target
from pool2d import load_table

MIRRORS = load_table("pool-9ft", {**MIRROR, **CORNER, **SIDE})
POOL = load_table("pool-9ft", {**CORNER, **SIDE})
CUSHIONS = POOL.with_knobs({"facing.restitution": 1.0, "facing.tangential": 0.0, "facing.friction": 1.0})
# Ways further apart than the benchmark's, m: bands that are narrower than this are few.
STEP = 2.5e-3


@pytest.mark.parametrize(
    ("kind", "angle", "width"),
    [
        ("corner", 0.0, 2.668),
        ("corner", 20.0, 2.425),
        ("side", 0.0, 3.229),
        ("side", 20.0, 2.958),
        ("side", 35.0, 2.420),
    ],
)
def test_mirrors_give_what_the_equations_give(kind: str, angle: float, width: float) -> None:
    """His equations solved to three digits, a ball that may meet a point and up to two facings, or one at the side.

    They and the engine have pocket, hole and ball in common, and nothing else.
    """
    assert target(MIRRORS, kind, angle, 2.0) / INCH == pytest.approx(width, abs=0.012)


@pytest.mark.parametrize("angle", TP_3_6)
def test_a_corner_pocket_is_as_large_as_published_to_balls_at_a_usual_speed(angle: float) -> None:
    """The preset's facings were fitted to these, so it is the fit that is looked at, and that it holds."""
    assert target(POOL, "corner", angle, 1.4) / INCH == pytest.approx(TP_3_6[angle], abs=0.15)


@pytest.mark.parametrize("speed", [0.7, 1.4, 7.0])
@pytest.mark.parametrize("angle", [0.0, 20.0])
def test_and_at_any_speed_where_no_rail_is_met(angle: float, speed: float) -> None:
    assert target(POOL, "corner", angle, speed, STEP) / INCH == pytest.approx(TP_3_6[angle], abs=0.15)


@pytest.mark.parametrize(("angle", "close"), [(0.0, 0.1), (20.0, 0.1), (35.0, 0.1), (50.0, 0.3)])
def test_a_side_pocket_is_as_large_as_published(angle: float, close: float) -> None:
    """To which nothing was fitted."""
    for speed in (0.7, 7.0):
        assert target(POOL, "side", angle, speed, STEP) / INCH == pytest.approx(TP_3_5[angle], abs=close)


@pytest.mark.parametrize(
    ("kind", "angle"),
    [*(("corner", angle) for angle in (-40.0, 0.0, 10.0, 20.0, 30.0, 40.0)), *(("side", angle) for angle in TP_3_5)],
)
def test_a_pocket_is_the_smaller_the_faster_the_ball(kind: str, angle: float) -> None:
    slow, usual, fast = (target(POOL, kind, angle, speed, STEP) for speed in (0.7, 2.0, 7.0))
    assert fast < usual < slow


def test_a_facing_takes_less_than_a_cushion_would() -> None:
    """Above all from balls that come by the rail."""
    for angle, speed in ((0.0, 0.7), (20.0, 2.0), (30.0, 0.7), (40.0, 0.7), (40.0, 4.0)):
        assert target(POOL, "corner", angle, speed, STEP) < target(CUSHIONS, "corner", angle, speed, STEP) - 0.04 * INCH
