"""The table as a picture: frame, cushions, cloth, pockets and marks, to scale, for any outline."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pygame

from ..outline import Corner, Point, edges, sides
from ..table import Table
from . import theme
from .view import FRAME, View

# Drawn this many times as large and scaled down: that smooths every edge.
_FINE = 2
# How wide the cushions are behind their noses, m (WPA: 1 7/8 to 2 in).
_CUSHION = 0.05
# The rounding of the frame's corners, m.
_ROUND = 0.08


def draw(table: Table, size: tuple[int, int], view: View) -> pygame.Surface:
    """The table without balls, on a surface of `size` pixels."""
    fine = view.zoomed(_FINE)
    canvas = pygame.Surface((size[0] * _FINE, size[1] * _FINE))
    canvas.fill(theme.BACKGROUND)
    _frame(canvas, table, fine)
    _sights(canvas, table, fine)
    pygame.draw.polygon(canvas, theme.CLOTH, _screen(table.geometry.outline, fine))
    _lamp(canvas, table, fine)
    _marks(canvas, table, fine)
    for pocket in table.geometry.pockets:
        centre = fine.to_screen(pocket.x, pocket.y)
        pygame.draw.circle(canvas, theme.COLLAR, centre, (pocket.radius + 0.012) * fine.scale)
        pygame.draw.circle(canvas, theme.HOLE, centre, pocket.radius * fine.scale)
    _cushions(canvas, table, fine)
    picture = pygame.transform.smoothscale(canvas, size)
    return picture.convert() if pygame.display.get_surface() else picture


def _screen(points: Sequence[Point], view: View) -> list[Point]:
    return [view.to_screen(x, y) for x, y in points]


def _frame(canvas: pygame.Surface, table: Table, view: View) -> None:
    """The wooden rails along every side, rounded at the corners."""
    inset = 0.006
    core = _screen(_grown(table.geometry.corners, FRAME - 0.01 - _ROUND), view)
    for color, radius in ((theme.WOOD_EDGE, _ROUND), (theme.WOOD, _ROUND - inset)):
        pygame.draw.polygon(canvas, color, core)
        for a, b in zip(core, [*core[1:], core[0]], strict=True):
            _band(canvas, color, a, b, radius * view.scale)
            pygame.draw.circle(canvas, color, a, radius * view.scale)


def _band(canvas: pygame.Surface, color: theme.Color, a: Point, b: Point, half: float) -> None:
    """A straight band from a to b, `half` as wide to either side."""
    length = math.dist(a, b)
    ox, oy = (a[1] - b[1]) / length * half, (b[0] - a[0]) / length * half
    corners = [(a[0] + ox, a[1] + oy), (b[0] + ox, b[1] + oy), (b[0] - ox, b[1] - oy), (a[0] - ox, a[1] - oy)]
    pygame.draw.polygon(canvas, color, corners)


def _grown(corners: Sequence[Corner], by: float) -> list[Point]:
    """The outline's corners moved outward, so that every side lies `by` further out."""
    grown = []
    for i, here in enumerate(corners):
        (ax, ay), (bx, by_) = (
            _outward(*edge) for edge in ((corners[i - 1], here), (here, corners[(i + 1) % len(corners)]))
        )
        far = by / (1.0 + ax * bx + ay * by_)
        grown.append((here.x + far * (ax + bx), here.y + far * (ay + by_)))
    return grown


def _outward(a: Corner, b: Corner) -> Point:
    """The unit vector out of the table from the edge between two corners."""
    length = math.hypot(b.x - a.x, b.y - a.y)
    return (b.y - a.y) / length, (a.x - b.x) / length


def _sights(canvas: pygame.Surface, table: Table, view: View) -> None:
    """The diamonds: as far apart on every side as the preset divides the length, clear of the pockets."""
    furniture = table.furniture
    if not furniture.sights:
        return
    pitch = table.knobs.table.length / furniture.sights
    for a, b in sides(table.geometry.corners):
        (nx, ny), length = _outward(a, b), math.hypot(b.x - a.x, b.y - a.y)
        parts = max(1, round(length / pitch))
        for i in range(1, parts):
            x = a.x + (b.x - a.x) * i / parts + nx * furniture.sight_inset
            y = a.y + (b.y - a.y) * i / parts + ny * furniture.sight_inset
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
    # Beside a table that does not fill its box there is nothing to be in the shade.
    canvas.fill(theme.BACKGROUND, special_flags=pygame.BLEND_RGB_MAX)


def _marks(canvas: pygame.Surface, table: Table, view: View) -> None:
    """The head string as far as there is cloth, the D behind it, and the spots."""
    furniture = table.furniture
    thin = max(2, round(0.002 * view.scale))
    if furniture.head_string is not None:
        x = furniture.head_string
        crossed = sorted(
            a.y + (x - a.x) * (b.y - a.y) / (b.x - a.x)
            for a, b in edges(table.geometry.corners)
            if (a.x > x) != (b.x > x)
        )
        for start, end in zip(crossed[::2], crossed[1::2], strict=True):
            pygame.draw.line(canvas, theme.MARK, view.to_screen(x, start), view.to_screen(x, end), thin)
        if furniture.d_radius > 0.0:
            _d(canvas, x, table.knobs.table.width / 2.0, furniture.d_radius, thin, view)
    for x, y in furniture.spots.values():
        pygame.draw.circle(canvas, theme.MARK, view.to_screen(x, y), max(2.0, 0.005 * view.scale))


def _d(canvas: pygame.Surface, x: float, y: float, radius: float, thin: int, view: View) -> None:
    """The half circle behind the baulk line."""
    angles = (math.pi * (0.5 + i / 64) for i in range(65))
    points = [(x + radius * math.cos(angle), y + radius * math.sin(angle)) for angle in angles]
    pygame.draw.lines(canvas, theme.MARK, False, _screen(points, view), thin)


def _cushions(canvas: pygame.Surface, table: Table, view: View) -> None:
    """Each cushion, `_CUSHION` wide behind its nose, mitred where it meets another without a pocket."""
    corners = table.geometry.corners
    backs = _grown(corners, _CUSHION)
    for i, (a, b) in enumerate(edges(corners)):
        front = list(table.geometry.cushions[a.cushion])
        normal = _outward(a, b)
        front = _cut(front, a, normal) if a.pocket else [backs[i], *front]
        front = _cut(front[::-1], a, normal)[::-1] if b.pocket else [*front, backs[(i + 1) % len(backs)]]
        pygame.draw.polygon(canvas, theme.CUSHION, _screen(front, view))
        nose = front[0 if a.pocket else 1 : None if b.pocket else -1]
        pygame.draw.lines(canvas, theme.NOSE, False, _screen(nose, view), max(2, round(0.004 * view.scale)))


def _cut(front: list[Point], corner: Corner, normal: Point) -> list[Point]:
    """A front that begins with a facing, from where that is as deep behind the nose as the cushion is."""
    depths = [(x - corner.x) * normal[0] + (y - corner.y) * normal[1] for x, y in front]
    first = next(i for i, depth in enumerate(depths) if depth < _CUSHION)
    if first == 0:
        return front
    (ax, ay), (bx, by) = front[first - 1 : first + 1]
    part = (_CUSHION - depths[first]) / (depths[first - 1] - depths[first])
    return [(bx + part * (ax - bx), by + part * (ay - by)), *front[first:]]
