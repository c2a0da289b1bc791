"""How sure the knobs of a fit are, and which of them the tracks cannot tell."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .shot_fit import CLIP, Fitted, Slopes, weights
from .tracks import Floats

# Standard deviations to either side that hold 95 of 100 normal errors: what an uncertainty means here.
COVERAGE = 1.96
# A knob takes part in what cannot be told where this part of it is along it.
_PART = 0.1


def untold(slopes: Sequence[Slopes], miss: float) -> list[list[int]]:
    """The groups of knobs, by number, that may be turned by about their widths without the tracks telling.

    Where points are seen `miss` m off, that is. In a group the knob comes first that has the largest part in it.
    """
    values, ways = np.linalg.eigh(_information(slopes))
    unsure = values < (COVERAGE * miss) ** 2
    groups = [
        [int(number) for number in np.argsort(-(way**2)) if way[number] ** 2 > _PART] for way in ways[:, unsure].T
    ]
    return sorted(groups)


def uncertainties(slopes: Sequence[Slopes], fitted: Sequence[Fitted], usual: float) -> Floats:
    """How far off each knob may be, in its width, 95 times of 100; `usual` is the size of a usual shot's misses, m.

    The larger of two: by the misses, were each an error of its own (Huber 1981, chapter 7), and by how much the knobs
    would move without each of the shots, as errors of one shot go together, and a launch that is lost pulls alone (the
    jackknife: Efron and Stein 1981, by shots and to first order). All knobs have to be told.
    """
    parts = [weights(one.misses, CLIP * usual) for one in fitted]
    pulls = [one.misses * part for one, part in zip(fitted, parts, strict=True)]
    # By how much a miss pulls more where it grows, on average; 1 where none is clipped.
    growth = float(np.mean(np.concatenate(parts) ** 3))
    told = _information(slopes) * growth
    by_misses = np.linalg.inv(told) * _variance(fitted, pulls, len(slopes[0].misses[0])) / growth
    without = np.array([_without(told, one.misses, pull, growth) for one, pull in zip(slopes, pulls, strict=True)])
    by_shots = np.sum(without**2, axis=0) * (len(without) - 1) / len(without)
    return np.asarray(COVERAGE * np.sqrt(np.maximum(np.diag(by_misses), by_shots)), np.float64)


def _without(told: Floats, misses: Floats, pull: Floats, growth: float) -> Floats:
    """How far the knobs move, in their widths, where one shot is left out; far, where no other tells them."""
    others = told - growth * (misses.T @ misses)
    return np.asarray(np.linalg.pinv(others, rcond=1e-12) @ (misses.T @ pull), np.float64)


def _variance(fitted: Sequence[Fitted], pulls: Sequence[Floats], knobs: int) -> float:
    """The mean square of what the misses pull with, less what the numbers that were fitted have taken from it."""
    free = knobs + sum(len(one.numbers) for one in fitted)
    every = np.concatenate(pulls)
    return float(np.sum(every**2)) / max(1, len(every) - free)


def _information(slopes: Sequence[Slopes]) -> Floats:
    """What all shots tell of the knobs together, m2."""
    return np.asarray(sum(one.misses.T @ one.misses for one in slopes), np.float64)
