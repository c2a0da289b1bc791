"""The clauses of the rules as tables: `tables/<game>.txt`, a row for a clause.

Columns are parted by two spaces or more; "-" is an empty cell.

clause  its number in the rules that the game's file names
what    what it says, in words
given   the situation, with commas: see `GIVEN`. Without a word on it a game is under way, player 0 shoots, all
        balls are on the table, and the cue ball is not in hand
said    the call: see `notation.call`
shot    what the referee saw: see `notation`
ruling  who does what next; then, as far as there are any, the fouls, the balls spotted, the points, and what
        changed of what only this game knows
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import asdict, dataclass, field, fields, replace
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from pool2d import Layout, Table, load_table
from pool2d.game.rules import CHOOSE, GAMES, Choice, Ruling, State
from pool2d.game.rules.notes import ENGLISH, Note
from pool2d.game.rules.pool.pool import PoolRules
from pool2d.game.rules.ruling import Declared
from pool2d.game.rules.spotting import Where

from .notation import after, only, report

POOL = load_table("pool-9ft")
TABLES = Path(__file__).parent / "tables"
DOES = {"aim": "aims", "place": "places", "choose": "chooses", "over": "wins"}


class Case(NamedTuple):
    """A row of a table."""

    clause: str
    what: str
    given: str
    said: str
    shot: str
    ruling: str


@dataclass
class Given:
    """A situation: options of the game, fields of the state and of the report, and the balls on the table."""

    breaks: bool = False
    where: Where = ""
    balls: tuple[str, ...] = ()
    may: tuple[Declared, ...] = ()
    options: dict[str, Any] = field(default_factory=dict)
    state: dict[str, Any] = field(default_factory=dict)
    report: dict[str, Any] = field(default_factory=dict)


def _option(given: Given, words: list[str]) -> None:
    given.options[words[0]] = float(words[1]) if words[1].isdigit() else words[1]


def _owes(given: Given, words: list[str]) -> None:
    mine, other = given.state.get("scores", (0, 0))
    owed = int(words[0]), int(words[1]) if len(words) > 1 else 0
    given.state.update(owed=owed, scores=(mine - owed[0], other - owed[1]))


# What may be given: "fouls 2" is what player 0 has, "holds 1 2 3 / 4" what each player has.
GIVEN: dict[str, Callable[[Given, list[str]], None]] = {
    "break": lambda given, words: setattr(given, "breaks", True),
    "kitchen": lambda given, words: setattr(given, "where", "kitchen"),
    "balls": lambda given, words: setattr(given, "balls", tuple(words)),
    "may": lambda given, words: setattr(given, "may", tuple(words)),
    "option": _option,
    "fouls": lambda given, words: given.state.update(fouls=(int(words[0]), 0)),
    "score": lambda given, words: given.state.update(scores=(int(words[0]), 0)),
    "solids": lambda given, words: given.state.update(groups=("solid", "stripe")),
    "holds": lambda given, words: given.state.update(held=_parted(words), scores=tuple(map(len, _parted(words)))),
    "owes": _owes,
    "waiting": lambda given, words: given.state.update(waiting=tuple(words)),
    "stroke": lambda given, words: given.report.update(stroke=tuple(words)),
    "frozen": lambda given, words: given.report.update(touching=tuple(words), pressed=tuple(words)),
    "first-behind": lambda given, words: given.report.update(kitchen=True),
    "stayed": lambda given, words: given.report.update(stayed=True),
    "over": lambda given, words: given.report.update(over=tuple(words)),
    "crossed": lambda given, words: given.report.update(crossed=tuple(words)),
}


def _parted(words: list[str]) -> tuple[tuple[str, ...], ...]:
    mine, _, other = " ".join(words).partition("/")
    return tuple(mine.split()), tuple(other.split())


def rows(name: str) -> pytest.MarkDecorator:
    """A game's table as parameters of a test, each called by clause and words."""
    return pytest.mark.parametrize(
        "case", [pytest.param(case, id=f"{case.clause} {case.what}") for case in table(name)]
    )


def table(name: str) -> list[Case]:
    """The rows of a game's table."""
    lines = (TABLES / f"{name}.txt").read_text(encoding="utf-8").splitlines()[1:]
    cells = [
        [("" if cell == "-" else cell) for cell in re.split(r" {2,}", row.strip())] for row in lines if row.strip()
    ]
    return [Case(*row) for row in cells]


def given(case: Case) -> Given:
    """What a row's cell says."""
    found = Given()
    for item in filter(None, case.given.split(", ")):
        name, *words = item.split()
        GIVEN[name](found, words)
    return found


def situation(rules: PoolRules[Any], case: Case) -> tuple[State, Layout]:
    """The state and layout before a row's shot; of pockets to choose from, player 0 has the first."""
    start, asked = rules.start(), given(case)
    if start.ask.kind == CHOOSE:
        start = rules.choose(start.state, start.layout, Choice(start.ask.options[0]))
    layout = only(start.layout, *asked.balls) if asked.balls else start.layout
    if asked.breaks:
        return replace(start.state, **asked.state), layout
    under_way = {"shots": 5, **({"opening": False} if hasattr(start.state, "opening") else {})}
    state = replace(start.state, **{**under_way, **asked.state})
    return rules.next(state, layout, 0, asked.where, may=(*rules.may, *asked.may)), layout


def rules_of(name: str, case: Case | None = None, on: Table = POOL) -> PoolRules[Any]:
    """The rules of a pool game, with a row's options."""
    rules = GAMES[name](on, given(case).options if case else None)
    assert isinstance(rules, PoolRules)
    return rules


def judged(name: str, case: Case) -> tuple[State, Ruling]:
    """The state before a row's shot, and the ruling on it."""
    rules = rules_of(name, case)
    state, layout = situation(rules, case)
    seen = report(case.shot, case.said, start=layout, **given(case).report)
    return state, rules.judge(state, after(layout, seen), seen)


def check(name: str, case: Case) -> None:
    """Judge a row's shot and compare."""
    state, ruling = judged(name, case)
    assert line(ruling, state) == case.ruling


def assert_told(ruling: Ruling) -> None:
    """Whatever is ruled can be said, of the right player, and says nothing that the state does not hold."""
    _assert_points_told(ruling)
    for note in (*ruling.notes, *ruling.fouls):
        text = ENGLISH[note.key]
        assert note.player in (0, 1) or "{player}" not in text, note
        assert note.ball or "{ball}" not in text, note
        what, _, which = note.key.partition(".")
        if what == "group":
            groups: tuple[str, ...] = asdict(ruling.state)["groups"]
            assert groups[note.player] == which, note
        elif what in ("turn", "in-hand", "chooses", "wins"):
            assert note.player == ruling.ask.player, note
    assert [note for note in ruling.notes if note in ruling.fouls] == list(ruling.fouls)


def _assert_points_told(ruling: Ruling) -> None:
    """Every change of the score is told; at one-pocket the balls that are held show it."""
    told = [(note.player, note.points if note.key == "score" else -note.points) for note in _scores(ruling)]
    changed = [(player, points) for player, points in enumerate(ruling.points) if points]
    assert told == ([] if hasattr(ruling.state, "held") else changed)


def _scores(ruling: Ruling) -> list[Note]:
    return [note for note in ruling.notes if note.key in ("score", "loses")]


def line(ruling: Ruling, before: State | None = None) -> str:
    """A ruling in a line, once it has been seen to be told well."""
    assert_told(ruling)
    ask, now = ruling.ask, ruling.state
    parts = [" ".join(filter(None, (str(ask.player), DOES[ask.kind], ask.where, "/".join(ask.options))))]
    if "push" in ask.may:
        parts.append("may push")
    if ruling.fouls:
        parts.append("foul " + " ".join(foul.key.removeprefix("foul.") for foul in ruling.fouls))
    if ruling.spotted:
        parts.append("spotted " + " ".join(ball for ball, _ in ruling.spotted))
    if any(ruling.points):
        parts.append("points " + " ".join(map(str, ruling.points)))
    own = {entry.name for entry in fields(now)} - {entry.name for entry in fields(State)} - {"opening"}
    for name in sorted(own):
        value = getattr(now, name)
        if before is not None and value != getattr(before, name):
            parts.append(f"{name} {_joined(value)}")
    return "; ".join(parts)


def _joined(value: tuple[Any, ...]) -> str:
    """Balls with spaces between, what belongs to each player with a stroke; "-" for none."""
    parts = [" ".join(map(str, part)) if isinstance(part, tuple) else str(part) for part in value]
    return " / ".join(part or "-" for part in parts) or "-"
