"""What every screen of the game is: it takes events, lets time pass, and draws itself."""

from __future__ import annotations

from typing import Protocol

import pygame

# A key that skipped a shot and is pressed again does nothing else so soon after the balls have come to rest, s.
GUARD = 0.35
# The parts of a window that have changed, in pixels; None where anything may have.
Boxes = list[pygame.Rect] | None


class Scene(Protocol):
    """A screen. The next state is the return value: a scene returns itself, another, or None to quit."""

    @property
    def still(self) -> bool:
        """Whether it would look the same at the next frame, unless an event comes."""
        ...

    def handle(self, event: pygame.event.Event) -> Scene | None:
        """Take one event."""
        ...

    def update(self, dt: float) -> Scene | None:
        """Let `dt` seconds pass."""
        ...

    def draw(self, surface: pygame.Surface, kept: bool = False) -> Boxes:
        """Draw the whole window. `kept` says that it still shows what this scene has drawn last, and no more.

        Returns where it has changed, which is all that has to be presented.
        """
        ...
