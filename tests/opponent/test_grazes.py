"""How far balls may graze the jaws: what is found is where the engine's balls begin to fall."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pool2d import load_table
from pool2d.opponent.grazes import ANGLES, GapFrame, falls
from pool2d.opponent.mouths import mouths

STRAIGHT = ANGLES.index(0.0)


def frame(table: str, pocket: str) -> GapFrame:
    seen = mouths(load_table(table))
    i = seen.names.index(pocket)
    (right, left), middle = seen.jaws[i].tolist(), seen.middles[i].tolist()
    return GapFrame(pocket, tuple(middle), float(seen.axes[i]), tuple(right), tuple(left), float(seen.radii[i]))


def straight(table: str, pocket: str) -> float:
    seen = mouths(load_table(table))
    return float(seen.grazed[seen.names.index(pocket), 0, STRAIGHT])


@pytest.mark.parametrize("pocket", ["bottom-left", "top-side"])
def test_a_ball_down_the_middle_falls_and_one_that_meets_a_jaw_full_does_not(pocket: str) -> None:
    table, mouth = load_table("pool-9ft"), frame("pool-9ft", pocket)
    gap = 0.5 * math.dist(mouth.right, mouth.left)
    assert falls(table, mouth, 0.0, 0.0, 1.0)
    assert not falls(table, mouth, 0.0, gap, 1.0)
    assert not falls(table, mouth, 0.0, -gap, 1.0)


def test_the_right_jaw_is_to_the_right_of_a_ball_that_comes_in() -> None:
    seen = mouths(load_table("l-shape"))
    for middle, axis, (right, left) in zip(seen.middles, seen.axes, seen.jaws, strict=True):
        across = np.array((-math.sin(axis), math.cos(axis)))
        assert (right - middle) @ across < 0.0 < (left - middle) @ across


def test_what_holds_of_one_jaw_holds_of_the_other_the_other_way_round() -> None:
    table, mouth = load_table("pool-9ft"), frame("pool-9ft", "bottom-side")
    places = [0.004 * i for i in range(-15, 16)]
    right = [falls(table, mouth, ANGLES[2], place, 1.0) for place in places]
    assert right == [falls(table, mouth, -ANGLES[2], -place, 1.0) for place in places]
    assert any(right) and not all(right)


def test_long_curves_let_in_what_pockets_hardly_wider_than_a_ball_do_not() -> None:
    assert straight("snooker-12ft", "top-left") > 2.0 * straight("pool-9ft", "top-left")
    assert straight("pool-9ft", "top-left") > straight("pyramid-12ft", "top-left") > -0.1
