"""The legend of the arrows: which colour means what."""

from __future__ import annotations

import pygame

from ...draw import pen, text, theme
from ...draw.vectors import CUE, RISING, ROLL, SIDE, SINKING, SPEED
from ..screen import Screen
from ..wording.words import Words

LEGEND = ((SPEED, "speed"), (ROLL, "roll"), (SIDE, "side"), (CUE, "cue"))
UPRIGHT = ((RISING, "rising"), (SINKING, "sinking"))


def draw_legend(surface: pygame.Surface, words: Words, screen: Screen, flies: bool = False) -> pygame.Rect:
    """Draw the legend at the lower left, above the bar; returns its rectangle, in pixels.

    Rising and sinking are told where a ball of the shot `flies`.
    """
    legend = (*LEGEND, *UPRIGHT) if flies else LEGEND
    unit, size = screen.unit, screen.small
    pitch = text.font(size).get_linesize()
    lines = [(color, words.say(f"vectors.{name}")) for color, name in legend]
    width = max(text.font(size).size(name)[0] for _, name in lines) + 4 * unit
    plate = pygame.Surface((width, pitch * len(legend) + unit), pygame.SRCALPHA)
    pygame.draw.rect(plate, theme.PANEL, plate.get_rect(), border_radius=unit * 3 // 4)
    for i, (color, name) in enumerate(lines):
        y = unit / 2 + (i + 0.5) * pitch
        pen.line(plate, color, (unit, y), (unit * 5 / 2, y), unit / 4)
        text.draw(plate, name, size, theme.TEXT, (unit * 13 / 4, y), (0.0, 0.5))
    return surface.blit(plate, (unit // 2, screen.bottom.top - plate.get_height() - unit))
