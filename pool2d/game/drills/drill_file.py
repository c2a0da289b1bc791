"""Drill files, shipped or the user's own.

A drill is a TOML file in `assets/drills` or the user's own `drills` folder:

    name = "Stop shot"
    text = "Pot the 1 and leave the cue ball where it was."
    de.name = "Stoppball"           # the player's own have other languages here, by their two letters
    de.text = "Kugel 1 versenken; der Spielball bleibt liegen."
    position = "pool-9ft cue@1.0,0.635 1@1.4,0.635"

    [[steps]]                       # what each stroke has to do, in order
    pot = "1"                       # a ball, a group, or "any", that falls; `least` of them, 1 if not said
    pocket = "top-right"            # into this pocket
    first = "1"                     # a ball or group that is hit first
    hits = ["red", "yellow"]        # balls that the cue ball has to hit
    rails = 3                       # cushions that the cue ball meets before the last of `hits`, or before any ball
    banks = 1                       # cushions that the potted ball meets before it falls
    driven = 4                      # balls that are driven to a cushion or fall
    clear = true                    # the cue ball meets no cushion
    over = ["7"]                    # balls that the cue ball jumps before it meets one
    via = ["right"]                 # cushions that the cue ball has to meet
    rest = [{ ball = "cue", x = [1.2, 1.4], y = [0.5, 0.8] }]     # where balls come to rest; also
                                                                  # { at = [x, y], within = m }

A step may give a `position` of its own; otherwise the balls stay as they lie. `respot = true` spots what fell.
The cue ball must never fall. `pass` is how many steps make the goal, all if not said; `tries` how often one
attempts it, the results adding up; `solution` are strokes that reach the goal.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

from ...config import catalogue
from ...config.fields import check_keys, value_of
from ...config.reader import read_toml
from ...errors import InputError, suggest
from ...physics.values import Layout
from ...table.placing import RANGES
from ...table.position_text import Position, read, read_shot
from ...table.scenario import scenario_of
from ...table.table import Table
from .drill import ANY, Drill, RestArea, Step, Wording

_KEYS = ("name", "text", "position", "steps", "pass", "tries", "solution")
_WORDING_KEYS = ("name", "text")
_LONGEST = {"name": 80, "text": 1000}
_MOST_STEPS = 100
_LANGUAGE = re.compile("[a-z]{2}")
_STEP_KEYS = (
    "position", "pot", "least", "pocket", "first", "hits", "rails", "banks", "driven", "clear", "over",
    "via", "rest", "respot",
)  # fmt: skip
_REST_KEYS = ("ball", "x", "y", "at", "within")


def drills() -> list[str]:
    """The names of all drills, the shipped ones first, then the user's own."""
    return catalogue.shipped(catalogue.DRILLS) + catalogue.own(catalogue.DRILLS)


def load(name: str) -> Drill:
    """A drill by name, or from a .toml file; raises InputError."""
    path = catalogue.find(catalogue.DRILLS, name)
    source, data = str(path), read_toml(path)
    languages = tuple(filter(_LANGUAGE.fullmatch, data))
    check_keys(data, (*_KEYS, *languages), source, "")
    own = _wording(data, source, "", Wording(path.stem, ""))
    position = read(value_of(data, "position", str, source), source)
    scenario = scenario_of(position)
    entries = value_of(data, "steps", list, source)
    if not 1 <= len(entries) <= _MOST_STEPS:
        raise InputError(source, "steps", entries, f"allowed is one step or more, up to {_MOST_STEPS}")
    table = scenario.table
    steps = tuple(_step(entry, table, f"steps[{i}].", source) for i, entry in enumerate(entries))
    _check_balls(steps, scenario.layout, table, source)
    goal, tries = value_of(data, "pass", int, source, len(steps)), value_of(data, "tries", int, source, 10)
    for key, value, most in (("pass", goal, len(steps)), ("tries", tries, 100)):
        if not 1 <= value <= most:
            raise InputError(source, key, value, f"allowed is 1 to {most}")
    return Drill(
        path.stem,
        own.name,
        own.text,
        table,
        scenario.layout,
        steps,
        goal,
        tries,
        tuple(read_shot(str(text), source) for text in value_of(data, "solution", list, source, [])),
        {language: _translated(data, language, source, own) for language in languages},
    )


def _translated(data: Mapping[str, Any], language: str, source: str, own: Wording) -> Wording:
    """A drill's words in another language, those it lacks being its own."""
    entry = data[language]
    if not isinstance(entry, dict):
        raise InputError(source, language, entry, "allowed is a section with " + ", ".join(_WORDING_KEYS))
    check_keys(entry, _WORDING_KEYS, source, f"{language}.")
    return _wording(entry, source, f"{language}.", own)


def _wording(data: Mapping[str, Any], source: str, prefix: str, default: Wording) -> Wording:
    return Wording(*(_words(data, key, source, prefix, default[i]) for i, key in enumerate(_WORDING_KEYS)))


def _words(data: Mapping[str, Any], key: str, source: str, prefix: str, default: str) -> str:
    """A text that the window can show, on one line however the file breaks it."""
    words = " ".join(str(value_of(data, key, str, source, default, prefix=prefix)).split())
    most = _LONGEST[key]
    if not words.isprintable() or len(words) > most:
        raise InputError(source, prefix + key, words, f"allowed is a text of up to {most} printable characters")
    return words


def _step(data: Any, table: Table, key: str, source: str) -> Step:
    if not isinstance(data, dict):
        raise InputError(source, key.rstrip("."), data, "allowed is a section with " + ", ".join(_STEP_KEYS))
    check_keys(data, _STEP_KEYS, source, key)
    step = Step(
        layout=_layout(value_of(data, "position", str, source, "", prefix=key), table, key, source),
        pot=value_of(data, "pot", str, source, "", prefix=key),
        least=_count(data, "least", source, key, 1),
        pocket=value_of(data, "pocket", str, source, "", prefix=key),
        first=value_of(data, "first", str, source, "", prefix=key),
        hits=tuple(map(str, value_of(data, "hits", list, source, [], prefix=key))),
        rails=_count(data, "rails", source, key),
        banks=_count(data, "banks", source, key),
        driven=_count(data, "driven", source, key),
        clear=value_of(data, "clear", bool, source, False, prefix=key),
        over=tuple(map(str, value_of(data, "over", list, source, [], prefix=key))),
        via=tuple(map(str, value_of(data, "via", list, source, [], prefix=key))),
        rest=tuple(
            _rest(entry, f"{key}rest", source) for entry in value_of(data, "rest", list, source, [], prefix=key)
        ),
        respot=value_of(data, "respot", bool, source, False, prefix=key),
    )
    pockets = [pocket.name for pocket in table.geometry.pockets]
    if step.pocket and step.pocket not in pockets:
        raise InputError(source, key + "pocket", step.pocket, suggest(step.pocket, pockets))
    cushions = sorted({element.name for element in table.elements if element.kind == "ball_cushion"})
    for name in step.via:
        if name not in cushions:
            raise InputError(source, key + "via", name, suggest(name, cushions))
    return step


def _layout(text: str, table: Table, key: str, source: str) -> Layout | None:
    """The position of a step on the drill's table; None where it has none of its own."""
    if not text:
        return None
    position = read(text, source)
    if position.table not in ("", table.source):
        raise InputError(source, key + "position", text, f"allowed is the table of the drill, {table.source}")
    if position != Position(position.layout, table=position.table):
        raise InputError(source, key + "position", text, "allowed are balls alone; the table is the drill's")
    try:
        return table.settle(position.layout)
    except InputError as error:
        raise InputError(source, key + "position", text, str(error)) from None


def _check_balls(steps: Sequence[Step], first: Layout, table: Table, source: str) -> None:
    """Raises InputError for a position without a cue ball, and for balls that a drill never has."""
    layouts = [first, *(step.layout for step in steps if step.layout is not None)]
    for layout in layouts:
        if table.furniture.cue not in layout:
            raise InputError(source, "position", ", ".join(layout), f"there has to be the {table.furniture.cue} ball")
    balls = {ball for layout in layouts for ball in layout}
    named = {ANY, *balls, *table.furniture.groups}
    for i, step in enumerate(steps):
        asked = [("pot", step.pot), ("first", step.first), *(("hits", ball) for ball in step.hits)]
        single = [*(("over", ball) for ball in step.over), *(("rest", rest.ball) for rest in step.rest)]
        for known, entries in ((named, asked), (balls, single)):
            for key, ball in entries:
                if ball and ball not in known:
                    raise InputError(source, f"steps[{i}].{key}", ball, suggest(ball, known))


def _count(data: Mapping[str, Any], key: str, source: str, prefix: str, least: int = 0) -> int:
    """A number of balls or cushions; it is `least` where it is not said."""
    value: int = value_of(data, key, int, source, least, prefix=prefix)
    if value < least:
        raise InputError(source, prefix + key, value, f"allowed is {least} or more")
    return value


def _rest(data: Any, key: str, source: str) -> RestArea:
    if not isinstance(data, dict):
        raise InputError(source, key, data, "allowed is a section with " + ", ".join(_REST_KEYS))
    check_keys(data, _REST_KEYS, source, key + ".")
    pairs: dict[str, Any] = {}
    for name in ("x", "y", "at"):
        if name in data:
            pair = data[name]
            if not (isinstance(pair, list) and len(pair) == 2 and all(type(one) in (int, float) for one in pair)):
                raise InputError(source, f"{key}.{name}", pair, "allowed are two numbers, m")
            for one in pair:
                RANGES["x"].check(one, source, f"{key}.{name}")
            if name != "at" and not pair[0] <= pair[1]:
                raise InputError(source, f"{key}.{name}", pair, "allowed are a number and one that is not less, m")
            pairs[name] = (float(pair[0]), float(pair[1]))
    within = data.get("within", math.inf)
    if type(within) not in (int, float) or not within > 0.0:
        raise InputError(source, f"{key}.within", within, "allowed is a number above 0, m")
    return RestArea(value_of(data, "ball", str, source, "cue", prefix=key + "."), within=float(within), **pairs)
