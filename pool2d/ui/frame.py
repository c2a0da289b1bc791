"""One picture of the window: the surface that is drawn on, and what of it has changed."""

from __future__ import annotations

from collections.abc import Iterable

import pygame

Boxes = list[pygame.Rect] | None


class Frame:
    """What scenes draw on. Boxes are in pixels; None in place of them stands for the whole surface.

    `before` is where the last frame has drawn over what lies below, such as the table: the rest of the surface still
    shows that. `changed` is where this frame differs from the last, which is all that has to be presented. A frame
    counts as drawn in whole unless the scene says otherwise by `begin_over`, so that one that knows nothing of this is
    safe. `over` is where this frame has drawn over what lies below, so far.
    """

    def __init__(self, surface: pygame.Surface) -> None:
        self.surface = surface
        self.before: Boxes = None
        self.changed: Boxes = None
        self.over: Boxes = None

    @property
    def size(self) -> tuple[int, int]:
        return self.surface.get_size()

    def begin(self) -> None:
        """Begin the next frame on the same surface."""
        self.before, self.over, self.changed = self.over, None, None

    def forget(self) -> None:
        """The surface may show anything: the next frame is to be drawn in whole."""
        self.over = None

    def begin_over(self, cleared: bool) -> None:
        """What lies below is there, and all that is drawn over it from now on will be told by `add`.

        `cleared` says that only the boxes `before` had to be drawn for that; else all of it was.
        """
        self.over = []
        self.changed = list(self.before) if cleared and self.before is not None else None

    def add(self, boxes: Iterable[pygame.Rect]) -> None:
        """Something was drawn in these boxes that is to be cleared for the next frame."""
        if self.over is not None:
            boxes = list(boxes)
            self.over += boxes
            self.replace(boxes)

    def replace(self, boxes: Iterable[pygame.Rect]) -> None:
        """Something was drawn in these boxes that needs no clearing: it stays, or what comes next covers it."""
        if self.changed is not None:
            self.changed += boxes

    def cover(self) -> None:
        """Something was drawn that may be anywhere."""
        self.over = self.changed = None
