"""A question over another scene."""

from __future__ import annotations

from collections.abc import Callable

import pygame

from ...draw import shapes, theme
from ..scene import Scene
from ..screen import Screen
from ..widgets.field import TextField
from ..widgets.form import Form
from ..widgets.widget import Button, Gap, Heading, Widget
from ..wording.words import say


def bottom_scene(scene: Scene) -> Scene:
    """What lies below all dialogs of a scene: one that is asked over another hides it."""
    while isinstance(scene, Dialog):
        scene = scene.below
    return scene


class Dialog:
    """Some rows of widgets in the middle of the window; Esc, or setting `done`, goes back, `go` goes elsewhere.

    `width` is in units of the grid.
    """

    width = 50

    def __init__(self, below: Scene, title: str, rows: list[list[Widget]]) -> None:
        self.below = below
        self.done = False
        self._after: Scene | None = below
        self.form = Form([[Heading(lambda: title, theme.TEXT, large=True)], [Gap(0.3)], *rows])

    @property
    def typing(self) -> bool:
        """Whether keys are for what has the focus, whatever else they mean."""
        focus = self.form.focus
        return focus is not None and (focus.greedy or isinstance(focus, TextField))

    @property
    def still(self) -> bool:
        """No: a hint appears where the pointer has rested for a while."""
        return False

    def handle(self, event: pygame.event.Event) -> Scene | None:
        greedy = self.form.focus is not None and self.form.focus.greedy
        if event.type == pygame.KEYDOWN and event.key == pygame.K_ESCAPE and not greedy:
            self.done = True
        else:
            self.form.handle(event)
        return self._next()

    def update(self, dt: float) -> Scene | None:
        self.form.update(dt)
        return self._next()

    def go(self, to: Scene | None) -> None:
        """Lead to another scene than the one below; None quits."""
        self._after, self.done = to, True

    def _next(self) -> Scene | None:
        """This scene until it is done, then what follows; it may be come back to."""
        if not self.done:
            return self
        self.form.let_go()
        after, self._after, self.done = self._after, self.below, False
        return after

    def draw(self, surface: pygame.Surface, kept: bool = False) -> None:
        bottom_scene(self.below).draw(surface)
        shapes.veil(surface)
        unit = Screen(*surface.get_size()).unit
        height = min(self.form.height(unit) + 4 * unit, surface.get_height() - 4 * unit)
        box = pygame.Rect(0, 0, min(self.width * unit, surface.get_width()), height)
        box.center = surface.get_rect().center
        self.form.place(box, unit)
        self.form.draw(surface)


class TextPrompt(Dialog):
    """Asks for a text. `take` gets it, and returns what is wrong with it, or nothing."""

    def __init__(self, below: Scene, title: str, label: str, value: str, take: Callable[[str], str]) -> None:
        self.field = TextField(label, value)
        self.field.select_all()
        self.take = take
        self.wrong = ""
        super().__init__(
            below,
            title,
            [
                [self.field],
                [Heading(lambda: self.wrong, theme.WARNING, lines=3)],
                [Button(say("form.cancel"), self._cancel), Button(say("form.save"), self._ok, strong=True)],
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


class Confirm(Dialog):
    """A question with a way on and a way back; `do` leads on."""

    width = 44

    def __init__(self, below: Scene, question: str, yes: str, do: Callable[[], Scene | None]) -> None:
        super().__init__(
            below,
            question,
            [
                [Gap(0.3)],
                [Button(say("form.cancel"), self._cancel), Button(yes, lambda: self.go(do()), strong=True)],
            ],
        )

    def _cancel(self) -> None:
        self.done = True
