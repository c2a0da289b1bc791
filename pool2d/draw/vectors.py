"""Arrows on the balls: how fast they go, how they spin, how fast they rise or sink, and where the cue points."""

from __future__ import annotations

import math

import pygame

from ..physics.values import Ball, Layout, Shot
from ..table.table import Table
from . import pen, theme
from .view import View

# An arrow's length beyond the ball, m for each m/s, and how long it may be, m.
_PER_SPEED = 0.1
_LONGEST = 0.9
# An arc's turn about the ball, degrees for each rad/s, and how far it may go.
_PER_SPIN = 3.0
_FURTHEST = 300.0
# Below these nothing is drawn, m/s.
_STILL = 0.01

SPEED = (250, 250, 246)
ROLL = (255, 150, 84)
SIDE = (126, 214, 255)
CUE = (255, 222, 110)
RISING = (176, 232, 128)
SINKING = (236, 150, 206)


def draw(surface: pygame.Surface, layout: Layout, table: Table, view: View) -> None:
    """Draw the arrows of every ball that moves or spins."""
    for ball in layout.on_table():
        radius = table.body_of(ball)[0]
        _arrow(surface, SPEED, ball, ball.vx, ball.vy, radius, view, 2.4)
        # The way the spin along the cloth would carry the ball: equal to the speed where it rolls.
        roll_x, roll_y = radius * ball.wy, -radius * ball.wx
        _arrow(surface, ROLL, ball, roll_x, roll_y, radius, view, 1.4)
        _axis(surface, ball, roll_x, roll_y, radius, view)
        _arc(surface, ball, radius * ball.wz, radius, view)
        _upright(surface, ball, radius, view)


def draw_cue(surface: pygame.Surface, ball: Ball, shot: Shot, table: Table, view: View) -> None:
    """Draw the cue's direction and speed, on the line that its tip takes."""
    radius = table.body_of(ball)[0]
    angle = math.radians(shot.angle)
    cos, sin = math.cos(angle), math.sin(angle)
    tip = ball._replace(x=ball.x + shot.side * radius * sin, y=ball.y - shot.side * radius * cos)
    _arrow(surface, CUE, tip, shot.speed * cos, shot.speed * sin, radius, view, 1.6)


def _arrow(
    surface: pygame.Surface, color: theme.Color, ball: Ball, vx: float, vy: float, radius: float, view: View,
    width: float,
) -> None:  # fmt: skip
    """An arrow out of the ball for a speed (vx, vy)."""
    speed = math.hypot(vx, vy)
    if speed < _STILL:
        return
    ux, uy = vx / speed, vy / speed
    length = radius + min(_PER_SPEED * speed, _LONGEST)
    thick = width * _thickness(view)
    _head(surface, color, view.to_screen(ball.x, ball.y),
          view.to_screen(ball.x + ux * length, ball.y + uy * length), thick)  # fmt: skip


def _head(surface: pygame.Surface, color: theme.Color, a: pen.Point, b: pen.Point, thick: float) -> None:
    """A line from a to b with a head at b."""
    length = math.dist(a, b)
    size = min(2.0 + 2.6 * thick, 0.7 * length)
    ux, uy = (b[0] - a[0]) / length, (b[1] - a[1]) / length
    neck = (b[0] - ux * size, b[1] - uy * size)
    pen.line(surface, color, a, neck, thick)
    wide = 0.55 * size
    pen.polygon(surface, color, [b, (neck[0] - uy * wide, neck[1] + ux * wide),
                                 (neck[0] + uy * wide, neck[1] - ux * wide)])  # fmt: skip


def _axis(surface: pygame.Surface, ball: Ball, roll_x: float, roll_y: float, radius: float, view: View) -> None:
    """Draw the axis of a ball's roll, horizontal spin in m/s at the rim, as a bar across it."""
    speed = math.hypot(roll_x, roll_y)
    if speed < _STILL:
        return
    ax, ay = -roll_y / speed * 1.3 * radius, roll_x / speed * 1.3 * radius
    ends = view.to_screen(ball.x - ax, ball.y - ay), view.to_screen(ball.x + ax, ball.y + ay)
    pen.line(surface, ROLL, *ends, 1.2 * _thickness(view))


def _arc(surface: pygame.Surface, ball: Ball, side: float, radius: float, view: View) -> None:
    """Draw the spin about the vertical, m/s at the rim, as an arc round the ball in its sense as seen from above."""
    if abs(side) < _STILL:
        return
    sweep = math.radians(min(max(_PER_SPIN * abs(side) / radius, 40.0), _FURTHEST))
    sense = math.copysign(1.0, side)
    count = max(4, round(math.degrees(sweep) / 10.0))
    points = []
    for i in range(count + 1):
        angle = math.pi / 2.0 + sense * sweep * i / count
        points.append(view.to_screen(ball.x + 1.5 * radius * math.cos(angle), ball.y + 1.5 * radius * math.sin(angle)))
    thick = 1.4 * _thickness(view)
    pen.paths(surface, [pen.Path(SIDE, points[:-1], thick)])
    _head(surface, SIDE, points[-2], _beyond(points[-2], points[-1], 1.0 + 2.0 * thick), thick)


def _upright(surface: pygame.Surface, ball: Ball, radius: float, view: View) -> None:
    """Draw a speed upward or downward: seen from above an arrow is its point, a dot, or its feathers, a cross.

    The ring round it is as far out from the ball as an arrow for that speed would reach.
    """
    if abs(ball.vz) < _STILL:
        return
    color = RISING if ball.vz > 0.0 else SINKING
    centre, thick = view.to_screen(ball.x, ball.y), 1.6 * _thickness(view)
    out = (radius + min(_PER_SPEED * abs(ball.vz), _LONGEST)) * view.scale
    pen.ring(surface, color, centre, out, thick)
    size = 0.45 * radius * view.scale
    if ball.vz > 0.0:
        pen.disc(surface, color, centre, 0.6 * size)
        return
    for side in (-1.0, 1.0):
        a, b = (centre[0] - size, centre[1] - side * size), (centre[0] + size, centre[1] + side * size)
        pen.line(surface, color, a, b, thick)


def _beyond(a: pen.Point, b: pen.Point, by: float) -> pen.Point:
    """The point `by` pixels past b, coming from a."""
    length = max(math.dist(a, b), 1e-6)
    return b[0] + (b[0] - a[0]) / length * by, b[1] + (b[1] - a[1]) / length * by


def _thickness(view: View) -> float:
    """How much thicker lines are drawn where the table is seen large."""
    return min(max(1.0, view.scale / 400.0), 2.0)
