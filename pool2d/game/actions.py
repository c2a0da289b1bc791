"""What players do in a match, as values that JSON holds to the bit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, TypeAlias, get_args

from ..config.fields import value_of
from ..errors import InputError, suggest
from ..physics.values import Layout, Shot
from ..table.position_text import Position, read, read_shot, write, write_shot
from .reasons import Reasons, reasons_of
from .rules import Choice
from .rules.report import Call


@dataclass(frozen=True, slots=True)
class Stroke:
    """A shot, and what was called before it; `why` whoever thought of it meant to play it, if that is told."""

    shot: Shot
    call: Call = field(default_factory=Call)
    why: Reasons | None = None


@dataclass(frozen=True, slots=True)
class Concede:
    """A player gives the frame up."""

    player: int


@dataclass(frozen=True, slots=True)
class Stalemate:
    """Both players see no progress: the frame begins again."""


@dataclass(frozen=True, slots=True)
class NextFrame:
    """The balls are racked for the next frame."""


@dataclass(frozen=True, slots=True)
class Arrange:
    """In practice: the balls are put where the layout has them."""

    layout: Layout


Action: TypeAlias = Stroke | Choice | Concede | Stalemate | NextFrame | Arrange

# What a line of a record says is done.
ActionKind: TypeAlias = Literal["stroke", "choose", "concede", "stalemate", "next", "arrange"]


def as_dict(action: Action) -> dict[str, Any]:
    """The action in JSON's types; `from_dict` reads it."""
    if isinstance(action, Stroke):
        return _line("stroke", shot=write_shot(action.shot), **_said(action))
    if isinstance(action, Choice):
        place = {"x": action.x, "y": action.y} if action.key == "place" else {}
        return _line("choose", key=action.key, **place)
    if isinstance(action, Concede):
        return _line("concede", player=action.player)
    if isinstance(action, Arrange):
        return _line("arrange", position=write(action.layout))
    return _line("stalemate" if isinstance(action, Stalemate) else "next")


def _said(stroke: Stroke) -> dict[str, Any]:
    """What was called, and why it was played, as far as anything is told of them."""
    call = {name: value for name, value in stroke.call.as_dict().items() if value}
    why = None if stroke.why is None else stroke.why.as_dict()
    return {name: said for name, said in (("call", call), ("why", why)) if said}


def _line(do: ActionKind, **what: object) -> dict[str, Any]:
    return {"do": do, **what}


def from_dict(data: Mapping[str, Any], source: str) -> Action:
    """The action that `as_dict` made it of; raises InputError."""
    do: ActionKind | None = data.get("do")
    if do == "stroke":
        return Stroke(read_shot(value_of(data, "shot", str, source), source), _call(data, source), _why(data, source))
    if do == "choose":
        x, y = (value_of(data, name, float, source, 0.0) for name in ("x", "y"))
        return Choice(value_of(data, "key", str, source), x, y)
    if do == "concede":
        return Concede(value_of(data, "player", int, source))
    if do == "arrange":
        position = read(text, source) if (text := value_of(data, "position", str, source)) else Position()
        if position != Position(position.layout):
            raise InputError(source, "position", text, "allowed are balls alone")
        return Arrange(position.layout)
    if do in ("next", "stalemate"):
        return NextFrame() if do == "next" else Stalemate()
    raise InputError(source, "do", do, suggest(str(do), get_args(ActionKind)))


def _call(data: Mapping[str, Any], source: str) -> Call:
    call = value_of(data, "call", dict, source, {})
    known = Call().as_dict()
    for name, value in call.items():
        if name not in known or type(value) is not type(known[name]):
            raise InputError(source, f"call.{name}", value, "allowed are ball, pocket, safety and push")
    return Call(**call)


def _why(data: Mapping[str, Any], source: str) -> Reasons | None:
    return reasons_of(value_of(data, "why", dict, source), source) if "why" in data else None
