"""Knobs from measurements made by hand: those with which the engine shows what was measured, and how sure they are."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..config.knobs import Knob, walk
from ..errors import InputError
from ..table.table import Table
from .measurements import MEASUREMENTS, QUANTITIES, Measurement, bare
from .readings import Reading

Vector = NDArray[np.float64]

# What is not measured is as the table's preset has it, give or take this: what measured tables differ by
# (sliding friction 0.15 to 0.4; pool cloth 0.005 to 0.015, heated 0.0044 to 0.0053; cushions 0.85 to 0.98 and 0.14 to
# 0.22; rubber that springs back along the rail by 0.13 to 0.17, or not at all; a nose's height by the rules to 1 %).
# So it counts in what is found.
_UNMEASURED = {
    "cloth.mu_slide": 0.04,
    "cloth.mu_roll": 0.002,
    "cushion.restitution": 0.04,
    "cushion.friction": 0.04,
    "cushion.tangential": 0.1,
    "cushion.nose_height": 0.0004,
}
# What the search begins with, where the table has more: with much friction at the nose the ball stops slipping there,
# and more of it changes little.
_FIRST = {"cushion.friction": 0.15}
# The search: its most steps, how near is near enough (in standard errors), how far one step may go and how far a
# nudge that tells a slope, and with what damping it gives up.
_STEPS, _NEAR, _STRIDE, _NUDGE, _DAMPED = 40, 1e-3, 0.4, 1e-4, 1e9
# A measurement that is missed by more standard errors than this cannot be had, or contradicts another.
_MISSED = 2.0
# In place of what a ball never does.
_FAR = 1e3
# How many values of a knob are tried to say what it can give.
_TRIED = 24


@dataclass(frozen=True, slots=True)
class HandFit:
    """One knob that was found.

    Attributes:
        knob: Its dotted name.
        was: What the table had.
        now: What was measured, to the second digit of its error.
        error: The standard error of that.
        by: The names of the measurements that tell it.
    """

    knob: str
    was: float
    now: float
    error: float
    by: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class HandFits:
    """All that was found.

    Attributes:
        knobs: The knobs, in the order of the measurements.
        strain: How much further than their errors allow measurements of the same knob are from each other: 1 where
            they agree; the error of that knob is larger by it.
    """

    knobs: tuple[HandFit, ...]
    strain: float

    @property
    def values(self) -> dict[str, float]:
        """The knobs by name."""
        return {each.knob: each.now for each in self.knobs}


def places(error: float) -> int:
    """How many decimals a value has a meaning to: to the second digit of its error."""
    return max(0, 1 - math.floor(math.log10(error)))


def fit_by_hand(table: Table, readings: Mapping[str, Reading], source: str) -> HandFits:
    """The knobs of a table with which the engine shows what was measured there.

    `readings` are by the quantities' names, such as "lag.seconds"; of the five measurements any may be missing. Knobs
    that none of them tells stay as they are, and what they may be off by counts in the errors. Raises InputError,
    naming `source`, the quantity, its value and what is possible, where no value of the knobs gives it.
    """
    search = _Search(table, _made(readings, source), readings)
    at = search.run()
    search.check(at, source)
    return search.found(at)


def _made(readings: Mapping[str, Reading], source: str) -> list[Measurement]:
    """The measurements that were made; raises InputError where one lacks a part, or there is none."""
    made = [each for each in MEASUREMENTS if any(part.name in readings for part in each.quantities)]
    for each in made:
        _check_whole(each, readings, source)
    if not made:
        raise InputError(source, "", None, "nothing was measured; any of " + ", ".join(QUANTITIES) + " would do")
    return made


def _check_whole(each: Measurement, readings: Mapping[str, Reading], source: str) -> None:
    given = next(part.name for part in each.quantities if part.name in readings)
    for part in each.quantities:
        if part.name not in readings and not part.assumed:
            raise InputError(source, part.name, None, f"missing; {given} tells nothing without it")


class _Search:
    """Least squares over the knobs, with all that the measurements and the other knobs may be off by.

    The knobs are searched on scales of their own: where a range spans several powers of ten, by their logarithms.
    """

    def __init__(self, table: Table, made: list[Measurement], readings: Mapping[str, Reading]) -> None:
        self.made = made
        self._table = bare(table)
        self._knobs = {
            name: (knob, float(value)) for name, knob, value in walk(table.knobs) if isinstance(value, float)
        }
        self.scales = {each.turns: _Scale(self._knobs[each.turns][0]) for each in made}
        self.ends = np.array([scale.ends for scale in self.scales.values()]).T
        self._terms = {part.name: readings.get(part.name, part.usual) for each in made for part in each.terms}
        self._seen = [readings[each.seen.name] for each in made]
        # Errors as they are known where the search begins serve to weigh the measurements against each other.
        self._whiten = self._weights(self._begin())

    def was(self, name: str) -> float:
        """A knob as the table has it."""
        return self._knobs[name][1]

    def knobs(self, at: Vector) -> dict[str, float]:
        """The knobs at a place of the search."""
        return {name: scale.value(part) for (name, scale), part in zip(self.scales.items(), at, strict=True)}

    # What is missed.

    def shown(self, at: Vector, others: Mapping[str, float] | None = None) -> Vector:
        """What the engine shows of each measurement, with other knobs beside those that are searched."""
        table = self._table.with_knobs({**self.knobs(at), **(others or {})})
        return np.array([self._play(each, table, {}) for each in self.made])

    def _play(self, each: Measurement, table: Table, others: Mapping[str, float]) -> float:
        """What the engine shows of one, with its terms as they were read, or others."""
        terms = {part.name: self._terms[part.name].value for part in each.terms}
        # What cannot be shown is far from anything measured, and not so far that no step leads back.
        return min(each.play(table, {**terms, **others}), _FAR)

    def missed(self, at: Vector) -> Vector:
        """What each measurement is missed by, in standard errors that are independent of each other."""
        seen = np.array([reading.value for reading in self._seen])
        return np.asarray(self._whiten @ (self.shown(at) - seen))

    def slopes(self, at: Vector, missed: Vector) -> Vector:
        """How `missed` changes with each knob."""
        steps = np.diag(np.where(at + _NUDGE < self.ends[1], _NUDGE, -_NUDGE))
        return np.array([(self.missed(at + step) - missed) / step.sum() for step in steps]).T

    # How far it may be.

    def _weights(self, at: Vector) -> Vector:
        """What makes the measurements' errors independent, and of size 1."""
        return np.asarray(np.linalg.inv(np.linalg.cholesky(self._covariance(at))))

    def _covariance(self, at: Vector) -> Vector:
        """What the measurements may be off by together."""
        here = self.shown(at)
        own = [reading.error**2 for reading in self._seen]
        shared = [np.outer(off, off) for off in self._by_others(at, here)]
        return np.asarray(np.diag(own) + np.diag(self._by_terms(at, here)) + sum(shared))

    def _by_terms(self, at: Vector, here: Vector) -> list[float]:
        """The variances that the errors of their terms give the measurements."""
        table = self._table.with_knobs(self.knobs(at))
        return [self._by_terms_of(each, table, one) for each, one in zip(self.made, here, strict=True)]

    def _by_terms_of(self, each: Measurement, table: Table, here: float) -> float:
        terms = {part.name: self._terms[part.name] for part in each.terms}
        others = [self._play(each, table, {name: term.value + term.error}) for name, term in terms.items()]
        return math.fsum((other - here) ** 2 for other in others)

    def _by_others(self, at: Vector, here: Vector) -> list[Vector]:
        """What each knob that is not measured may put the measurements off by."""
        others = [name for name in _UNMEASURED if name not in self.scales]
        return [self.shown(at, {name: self._other(name)}) - here for name in others]

    def _other(self, name: str) -> float:
        """What a knob that is not measured may be as well as what it is."""
        knob, value = self._knobs[name]
        return value - _UNMEASURED[name] if value - _UNMEASURED[name] >= knob.lo else value + _UNMEASURED[name]

    # The search.

    def _begin(self) -> Vector:
        """Where it begins: with the table as it is, and not too rough a nose."""
        first = {name: min(self.was(name), _FIRST.get(name, math.inf)) for name in self.scales}
        return np.array([self.scales[name].place(value) for name, value in first.items()])

    def run(self) -> Vector:
        """Where the squares of what the measurements are missed by are least (Levenberg and Marquardt)."""
        at, damping = self._begin(), 1e-3
        missed = self.missed(at)
        for _ in range(_STEPS):
            slopes = self.slopes(at, missed)
            there, after, damping = self._better(at, missed, slopes, damping)
            moved = slopes @ (there - at)
            at, missed = there, after
            if moved @ moved < _NEAR * _NEAR:
                break
        return at

    def _better(self, at: Vector, missed: Vector, slopes: Vector, damping: float) -> tuple[Vector, Vector, float]:
        """A better place, what is missed there and the next damping; the same place where none is found."""
        normal = slopes.T @ slopes
        while damping < _DAMPED:
            # Where nothing shown depends on a knob, there is no step to solve for: least squares leave it as it is.
            step = np.linalg.lstsq(normal + damping * np.diag(np.diag(normal) + 1e-9), -slopes.T @ missed)[0]
            there = np.clip(at + np.clip(step, -_STRIDE, _STRIDE), *self.ends)
            after = self.missed(there)
            if after @ after < missed @ missed:
                return there, after, damping * 0.1
            damping *= 10.0
        return at, missed, damping

    def check(self, at: Vector, source: str) -> None:
        """Raises InputError for a measurement that no value of its knob gives."""
        for i, (each, reading, shown) in enumerate(zip(self.made, self._seen, self.shown(at), strict=True)):
            if abs(shown - reading.value) > _MISSED * reading.error:
                least, most = self._possible(at, i)
                if not least <= reading.value <= most:
                    raise InputError(source, each.seen.name, reading.value, self._told(each, least, most))

    def _possible(self, at: Vector, which: int) -> tuple[float, float]:
        """The least and the most that a measurement can be, by the knob that it tells."""
        each = self.made[which]
        scale, here = self.scales[each.turns], self.knobs(at)
        values = [here[each.turns], *map(scale.value, np.linspace(*scale.ends, _TRIED))]
        tables = (self._table.with_knobs({**here, each.turns: value}) for value in values)
        tried = [self._play(each, table, {}) for table in tables]
        shown = [one for one in tried if one < _FAR]
        return min(shown, default=_FAR), max(shown, default=_FAR)

    def _told(self, each: Measurement, least: float, most: float) -> str:
        """What is possible, in words."""
        knob = self._knobs[each.turns][0]
        if least == _FAR:
            return f"no ball gets so far on this table, whatever {each.turns} is"
        allowed = f"allowed is {least:.3g} to {most:.3g} {each.seen.knob.unit}".rstrip()
        return f"{allowed}, which is what {each.turns} from {knob.lo:g} to {knob.hi:g} gives on this table"

    def found(self, at: Vector) -> HandFits:
        """The knobs and their errors at the end of the search."""
        self._whiten = self._weights(at)
        missed = self.missed(at)
        strain, errors = self._strain(missed), self._errors(at, missed)
        parts = zip(self.scales, at, errors, strict=True)
        return HandFits(tuple(self._fit(name, part, error, strain) for name, part, error in parts), strain)

    def _errors(self, at: Vector, missed: Vector) -> Vector:
        """The standard errors along the scales; all of a knob's range is as likely where nothing tells it."""
        slopes = self.slopes(at, missed)
        range_ = np.diag(12.0 / (self.ends[1] - self.ends[0]) ** 2)
        return np.asarray(np.sqrt(np.diag(np.linalg.inv(slopes.T @ slopes + range_))))

    def _strain(self, missed: Vector) -> float:
        """How much further the measurements are off than their errors say, where there are more than knobs."""
        spare = len(missed) - len(self.scales)
        return max(1.0, math.sqrt(float(missed @ missed) / spare)) if spare else 1.0

    def _fit(self, name: str, part: float, error: float, strain: float) -> HandFit:
        scale, by = self.scales[name], tuple(each.name for each in self.made if each.turns == name)
        off = scale.error(part, error * strain if len(by) > 1 else error)
        return HandFit(name, self.was(name), scale.within(round(scale.value(part), places(off))), off, by)


class _Scale:
    """Where a knob's values lie on a line: by their logarithms where its range spans several powers of ten."""

    def __init__(self, knob: Knob) -> None:
        self._log = knob.lo > 0.0 and knob.hi / knob.lo >= 50.0
        self.ends = self.place(knob.lo), self.place(knob.hi)
        self._range = knob.lo, knob.hi

    def place(self, value: float) -> float:
        return math.log(value) if self._log else value

    def value(self, place: float) -> float:
        return self.within(math.exp(place) if self._log else float(place))

    def within(self, value: float) -> float:
        """The value, or the nearest that the knob may have."""
        return min(max(value, self._range[0]), self._range[1])

    def error(self, place: float, error: float) -> float:
        """An error along the line as one of the knob."""
        return float(error * self.value(place) if self._log else error)
