"""The table's picture behind everything, for any camera, kept sharp without holding up a frame."""

from __future__ import annotations

import math
import threading
from collections.abc import Hashable, Sequence
from concurrent.futures import Future

import pygame

from ...table.table import Table
from .. import theme
from ..view import View
from . import table_picture

# So many frames after the last change the picture begins to be drawn in full.
_REST = 8
# What is seen from nearer is cut out of a picture so many times as wide: as far as so many pixels go, within limits.
_NEAR, _NEAREST, _PIXELS = 1.5, 2.0, 6e6


class Background:
    """The table's picture: of the whole table, or a part cut out of a larger picture, drawn when it is needed."""

    def __init__(self) -> None:
        self._whole = _Whole()
        self._larger = _Painter()
        self._waiting = False
        # The surface filled last, and with what.
        self._filled: tuple[pygame.Surface, pygame.Surface] | None = None
        self._view: View | None = None
        self._seen: Hashable = None
        self._part = pygame.Surface((1, 1))

    @property
    def settled(self) -> bool:
        """Whether the picture is drawn in full."""
        return self._whole.settled and not self._waiting

    def show(
        self, surface: pygame.Surface, table: Table, home: View, view: View, over: Sequence[pygame.Rect] | None = None
    ) -> bool:
        """Fill the surface with the table as `view` has it; `home` is the view of the whole table.

        `over`: the surface still shows what was filled last, and all that was drawn since lies in these rectangles.
        Then only they are filled, unless the table's picture has changed. Returns whether only they were.
        """
        picture = self._picture(surface.get_size(), table, home, view)
        before, self._filled = self._filled, (surface, picture)
        if over is None or before is None or before[0] is not surface or before[1] is not picture:
            surface.blit(picture, (0, 0))
            return False
        surface.blits([(picture, box.topleft, box) for box in map(_askew, over)], False)
        return True

    def _picture(self, size: tuple[int, int], table: Table, home: View, view: View) -> pygame.Surface:
        whole = self._whole.take(table, size, home)
        moving, self._view = view != self._view, view
        self._waiting = False
        if view == home:
            return whole
        given = (whole, home)
        if self._whole.settled:
            times = min(max(_NEAR, math.sqrt(_PIXELS / (size[0] * size[1]))), _NEAREST)
            near = home.zoomed(times)
            large = self._larger.take(table, (round(size[0] * times), round(size[1] * times)), near)
            self._waiting = large is None or moving
            if large is not None:
                given = (large, near)
        seen = (given[0], view, moving)
        if seen != self._seen:
            if self._part.get_size() != size:
                self._part = pygame.Surface(size)
            _cut(*given, self._part, view, quick=moving)
            self._seen, self._filled = seen, None
        return self._part


def _askew(box: pygame.Rect) -> pygame.Rect:
    """The box, beginning at an odd pixel.

    SDL writes rows of pixels that begin at a multiple of 16 bytes past the processor's cache: good for a whole
    window, but several times slower for small parts that are drawn upon at once.
    """
    left = (box.left - 1) | 1
    return pygame.Rect(left, box.top, box.right - left, box.height)


class _Painter:
    """Draws a picture on a thread of its own, beside the loop; one at a time."""

    def __init__(self) -> None:
        self._made: Hashable = None
        self._picture: Future[pygame.Surface] | None = None

    def take(self, table: Table, size: tuple[int, int], view: View) -> pygame.Surface | None:
        """The picture as soon as it is drawn; until then None. Raises what drawing it has raised."""
        made = (table_picture.content(table), size, view)
        if made != self._made and (self._picture is None or self._picture.done()):
            self._made, self._picture = made, Future()
            threading.Thread(target=_paint, args=(self._picture, table, size, view), daemon=True).start()
        if made != self._made or self._picture is None or not self._picture.done():
            return None
        return self._picture.result()


def _paint(picture: Future[pygame.Surface], table: Table, size: tuple[int, int], view: View) -> None:
    try:
        # One strip at a time leaves the other processors to the loop.
        picture.set_result(table_picture.draw(table, size, view, workers=1))
    except Exception as error:
        picture.set_exception(error)


class _Whole:
    """The picture of the whole table; a quick, rough one while the window or the table is being changed."""

    def __init__(self) -> None:
        self._made: Hashable = None
        self._picture: pygame.Surface | None = None
        # The last one drawn in full, which is what gets stretched, and its view.
        self._full: tuple[pygame.Surface, View] | None = None
        self._painter = _Painter()
        self._resting = 0
        self.settled = False

    def take(self, table: Table, size: tuple[int, int], view: View) -> pygame.Surface:
        """The picture for this frame."""
        made = (table_picture.content(table), size, view)
        if made != self._made:
            self._change(table, size, view)
            self._made, self._resting = made, 0
        elif not self.settled:
            self._resting += 1
            if self._resting >= _REST and (picture := self._painter.take(table, size, view)):
                self._take(picture, view)
                # The lean one goes.
                self._painter = _Painter()
        assert self._picture is not None
        return self._picture

    def _change(self, table: Table, size: tuple[int, int], view: View) -> None:
        """Take a picture that is kept already, or a quick one until nothing changes any more."""
        ready = table_picture.kept(table, size, view) if self._picture else table_picture.draw(table, size, view)
        self.settled = False
        if ready:
            self._take(ready, view)
        elif self._full and isinstance(self._made, tuple) and self._made[0] == table_picture.content(table):
            self._picture = pygame.Surface(size)
            _cut(*self._full, self._picture, view)
        else:
            self._full = None
            self._picture = table_picture.window_copy(table_picture.draft(table, size, view))

    def _take(self, picture: pygame.Surface, view: View) -> None:
        self._picture = table_picture.window_copy(picture)
        self._full = (self._picture, view)
        self.settled = True


def _cut(picture: pygame.Surface, given: View, part: pygame.Surface, view: View, quick: bool = False) -> None:
    """Draw onto `part` what `view` shows of the table, scaled out of a picture that was drawn in the view `given`.

    A `quick` one is rough, for a picture that is seen for one frame.
    """
    factor = view.scale / given.scale
    left, top = given.to_screen(*view.to_table(0.0, 0.0))
    right, bottom = given.to_screen(*view.to_table(*map(float, part.get_size())))
    box = pygame.Rect(math.floor(left), math.floor(top), 0, 0)
    box.width, box.height = math.ceil(right) - box.left, math.ceil(bottom) - box.top
    box = box.clip(picture.get_rect())
    part.fill(theme.BACKGROUND)
    seen, to = picture.subsurface(box), (round(box.width * factor), round(box.height * factor))
    # Smooth scaling makes copies of its own of 24 bits, more than one.
    scaled = (
        pygame.transform.scale(seen, to) if quick else pygame.transform.smoothscale(table_picture.window_copy(seen), to)
    )
    part.blit(scaled, (round((box.left - left) * factor), round((box.top - top) * factor)))
