"""How sure knobs are, held against errors that are known."""

from __future__ import annotations

import numpy as np
import pytest

from pool2d.fit.certainty import COVERAGE, uncertainties, untold
from pool2d.fit.shot_fit import Fitted, Slopes
from pool2d.fit.tracks import Floats

MISS = 0.0004


def shots(count: int, columns: Floats) -> list[Slopes]:
    """So many shots with slopes at random, in the directions that `columns` leave."""
    rng = np.random.default_rng(1)
    return [Slopes(rng.normal(0.0, 0.01, (400, len(columns))) @ columns, np.zeros((0, 0))) for _ in range(count)]


@pytest.mark.parametrize(
    ("columns", "groups"),
    [
        (np.eye(3), []),
        (np.diag([1.0, 0.0, 1.0]), [[1]]),
        (np.diag([0.0, 1.0, 0.0]), [[0], [2]]),
        (np.array([[1.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 0.0]]), [[0, 1]]),
        (np.array([[1.0, 0.5, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 0.0]]), [[1, 0]]),
        # Told, but less than a miss over all points tells of a width.
        (np.diag([1.0, 1e-4, 1.0]), [[1]]),
        (np.diag([1.0, 1e-2, 1.0]), []),
    ],
)
def test_what_cannot_be_told_is_named(columns: Floats, groups: list[list[int]]) -> None:
    assert [sorted(group) for group in untold(shots(4, columns), MISS)] == [sorted(group) for group in groups]


def test_the_knob_with_the_larger_part_comes_first() -> None:
    columns = np.array([[1.0, 0.5, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 0.0]])
    assert untold(shots(4, columns), MISS) == [[1, 0]]


def test_uncertainty_holds_ninety_five_of_a_hundred_errors() -> None:
    """Of a linear model with normal misses, solved three hundred times."""
    slopes, rng = shots(12, np.array([[1.0, 0.3], [0.0, 0.2]])), np.random.default_rng(2)
    every = np.concatenate([one.misses for one in slopes])
    within = 0
    for _ in range(300):
        noise = rng.normal(0.0, MISS, len(every))
        off = np.linalg.lstsq(every, noise, rcond=None)[0]
        left = np.split(noise - every @ off, 12)
        fitted = [Fitted(np.zeros(0), part, 0.0) for part in left]
        within += int(np.sum(np.abs(off) <= uncertainties(slopes, fitted, MISS)))
    # The larger of two estimates, so rather more.
    assert 0.93 <= within / 600 <= 0.99


def test_errors_that_go_together_in_a_shot_count_as_one() -> None:
    slopes = shots(12, np.eye(1))
    rng = np.random.default_rng(3)
    apart = [Fitted(np.zeros(0), rng.normal(0.0, MISS, 400), 0.0) for _ in slopes]
    # Each shot wants another knob: as much as ten of the misses' own uncertainties.
    alone = uncertainties(slopes, apart, MISS)[0]
    pulled = [
        Fitted(np.zeros(0), fit.misses + way.misses[:, 0] * 10.0 * alone * rng.normal(), 0.0)
        for way, fit in zip(slopes, apart, strict=True)
    ]
    assert uncertainties(slopes, pulled, MISS)[0] > 4.0 * alone
    by_hand = COVERAGE * MISS / np.linalg.norm(np.concatenate([one.misses for one in slopes]))
    assert alone == pytest.approx(by_hand, rel=0.5)
