"""One description of a parameter: it validates files, documents `--set` and builds sliders.

A group of knobs is a frozen dataclass whose fields are made by `knob` or `choice`; groups nest.
A knob's dotted name is its path through the groups: `cloth.mu_slide`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields, is_dataclass, replace
from typing import Any, TypeVar

from ..errors import InputError, suggest

_KNOB = "knob"
Group = TypeVar("Group")


@dataclass(frozen=True, slots=True)
class Knob:
    """A parameter's default, range (or choices), unit and one line of text.

    The default tells the kind: a number, true or false, one of the choices, or where there are none, a text of
    up to `hi` characters.
    """

    default: float | str
    lo: float
    hi: float
    unit: str
    doc: str
    choices: tuple[str, ...] = ()

    def allowed(self) -> str:
        """What a value may be, in words."""
        if self.choices:
            return "one of " + ", ".join(self.choices)
        if isinstance(self.default, bool):
            return "true or false"
        if isinstance(self.default, str):
            return f"a text of up to {self.hi:g} characters"
        unit = f" {self.unit}" if self.unit else ""
        return f"a number from {self.lo:g} to {self.hi:g}{unit}"

    def check(self, value: object, source: str, name: str) -> float | str:
        """The value, as the knob stores it.

        Raises InputError where it is of the wrong type or out of range.
        """
        if self.choices:
            if isinstance(value, str) and value in self.choices:
                return value
        elif isinstance(self.default, bool):
            if isinstance(value, bool):
                return value
        elif isinstance(self.default, str):
            if isinstance(value, str) and value.isprintable() and len(value) <= self.hi:
                return value
        elif isinstance(value, (int, float)) and not isinstance(value, bool):
            number = float(value) if abs(value) < 1e300 else math.inf
            if math.isfinite(number) and self.lo <= number <= self.hi:
                return number
        raise InputError(source, name, value, f"allowed is {self.allowed()}")


def knob(default: float, lo: float, hi: float, unit: str, doc: str) -> Any:
    """A number within a range, as a dataclass field."""
    return field(default=default, metadata={_KNOB: Knob(default, lo, hi, unit, doc)})


def choice(default: str, choices: tuple[str, ...], doc: str) -> Any:
    """A name out of a few, as a dataclass field."""
    return field(default=default, metadata={_KNOB: Knob(default, 0.0, 0.0, "", doc, choices)})


def flag(default: bool, doc: str) -> Any:
    """True or false, as a dataclass field."""
    return field(default=default, metadata={_KNOB: Knob(default, 0.0, 1.0, "", doc)})


def text(default: str, longest: int, doc: str) -> Any:
    """A line of text, as a dataclass field."""
    return field(default=default, metadata={_KNOB: Knob(default, 0.0, longest, "", doc)})


def walk(group: object, prefix: str = "") -> Iterator[tuple[str, Knob, float | str]]:
    """Every knob below `group` as (dotted name, description, present value)."""
    assert is_dataclass(group)
    for entry in fields(group):
        value = getattr(group, entry.name)
        if _KNOB in entry.metadata:
            yield prefix + entry.name, entry.metadata[_KNOB], value
        else:
            yield from walk(value, prefix + entry.name + ".")


def apply(group: Group, values: Mapping[str, object], source: str) -> Group:
    """A copy of `group` with dotted names set.

    Raises InputError naming `source`, the key and what is allowed.
    """
    known = {name: (knob_, present) for name, knob_, present in walk(group)}
    for name, value in values.items():
        if name not in known:
            raise InputError(source, name, value, suggest(name, known))
        group = _set(group, name, known[name][0].check(value, source, name))
    return group


def _set(group: Group, name: str, value: float | str) -> Group:
    head, _, rest = name.partition(".")
    new = _set(getattr(group, head), rest, value) if rest else value
    return replace(group, **{head: new})  # type: ignore[type-var]
