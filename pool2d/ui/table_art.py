"""The table as a picture: frame, cushions, cloth, pockets and marks, to scale."""

from __future__ import annotations

import math

import numpy as np
import pygame

from ..outline import Point
from ..table import Table
from . import theme
from .view import FRAME, View

# Drawn this many times as large and scaled down: that smooths every edge.
_FINE = 2
# How wide the cushions are behind their noses, m (WPA: 1 7/8 to 2 in).
_CUSHION = 0.05


def draw(table: Table, size: tuple[int, int], view: View) -> pygame.Surface:
    """The table without balls, on a surface of `size` pixels."""
    fine = view.zoomed(_FINE)
    canvas = pygame.Surface((size[0] * _FINE, size[1] * _FINE))
    canvas.fill(theme.BACKGROUND)
    _frame(canvas, table, fine)
    pygame.draw.polygon(canvas, theme.CLOTH, _screen(table.geometry.outline, fine))
    _lamp(canvas, table, fine)
    _marks(canvas, table, fine)
    for pocket in table.geometry.pockets:
        centre = fine.to_screen(pocket.x, pocket.y)
        pygame.draw.circle(canvas, theme.COLLAR, centre, (pocket.radius + 0.012) * fine.scale)
        pygame.draw.circle(canvas, theme.HOLE, centre, pocket.radius * fine.scale)
    for front in table.geometry.cushions.values():
        shape = _screen(_trimmed(front), fine)
        pygame.draw.polygon(canvas, theme.CUSHION, shape)
        pygame.draw.lines(canvas, theme.NOSE, False, shape, max(2, round(0.004 * fine.scale)))
    picture = pygame.transform.smoothscale(canvas, size)
    return picture.convert() if pygame.display.get_surface() else picture


def _screen(points: tuple[Point, ...] | list[Point], view: View) -> list[Point]:
    return [view.to_screen(x, y) for x, y in points]


def _frame(canvas: pygame.Surface, table: Table, view: View) -> None:
    """The wooden rails, with diamonds, and their rounded corners."""
    size = table.knobs.table
    left, top = view.to_screen(-FRAME + 0.01, size.width + FRAME - 0.01)
    right, bottom = view.to_screen(size.length + FRAME - 0.01, -FRAME + 0.01)
    outer = pygame.Rect(round(left), round(top), round(right - left), round(bottom - top))
    round_corner = round(0.08 * view.scale)
    pygame.draw.rect(canvas, theme.WOOD_EDGE, outer, border_radius=round_corner)
    inset = round(0.006 * view.scale)
    pygame.draw.rect(canvas, theme.WOOD, outer.inflate(-2 * inset, -2 * inset), border_radius=round_corner - inset)
    sights = table.furniture.sights
    inset_m = table.furniture.sight_inset
    places = [(size.length * i / sights, side) for i in range(1, sights) for side in (-inset_m, size.width + inset_m)]
    across = sights // 2
    places += [(side, size.width * i / across) for i in range(1, across) for side in (-inset_m, size.length + inset_m)]
    for x, y in places:
        if all(math.hypot(x - pocket.x, y - pocket.y) > pocket.radius + 0.03 for pocket in table.geometry.pockets):
            diamond = [(x - 0.009, y), (x, y - 0.009), (x + 0.009, y), (x, y + 0.009)]
            pygame.draw.polygon(canvas, theme.SIGHT, _screen(diamond, view))


def _lamp(canvas: pygame.Surface, table: Table, view: View) -> None:
    """Brighter under the lamp, darker toward the rails."""
    size = table.knobs.table
    u = np.linspace(-1.1, 1.1, 64)[:, None]
    v = np.linspace(-1.1, 1.1, 32)[None, :]
    glow = np.clip(255.0 * (1.0 - 0.30 * np.clip(0.7 * u * u + 0.5 * v * v, 0.0, 1.0)), 0.0, 255.0).astype(np.uint8)
    shade = pygame.surfarray.make_surface(np.repeat(glow[..., None], 3, axis=2))
    corner = view.to_screen(-0.13, size.width + 0.13)
    extent = (round((size.length + 0.26) * view.scale), round((size.width + 0.26) * view.scale))
    # Only the cloth is lit; the frame is in the lamp's shade anyway.
    canvas.blit(pygame.transform.smoothscale(shade, extent), corner, special_flags=pygame.BLEND_RGB_MULT)


def _marks(canvas: pygame.Surface, table: Table, view: View) -> None:
    """The head string and the spots."""
    furniture, width = table.furniture, table.knobs.table.width
    if furniture.head_string is not None:
        start, end = (view.to_screen(furniture.head_string, y) for y in (0.0, width))
        pygame.draw.line(canvas, theme.MARK, start, end, max(2, round(0.002 * view.scale)))
    for x, y in furniture.spots.values():
        pygame.draw.circle(canvas, theme.MARK, view.to_screen(x, y), max(2.0, 0.005 * view.scale))


def _trimmed(front: tuple[Point, ...]) -> list[Point]:
    """A cushion's front with its facings cut where the cushion ends, `_CUSHION` behind the nose."""
    points = list(front)
    # The nose runs between the two innermost points: the middle of the list.
    (ax, ay), (bx, by) = points[len(points) // 2 - 1], points[len(points) // 2]
    length = math.hypot(bx - ax, by - ay)
    nx, ny = (by - ay) / length, -(bx - ax) / length
    for end, inner in ((0, 1), (-1, -2)):
        deep = (points[end][0] - ax) * nx + (points[end][1] - ay) * ny
        near = (points[inner][0] - ax) * nx + (points[inner][1] - ay) * ny
        if deep > _CUSHION > near:
            part = (_CUSHION - near) / (deep - near)
            points[end] = (
                points[inner][0] + part * (points[end][0] - points[inner][0]),
                points[inner][1] + part * (points[end][1] - points[inner][1]),
            )
    return points
