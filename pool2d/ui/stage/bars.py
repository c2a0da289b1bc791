"""The bars above and below the table, with the ball diagram and the cue diagram."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable
from functools import lru_cache

import pygame

from ...draw import pen, text, theme
from ...game.aim import MAX_ELEVATION, MAX_OFFSET, MAX_SPEED, Aim
from ...physics.strike import miscue_limit
from ..frame import Frame
from ..screen import Screen
from ..wording.words import Words


class CachedBars:
    """The two bars as they were drawn last: while a shot runs they mostly stay the same."""

    def __init__(self) -> None:
        self._key: Hashable = None
        self._parts: list[tuple[pygame.Surface, tuple[int, int]]] = []

    def show(self, frame: Frame, screen: Screen, key: Hashable, draw: Callable[[], None]) -> None:
        """Show what `draw` has drawn for this key, or have it drawn."""
        bars = [screen.top, screen.bottom]
        if key != self._key:
            draw()
            self._key = key
            self._parts = [(frame.surface.subsurface(box).copy(), box.topleft) for box in bars]
        elif frame.changed is None:
            frame.surface.blits(self._parts, False)
        else:
            # They are still there: nothing has been drawn that might lie over them, such as a cue.
            return
        frame.replace(bars)


def draw_bars(surface: pygame.Surface, screen: Screen, title: str, note: str) -> None:
    """The two bars, with the table's name on the left of the upper one and a note on its right."""
    for bar in (screen.top, screen.bottom):
        surface.fill(theme.PANEL[:3], bar)
    y = screen.top.centery
    text.draw(surface, title, screen.small, theme.QUIET, (screen.unit * 2, y), (0.0, 0.5))
    text.draw(surface, note, screen.small, theme.TEXT, (screen.width - screen.unit * 2, y), (1.0, 0.5))


def draw_controls(
    surface: pygame.Surface, words: Words, screen: Screen, aim: Aim, speed: float, tip_friction: float
) -> None:  # fmt: skip
    """The ball diagram, the cue diagram and the speed."""
    named = words.say("play.with_jump_cue") if aim.jump else ""
    limit = miscue_limit(tip_friction)
    # No pixel of it changes by less than a tenth of a degree, as a butt that is raised by itself does all the time.
    elevation = round(aim.elevation, 1)
    surface.blit(_diagrams(screen, aim.side, aim.height, elevation, limit, named), screen.bottom)
    bar = screen.power
    radius = bar.height // 2
    y = screen.bottom.top + screen.unit * 2
    text.draw(surface, words.speed(speed), screen.large, theme.TEXT, (bar.left, y))
    place = (bar.right, y + screen.large // 3)
    text.draw(surface, bearing(words, aim.angle), screen.small, theme.QUIET, place, (1.0, 0.0))
    pygame.draw.rect(surface, theme.EDGE, bar, border_radius=radius)
    filled = bar.copy()
    filled.width = round(bar.width * min(1.0, speed / MAX_SPEED))
    if filled.width > 0:
        pygame.draw.rect(surface, theme.ACCENT, filled, border_radius=radius)


def bearing(words: Words, angle: float) -> str:
    """A direction in degrees as text, from 0 to below 360 also after rounding."""
    return words.number(round(angle, 2) % 360.0, ".2f") + "\N{DEGREE SIGN}"


def draw_message(
    surface: pygame.Surface, screen: Screen, message: str, color: theme.Color, taken: int = 0, aimed: str = ""
) -> None:  # fmt: skip
    """The message in the lower bar, wrapped into what room there is, less `taken` pixels of its width."""
    box = screen.message
    box.width = max(1, box.width - taken)
    pitch = text.font(screen.small).get_linesize()
    lines = message_lines(message, aimed, screen.small, box.width, box.height // pitch)
    y = box.centery - pitch * len(lines) / 2
    for line in lines:
        text.draw(surface, line, screen.small, color, (box.left, y))
        y += pitch


def message_lines(message: str, aimed: str, size: int, width: int, most: int) -> tuple[str, ...]:
    """A message, and after it what is said of the shot that is aimed, in up to `most` lines.

    Where there is no room for both, the latter goes before: it is what is to be read before the stroke. A message that
    ends in a name, or in a path, is ended by a full stop then.
    """
    if aimed and message and message[-1].isalnum():
        message += "."
    told = f"{message} {aimed}".strip()
    if aimed and len(text.wrap(told, size, width)) > most:
        told = f"{aimed} {message}"
    return text.in_lines(told, size, width, most)


@lru_cache(maxsize=4)
def _diagrams(screen: Screen, side: float, height: float, elevation: float, limit: float, named: str) -> pygame.Surface:
    """The left part of the lower bar with the ball and cue diagrams; drawn once for each aim, then remembered.

    `named` is what the cue is called that is none for playing.
    """
    bar, aim = screen.bottom, Aim(side=side, height=height, elevation=elevation)
    surface = pygame.Surface((screen.cue_diagram.right + screen.unit, bar.height))
    surface.fill(theme.PANEL[:3])
    _ball_diagram(surface, screen.ball_diagram.move(0, -bar.top), aim, limit)
    _cue_diagram(surface, screen.cue_diagram.move(0, -bar.top), screen, aim, named)
    return surface


def _ball_diagram(surface: pygame.Surface, box: pygame.Rect, aim: Aim, limit: float) -> None:
    centre, radius = box.center, box.width / 2
    pen.disc(surface, theme.IVORY, centre, radius)
    for x, y in ((1.0, 0.0), (0.0, 1.0)):
        a = (centre[0] - x * radius * MAX_OFFSET, centre[1] - y * radius * MAX_OFFSET)
        b = (centre[0] + x * radius * MAX_OFFSET, centre[1] + y * radius * MAX_OFFSET)
        pen.line(surface, (200, 196, 184), a, b, 1.0)
    if limit < 1.0:
        pen.ring(surface, (176, 170, 156), centre, radius * limit, 1.2)
    clean = math.hypot(aim.side, aim.height) <= limit
    tip = (centre[0] + aim.side * radius, centre[1] - aim.height * radius)
    pen.disc(surface, theme.CUE_TIP if clean else theme.WARNING, tip, radius * 0.2)


def _cue_diagram(surface: pygame.Surface, box: pygame.Rect, screen: Screen, aim: Aim, named: str) -> None:
    unit = screen.unit
    centre, radius = (screen.cue_ball_centre[0], box.bottom - unit * 2.5), unit * 1.5
    floor = centre[1] + radius
    pen.line(surface, theme.CLOTH, (box.left, floor), (box.right, floor), 2.0)
    tilt = math.radians(aim.elevation)
    ahead, up = (math.cos(tilt), math.sin(tilt)), (math.sin(tilt), -math.cos(tilt))
    # The tip's place on the ball, seen from the right-hand side of the shot; y grows downward here.
    start = (centre[0] - ahead[0] * radius + up[0] * aim.height * radius,
             centre[1] - ahead[1] * radius + up[1] * aim.height * radius)  # fmt: skip
    length = unit * (9.5 if aim.elevation < 40.0 else 7.0 - 2.0 * aim.elevation / MAX_ELEVATION)
    length *= 0.5 if named else 1.0
    label = f"{aim.elevation:.0f}\N{DEGREE SIGN}"
    # The butt ends below its figure, or beside it.
    wide, high = text.font(screen.small).size(label)
    beside, below = start[0] - box.left - wide - unit * 0.5, start[1] - box.top - high - unit * 0.4
    length = min(length, max(beside / max(ahead[0], 1e-9), below / max(up[0], 1e-9)))
    butt = (start[0] - ahead[0] * length, start[1] - ahead[1] * length)
    pen.disc(surface, theme.IVORY, centre, radius)
    pen.line(surface, theme.CUE_SHAFT, start, butt, unit * 0.45)
    pen.line(surface, theme.CUE_TIP, start, (start[0] - ahead[0] * 4, start[1] - ahead[1] * 4), unit * 0.45)
    place = text.draw(surface, label, screen.small, theme.QUIET, (box.left, box.top))
    if named:
        text.draw(surface, named, screen.small, theme.ACCENT, (place.right + unit, box.top))
