"""Dialogs: what lies over the scene that it was opened from, and a form of widgets in the middle of the window."""

from __future__ import annotations

from collections.abc import Callable

import pygame

from ...draw import shapes, theme
from ...table.table import Table
from ..frame import Frame
from ..scene import Scene
from ..screen import Screen
from ..widgets.field import TextField
from ..widgets.form import Form
from ..widgets.widget import Button, Gap, Heading, Widget


class Overlay(Scene):
    """Something over the scene `below`. Of several over each other only the last is seen, and the bottom, darkened."""

    def __init__(self, below: Scene) -> None:
        self.below = below
        self.words = below.words

    @property
    def bottom(self) -> Scene:
        return self.below.bottom

    @property
    def table(self) -> Table | None:
        return self.bottom.table

    def lay_out(self, size: tuple[int, int]) -> None:
        self.bottom.lay_out(size)

    def draw(self, frame: Frame) -> None:
        self.bottom.draw(frame)
        shapes.veil(frame.surface)
        frame.cover()


class Dialog(Overlay):
    """A scene that shows a form of widgets over the scene `below`.

    Esc, `close`, or setting `done` closes it and returns to that scene; `go` leads to another. `width` is the form's
    width in units of the grid (`theme.unit`).
    """

    width = 50

    def __init__(self, below: Scene, title: str, rows: list[list[Widget]]) -> None:
        super().__init__(below)
        self.done = False
        self._after: Scene | None = below
        self.form = Form([[Heading(lambda: title, theme.TEXT, large=True)], [Gap(0.3)], *rows])

    @property
    def takes_text(self) -> bool:
        focus = self.form.focus
        return focus is not None and (focus.greedy or isinstance(focus, TextField))

    # Never `still`: a hint appears once the pointer has rested over a widget for a while.

    def leave(self) -> None:
        self.form.let_go()

    def handle(self, event: pygame.event.Event) -> Scene | None:
        greedy = self.form.focus is not None and self.form.focus.greedy
        if event.type == pygame.KEYDOWN and event.key == pygame.K_ESCAPE and not greedy:
            self.close()
        else:
            self.form.handle(event)
        return self._next()

    def update(self, dt: float) -> Scene | None:
        self.form.update(dt)
        return self._next()

    def go(self, to: Scene | None) -> None:
        """Show the scene `to` next, instead of the one below; None quits the program."""
        self._after, self.done = to, True

    def close(self) -> None:
        """Go back to the scene below."""
        self.done = True

    def _next(self) -> Scene | None:
        """The scene to show next: this one until it is done. It is reset, so that it can be opened again."""
        if not self.done:
            return self
        self.form.let_go()
        after, self._after, self.done = self._after, self.below, False
        return after

    def lay_out(self, size: tuple[int, int]) -> None:
        super().lay_out(size)
        unit = Screen(*size).unit
        height = min(self.form.height(unit) + 4 * unit, size[1] - 4 * unit)
        box = pygame.Rect(0, 0, min(self.width * unit, size[0]), height)
        box.center = size[0] // 2, size[1] // 2
        self.form.place(box, unit)

    def draw(self, frame: Frame) -> None:
        super().draw(frame)
        self.form.draw(frame.surface)


class TextPrompt(Dialog):
    """A dialog that asks for a line of text.

    `take` is called with the text on Enter or the button; it returns what is wrong with it, to be shown, or "".
    """

    def __init__(self, below: Scene, title: str, label: str, value: str, take: Callable[[str], str]) -> None:
        say = below.words.say
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
                [Button(say("form.cancel"), self.close), Button(say("form.save"), self._ok, strong=True)],
            ],
        )

    def handle(self, event: pygame.event.Event) -> Scene | None:
        if event.type == pygame.KEYDOWN and event.key == pygame.K_RETURN and self.form.focus is self.field:
            self._ok()
        return super().handle(event)

    def _ok(self) -> None:
        self.wrong = self.take(self.field.value)
        self.done = not self.wrong


class Confirm(Dialog):
    """A dialog that asks to confirm something: the confirming button calls `do`, Esc and the other go back."""

    width = 44

    def __init__(self, below: Scene, question: str, yes: str, do: Callable[[], Scene | None]) -> None:
        super().__init__(
            below,
            question,
            [
                [Gap(0.3)],
                [Button(below.words.say("form.cancel"), self.close), Button(yes, lambda: self.go(do()), strong=True)],
            ],
        )
