"""The ways pool2d says no: the input is wrong, a shot does not end, or shots played elsewhere do not come back."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches
from typing import Any

from .printable import printable

# No name is longer, and of more names than this one is told that there are many.
_LONG_WORD = 60
_MANY = 500
# A path may have thousands of characters.
_LONGEST = 8000


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
        super().__init__(printable(said if key else f"{where}: {allowed}", _LONGEST))

    def __reduce__(self) -> tuple[type[InputError], tuple[object, ...]]:
        # An error that comes from another process is made again of what it tells.
        return type(self), (self.source, self.key, self.value, self.allowed, self.line)

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

    def __reduce__(self) -> tuple[type[BudgetError], tuple[object, ...]]:
        return type(self), (self.budget, self.time, self.scenario)


class WorkerError(RuntimeError):
    """Shots were handed to others to play, and did not come back: a process has died, or a cluster cannot be reached.

    `done` is how many of the first shots had come back by then.
    """

    def __init__(self, done: int, reason: str) -> None:
        self.done = done
        self.reason = reason
        super().__init__(f"the shots after the first {done} did not come back from their worker: {reason}")

    def __reduce__(self) -> tuple[type[WorkerError], tuple[object, ...]]:
        return type(self), (self.done, self.reason)


def suggest(word: str, known: Iterable[str]) -> str:
    """What is allowed instead of an unknown `word`: the nearest known one, or all of them."""
    options = sorted(known)
    # Comparing takes time that grows with all of them, and nobody reads so many.
    near = get_close_matches(word[:_LONG_WORD], options[:_MANY], n=1, cutoff=0.6)
    if near:
        return f"unknown; did you mean {_clipped(near[0], _LONG_WORD)}?"
    return "unknown; known are " + _clipped(", ".join(options[:_MANY]), 1000)


def _repr(value: object) -> str:
    try:
        return repr(value)
    except RecursionError:
        return "(nested too deep)"
    except ValueError:
        # Python writes no whole number of more digits.
        return "(a number of more than 4300 digits)"


def _clipped(text: str, most: int) -> str:
    return text if len(text) <= most else text[: most - 3] + "..."
