"""Smooth rounded rectangles, and the grounds of pages and panels that are made of them."""

from __future__ import annotations

from functools import lru_cache

import pygame

from . import theme
from .theme import Color

# Corners are drawn so many times larger, and then made smaller.
_FINE = 4


def rounded(
    surface: pygame.Surface, rect: pygame.Rect, color: Color | None, radius: int, edge: Color | None = None,
    width: int = 1,
) -> None:  # fmt: skip
    """Draw a rounded rectangle, filled with `color` and with an edge of so many pixels, or with one of both."""
    if rect.width > 0 and rect.height > 0:
        surface.blit(_picture(rect.size, color, radius, edge, width), rect)


def veil(surface: pygame.Surface) -> None:
    """Darken what is below a page or a question."""
    shade = pygame.Surface(surface.get_size(), pygame.SRCALPHA)
    shade.fill(theme.VEIL)
    surface.blit(shade, (0, 0))


def panel(surface: pygame.Surface, rect: pygame.Rect, unit: int) -> None:
    """The ground of a page, a panel or a question."""
    rounded(surface, rect, theme.PANEL, unit)


@lru_cache(maxsize=256)
def _picture(size: tuple[int, int], color: Color | None, radius: int, edge: Color | None, width: int) -> pygame.Surface:
    across, down = size
    radius = max(0, min(radius, across // 2, down // 2))
    image = pygame.Surface(size, pygame.SRCALPHA)
    if edge is not None:
        image.fill(edge, (radius, 0, across - 2 * radius, down))
        image.fill(edge, (0, radius, across, down - 2 * radius))
    inset = 0 if edge is None else width
    side = max(radius, inset)
    inner = _clear(color if color is not None else edge) if color is None else color
    image.fill(inner, (side, inset, across - 2 * side, down - 2 * inset))
    image.fill(inner, (inset, side, across - 2 * inset, down - 2 * side))
    if radius:
        disc = _disc(radius, color, edge, width)
        for x, y in ((0, 0), (1, 0), (0, 1), (1, 1)):
            place = (x * (across - radius), y * (down - radius))
            image.fill((0, 0, 0, 0), (*place, radius, radius))
            image.blit(disc, place, (x * radius, y * radius, radius, radius))
    return image


@lru_cache(maxsize=128)
def _disc(radius: int, color: Color | None, edge: Color | None, width: int) -> pygame.Surface:
    """The four corners, put together."""
    fine = _FINE * radius
    large = pygame.Surface((2 * fine, 2 * fine), pygame.SRCALPHA)
    # What is clear has the colour of what is beside it, or it would darken it when the two are mixed.
    large.fill(_clear(edge if edge is not None else color))
    if edge is not None:
        pygame.draw.circle(large, edge, (fine, fine), fine)
    inner = _clear(edge) if color is None else color
    pygame.draw.circle(large, inner, (fine, fine), fine - (0 if edge is None else _FINE * width))
    return pygame.transform.smoothscale(large, (2 * radius, 2 * radius))


def _clear(color: Color | None) -> Color:
    return (0, 0, 0, 0) if color is None else (color[0], color[1], color[2], 0)
