"""Rows of `tables/` for the games that are not pool: the situation is told by fields of the state and places of balls.

The columns are those of `cases`. What may be given, with commas: "balls red1 pink", those on the table; "at cue 1.5
0.9", where one lies, in m; "where d"; "option miss always"; "touching", "stroke", "over" and others of SEEN as
in a report; and any field of the game's state, such as "phase color" or "scores 10 3". What changed of the fields that
a test names stands at the end of the ruling, behind what was noted.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

from pool2d import Layout, Table
from pool2d.game.rules import GAMES, Rules, Ruling, State
from pool2d.game.rules.spotting import AREAS, Where, put

from .cases import Case, line
from .notation import after, only, report

SEEN = ("touching", "pressed", "stroke", "over", "over_later", "vaulted", "jammed", "strayed", "passed", "cleared")
NOTED = (
    "miss",
    "warned",
    "free-ball",
    "tie",
    "re-racked",
    "two-visits",
    "last-inning",
    "missed.none",
    "missed.one",
    "cushions.0",
    "cushions.1",
    "cushions.2",
    "free-shot",
    "own-ball",
    "no-finish",
)


@dataclass
class Scene:
    """A situation."""

    balls: tuple[str, ...] = ()
    places: dict[str, tuple[float, float]] = field(default_factory=dict)
    where: Where = ""
    options: dict[str, Any] = field(default_factory=dict)
    state: dict[str, Any] = field(default_factory=dict)
    report: dict[str, Any] = field(default_factory=dict)


def scene(text: str) -> Scene:
    """What a row's cell says."""
    found = Scene()
    for name, *words in (item.split() for item in filter(None, text.split(", "))):
        if name == "balls":
            found.balls = tuple(words)
        elif name == "at":
            found.places[words[0]] = (float(words[1]), float(words[2]))
        elif name == "where":
            found.where = next(area for area in AREAS if area == words[0])
        elif name == "option":
            found.options[words[0]] = _value(words[1])
        elif name in SEEN:
            found.report[name] = tuple(words)
        else:
            values = tuple(_value(word) for word in words)
            found.state[name] = True if not values else values[0] if len(values) == 1 else values
    return found


def _value(word: str) -> Any:
    return int(word) if word.lstrip("-").isdigit() else word


# How a game asks player 0 to shoot.
Asks = Callable[[Any, State, Layout, Scene], State]


def judged(name: str, table: Table, case: Case, asks: Asks) -> tuple[Rules[Any], Ruling]:
    """The rules with a row's options, and the ruling on its shot."""
    given = scene(case.given)
    rules = GAMES[name](table, given.options)
    start = rules.start()
    layout = only(start.layout, *given.balls) if given.balls else start.layout
    for ball, place in given.places.items():
        layout = put(layout, ball, place)
    state = asks(rules, replace(start.state, **{"shots": 5, **given.state}), layout, given)
    seen = report(case.shot, case.said, state.ask.ball, start=layout, **given.report)
    return rules, rules.judge(state, after(layout, seen), seen)


def told(ruling: Ruling, *names: str) -> str:
    """A ruling in a line, with what was noted, and the named fields of the state."""
    notes = [note.key for note in ruling.notes if note.key in NOTED]
    fields = [f"{name} {_words(getattr(ruling.state, name))}" for name in names]
    call = ["call"] if ruling.ask.call else []
    return "; ".join((line(ruling), *call, *notes, *fields))


def _words(value: Any) -> str:
    return " ".join(str(part) or "-" for part in value) if isinstance(value, tuple) else str(value)
