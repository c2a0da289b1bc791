"""The shots of a study: every combination of a grid, and errors as a hand makes them."""

from __future__ import annotations

import statistics
from itertools import islice, product

import pytest

from pool2d import Shot
from pool2d.study.sweep import Sweep

BASE = Shot(angle=10.0, speed=2.0, side=0.1, height=-0.2, elevation=3.0, ball="7")
GRID = {"speed": (1.0, 3.0, 2.0), "angle": (0.0, 5.0)}


def test_a_grid_is_every_combination_the_last_changing_fastest() -> None:
    sweep = Sweep(BASE, GRID, {}, 1, 0)
    shots = list(sweep.shots())
    assert [(shot.speed, shot.angle) for shot in shots] == list(product(*GRID.values()))
    assert {(shot.side, shot.height, shot.elevation, shot.ball) for shot in shots} == {(0.1, -0.2, 3.0, "7")}
    assert len(sweep) == len(shots) == 6


def test_a_shot_is_found_in_the_grid_by_its_number() -> None:
    sweep = Sweep(BASE, GRID, {"side": 0.1}, 4, 0)
    for number, shot in enumerate(sweep.shots()):
        assert shot.speed == GRID["speed"][sweep.place("speed", number)]
        assert shot.angle == GRID["angle"][sweep.place("angle", number)]


def test_noise_is_of_its_size_about_what_was_meant_and_of_nothing_else() -> None:
    sweep = Sweep(BASE, {"angle": (-20.0, 20.0)}, {"angle": 0.5, "speed": 0.1}, 4000, 3)
    shots = list(sweep.shots())
    for meant, some in ((-20.0, shots[:4000]), (20.0, shots[4000:])):
        assert statistics.fmean(shot.angle for shot in some) == pytest.approx(meant, abs=0.04)
        assert statistics.stdev(shot.angle for shot in some) == pytest.approx(0.5, rel=0.05)
        assert statistics.fmean(shot.speed for shot in some) == pytest.approx(2.0, abs=0.01)
        assert statistics.stdev(shot.speed for shot in some) == pytest.approx(0.1, rel=0.05)
    assert {(shot.side, shot.height, shot.elevation) for shot in shots} == {(0.1, -0.2, 3.0)}
    assert statistics.correlation([shot.angle for shot in shots[:4000]], [shot.speed for shot in shots[:4000]]) < 0.06


def test_a_seed_draws_the_same_errors_and_another_others() -> None:
    first, again, other = (list(Sweep(BASE, {}, {"angle": 0.5}, 50, seed).shots()) for seed in (1, 1, 2))
    assert first == again
    assert not set(first) & set(other)
    # What is left of a study are the shots that it would have come to.
    assert list(islice(Sweep(BASE, {}, {"angle": 0.5}, 50, 1).shots(), 20, None)) == first[20:]


def test_no_error_leads_beyond_what_can_be() -> None:
    level = Shot(elevation=0.0, speed=0.05)
    shots = list(Sweep(level, {}, {"elevation": 1.0, "speed": 1.0, "side": 3.0}, 200, 1).shots())
    assert {shot.elevation for shot in shots if shot.elevation <= 0.0} == {0.0}
    assert min(shot.speed for shot in shots) == 0.0
    assert (min(shot.side for shot in shots), max(shot.side for shot in shots)) == (-1.0, 1.0)
    for shot in shots:
        shot.check()


def test_noise_goes_three_deviations_to_either_side_as_far_as_it_can() -> None:
    sweep = Sweep(BASE, {}, {"angle": 2.0, "elevation": 2.0}, 1, 0)
    assert sweep.spread("angle") == (4.0, 16.0)
    assert sweep.spread("elevation") == (0.0, 9.0)
