"""A fit from end to end: launches, the knobs by one half of the shots, and both halves judged before and after."""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from importlib import import_module

import numpy as np

from ..errors import InputError, suggest
from ..study.crew import Crew
from . import certainty
from .knob_fit import STAGES, KnobFit
from .miss import Stretch
from .shot_fit import COARSE, Fitted, Setting, knobs, launched
from .tracks import Floats

# Shots of which one half can be held back.
FEWEST = 2


@dataclass(frozen=True, slots=True)
class Errors:
    """How far off balls are in each of some shots, cm: the root mean square distance over all points of a shot."""

    of: tuple[float, ...]

    def quartiles(self) -> tuple[float, float, float]:
        """The lower quartile, the median, the upper quartile."""
        low, middle, high = np.percentile(self.of, (25.0, 50.0, 75.0)).tolist()
        return low, middle, high

    def __str__(self) -> str:
        low, middle, high = self.quartiles()
        return f"{middle:.3g} ({low:.3g}-{high:.3g})"


class TrackedFit:
    """A fit as far as it has come; what an interrupt leaves of it can be used.

    `before` are all launches with the knobs as they were, `knob_fit` what is being fitted to every other shot, `after`
    the launches of all shots with the knobs that were found, in order, and `uncertain` how sure these are.
    """

    def __init__(self, setting: Setting, shots: Sequence[Stretch], noise: float, source: str) -> None:
        if len(shots) < FEWEST:
            raise InputError(source, "", None, f"has {len(shots)} shots that can be fitted; needed are {FEWEST}")
        self.setting = setting
        self.shots = list(shots)
        self.noise = noise
        self.before: list[Fitted] = []
        self.after: list[Fitted] = []
        self.knob_fit: KnobFit | None = None
        self.uncertain: Floats | None = None
        self._source = source

    def run(self, crew: Crew) -> None:
        """All of it; raises InputError where the tracks cannot tell the knobs, naming them."""
        self.before = crew.each(launched, [(self.setting, shot, COARSE) for shot in self.shots])
        fit = KnobFit(self.setting, self.shots[::2], self.before[::2], self.noise, crew)
        # What no noise hides now, none will: to refuse later would waste a user's time.
        self._check(certainty.untold(fit.slopes(), self.noise))
        self.knob_fit = fit
        fit.run()
        slopes = fit.slopes()
        self._check(certainty.untold(slopes, fit.usual))
        self.uncertain = certainty.uncertainties(slopes, fit.fitted, fit.usual) * fit.widths
        self.after = self._judged(fit, crew)

    def _judged(self, fit: KnobFit, crew: Crew) -> list[Fitted]:
        """The launches of all shots with the knobs that were found."""
        back = KnobFit(fit.setting, self.shots[1::2], self.before[1::2], self.noise, crew)
        for seconds, _ in STAGES[:-1]:
            # As far as the knobs' own stages look, that none of the halves is judged more kindly.
            back.settle([shot.up_to(seconds) for shot in back.stretches])
        after = list(self.before)
        after[::2], after[1::2] = fit.fitted, back.fitted
        return after

    def _check(self, groups: list[list[int]]) -> None:
        """Raises InputError for groups of knobs that cannot be told, with what else could be fitted."""
        if not groups:
            return
        names = self.setting.names
        told = "; ".join(_refused([names[number] for number in group]) for group in groups)
        left = [name for number, name in enumerate(names) if number not in {group[0] for group in groups}]
        hint = f"; fit the others: --knobs {','.join(left)}" if left else ""
        raise InputError(self._source, "", None, f"the tracks cannot tell {told}{hint}")


def errors(fitted: Sequence[Fitted]) -> Errors:
    """The errors of launches that were fitted."""
    # Misses are along each of two axes.
    return Errors(tuple(100.0 * math.sqrt(2.0) * one.size for one in fitted))


def tasks(shots: int) -> int:
    """How often a crew fits a shot at most, for a bar."""
    half, back = (shots + 1) // 2, shots // 2
    return shots + half * (4 + sum(2 * rounds + 2 for _, rounds in STAGES)) + back * 2 * (len(STAGES) - 1)


def has_optimiser() -> bool:
    """Whether scipy is there, which an optional extra brings."""
    with suppress(ImportError):
        return bool(import_module("scipy"))
    return False


def check_knobs(names: Sequence[str], source: str, key: str) -> None:
    """Raises InputError for a name that is no knob which may be turned between two numbers, or is there twice."""
    turned = [name for name, knob in knobs().items() if type(knob.default) is float]
    for number, name in enumerate(names):
        if name not in turned:
            raise InputError(source, key, name, suggest(name, turned))
        if name in names[:number]:
            raise InputError(source, key, name, "is there twice")


def _refused(names: list[str]) -> str:
    return names[0] if len(names) == 1 else f"{' and '.join(names)} apart"
