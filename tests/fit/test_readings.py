"""What people type in as readings, and what their repetition is worth."""

from __future__ import annotations

import random
from statistics import stdev

import pytest

from pool2d import InputError
from pool2d.config.knobs import Knob
from pool2d.fit.readings import Quantity, average, read

LAG = Quantity("lag.seconds", Knob(0.0, 1.0, 60.0, "s", ""), 0.2)


@pytest.mark.parametrize(
    ("given", "value", "error"),
    [
        (8.4, 8.4, 0.2),
        (8, 8.0, 0.2),
        ("8.4", 8.4, 0.2),
        ("8,4", 8.4, 0.2),
        ("8.4 +-0.1", 8.4, 0.1),
        ("8.4 +- 0,1", 8.4, 0.1),
        ("8.4 +/-0.1", 8.4, 0.1),
        ("8.4\N{PLUS-MINUS SIGN}0.1", 8.4, 0.1),
        ([8.4, 8.4], 8.4, 0.1),
        ("8.2 8.6", 8.4, (0.2**2 + 2 * 0.2**2) ** 0.5 / 2),
        ("8,2; 8,6", 8.4, (0.2**2 + 2 * 0.2**2) ** 0.5 / 2),
        ("8.2, 8.6 +-0.01", 8.4, (0.01**2 + 2 * 0.2**2) ** 0.5 / 2),
    ],
)
def test_readings_are_averaged_with_their_error(given: object, value: float, error: float) -> None:
    reading = read(given, LAG, "here")
    assert reading.value == pytest.approx(value)
    assert reading.error == pytest.approx(error)


@pytest.mark.parametrize(
    "given",
    ["", "  ", "fast", "8.4.2", "8.4,8.6", "+-0.2", "8.4 +-", "8.4 +- 0", "8.4 +- -1", "8.4 +-1 2", "8.4 +-1 +-2",
     "0.5", "nan", "inf", "8.4 +-inf", "8.4 +-nan", 0.5, 61, True, None, [], [8.4, "8"], ["8"],
     [8.4, 99], [8.4] * 101, {}],
)  # fmt: skip
def test_what_is_no_reading_is_told_in_one_line(given: object) -> None:
    with pytest.raises(InputError, match=r"^here: lag\.seconds = .*allowed (is|are) ") as caught:
        read(given, LAG, "here")
    assert "\n" not in str(caught.value)


def test_the_error_of_many_readings_is_that_of_their_mean() -> None:
    rng = random.Random(3)
    means, errors = [], []
    for _ in range(400):
        reading = average([rng.gauss(8.4, 0.5) for _ in range(8)], 0.5)
        means.append(reading.value)
        errors.append(reading.error)
    assert stdev(means) == pytest.approx(sum(errors) / len(errors), rel=0.1)


def test_readings_that_lie_far_apart_are_less_sure_than_was_said() -> None:
    assert average([7.0, 9.0, 8.0, 8.5], 0.01).error > 0.35
