"""Balls drawn as lit spheres, turned as they have rolled, at any radius, placed to a quarter of a pixel."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from functools import lru_cache
from typing import NamedTuple

import pygame

from ...physics.orientation import FACING, Quaternion
from ...physics.values import Ball
from ...table.furniture import Look
from ...table.table import Table
from .. import theme
from ..theme import BALLS, IVORY, Style
from ..view import View
from . import ball_skin
from .ball_light import STEPS, light, place, shadow, shadow_of
from .ball_paint import Coat
from .ball_sprite import LEVELS, LIT, Sprite, render

# What a faint ball takes away of what is behind it, of 255.
_FAINT = 110
# How high above the cloth the eye is to which a ball that flies looks larger, m: lower than any real one, so that a hop
# of a few centimetres is seen; and from which height on balls look no larger.
_EYE, _HIGHEST = 0.8, 0.4
# How high a ball has all the light that it gets, in its radii; and into how many steps a radius of height is cut for
# shadows.
_BRIGHTEST, _HEIGHTS = 8.0, 4
# From which height on, in radii, a shadow grows no softer; and into how many steps a pixel is cut for the size of a
# ball in the air.
_SOFTEST, _SIZES = 6.0, 2


class Placed(NamedTuple):
    """A ball to be drawn: its look, centre and radius in pixels, and orientation.

    `alpha` from 0, unseen, to 255, solid. `shadow` asks for a shadow on the cloth, which a ball in a tray has not.
    One that is not `fine` is drawn faster and a little rougher: for a ball that moves and is seen for one frame
    only. A ball off the cloth is drawn `nearer` times as large; `height` is that of its lowest point above what is
    below it, in pixels: so far its shadow parts from it, and the more light it has.
    """

    look: Look
    centre: tuple[float, float]
    radius: float
    orientation: Quaternion = FACING
    alpha: int = 255
    shadow: bool = True
    fine: bool = True
    nearer: float = 1.0
    height: float = 0.0


# Pictures painted before, the latest last. Like a function's cache, it changes no picture.
_drawn: dict[Sprite, pygame.Surface] = {}
_KEPT = 512
# Balls painted together: more need memory that has to be fetched anew each time, fewer cost more calls. What is
# only looked up needs little.
_BATCH = {True: 8, False: 32}


def draw(
    surface: pygame.Surface,
    ball: str,
    centre: tuple[float, float],
    radius: float,
    faint: bool = False,
    look: Look | None = None,
    orientation: Quaternion = FACING,
    style: Style = theme.PLAIN,
) -> None:
    """Draw one ball and its shadow, at `centre` with `radius`, in pixels.

    `faint` is for a ball that is not really there, such as the guide's ghost ball. Without a `look`, a ball whose
    id is a number looks like that ball of a pool set, and any other like a cue ball.
    """
    alpha = _FAINT if faint else 255
    draw_all(surface, [Placed(look or usual(ball), centre, radius, orientation, alpha, not faint)], style)


def draw_all(surface: pygame.Surface, balls: Iterable[Placed], style: Style = theme.PLAIN) -> list[pygame.Rect]:
    """Draw balls, later ones over earlier ones, all above their shadows.

    Returns the rectangles, in pixels, in which it has drawn.
    """
    shadows, sprites, corners = [], [], []
    for ball in balls:
        lies, radius = _radii(ball)
        aloft = radius != lies
        # Of each size on its way there is one picture, put to a whole pixel: nobody sees in one frame that it is.
        x, y, step = place((round(ball.centre[0]), round(ball.centre[1])) if aloft else ball.centre)
        if ball.shadow:
            shadows.append(_shadow(ball))
        level = round(ball.alpha * LEVELS / 255.0)
        # A rough picture is not looked for again.
        # Nor is a skin worth making for a size that passes.
        fine = ball.fine or aloft
        orientation = _rounded(ball.orientation, radius) if fine else ball.orientation
        lit = round(min(max(0.0, ball.height / ball.radius) / _BRIGHTEST, 1.0) * LIT)
        sprites.append(Sprite(Coat(ball.look, style), radius, step, orientation, level, fine, lit))
        half = light(radius).half
        corners.append((x - half, y - half))
    # The type allows for none being returned.
    return surface.blits([*shadows, *zip(_images(sprites), corners, strict=True)]) or []


def _shadow(ball: Placed) -> tuple[pygame.Surface, tuple[int, int]]:
    """The shadow of a ball, and its top left corner; below a ball that flies it is as large as if it lay there."""
    radius, height = _radii(ball)[0], max(0.0, ball.height)
    soft = round(min(height / radius, _SOFTEST) * _HEIGHTS) / _HEIGHTS
    x, y = ball.centre
    if soft > 0.0:
        # It has no edge by which to see that it lies on a whole pixel.
        aside, below = shadow_of(height)
        x, y = round(x + aside), round(y + below)
    left, top, step = place((x, y))
    shade, right, down = shadow(radius, step, soft)
    return shade, (left + right, top + down)


def _radii(ball: Placed) -> tuple[float, float]:
    """The radius of a ball, rounded to parts of a pixel, as it lies and as it looks in the air."""
    lies = max(1.0, round(ball.radius * STEPS) / STEPS)
    return lies, lies + round(_SIZES * ball.radius * (ball.nearer - 1.0)) / _SIZES


def placed_on(table: Table, view: View, ball: Ball, orientation: Quaternion) -> Placed:
    """A ball of a table to be drawn where it is, as a view shows it."""
    centre, radius = view.to_screen(ball.x, ball.y), table.body_of(ball)[0] * view.scale
    placed = Placed(look_of(table, ball.id), centre, radius, orientation)
    if ball.z == 0.0:
        return placed
    height = ball.z - table.ground(ball.x, ball.y)
    return placed._replace(nearer=_nearer(ball.z), height=height * view.scale, shadow=height >= 0.0)


def from_below(balls: Iterable[Ball]) -> list[Ball]:
    """Balls in the order in which they are drawn: higher ones lie over lower ones."""
    return sorted(balls, key=lambda ball: ball.z)


def _nearer(z: float) -> float:
    """How many times as large a ball at a height of `z` m looks, to an eye `_EYE` m above the cloth."""
    return _EYE / (_EYE - min(z, _HIGHEST))


def ghost_of(table: Table, view: View, ball: Ball) -> Placed:
    """A ball that is not really there, such as where one would come to rest: faint, and without a shadow.

    It is put to a whole pixel: so one picture does wherever an aim that turns moves it.
    """
    x, y = view.to_screen(ball.x, ball.y)
    return placed_on(table, view, ball, FACING)._replace(centre=(round(x), round(y)), alpha=_FAINT, shadow=False)


def look_of(table: Table, ball: str) -> Look:
    """The look of a ball on a table, by its id: as the preset describes it, or the usual one."""
    return table.furniture.looks.get(ball) or usual(ball)


@lru_cache(maxsize=256)
def usual(ball: str) -> Look:
    """The look of a ball whose preset does not describe it: by its number, or as a cue ball."""
    number = int(ball) if ball.isdecimal() and len(ball) < 4 else 0
    if number == 0:
        return Look(_hex(IVORY), dots=True)
    color = BALLS.get(number if number <= 8 else number - 8, (150, 150, 150))
    return Look(_hex(color), stripe=number > 8, number=ball)


def _hex(color: tuple[int, ...]) -> str:
    return "#" + bytes(color[:3]).hex()


def _rounded(orientation: Quaternion, radius: float) -> Quaternion:
    """The orientation rounded, so that pictures can be reused: neighbours differ by a quarter of a pixel at the rim.

    The quaternion is not of unit length.
    """
    w, x, y, z = orientation
    fine = math.copysign(8.0 * radius, w)
    return round(w * fine), round(x * fine), round(y * fine), round(z * fine)


def _images(sprites: Sequence[Sprite]) -> list[pygame.Surface]:
    """The pictures of sprites; those that are not remembered are drawn together, by radius and fineness."""
    # One that is good for a moment only is hardly ever wanted again.
    images = [_drawn.get(sprite) if sprite.fine else None for sprite in sprites]
    missing: dict[tuple[float, bool], list[int]] = {}
    made = 0
    for i, (sprite, image) in enumerate(zip(sprites, images, strict=True)):
        if image is None:
            fine = sprite.fine
            if not fine and not ball_skin.known(sprite.coat, sprite.radius):
                # One new skin at a time holds nothing up; until it has one, a ball is painted.
                made += 1
                fine = made > 1
            missing.setdefault((sprite.radius, fine), []).append(i)
    for (_, fine), group in missing.items():
        for start in range(0, len(group), _BATCH[fine]):
            batch = group[start : start + _BATCH[fine]]
            for i, image in zip(batch, render([sprites[i] for i in batch], fine), strict=True):
                images[i] = image
                if sprites[i].fine:
                    _drawn[sprites[i]] = image
    while len(_drawn) > _KEPT:
        del _drawn[next(iter(_drawn))]
    return [image for image in images if image is not None]
