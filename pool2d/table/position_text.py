"""A layout and a shot as one line of text, to copy, paste, type and keep.

    pool-9ft+heated cloth.mu_roll=0.012 cue@0.635,0.3175 1@1.905,0.635 8@2.6,1.3! cue:12.5,3.0,0.2

| word | what it says |
|---|---|
| `pool-9ft+heated` | the table, and conditions laid over it; may be left out |
| `cloth.mu_roll=0.012` | a knob that is set |
| `1@1.905,0.635` | a ball at rest and its place, m; `,r0.03` its own radius, `,m0.2` its own mass |
| `8@2.6,1.3!` | a ball that has been pocketed, and where it fell; `!!` one that has left the table |
| `cue:12.5,3.0,0.2,-0.1,5.0` | a shot: the ball, angle, speed, side, height, elevation; zeros at the end are left out |
| `cue:12.5,3.0,easy` | the same with an easy stroke; `jump` with the jump cue |

Numbers are the shortest that read back to the same bits, so what is written reads back equal. What is
no letter, digit or one of `_.-~/` in a name is escaped as in an address: %20 is a blank. A ball's motion
is not told: positions are of balls at rest.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from urllib.parse import quote, unquote

from ..errors import InputError
from ..physics.values import OFF, POCKETED, RESTING, Ball, Layout, Phase, Shot
from .placing import MOST_BALLS, RANGES, check_id
from .table import Table

# Longer than any layout; reading stops there.
_LONGEST = 200_000
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?", re.ASCII | re.IGNORECASE)
_SHOT = ("angle", "speed", "side", "height", "elevation")
# What ends the text of a shot for which it is so, in this order.
_WORDS = ("easy", "jump")
# What follows a ball that is no longer played.
_SIGNS: dict[Phase, str] = {POCKETED: "!", OFF: "!!"}
_ALLOWED = "allowed are a table, knob=value, ball@x,y and one ball:angle,speed"


@dataclass(frozen=True, slots=True)
class Position:
    """What a text tells; an empty `table` where it names none."""

    layout: Layout = field(default_factory=Layout)
    shot: Shot | None = None
    table: str = ""
    conditions: tuple[str, ...] = ()
    set: Mapping[str, float | str] = field(default_factory=dict)


def write(layout: Layout, shot: Shot | None = None, table: Table | None = None) -> str:
    """The text of a layout, of a shot, and of the table they are on, where given."""
    words = []
    if table is not None:
        words.append("+".join(_escaped(name) for name in (table.source, *table.conditions)))
        words += [f"{_escaped(name)}={_told(value)}" for name, value in table.set.items()]
    words += [_ball_text(ball) for ball in layout.values()]
    if shot is not None:
        words.append(write_shot(shot))
    return " ".join(words)


def write_shot(shot: Shot) -> str:
    """The text of a shot."""
    numbers = [float(getattr(shot, name)) for name in _SHOT]
    while len(numbers) > 2 and not numbers[-1] and repr(numbers[-1]) == "0.0":
        numbers.pop()
    parts = [*map(repr, numbers), *(word for word in _WORDS if getattr(shot, word))]
    return f"{_escaped(shot.ball)}:{','.join(parts)}"


def read(text: str, source: str = "position") -> Position:
    """What a text tells; raises InputError naming the wrong word. Whether the balls fit is the table's to say."""
    if len(text) > _LONGEST:
        raise InputError(source, "", None, f"longer than {_LONGEST} characters; no layout is")
    words = text.split()
    if not words:
        raise InputError(source, "", None, f"empty; {_ALLOWED}")
    table, *conditions = [""]
    if not re.search("[@:=]", words[0]):
        first = words.pop(0)
        table, *conditions = [_plain(name, first, source) for name in first.split("+")]
    balls: dict[str, Ball] = {}
    knobs: dict[str, float | str] = {}
    shot: Shot | None = None
    for word in words:
        name, sign, rest = re.match(r"([^@:=]*)([@:=]?)(.*)", word, re.DOTALL).groups()  # type: ignore[union-attr]
        name = _plain(name, word, source)
        if len(balls) >= MOST_BALLS:
            raise InputError(source, "word", word, f"allowed are up to {MOST_BALLS} balls")
        if sign == "@" and name not in balls:
            balls[name] = _ball(name, rest, word, source)
        elif sign == "=" and name not in knobs:
            knobs[name] = float(rest) if _NUMBER.fullmatch(rest) else _plain(rest, word, source)
        elif sign == ":" and shot is None:
            shot = _shot(name, rest, word, source)
        else:
            twice = {"@": "this ball is there already", ":": "there is a shot already", "=": "this knob is set already"}
            raise InputError(source, "word", word, twice.get(sign, _ALLOWED))
    return Position(Layout(balls.values()), shot, table, tuple(conditions), knobs)


def read_shot(text: str, source: str = "shot") -> Shot:
    """The shot that a text tells; raises InputError."""
    ball, sign, rest = text.strip()[:_LONGEST].partition(":")
    if not sign:
        raise InputError(source, "shot", text, "allowed is ball:angle,speed,side,height,elevation")
    return _shot(_plain(ball, text, source), rest, text, source)


def _ball_text(ball: Ball) -> str:
    parts = [repr(float(ball.x)), repr(float(ball.y))]
    parts += [f"{key}{float(value)!r}" for key, value in (("r", ball.radius), ("m", ball.mass)) if value is not None]
    return f"{_escaped(ball.id)}@{','.join(parts)}{_SIGNS.get(ball.phase, '')}"


def _ball(name: str, text: str, word: str, source: str) -> Ball:
    sign = "!" * (len(text) - len(text.rstrip("!")))
    x, _, rest = text.removesuffix(sign).partition(",")
    y, *more = rest.split(",")
    own: dict[str, float] = {}
    for part in more:
        key = {"r": "radius", "m": "mass"}.get(part[:1])
        if key is None or key in own:
            raise InputError(source, "word", word, "allowed is ball@x,y and then r and a radius, m and a mass")
        own[key] = _number(part[1:], key, word, source)
    phase: Phase = next((phase for phase, mark in _SIGNS.items() if mark == sign), RESTING)
    if sign and phase == RESTING:
        raise InputError(source, "word", word, "allowed is ! after a pocketed ball, !! after one off the table")
    check_id(name, source, f"ball in {word}")
    return Ball(name, _number(x, "x", word, source), _number(y, "y", word, source), phase=phase, **own)


def _shot(name: str, text: str, word: str, source: str) -> Shot:
    parts = text.split(",")
    jump, easy = (bool(parts) and parts[-1] == said and bool(parts.pop()) for said in reversed(_WORDS))
    if not 2 <= len(parts) <= len(_SHOT) or not all(_NUMBER.fullmatch(part) for part in parts):
        raise InputError(source, "shot", word, "allowed is ball:angle,speed,side,height,elevation")
    shot = Shot(ball=name, **dict(zip(_SHOT, map(float, parts), strict=False)), easy=easy, jump=jump)
    shot.check(source)
    return shot


def _number(text: str, key: str, word: str, source: str) -> float:
    if not _NUMBER.fullmatch(text):
        raise InputError(source, "word", word, f"{key} is {text!r}; allowed is {RANGES[key].allowed()}")
    return float(RANGES[key].check(float(text), source, f"{key} in {word}"))


def _escaped(name: str) -> str:
    return quote(name, safe="~/")


def _plain(name: str, word: str, source: str) -> str:
    """A name as it was before it was escaped."""
    try:
        plain = unquote(name, errors="strict")
    except UnicodeDecodeError:
        plain = ""
    if not plain or not plain.isprintable():
        raise InputError(source, "word", word, f"a name is missing or cannot be read; {_ALLOWED}")
    return plain


def _told(value: object) -> str:
    return _escaped(value) if isinstance(value, str) else repr(value)
