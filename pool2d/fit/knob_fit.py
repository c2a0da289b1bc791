"""The knobs that all shots share: turned until the misses of all launches, fitted again each time, are least.

The launches are solved for within each step of the knobs (variable projection: Golub and Pereyra 1973; with the
Jacobian of Kaufman 1975). A miss counts by its square up to a few times the usual, and by its size beyond: after many
contacts a shot may go any way. The beginnings of the shots are looked at first, then more and more of them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ..study.crew import Crew
from .miss import Stretch
from .shot_fit import (
    CLIP,
    COARSE,
    HORIZONS,
    Fitted,
    Setting,
    Slopes,
    approached,
    knob_slopes,
    knobs,
    launched,
    width_of,
)
from .tracks import Floats

# How far into the shots the stages look, s, and how often each turns the knobs, at most.
STAGES = (*((seconds, 8) for seconds in HORIZONS), (math.inf, 8), (math.inf, 15))
# Below this part of its width no knob is turned any more.
_LEAST = 1e-4
# A shot that misses so many times what shots usually do is looked for anew; one that then misses more sits out.
_AGAIN, _POOR = 1.5, 4.0


def usual_miss(fitted: Sequence[Fitted], noise: float) -> float:
    """How far off, m, along each axis, a shot as good as the median one is; not less than what was seen is off."""
    return max(noise, float(np.median([one.size for one in fitted])))


class KnobFit:
    """A fit as far as it has come: `setting` has the best knobs so far, `fitted` their launches, shot by shot."""

    def __init__(
        self, setting: Setting, stretches: Sequence[Stretch], fitted: Sequence[Fitted], noise: float, crew: Crew
    ) -> None:
        self.setting = setting
        self.stretches = list(stretches)
        self.fitted = list(fitted)
        self.noise = noise
        self.widths = np.array(
            [width_of(name, value) for name, value in zip(setting.names, setting.values, strict=True)]
        )
        self._crew = crew

    def run(self, passed: Callable[[int], None] = lambda stage: None) -> None:
        """Turn the knobs to where the misses are least; `passed` is called after each stage."""
        for number, (seconds, rounds) in enumerate(STAGES):
            stretches = [stretch.up_to(seconds) for stretch in self.stretches]
            self.settle(stretches)
            _Stage(self, stretches, self._crew).run(rounds)
            passed(number)
        self.settle(self.stretches)

    def settle(self, stretches: Sequence[Stretch]) -> None:
        """Fit the launches to more of the shots; those that miss far more than others are looked for anew."""
        clip = CLIP * self.usual
        jobs = [(self.setting, stretch, one.numbers, clip) for stretch, one in zip(stretches, self.fitted, strict=True)]
        self.fitted = self._crew.each(approached, jobs)
        poor = [number for number, one in enumerate(self.fitted) if one.size > _AGAIN * self.usual]
        again = self._crew.each(launched, [(self.setting, stretches[number], COARSE) for number in poor])
        for number, one in zip(poor, again, strict=True):
            self.fitted[number] = min(self.fitted[number], one, key=lambda one: one.size)

    @property
    def usual(self) -> float:
        """How far off, m, along each axis, a shot as good as the median one is."""
        return usual_miss(self.fitted, self.noise)

    def slopes(self) -> list[Slopes]:
        """How what is missed changes with the knobs, shot by shot."""
        clip = CLIP * self.usual
        jobs = [(self.setting, stretch, one.numbers, self.widths, clip) for stretch, one in self._pairs()]
        return self._crew.each(knob_slopes, jobs)

    def _pairs(self) -> list[tuple[Stretch, Fitted]]:
        return list(zip(self.stretches, self.fitted, strict=True))


class _Stage:
    """The knobs turned with shots looked at so far; in its numbers a knob is as many widths from where it began.

    Shots that miss far more than others sit out: they have gone another way, and would tell wrong things.
    """

    def __init__(self, fit: KnobFit, stretches: Sequence[Stretch], crew: Crew) -> None:
        self._fit = fit
        self._crew = crew
        self._start = np.array(fit.setting.values)
        self._clip = CLIP * fit.usual
        self._in = [number for number, one in enumerate(fit.fitted) if one.size <= _POOR * fit.usual]
        self._views = [stretches[number] for number in self._in]
        # The last that was tried, and the best, with what it changes by.
        self._tried = self._best = _Try(np.zeros(len(self._start)), [fit.fitted[number] for number in self._in])
        self._slopes: list[Slopes] = []

    def run(self, rounds: int) -> None:
        """Turn them, and leave with the fit what is best."""
        from scipy.optimize import least_squares

        low, high = self._bounds()
        least_squares(
            self._misses, self._tried.x, self._jacobian, bounds=(low, high),
            loss="soft_l1", f_scale=self._clip, max_nfev=rounds, xtol=_LEAST, ftol=1e-7, gtol=None,
        )  # fmt: skip
        self._keep(min(self._best, self._tried, key=lambda one: one.cost))

    def _bounds(self) -> tuple[Floats, Floats]:
        """How far each knob may be turned, in widths."""
        allowed = [knobs()[name] for name in self._fit.setting.names]
        low, high = np.array([knob.lo for knob in allowed]), np.array([knob.hi for knob in allowed])
        return (low - self._start) / self._fit.widths, (high - self._start) / self._fit.widths

    def _setting(self, x: Floats) -> Setting:
        return self._fit.setting.turned(self._start + self._fit.widths * x)

    def _misses(self, x: Floats) -> Floats:
        """What is missed with knobs turned so."""
        if not np.array_equal(x, self._tried.x):
            setting, begun = self._setting(x), self._foreseen(x)
            jobs = [(setting, stretch, row, self._clip) for stretch, row in zip(self._views, begun, strict=True)]
            self._tried = _Try(x.copy(), self._crew.each(approached, jobs))
        return np.concatenate([one.misses for one in self._tried.fitted])

    def _foreseen(self, x: Floats) -> list[Floats]:
        """The numbers of each launch as they should be with other knobs, from the best and its slopes."""
        if not self._slopes:
            return [one.numbers for one in self._best.fitted]
        by = x - self._best.x
        return [one.numbers + way.numbers @ by for one, way in zip(self._best.fitted, self._slopes, strict=True)]

    def _jacobian(self, x: Floats) -> Floats:
        """How the misses change; it is asked for only where a step has led to something better, which is kept."""
        self._misses(x)
        self._best = self._tried
        self._keep(self._best)
        setting = self._setting(x)
        pairs = zip(self._views, self._best.fitted, strict=True)
        jobs = [(setting, stretch, one.numbers, self._fit.widths, self._clip) for stretch, one in pairs]
        self._slopes = self._crew.each(knob_slopes, jobs)
        return np.concatenate([slopes.misses for slopes in self._slopes])

    def _keep(self, best: _Try) -> None:
        self._fit.setting = self._fit.setting.turned(self._start + self._fit.widths * best.x)
        for number, one in zip(self._in, best.fitted, strict=True):
            self._fit.fitted[number] = one


@dataclass(frozen=True, slots=True)
class _Try:
    """Knobs that were tried, in widths from the start, and the launches that fit best with them."""

    x: Floats
    fitted: list[Fitted]

    @property
    def cost(self) -> float:
        return sum(one.cost for one in self.fitted)
