"""Reports written by hand, short enough for a row of a table.

    cue-1       the cue ball meets the 1            1|right    the 1 is driven to the right cushion
    1>top-left  the 1 falls into a pocket           1^right    the 1 leaves the table over the right cushion
    1/right     the 1 comes down on the right rail  1~right    the 1 comes to rest there, and is off the table
    a+b         "cue-1+2": the cue ball meets the 1 and the 2 at the same moment

In their order, with spaces between; "_" stands for a space in a name, as in 1|top-left_jaw. A rail or a
pocket that does not matter may be left out: "1|", "1>"; without a cushion, "1^", nobody has seen how the 1 left.
"""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

from pool2d import Layout
from pool2d.game.rules.report import BALL, OFF, POCKET, RAIL, TOP, Call, Contact, Report
from pool2d.physics import values
from pool2d.physics.values import POCKETED

ANY_RAIL, ANY_POCKET = "right", "top-left"


def contacts(text: str) -> tuple[Contact, ...]:
    """The contacts that a text tells."""
    found: list[Contact] = []
    for word in text.split():
        word = word.replace("_", " ")
        lost = re.fullmatch(r"(.*)[\^~](.*)", word)
        if lost:
            found.append(Contact(OFF, lost[1], lost[2]))
        elif "/" in word:
            ball, _, rail = word.partition("/")
            found.append(Contact(TOP, ball, rail))
        elif ">" in word:
            ball, _, pocket = word.partition(">")
            found.append(Contact(POCKET, ball, pocket or ANY_POCKET))
        elif "|" in word:
            ball, _, rail = word.partition("|")
            found.append(Contact(RAIL, ball, rail or ANY_RAIL))
        else:
            ball, _, others = word.partition("-")
            found += [Contact(BALL, ball, other) for other in others.split("+")]
    return tuple(found)


def call(text: str) -> Call:
    """A call: "1>top-left", "safety", "push", or "" for none. A ball alone is called into any pocket: "1>"."""
    if text in ("safety", "push"):
        return Call(safety=text == "safety", push=text == "push")
    ball, _, pocket = text.partition(">")
    return Call(ball, pocket or (ANY_POCKET if ">" in text else ""))


def report(text: str, said: str = "", cue: str = "cue", **more: Any) -> Report:
    """A report; `more` sets other fields of it. The first ball met is read from the text."""
    first = next((word for word in text.split() if word.startswith(f"{cue}-")), "")
    met = tuple(first.removeprefix(f"{cue}-").split("+")) if first else ()
    resting = tuple(word.partition("~")[0] for word in text.split() if "~" in word)
    return replace(Report(contacts(text), call(said), cue, met, on_rail=resting), **more)


def after(layout: Layout, seen: Report) -> Layout:
    """The layout once the balls that fell or left the table in a report are gone."""
    fallen = layout.put(*(layout[ball]._replace(phase=POCKETED) for ball in seen.fallen))
    # Where a ball was last seen is beyond the rails.
    return fallen.put(*(layout[ball]._replace(x=-0.2, z=0.1, phase=values.OFF) for ball in seen.left))


def without(layout: Layout, *balls: str) -> Layout:
    """The layout with balls pocketed earlier."""
    return layout.put(*(layout[ball]._replace(phase=POCKETED) for ball in balls))


def only(layout: Layout, *balls: str, cue: str = "cue") -> Layout:
    """The layout with all object balls but these pocketed earlier."""
    return without(layout, *(ball for ball in layout if ball not in balls and ball != cue))
