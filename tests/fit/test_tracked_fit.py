"""Fits of tracks that were made: the knobs that they were made with are found, and what cannot be told is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pool2d import InputError, Shot
from pool2d.fit.miss import Stretch
from pool2d.fit.shot_fit import Fitted, setting_of
from pool2d.fit.tracked_fit import TrackedFit, check_knobs, errors
from pool2d.fit.usual_knobs import usual_knobs
from pool2d.study.crew import Crew

from .known_shots import CUE, NOISE, RED, TABLE, alone, stretch

TRUE = {"cloth.mu_slide": 0.19, "cushion.restitution": 0.85}


def fit_of(shots: list[Stretch], *names: str) -> TrackedFit:
    values = {
        "cloth.mu_slide": 0.2,
        "cushion.restitution": 0.87,
        "ball.restitution": 0.95,
        "cue.mass": 0.5,
        "gravity": 9.8,
        "cloth.mu_roll": 0.0044,
    }
    return TrackedFit(setting_of(TABLE, {name: values[name] for name in names}), shots, NOISE, "shots.csv")


def test_knobs_are_found_and_both_halves_judged() -> None:
    fit = fit_of(alone(TABLE.with_knobs(TRUE), 4), *TRUE)
    fit.run(Crew())
    assert fit.knob_fit is not None
    assert fit.uncertain is not None
    for value, true, sure in zip(fit.knob_fit.setting.values, TRUE.values(), fit.uncertain.tolist(), strict=True):
        assert abs(value - true) < 3.0 * sure
        # A tenth of a percent and less is known, of a knob that was off by much more.
        assert sure < 0.01 * true
    assert len(fit.before) == len(fit.after) == 4
    before, after = errors(fit.before).of, errors(fit.after).of
    # Noise of 0.4 mm along each axis is 0.057 cm of distance.
    assert after == pytest.approx([100.0 * math.sqrt(2.0) * NOISE] * 4, rel=0.15)
    assert min(before) > 2.0 * max(after)


def test_balls_and_their_restitution_are_found() -> None:
    true = TABLE.with_knobs({"ball.restitution": 0.92})
    shots = [
        stretch(Shot(10.0 + 1.2 * i, 1.8 + 0.2 * i, 0.0, 0.1), (CUE, RED._replace(y=0.66)), i, NOISE, true)
        for i in range(2)
    ]
    fit = fit_of(shots, "ball.restitution")
    fit.run(Crew())
    assert fit.knob_fit is not None
    assert fit.uncertain is not None
    assert abs(fit.knob_fit.setting.values[0] - 0.92) < 3.0 * fit.uncertain[0] < 0.03


@pytest.mark.parametrize(
    ("names", "told"),
    [
        (
            ("ball.restitution", "cushion.restitution"),
            "the tracks cannot tell ball.restitution; fit the others: --knobs cushion.restitution",
        ),
        # A heavier cue is as good as a faster one.
        (("cushion.restitution", "cue.mass"), "cannot tell cue.mass; fit the others: --knobs cushion.restitution"),
        (("ball.restitution",), "the tracks cannot tell ball.restitution$"),
    ],
)
def test_knobs_that_tracks_cannot_tell_are_refused_by_name(names: tuple[str, ...], told: str) -> None:
    with pytest.raises(InputError, match=told):
        fit_of(alone(TABLE, 2), *names).run(Crew())


def test_knobs_that_go_together_are_refused_together() -> None:
    """Balls slide and roll as friction times gravity has it: tracks without cushions tell no more."""
    shots = [stretch(Shot(5.0, 1.0 + 0.1 * i, 0.0, -0.2), (CUE,), i) for i in range(2)]
    told = "cannot tell (gravity and cloth.mu_slide|cloth.mu_slide and gravity) apart"
    with pytest.raises(InputError, match=told):
        fit_of(shots, "cloth.mu_slide", "cloth.mu_roll", "gravity").run(Crew())


def test_one_shot_leaves_none_to_judge_by() -> None:
    with pytest.raises(InputError, match=r"shots.csv: has 1 shots that can be fitted; needed are 2"):
        fit_of(alone(TABLE, 1), "cushion.restitution")


@pytest.mark.parametrize(
    ("names", "told"),
    [
        (("cloth.mu_slid",), "did you mean cloth.mu_slide"),
        (("ball.law",), "unknown"),
        (("cloth.mu_roll", "cloth.mu_roll"), "is there twice"),
    ],
)
def test_knobs_have_to_be_numbers_that_there_are(names: tuple[str, ...], told: str) -> None:
    with pytest.raises(InputError, match=told):
        check_knobs(names, "command line", "--knobs")


def test_errors_are_distances_in_cm() -> None:
    some = [Fitted(np.zeros(0), np.array([0.03 * i, 0.0, 0.04 * i, 0.0]), 0.0) for i in range(1, 6)]
    # Two points, one 3 cm off along x, the other 4: the root mean square is 3.54.
    assert errors(some).of == pytest.approx([100.0 * i * math.sqrt((0.03**2 + 0.04**2) / 2.0) for i in range(1, 6)])
    assert errors(some).quartiles() == pytest.approx([i * 3.5355 for i in (2, 3, 4)], rel=1e-4)
    assert str(errors(some)) == "10.6 (7.07-14.1)"


@pytest.mark.parametrize(
    ("laws", "some", "none"),
    [
        ({}, {"cushion.tangential", "ball.friction_a", "ball.friction_c"}, {"ball.friction"}),
        ({"ball.law": "impulse"}, {"ball.friction", "cloth.mu_spin"}, {"ball.friction_b"}),
        ({"ball.law": "frictionless"}, {"ball.restitution"}, {"ball.friction", "ball.friction_a"}),
        ({"cushion.law": "impulse"}, {"cushion.friction"}, {"cushion.tangential"}),
    ],
)
def test_the_usual_knobs_are_those_that_the_laws_read(laws: dict[str, str], some: set[str], none: set[str]) -> None:
    names = usual_knobs(TABLE.with_knobs(laws))
    check_knobs(names, "", "")
    assert some <= set(names)
    assert not none & set(names)
