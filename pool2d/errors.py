"""The two ways pool2d says no: the input is wrong, or a shot does not end."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches
from typing import Any


class InputError(ValueError):
    """Bad input, told in one line: where it stands, which key, what value, what is allowed.

    Attributes: `source` (a file, or whatever names the input), `key`, `value`, `allowed`, and `line`, 0
    where it is not known. Without a key the complaint is about the source as a whole.
    """

    def __init__(self, source: str, key: str, value: object, allowed: str, line: int = 0) -> None:
        self.source = source
        self.key = key
        self.value = value
        self.allowed = allowed
        self.line = line
        where = f"{source}, line {line}" if line else source
        said = f"{where}: {_clipped(key, 100)} = {_clipped(_repr(value), 60)}: {allowed}"
        super().__init__(_line(said if key else f"{where}: {allowed}"))

    def at(self, source: str) -> InputError:
        """The same complaint, said of another source."""
        return type(self)(source, self.key, self.value, self.allowed)


class BudgetError(RuntimeError):
    """A shot took more events than the engine's budget allows.

    `scenario` is the input that reproduces it, in the form of a scenario file.
    """

    def __init__(self, budget: int, time: float, scenario: dict[str, Any]) -> None:
        self.budget = budget
        self.time = time
        self.scenario = scenario
        super().__init__(f"the shot is not over after {budget} events, at t = {time:.6f} s")


def suggest(word: str, known: Iterable[str]) -> str:
    """What is allowed instead of an unknown `word`: the nearest known one, or all of them."""
    options = sorted(known)
    near = get_close_matches(word, options, n=1, cutoff=0.6)
    if near:
        return f"unknown; did you mean {near[0]}?"
    return "unknown; known are " + ", ".join(options)


def _line(text: str) -> str:
    """Text that stays on its line and can be written anywhere, whatever a file holds."""
    return "".join(char if char.isprintable() else repr(char)[1:-1] for char in text)


def _repr(value: object) -> str:
    try:
        return repr(value)
    except RecursionError:
        return "(nested too deep)"


def _clipped(text: str, most: int) -> str:
    return text if len(text) <= most else text[: most - 3] + "..."
