"""What every screen of the game is: it takes events, lets time pass, and draws itself."""

from __future__ import annotations

from enum import Enum, auto

import pygame

from ..table.table import Table
from .frame import Frame
from .wording.words import Words

# A key that skipped a shot and is pressed again does nothing else so soon after the balls have come to rest, s.
GUARD = 0.35


class Scene:
    """A screen. The next state is the return value: a scene returns itself, another, or None to quit.

    `words` is what it says things by, the app's; a scene over another has it from that. What is below says what a scene
    allows and needs; each class overrides what is otherwise with it.
    """

    words: Words

    @property
    def still(self) -> bool:
        """Whether it would look the same at the next frame, unless an event comes."""
        return False

    @property
    def opens_pages(self) -> bool:
        """Whether a key may open a page over it: the options, the drills, the help."""
        return False

    @property
    def takes_text(self) -> bool:
        """Whether keys are for a text or a binding at present, whatever else they mean."""
        return False

    @property
    def table(self) -> Table | None:
        """The table that is seen, after which the window is named; None where there is none."""
        return None

    @property
    def bottom(self) -> Scene:
        """What lies below all pages and questions that are over it: the scene itself where it is none."""
        return self

    def enter(self, by_key: bool) -> None:
        """It is on the window from now on; `by_key` where a key has led here, which may be pressed once more."""

    def leave(self) -> None:
        """The hands leave: whatever they hold is let go of."""

    def handle(self, event: pygame.event.Event) -> Scene | None:
        """Take one event."""
        raise NotImplementedError

    def update(self, dt: float) -> Scene | None:
        """Let `dt` seconds pass."""
        return self

    def lay_out(self, size: tuple[int, int]) -> None:
        """Put everything in its place in a window of `size` pixels: before it is drawn, and before it takes events."""

    def draw(self, frame: Frame) -> None:
        """Draw the window as it was laid out, and tell the frame what has changed."""
        raise NotImplementedError


class Wish(Enum):
    """A scene that is asked for without being known: PAUSED where Esc finds nothing to put away, ENDED where a
    shot or a choice may have ended the frame, QUIT for none any more."""

    PAUSED = auto()
    ENDED = auto()
    QUIT = auto()
