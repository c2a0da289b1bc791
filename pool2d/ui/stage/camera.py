"""The camera: how near the table is seen and which part of it, by zoom and pan."""

from __future__ import annotations

import math
from collections.abc import Callable

import pygame

from ...draw.view import FRAME, View

MAX_ZOOM = 4.0
# One notch of the wheel, and one press of a key.
_NOTCH = 1.2
# How far one press of a key moves the view, as a part of what is seen.
_LOOK = 0.125
# In this time, s, the camera has come about two thirds of its way.
_EASE = 0.05

Area = tuple[int, int, int, int]
Pos = tuple[int, int]


class Camera:
    """What part of the table shows in an area of the window, (left, top, width, height) in pixels.

    `home` is the view of the whole table, `target` where the camera is going, `view` where it is now: each a
    `View`. `view` glides along the straight line to `target`, so what a zoom keeps under the pointer stays there
    all the way. `keys` are the camera's actions by name.
    """

    def __init__(self) -> None:
        self.home = self.target = self.view = View(1.0, 0.0, 0.0)
        self._area: Area = (0, 0, 1, 1)
        self._size = (1.0, 1.0)
        self._pointer: Pos | None = None
        self._grip: Pos | None = None
        self.keys: dict[str, Callable[[], None]] = {
            "nearer": lambda: self.zoom(1.0),
            "farther": lambda: self.zoom(-1.0),
            "look_left": lambda: self._look(-_LOOK, 0.0),
            "look_right": lambda: self._look(_LOOK, 0.0),
            "look_up": lambda: self._look(0.0, -_LOOK),
            "look_down": lambda: self._look(0.0, _LOOK),
            "whole_table": self.reset,
        }

    @property
    def settled(self) -> bool:
        """Whether the camera has reached its target."""
        return self.view == self.target

    def fit(self, home: View, size: tuple[float, float], area: Area) -> None:
        """Take `home`, the view of a whole table of `size` m, and the area of the window, in pixels.

        Where they differ from before, the zoom and the point in the middle are kept.
        """
        if (home, size, area) == (self.home, self._size, self._area):
            return
        zoom, middle = self.target.scale / self.home.scale, self.target.to_table(*_middle(self._area))
        fresh = size != self._size
        self.home, self._size, self._area = home, size, area
        self.target = home
        if not fresh and zoom > 1.0:
            self._go(home.scale * zoom, *middle, *_middle(area))
        self.view = self.target

    def handle(self, event: pygame.event.Event, mod: int) -> bool:
        """Zoom by Ctrl and the wheel, pan by the middle button; returns whether the camera had a use for the event."""
        if event.type == pygame.MOUSEMOTION:
            self._pointer = event.pos
            if self._grip is None:
                return False
            self.pan(event.pos[0] - self._grip[0], event.pos[1] - self._grip[1])
            self.view = self.target
            self._grip = event.pos
        elif event.type == pygame.MOUSEWHEEL and mod & (pygame.KMOD_CTRL | pygame.KMOD_META):
            self.zoom(event.y)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 2:
            self._grip = event.pos
        elif event.type == pygame.MOUSEBUTTONUP and event.button == 2:
            self._grip = None
        else:
            return False
        return True

    def let_go(self) -> None:
        """Forget a drag."""
        self._grip = None

    def zoom(self, notches: float) -> None:
        """Zoom in by so many notches of the wheel, out where negative, about the pointer, or the middle without one."""
        left, top, width, height = self._area
        at = _middle(self._area)
        if self._pointer is not None and pygame.Rect(left, top, width, height).collidepoint(self._pointer):
            at = (float(self._pointer[0]), float(self._pointer[1]))
        scale = self.target.scale * math.pow(_NOTCH, notches)
        self._go(scale, *self.target.to_table(*at), *at)

    def pan(self, dx: float, dy: float) -> None:
        """Move the table by so many pixels on the screen."""
        self._go(self.target.scale, *self.target.to_table(0.0, 0.0), dx, dy)

    def reset(self) -> None:
        """Show the whole table."""
        self.target = self.home

    def update(self, dt: float, eased: bool) -> None:
        """Let `dt` s pass: the view glides toward its target, or without `eased` is there at once."""
        if self.view == self.target:
            return
        part = 1.0 - math.exp(-dt / _EASE)
        here, there = self.view, self.target
        self.view = View(
            here.scale + part * (there.scale - here.scale),
            here.left + part * (there.left - here.left),
            here.bottom + part * (there.bottom - here.bottom),
        )
        far = max(abs(self.view.left - there.left), abs(self.view.bottom - there.bottom))
        if not eased or far + abs(self.view.scale - there.scale) < 0.5:
            self.view = there

    def _look(self, right: float, down: float) -> None:
        """Move the view by a part of the area's width to the right and of its height down."""
        self.pan(-right * self._area[2], -down * self._area[3])

    def _go(self, scale: float, x: float, y: float, px: float, py: float) -> None:
        """Head for a scale, pixels per m, with the table's point (x, y) at the pixel (px, py), within bounds."""
        scale = min(max(scale, self.home.scale), MAX_ZOOM * self.home.scale)
        left, top, width, height = self._area
        across = _within(px - x * scale, left, width, self._size[0] * scale, FRAME * scale)
        down = _within(py + y * scale - self._size[1] * scale, top, height, self._size[1] * scale, FRAME * scale)
        self.target = View(scale, across, down + self._size[1] * scale)


def _within(start: float, low: float, room: float, size: float, margin: float) -> float:
    """Where the picture of the table may start along one axis, in pixels, if it would start at `start`.

    With its margins it has to fill the room from `low` on; where it is too small for that, it is put in the middle.
    """
    if size + 2.0 * margin <= room:
        return low + (room - size) / 2.0
    return min(max(start, low + room - size - margin), low + margin)


def _middle(area: Area) -> tuple[float, float]:
    return area[0] + area[2] / 2.0, area[1] + area[3] / 2.0
