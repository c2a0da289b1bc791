"""Why a stroke of a match was played: its lines on the table, and a panel that says it in words."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Final

import pygame

from ...draw import intentions, shapes, text, theme
from ...draw.intentions import Intended, Intentions
from ...draw.ways import Line, joined
from ...game.actions import Action, Stroke
from ...game.explained import told
from ...game.match import Match, Moment
from ..screen import Screen
from ..wording import why_text
from ..wording.words import Words
from .stage import Stage

# The heading of a part has the colour of the lines that it is about.
_COLORS: Final[dict[str, theme.Color]] = {
    "meant": intentions.MEANT, "others": intentions.OTHER, "fears": theme.WARNING, "hand": theme.QUIET,
}  # fmt: skip
# How wide headings and sentences are, in units.
_HEADING, _SENTENCE = 11, 44
# How far apart the places along a way are that the panel keeps clear of, m.
_SPACED = 0.03
# How much more those count along which the cue ball is aimed.
_AIMED = 4
# How many lines of a caption are kept clear of.
_CAPTION = 3

# A line of the panel: its heading, "" for none, the heading's colour, and what is said.
Said = tuple[str, theme.Color, str]


def draw(surface: pygame.Surface, words: Words, stage: Stage, match: Match, before: Moment, action: Action) -> None:
    """Draw why a stroke was played in a match at the moment `before` it, clear of what it tells of."""
    found = Intentions(None, ())
    if isinstance(action, Stroke) and action.why is not None:
        found = intentions.intentions(match.table, before.layout, action.why)
        surface.set_clip(stage.screen.table)
        intentions.draw(surface, found, match.table, stage.view)
        surface.set_clip(None)
    said = lines(words, stage.screen, match, before, action)
    box = place(stage.screen, len(said), [stage.view.to_screen(*point) for point in _points(found)])
    _draw_panel(surface, words, stage.screen, box, said)


def lines(words: Words, screen: Screen, match: Match, before: Moment, action: Action) -> list[Said]:
    """What the panel says below its title, in lines as wide as it is."""
    voice = why_text.voice(words, match)
    parts = told(match, before, action, voice) if isinstance(action, Stroke) else []
    found: list[Said] = []
    for key, sentences in parts:
        wrapped = [line for one in sentences for line in _wrapped(one, screen)]
        headings = [why_text.template(words, key)] + [""] * len(wrapped)
        found += [(heading, _COLORS[key], line) for heading, line in zip(headings, wrapped, strict=False)]
    return found or [("", theme.QUIET, why_text.template(words, "untold"))]


def _wrapped(sentence: str, screen: Screen) -> tuple[str, ...]:
    return text.wrap(sentence, screen.small, _SENTENCE * screen.unit)


def place(screen: Screen, count: int, points: Sequence[tuple[float, float]]) -> pygame.Rect:
    """The corner for a panel of so many lines that covers the fewest of the points, the first of equals."""
    unit, room = screen.unit, pygame.Rect(screen.table).inflate(-screen.unit, -screen.unit)
    # Below it there is room for what is said over the table's lower edge.
    room.height -= _CAPTION * text.font(screen.small).get_linesize()
    width = (_HEADING + _SENTENCE + 3) * unit
    size = (min(width, room.width), min(_height(screen, count), room.height))
    corners = [pygame.Rect((0, 0), size) for _ in range(4)]
    corners[0].topright, corners[1].topleft = room.topright, room.topleft
    corners[2].bottomright, corners[3].bottomleft = room.bottomright, room.bottomleft
    return min(corners, key=lambda box: sum(box.collidepoint(point) for point in points))


def _height(screen: Screen, count: int) -> int:
    return (count + 1) * text.font(screen.small).get_linesize() + 3 * screen.unit


def _points(found: Intentions) -> Iterator[tuple[float, float]]:
    """Places along the ways, evenly spaced, m."""
    for intended in (found.meant, *found.others):
        for line in _lines(intended):
            yield from (place for ends in pairwise(line) for place in _between(*ends))


def _lines(intended: Intended | None) -> list[Line]:
    if intended is None:
        return []
    return [*[intended.fore.cue] * _AIMED, intended.fore.after, joined(intended.balls)]


def _between(a: tuple[float, float], b: tuple[float, float]) -> Iterator[tuple[float, float]]:
    steps = math.ceil(math.dist(a, b) / _SPACED)
    for step in range(steps):
        yield a[0] + (b[0] - a[0]) * step / steps, a[1] + (b[1] - a[1]) * step / steps


def _draw_panel(surface: pygame.Surface, words: Words, screen: Screen, box: pygame.Rect, said: list[Said]) -> None:
    unit, size = screen.unit, screen.small
    pitch = text.font(size).get_linesize()
    shapes.panel(surface, box, unit)
    x, y = box.left + unit * 3 // 2, box.top + unit
    text.draw(surface, why_text.template(words, "title"), size, theme.ACCENT, (x, y))
    for number, (heading, color, line) in enumerate(said):
        top = y + unit + (number + 1) * pitch
        text.draw(surface, heading, size, color, (x, top))
        text.draw(surface, line, size, theme.TEXT, (x + _HEADING * unit, top))
