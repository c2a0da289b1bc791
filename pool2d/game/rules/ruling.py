"""What is asked of the players, where a game stands, and what follows from a shot: values that never change.

What a game may ask, and what may be said, are words of their own types, so that none is misspelt.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, asdict, dataclass, field, fields
from typing import Any, Final, Literal, NamedTuple, TypeAlias, TypedDict

from ...errors import InputError, suggest
from ...physics.values import Layout
from .notes import Note
from .spotting import Spotted, Where

# What is called otherwise in JSON than here.
WRITTEN = {"player": "who"}
AskKind: TypeAlias = Literal["aim", "place", "choose", "over"]
AIM: Final = "aim"
PLACE: Final = "place"
CHOOSE: Final = "choose"
OVER: Final = "over"
CallKind: TypeAlias = Literal["", "ball", "pocket"]
Declared: TypeAlias = Literal["safety", "push"]


@dataclass(frozen=True, slots=True)
class Ask:
    """What is to happen next, and who is to do it.

    Attributes:
        kind: "aim", to shoot; "place", to put the cue ball on the table first; "choose", to pick one of `options`;
            "over", the game has ended.
        player: Who is to do it, counted from 0; where the game has ended who has won, -1 for nobody.
        ball: The cue ball to be struck.
        where: The area of a cue ball in hand, "" where it is not in hand: while one aims, a cue ball in hand may still
            be moved within it.
        on: The balls that may be hit first.
        call: What must be said before the shot: "" nothing, "ball", or "pocket" for a ball and a pocket, which the
            obvious shot needs not.
        may: What else may be said: "safety", "push".
        options: The keys to choose from; a player who is to aim or place may be offered some too, and need not choose.
        cues: Where any are named, the balls of which any may be struck in place of `ball`.
    """

    kind: AskKind
    player: int
    ball: str = ""
    where: Where = ""
    on: tuple[str, ...] = ()
    call: CallKind = ""
    may: tuple[Declared, ...] = ()
    options: tuple[str, ...] = ()
    cues: tuple[str, ...] = ()


class Asked(TypedDict, total=False):
    """What may be asked of a player who is to shoot, as `Ask` has it."""

    on: tuple[str, ...]
    call: CallKind
    may: tuple[Declared, ...]
    options: tuple[str, ...]
    cues: tuple[str, ...]


class Choice(NamedTuple):
    """What a player picked: a key out of `Ask.options`; or "place", and where the cue ball goes, m."""

    key: str
    x: float = 0.0
    y: float = 0.0


@dataclass(frozen=True, slots=True)
class State:
    """Where a game stands, apart from the balls. Games add fields of their own, of JSON's types and tuples.

    `turn` is whose turn it is and `breaker` who broke; `scores` the points; `fouls` how many fouls in a row
    each player has made; `seed` and `racks` give the next rack; `shots` counts the strokes since the last break.
    """

    ask: Ask = field(default_factory=lambda: Ask(AIM, 0))
    turn: int = 0
    breaker: int = 0
    scores: tuple[int, ...] = (0, 0)
    fouls: tuple[int, ...] = (0, 0)
    seed: int = 0
    racks: int = 0
    shots: int = 0

    @property
    def over(self) -> bool:
        """Whether the game has ended."""
        return self.ask.kind == OVER

    @property
    def winner(self) -> int | None:
        """Who has won; None while nobody has."""
        return self.ask.player if self.over and self.ask.player >= 0 else None

    def as_dict(self) -> dict[str, Any]:
        """The state in JSON's types; the player who is asked is called `who` there, as records have it."""
        data = asdict(self)
        data["ask"] = {WRITTEN.get(name, name): value for name, value in data["ask"].items()}
        return data


class Ruling(NamedTuple):
    """What happens after a shot or a choice.

    `notes` say what happened, in order, the last one what is next; `fouls` why it was a foul, the gravest
    first; `spotted` which balls went back on the table and where, as pairs of a ball and its (x, y) in m; `points` what
    each player's score changed by.
    """

    state: State
    layout: Layout
    notes: tuple[Note, ...] = ()
    fouls: tuple[Note, ...] = ()
    spotted: Spotted = ()
    points: tuple[int, ...] = (0, 0)

    @property
    def ask(self) -> Ask:
        """What is to happen next, and who is to do it."""
        return self.state.ask

    @property
    def foul(self) -> bool:
        """Whether the stroke was a foul."""
        return bool(self.fouls)


def read_value(kind: type[Any], data: Mapping[str, Any], source: str) -> Any:
    """A state, or what is asked in it, from a dictionary, lists becoming tuples; raises InputError."""
    known = {WRITTEN.get(entry.name, entry.name): entry.name for entry in fields(kind)}
    for name in data:
        if name not in known:
            raise InputError(source, name, data[name], suggest(name, known))
    values = {known[name]: _tupled(value) for name, value in data.items()}
    if "ask" in values and kind is not Ask:
        if not isinstance(data["ask"], Mapping):
            raise InputError(source, "ask", data["ask"], "allowed is what a state's as_dict gives")
        values["ask"] = read_value(Ask, data["ask"], source)
    lacking = [written for written, name in known.items() if name not in values and name in _needed(kind)]
    if lacking:
        raise InputError(source, "", dict(data), f"missing is {lacking[0]!r}")
    return kind(**values)


def _needed(kind: type[Any]) -> list[str]:
    return [entry.name for entry in fields(kind) if entry.default is MISSING and entry.default_factory is MISSING]


def _tupled(value: Any) -> Any:
    return tuple(_tupled(item) for item in value) if isinstance(value, (list, tuple)) else value
