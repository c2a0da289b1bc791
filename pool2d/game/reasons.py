"""Why a stroke was played: what was meant, what else was looked at, and what was feared, as a value that JSON holds.

Whoever thinks of strokes makes one and plays it with the stroke (`Stroke.why`); nothing is judged by it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from typing import Any, Final, Literal, NamedTuple, TypeAlias, get_args

from ..config.fields import check_keys, value_of
from ..errors import InputError, suggest
from ..physics.values import Shot
from ..table.position_text import read_shot, write_shot
from .rules.notes import ENGLISH, Note, note_of, written

# What a stroke is meant to be. "hope" is one of which nothing is expected.
StrokeKind: TypeAlias = Literal[
    "pot", "combination", "carom", "bank", "kick", "cannon", "safety", "break", "push", "hope"
]  # fmt: skip
# What is held to be between never and always.
_SHARES: Final = ("chance", "fouls", "lost")


@dataclass(frozen=True, slots=True)
class Thought:
    """A stroke that a player thought of, as it was meant.

    Attributes:
        kind: What it was meant to be.
        shot: The stroke itself; what the hand made of one that was played may differ.
        ball: The ball that it meant, "" for none.
        pocket: The pocket for that ball, "" for none.
        chance: How likely it was held to come off, from 0 to 1.
        value: What it was held to be worth: a chance to win, or points ahead in a game that is scored.
        runs: How often it was played in mind.
        fouls: The share of those that were fouls.
        lost: The share of those that brought the other player to the table.
        place: Where a cue ball in hand was to be put, m; None where it lay already.
    """

    kind: StrokeKind
    shot: Shot
    ball: str = ""
    pocket: str = ""
    chance: float = 0.0
    value: float = 0.0
    runs: int = 0
    fouls: float = 0.0
    lost: float = 0.0
    place: tuple[float, float] | None = None

    def as_dict(self) -> dict[str, Any]:
        """The thought in JSON's types, without what it leaves out."""
        said = {**asdict(self), "shot": write_shot(self.shot), "place": list(self.place or ())}
        return {name: value for name, value in said.items() if value}


class Fear(NamedTuple):
    """What went wrong when a stroke was played in mind, and in what share of all the times."""

    note: Note
    share: float

    def as_dict(self) -> dict[str, Any]:
        """The fear in JSON's types."""
        return {**written(self.note), "share": self.share}


@dataclass(frozen=True, slots=True)
class Reasons:
    """Why a stroke was played: what was `meant`, the next best of the `others`, and the `fears`, the worst first."""

    meant: Thought
    others: tuple[Thought, ...] = ()
    fears: tuple[Fear, ...] = ()

    def as_dict(self) -> dict[str, Any]:
        """The reasons in JSON's types; `reasons_of` reads them."""
        more = {"others": [one.as_dict() for one in self.others], "fears": [one.as_dict() for one in self.fears]}
        return {**self.meant.as_dict(), **{name: some for name, some in more.items() if some}}


def reasons_of(data: Mapping[str, Any], source: str, key: str = "why") -> Reasons:
    """The reasons that `Reasons.as_dict` made it of; raises InputError naming what is wrong below `key`."""
    others = _each(data, "others", source, key)
    fears = _each(data, "fears", source, key)
    own = {name: value for name, value in data.items() if name not in ("others", "fears")}
    feared = [_fear(one, source, f"{key}.fears") for one in fears]
    return Reasons(
        _thought(own, source, key),
        tuple(_thought(one, source, f"{key}.others") for one in others),
        # What a later version fears may have no words here.
        tuple(fear for fear in feared if fear.note.key in ENGLISH),
    )


def _each(data: Mapping[str, Any], name: str, source: str, key: str) -> list[dict[str, Any]]:
    some: list[Any] = value_of(data, name, list, source, [], f"{key}.")
    for one in some:
        if not isinstance(one, dict):
            raise InputError(source, f"{key}.{name}", one, "allowed is a dict")
    return some


def _thought(data: Mapping[str, Any], source: str, key: str) -> Thought:
    check_keys(data, [entry.name for entry in fields(Thought)], source, f"{key}.")
    plain = asdict(Thought("pot", Shot()))
    read = {name: value_of(data, name, type(plain[name]), source, plain[name], f"{key}.") for name in _PLAIN}
    for name in _SHARES:
        _check_share(read[name], source, f"{key}.{name}")
    return Thought(_kind(data, source, key), _shot(data, source, key), place=_place(data, source, key), **read)


# The attributes that stand in JSON as they are.
_PLAIN: Final = ("ball", "pocket", "chance", "value", "runs", "fouls", "lost")


def _kind(data: Mapping[str, Any], source: str, key: str) -> StrokeKind:
    kind: StrokeKind = value_of(data, "kind", str, source, prefix=f"{key}.")
    if kind not in get_args(StrokeKind):
        raise InputError(source, f"{key}.kind", kind, suggest(kind, get_args(StrokeKind)))
    return kind


def _shot(data: Mapping[str, Any], source: str, key: str) -> Shot:
    text = value_of(data, "shot", str, source, prefix=f"{key}.")
    try:
        return read_shot(text, source)
    except InputError as error:
        raise InputError(source, f"{key}.shot", text, error.allowed) from None


def _place(data: Mapping[str, Any], source: str, key: str) -> tuple[float, float] | None:
    place = value_of(data, "place", list, source, [], f"{key}.")
    if not place:
        return None
    if len(place) != 2 or not all(type(value) is float and math.isfinite(value) for value in place):
        raise InputError(source, f"{key}.place", place, "allowed are x and y, in m")
    return place[0], place[1]


def _fear(data: dict[str, Any], source: str, key: str) -> Fear:
    share = value_of(data, "share", float, source, prefix=f"{key}.")
    _check_share(share, source, f"{key}.share")
    return Fear(note_of({name: value for name, value in data.items() if name != "share"}, source, key), share)


def _check_share(value: float, source: str, key: str) -> None:
    if not 0.0 <= value <= 1.0:
        raise InputError(source, key, value, "allowed is a number from 0 to 1")
