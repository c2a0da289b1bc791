"""What people have read off: numbers, one or several of the same, and how far each may be off."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from ..config.knobs import Knob
from ..errors import InputError

# More readings than anybody takes of one thing.
_MOST = 100
_FORM = "numbers such as 8.4 8.6 8.5, which are averaged, and what each may be off by, as +-0.2"
_ERROR = re.compile(r"\+/?-|\N{PLUS-MINUS SIGN}")


@dataclass(frozen=True, slots=True)
class Quantity:
    """Something that can be read off at a table.

    Attributes:
        name: Its key, such as "lag.seconds".
        knob: What it may be: range, unit, text; and for what is seldom measured, what it is then taken to be.
        error: How far a reading is off, as a standard deviation, where nobody says otherwise.
        assumed: Whether the default stands in for a reading that nobody has made.
        asked: Whether people are asked for it; what seldom differs is for files.
    """

    name: str
    knob: Knob
    error: float
    assumed: bool = False
    asked: bool = True

    @property
    def usual(self) -> Reading:
        """What stands in for a reading."""
        return Reading(float(self.knob.default), self.error)


@dataclass(frozen=True, slots=True)
class Reading:
    """The mean of what was read off, and its standard error."""

    value: float
    error: float


def average(values: Sequence[float], error: float) -> Reading:
    """The mean of readings of which each is said to be off by `error`, a standard deviation.

    What is said counts as much as one more reading would: the variance of one is
    (error^2 + sum of the squared differences from the mean) / n, so that two that happen to agree are not taken for
    exact, and many speak for themselves.
    """
    count = len(values)
    mean = math.fsum(values) / count
    spread = math.fsum((value - mean) ** 2 for value in values)
    return Reading(mean, math.sqrt((error * error + spread) / count / count))


def read(given: Any, quantity: Quantity, source: str) -> Reading:
    """A reading from a file, a field or an answer: a number, several, or a text such as "8.4 8.6 +-0.2".

    Raises InputError, naming the quantity and what is allowed.
    """
    name = quantity.name
    if isinstance(given, str):
        values, error = _parsed(given, quantity, source)
    else:
        values, error = given if isinstance(given, list) else [given], quantity.error
    if not 0 < len(values) <= _MOST:
        raise InputError(source, name, given, f"allowed are up to {_MOST} {_FORM}")
    return average([float(quantity.knob.check(value, source, name)) for value in values], error)


def _parsed(text: str, quantity: Quantity, source: str) -> tuple[list[float], float]:
    """The numbers of a text, and the error of each."""
    values, *errors = _ERROR.split(text)
    numbers = [_numbers(part, text, quantity, source) for part in (values, *errors)]
    if not errors:
        return numbers[0], quantity.error
    if len(errors) > 1 or len(numbers[1]) != 1 or not 0.0 < numbers[1][0] < math.inf:
        raise InputError(source, quantity.name, text, f"allowed are {_FORM}")
    return numbers[0], numbers[1][0]


def _numbers(part: str, text: str, quantity: Quantity, source: str) -> list[float]:
    """The numbers between blanks, with a point or, as some languages have it, a comma."""
    try:
        return [float(word.rstrip(",;").replace(",", ".")) for word in part.split()]
    except ValueError:
        raise InputError(source, quantity.name, text, f"allowed are {_FORM}") from None
