"""A study's outcome over two things that were swept, as a picture: a coloured cell for each pair of values."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import pygame

from ...physics.values import SHOT_RANGES
from ...study.findings import Axis, HeatMap
from .. import text, theme
from .ramp import colors

# Lengths in parts of the picture's height.
_LETTERS, _TITLE, _LEFT, _RIGHT, _TOP, _BOTTOM, _BAR = 0.026, 0.036, 0.16, 0.2, 0.12, 0.16, 0.035
# Values written along a side, at most.
_TICKS = 7
# Cells without a shot.
_EMPTY = (40, 42, 44)


def draw(heat: HeatMap, size: tuple[int, int]) -> pygame.Surface:
    """The map with its axes and what its colours mean."""
    pygame.font.init()
    picture = pygame.Surface(size)
    picture.fill(theme.BACKGROUND)
    width, height = size
    left, top = round(_LEFT * height), round(_TOP * height)
    area = pygame.Rect(left, top, width - left - round(_RIGHT * height), height - top - round(_BOTTOM * height))
    known = heat.mean[np.isfinite(heat.mean)]
    low, high = (float(known.min()), float(known.max())) if known.size else (0.0, 0.0)
    picture.blit(_cells(heat.mean, low, high, area.size), area)
    pygame.draw.rect(picture, theme.EDGE, area.inflate(2, 2), 1)
    title = text.fitted(heat.title, round(_TITLE * height), width - area.left)
    text.draw(picture, title, round(_TITLE * height), theme.TEXT, (area.left, top / 2.0), (0.0, 0.5))
    _label_x(picture, heat.x, area, height)
    _label_y(picture, heat.y, area, height)
    _bar(picture, low, high, area, height)
    return picture


def _cells(mean: npt.NDArray[np.float64], low: float, high: float, size: tuple[int, int]) -> pygame.Surface:
    """The cells, y up, each a rectangle of one colour."""
    span = (high - low) or 1.0
    known = np.isfinite(mean)
    shades = colors(np.where(known, (mean - low) / span, 0.0))
    pixels = np.where(known[..., None], shades, np.array(_EMPTY, np.uint8))
    return pygame.transform.scale(pygame.surfarray.make_surface(pixels[::-1].transpose(1, 0, 2)), size)


def _label_x(picture: pygame.Surface, axis: Axis, area: pygame.Rect, height: int) -> None:
    letters = round(_LETTERS * height)
    for part, value in _ticks(axis):
        across = area.left + part * area.width
        pygame.draw.line(picture, theme.QUIET, (across, area.bottom + 1), (across, area.bottom + letters // 3))
        text.draw(picture, value, letters, theme.TEXT, (across, area.bottom + 0.5 * letters), (0.5, 0.0))
    place = (area.centerx, area.bottom + 3.2 * letters)
    text.draw(picture, _name(axis), letters, theme.QUIET, place, (0.5, 0.5))


def _label_y(picture: pygame.Surface, axis: Axis, area: pygame.Rect, height: int) -> None:
    letters = round(_LETTERS * height)
    for part, value in _ticks(axis):
        level = area.bottom - part * area.height
        pygame.draw.line(picture, theme.QUIET, (area.left - letters // 3, level), (area.left - 2, level))
        text.draw(picture, value, letters, theme.TEXT, (area.left - 0.6 * letters, level), (1.0, 0.5))
    name = pygame.transform.rotate(text.picture(_name(axis), letters, theme.QUIET), 90.0)
    picture.blit(name, name.get_rect(center=(round(0.9 * letters), area.centery)))


def _bar(picture: pygame.Surface, low: float, high: float, area: pygame.Rect, height: int) -> None:
    """What the colours mean, beside the map."""
    letters = round(_LETTERS * height)
    bar = pygame.Rect(area.right + letters, area.top, round(_BAR * height), area.height)
    shades = _cells(np.linspace(0.0, 1.0, 256)[:, None], 0.0, 1.0, bar.size)
    if high > low:
        picture.blit(shades, bar)
    else:
        picture.fill(colors(np.zeros(1))[0].tolist(), bar)
    for part, value in ((0.0, low), (0.5, (low + high) / 2.0), (1.0, high)):
        place = (bar.right + 0.5 * letters, bar.bottom - part * bar.height)
        if high > low or part == 0.5:
            text.draw(picture, _said(value, high - low), letters, theme.TEXT, place, (0.0, 0.5))


def _ticks(axis: Axis) -> list[tuple[float, str]]:
    """Some of an axis's values at even steps, each with its place from 0 to 1 along the axis."""
    count = len(axis.values)
    least = max(1, math.ceil((count - 1) / (_TICKS - 1)))
    # A step that also meets the last value, if one is near.
    step = next((step for step in range(least, 2 * least) if (count - 1) % step == 0), least)
    return [((i + 0.5) / count, f"{axis.values[i]:.4g}") for i in range(0, count, step)]


def _said(value: float, span: float) -> str:
    """A value to a hundredth of the span that it lies in."""
    return f"{value:.3g}" if span <= 0.0 else f"{round(value, 2 - math.floor(math.log10(span))):.6g}"


def _name(axis: Axis) -> str:
    unit = SHOT_RANGES[axis.name][2].strip()
    return f"{axis.name}, {unit}" if unit else f"{axis.name}, in radii"
