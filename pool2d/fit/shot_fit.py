"""The launch of one shot that fits its tracks best, for given knobs; and how its misses then change with the knobs."""

from __future__ import annotations

import pickle
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Final

import numpy as np

from ..config.knobs import Knob, walk
from ..table.table import Table
from ..table.table_knobs import Knobs
from . import launch
from .miss import Stretch, launch_slopes, misses
from .tracks import Floats

# Tries of a step: while the best guess is sought, and for a launch that is near.
_FEW, _SOME, _MANY = 8, 15, 40
# Of the guesses so many are followed beyond the first meeting of balls.
_BEST = 4
# A miss that is so many times the usual counts by its size alone, no longer by its square.
CLIP: Final = 3.0
# While nothing is known of a shot, misses up to this count by their squares, m.
COARSE: Final = 0.03
# How far into a shot it is looked at, one after the other, s: what comes late depends most on what came before.
HORIZONS: Final = (2.0, 3.5, 6.0)
# How far beyond the first meeting of balls a guess is held to the tracks, s.
_BEYOND = 0.15
# How far a launch is thought to be turned as knobs are, in parts of its scales.
_FREE = 3.0
# By what part of its width a knob is turned for a derivative.
_STEP = 1e-5


@dataclass(frozen=True, slots=True)
class Setting:
    """A table, pickled, and knobs that are turned on it, in their order."""

    kit: bytes
    names: tuple[str, ...] = ()
    values: tuple[float, ...] = ()

    def turned(self, values: Floats) -> Setting:
        """The same with other values of its knobs."""
        return replace(self, values=tuple(values.tolist()))


@dataclass(frozen=True, slots=True)
class Fitted:
    """A launch that was fitted: its numbers, its misses, m, and what they cost."""

    numbers: Floats
    misses: Floats
    cost: float

    @property
    def size(self) -> float:
        """The root mean square of the misses, m, along each axis."""
        return rms(self.misses)


@lru_cache(maxsize=64)
def table_of(setting: Setting) -> Table:
    """The table of a setting."""
    table: Table = pickle.loads(setting.kit)
    return table.with_knobs(dict(zip(setting.names, setting.values, strict=True)))


def setting_of(table: Table, values: Mapping[str, float]) -> Setting:
    """A table whose knobs of these names are to be turned, at these values."""
    return Setting(pickle.dumps(table), tuple(values), tuple(values.values()))


def clipped_cost(missed: Floats, clip: float) -> float:
    """What misses cost: half their squares, m2, but for those beyond `clip` m, which count by their size alone."""
    return float(np.sum(clip**2 * (np.hypot(1.0, missed / clip) - 1.0)))


def rms(missed: Floats) -> float:
    """The root of the mean square."""
    return float(np.sqrt(np.mean(missed**2)))


def weights(missed: Floats, clip: float) -> Floats:
    """What part of its square each miss counts by."""
    return 1.0 / np.hypot(1.0, missed / clip)


def refine(setting: Setting, stretch: Stretch, numbers: Floats, clip: float, tries: int = _MANY) -> Fitted:
    """The launch nearest to `numbers` whose clipped misses are least."""
    from scipy.optimize import least_squares

    table, scale = table_of(setting), launch.scales(stretch.seen)
    found = least_squares(
        lambda x: misses(table, stretch, numbers + scale * x),
        np.zeros(len(numbers)),
        lambda x: launch_slopes(table, stretch, numbers + scale * x) * scale,
        loss="soft_l1", f_scale=clip, max_nfev=tries, ftol=1e-9, xtol=1e-9, gtol=None,
    )  # fmt: skip
    return Fitted(numbers + scale * found.x, found.fun, float(found.cost))


def approached(setting: Setting, stretch: Stretch, numbers: Floats, clip: float) -> Fitted:
    """As `refine`, from numbers that may be far off: at first with a clip that leaves most misses alone."""
    usual = CLIP * rms(misses(table_of(setting), stretch, numbers))
    begun = refine(setting, stretch, numbers, max(COARSE, usual)).numbers if usual > 2.0 * clip else numbers
    return refine(setting, stretch, begun, clip)


def launched(setting: Setting, stretch: Stretch, clip: float) -> Fitted:
    """A launch for tracks of which nothing is known yet.

    Guesses are held to the tracks up to where balls first meet, the best of them a little further, and the best of
    those further and further to the stretch's end: so no launch is led astray by what only comes of it late. Raises
    InputError where the balls cannot stand where they were seen.
    """
    seen, table = stretch.seen, table_of(setting)
    first, second = stretch.up_to(min(seen.meeting(1) + _BEYOND - seen.moment, HORIZONS[0])), stretch.up_to(HORIZONS[0])
    found = [refine(setting, first, guess, clip, _FEW) for guess in launch.guesses(table, seen, stretch.elevation)]
    found.sort(key=lambda one: clipped_cost(misses(table, second, one.numbers), clip))
    found = [refine(setting, second, one.numbers, clip, _SOME) for one in found[:_BEST]]
    best = min(found, key=lambda one: one.cost)
    for seconds in HORIZONS[1:]:
        if stretch.up_to(seconds).end < stretch.end:
            best = refine(setting, stretch.up_to(seconds), best.numbers, clip, _SOME)
    return refine(setting, stretch, best.numbers, clip)


@dataclass(frozen=True, slots=True)
class Slopes:
    """What changes with knobs, in their widths, where the launch is fitted again: the misses, m, and the launch."""

    misses: Floats
    numbers: Floats


def knob_slopes(setting: Setting, stretch: Stretch, numbers: Floats, widths: Floats, clip: float) -> Slopes:
    """How the misses of a fitted launch, and its numbers, change with each knob (variable projection; Kaufman 1975)."""
    a = launch_slopes(table_of(setting), stretch, numbers) * launch.scales(stretch.seen)
    b = np.column_stack([_knob_slope(setting, stretch, numbers, i, width) for i, width in enumerate(widths.tolist())])
    root = np.sqrt(weights(misses(table_of(setting), stretch, numbers), clip))[:, None]
    # What a launch may be turned by is bounded: the tracks of a shot may leave some of it open.
    held = np.vstack([root * a, clip / CLIP / _FREE * np.eye(a.shape[1])])
    follows = np.linalg.lstsq(held, np.vstack([root * b, np.zeros((a.shape[1], b.shape[1]))]), rcond=None)[0]
    return Slopes(b - a @ follows, -launch.scales(stretch.seen)[:, None] * follows)


def _knob_slope(setting: Setting, stretch: Stretch, numbers: Floats, number: int, width: float) -> Floats:
    """How misses change with one knob, in its width, the launch being as it is."""
    values = np.array(setting.values)
    step = _STEP * width * (1.0 if values[number] + _STEP * width <= knobs()[setting.names[number]].hi else -1.0)
    values[number] += step
    turned = misses(table_of(setting.turned(values)), stretch, numbers)
    return (turned - misses(table_of(setting), stretch, numbers)) / (step / width)


def width_of(name: str, value: float) -> float:
    """How far a knob may well be from a value: a quarter of it, or for a small one a part of what is allowed."""
    knob = knobs()[name]
    return max(0.25 * abs(value), 0.02 * (knob.hi - knob.lo))


@lru_cache(maxsize=1)
def knobs() -> dict[str, Knob]:
    """What each knob allows, by its name."""
    return {name: knob for name, knob, _ in walk(Knobs())}
