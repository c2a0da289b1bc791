"""What is said of a cue that has something in its way."""

from __future__ import annotations

from ...physics.values import Layout
from ...table.clearance import CLOTH, Clearance
from . import ruling_text
from .shot_text import place_name
from .words import Words

# What is raised by less, degrees, every stroke is: the cushion behind it asks for that, and the diagram tells it.
TOLD = 3.0


def raised(words: Words, clearance: Clearance, layout: Layout) -> str:
    """How far the butt is raised by itself, and over what: "12 degrees, over the 7."; empty where that is little."""
    if clearance.elevation is None or not clearance.over or clearance.elevation < TOLD:
        return ""
    what = _in_the_way(words, clearance.over, layout)
    return words.say("clearance.raised", degrees=words.number(clearance.elevation, ".0f"), what=what)


def refused(words: Words, clearance: Clearance, layout: Layout, other_tips: bool) -> str:
    """Why the stroke cannot be played; `other_tips` is whether the ball can be struck along this aim elsewhere."""
    what = _in_the_way(words, clearance.over, layout)
    return words.say("clearance.no_tip", what=what) if other_tips else words.say("clearance.no_stroke", what=what)


def _in_the_way(words: Words, over: str, layout: Layout) -> str:
    if over in layout:
        return words.say("clearance.ball", ball=ruling_text.ball(words, over))
    if over == CLOTH:
        return words.say("clearance.cloth")
    place, _, part = over.partition(" ")
    if part == "jaw":
        return words.say("clearance.jaw", jaw=place_name(words, over))
    where = place_name(words, place)
    return words.say("clearance.pocket", where=where) if part == "back" else words.say("clearance.cushion", where=where)
