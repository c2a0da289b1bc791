"""What a study looks at in each shot: an outcome, told as a number."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from ..errors import InputError, suggest

Row = Mapping[str, str]
# What is asked of a shot as a whole, by the words for its mean.
_WHOLE = {
    "potted": "balls potted",
    "off": "balls that leave the table",
    "scratch": "share of shots in which the struck ball falls",
    "miscue": "share of shots in which the tip slips",
    "duration": "duration, s",
    "events": "events",
}
# What is asked of one ball.
_OF_BALL = {
    "potted": "share of shots in which ball {} falls",
    "off": "share of shots in which ball {} leaves the table",
    "first": "share of shots in which ball {} is met first",
    "cushions": "cushions that ball {} comes to",
}


@dataclass(frozen=True, slots=True)
class Outcome:
    """A number that each row of a study's results has: the columns that it needs, and what its mean is, in words."""

    name: str
    title: str
    columns: tuple[str, ...]
    value: Callable[[Row], float]


def outcome_of(name: str, balls: Sequence[str], source: str, key: str) -> Outcome:
    """The outcome of a name: "potted", "scratch" and so on, or "potted.8", "first.8", "off.8", "cushions.cue".

    Raises InputError for one that is not known, or whose ball is not there.
    """
    whole, point, ball = name.partition(".")
    known = [*_WHOLE, *(f"{each}.{ball}" for each in _OF_BALL for ball in balls)]
    if name not in known:
        raise InputError(source, key, name, suggest(name, known))
    if not point:
        return Outcome(name, _WHOLE[name], (name,), lambda row: float(row[name]))
    title = _OF_BALL[whole].format(ball)
    if whole == "first":
        return Outcome(name, title, ("first",), lambda row: float(row["first"] == ball))
    if whole == "potted":
        column = f"{ball}.pocket"
        return Outcome(name, title, (column,), lambda row: float(row[column] != ""))
    column = f"{ball}.{whole}"
    return Outcome(name, title, (column,), lambda row: float(row[column]))
