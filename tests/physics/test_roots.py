"""The first root of a quartic, against a dense scan and against numpy's companion matrices."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from pool2d.physics.roots import falling_root, first_root

COEFFICIENT = st.floats(-10.0, 10.0).map(lambda x: x if abs(x) > 1e-3 else 0.0)
COEFFICIENTS = st.tuples(COEFFICIENT, COEFFICIENT, COEFFICIENT, COEFFICIENT, COEFFICIENT)
ROOT = st.floats(-2.0, 12.0, allow_subnormal=False)
Coefficients = tuple[float, float, float, float, float]


def value(c: Coefficients, t: float) -> float:
    return (((c[4] * t + c[3]) * t + c[2]) * t + c[1]) * t + c[0]


def rounding(c: Coefficients, t: float) -> float:
    """How far from the truth a value at t may be."""
    return 1e-14 * sum(abs(one) * t**power for power, one in enumerate(c))


def through(roots: list[float], lead: float) -> Coefficients:
    """The polynomial with these roots, of degree four or less, lowest coefficient first."""
    c = [lead]
    for root in roots:
        c = [low - root * high for low, high in zip([0.0, *c], [*c, 0.0], strict=True)]
    c += [0.0] * (5 - len(c))
    return c[0], c[1], c[2], c[3], c[4]


@given(COEFFICIENTS, st.floats(0.1, 12.0))
def test_no_earlier_crossing_is_missed(c: Coefficients, end: float) -> None:
    """Between the last point above zero and the first below, in a dense scan, lies the root."""
    found = first_root(*c, end)
    scan = np.linspace(0.0, end, 2001)
    values = np.polyval(c[::-1], scan)
    sure = np.array([rounding(c, float(t)) for t in scan])
    above, below = values > sure, values < -sure
    crossings = [i for i in range(2000) if above[: i + 1].any() and below[i + 1]]
    assume(crossings or found < math.inf)
    if crossings:
        assert found <= scan[crossings[0] + 1] * (1.0 + 1e-12)
    if found < math.inf:
        assert 0.0 <= found <= end
        assert abs(value(c, found)) <= 10.0 * rounding(c, found) + 1e-300
        before, after = found * (1.0 - 1e-6), found * (1.0 + 1e-6)
        assert value(c, before) >= -rounding(c, before)
        assert value(c, after) <= rounding(c, after)


@given(st.lists(ROOT, min_size=1, max_size=4), st.sampled_from([1.0, -1.0, 0.3, -7.0]))
def test_first_falling_root_of_known_roots(roots: list[float], lead: float) -> None:
    roots.sort()
    assume(all(b - a > 1e-3 for a, b in pairwise(roots)) and all(abs(r) > 1e-3 for r in roots))
    c = through(roots, lead)
    # It falls through a root where it is positive just before.
    falling = [
        root
        for i, root in enumerate(roots)
        if root > 0.0 and lead * (-1.0) ** (len(roots) - i) > 0.0
    ]  # fmt: skip
    assert first_root(*c, 15.0) == (pytest.approx(falling[0], rel=1e-6) if falling else math.inf)


@given(COEFFICIENTS)
def test_agrees_with_companion_matrices(c: Coefficients) -> None:
    slopes = np.polyder(np.poly1d(c[::-1]))
    real = []
    for root in np.roots(c[::-1]):
        if abs(root.imag) < 1e-3 * (1.0 + abs(root)):
            # Where the slope is not small the root is well known.
            assume(abs(slopes(root.real)) > 1e-2 and abs(root.real) > 1e-6 and abs(root.real - 15.0) > 1e-6)
            real.append(float(root.real))
    falling = [root for root in real if 0.0 < root < 15.0 and slopes(root) < 0.0]
    assert first_root(*c, 15.0) == (pytest.approx(min(falling), rel=1e-9) if falling else math.inf)


@pytest.mark.parametrize(
    ("c", "end", "root"),
    [
        ((1.0, -1.0, 0.0, 0.0, 0.0), 2.0, 1.0),
        ((1.0, -1.0, 0.0, 0.0, 0.0), 1.0, 1.0),
        ((1.0, -1.0, 0.0, 0.0, 0.0), 0.9, math.inf),
        ((1.0, 0.0, 0.0, 0.0, -1.0), 5.0, 1.0),
        ((1.0, 0.0, 0.0, 0.0, 1.0), 5.0, math.inf),
        ((-1.0, 1.0, 0.0, 0.0, 0.0), 5.0, math.inf),
        ((0.0, 0.0, 0.0, 0.0, 0.0), 5.0, math.inf),
        ((0.0, 1.0, -1.0, 0.0, 0.0), 5.0, 1.0),
        ((0.0, -1.0, 0.0, 0.0, 0.0), 5.0, math.inf),
        ((1.0, -2.0, 0.0, 0.0, 0.0), 1e9, 0.5),
        ((1e-20, -1e-10, 0.0, 0.0, 0.0), 1.0, 1e-10),
    ],
)
def test_plain_cases(c: Coefficients, end: float, root: float) -> None:
    assert first_root(*c, end) == pytest.approx(root, rel=1e-15)


@given(COEFFICIENT, COEFFICIENT, COEFFICIENT)
def test_falling_root_of_a_quadratic(c0: float, c1: float, c2: float) -> None:
    assume(all(one == 0.0 or abs(one) > 1e-6 for one in (c0, c1, c2)))
    t = falling_root(c0, c1, c2)
    if t < math.inf:
        size = abs(c0) + abs(c1 * t) + abs(c2 * t * t)
        assert abs((c2 * t + c1) * t + c0) <= 1e-12 * size
        assert c1 + 2.0 * c2 * t <= 1e-6 * (abs(c1) + abs(c2 * t))
    else:
        # Nowhere does it fall through zero: it has no two roots, or it is a line that does not fall.
        assert c1 * c1 - 4.0 * c0 * c2 <= 0.0 if c2 != 0.0 else c1 >= 0.0
