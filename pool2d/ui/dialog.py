"""A question over another scene."""

from __future__ import annotations

from collections.abc import Callable

import pygame

from . import theme
from .form import Form
from .hud import Screen
from .inputs import TextField
from .scene import Scene
from .widgets import Button, Heading, Widget


class Dialog:
    """Some rows of widgets in the middle of the window; Esc, or setting `done`, goes back."""

    def __init__(self, below: Scene, title: str, rows: list[list[Widget]]) -> None:
        self.below = below
        self.done = False
        self.form = Form([[Heading(lambda: title, theme.TEXT, large=True)], *rows])

    @property
    def still(self) -> bool:
        """No: a hint appears where the pointer has rested for a while."""
        return False

    def handle(self, event: pygame.event.Event) -> Scene | None:
        if event.type == pygame.KEYDOWN and event.key == pygame.K_ESCAPE:
            self.done = True
        else:
            self.form.handle(event)
        return self.below if self.done else self

    def update(self, dt: float) -> Scene | None:
        self.form.update(dt)
        return self.below if self.done else self

    def draw(self, surface: pygame.Surface) -> None:
        self.below.draw(surface)
        veil = pygame.Surface(surface.get_size(), pygame.SRCALPHA)
        veil.fill(theme.VEIL)
        surface.blit(veil, (0, 0))
        unit = Screen(*surface.get_size()).unit
        box = pygame.Rect(0, 0, 50 * unit, self.form.height(unit) + 4 * unit)
        box.center = surface.get_rect().center
        self.form.place(box, unit)
        self.form.draw(surface)


class Ask(Dialog):
    """Asks for a text. `take` gets it, and returns what is wrong with it, or nothing."""

    def __init__(self, below: Scene, title: str, label: str, value: str, take: Callable[[str], str]) -> None:
        self.field = TextField(label, value)
        self.take = take
        self.wrong = ""
        super().__init__(
            below,
            title,
            [
                [self.field],
                [Heading(lambda: self.wrong, theme.WARNING, lines=3)],
                [Button("Cancel", self._cancel), Button("Save", self._ok, strong=True)],
            ],
        )

    def handle(self, event: pygame.event.Event) -> Scene | None:
        if event.type == pygame.KEYDOWN and event.key == pygame.K_RETURN and self.form.focus is self.field:
            self._ok()
        return super().handle(event)

    def _ok(self) -> None:
        self.wrong = self.take(self.field.value)
        self.done = not self.wrong

    def _cancel(self) -> None:
        self.done = True
