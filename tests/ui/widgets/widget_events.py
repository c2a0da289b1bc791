"""Widgets on a form, and what a hand does to them."""

from __future__ import annotations

from collections.abc import Callable

import pygame

from pool2d.config.knobs import Knob
from pool2d.ui.widgets.form import Form
from pool2d.ui.widgets.inputs import Slider
from pool2d.ui.widgets.widget import Button, Widget

BOX = pygame.Rect(100, 50, 320, 600)


class Cell:
    """A value that a widget reads and writes."""

    def __init__(self, value: float | str | bool) -> None:
        self.value = value

    def number(self) -> float:
        return float(self.value)

    def text(self) -> str:
        return str(self.value)

    def flag(self) -> bool:
        return bool(self.value)

    def put(self, value: float | str | bool) -> None:
        self.value = value


def form(*widgets: Widget) -> Form:
    made = Form([[widget] for widget in widgets])
    made.place(BOX, 8)
    made.draw(pygame.Surface((800, 720)))
    return made


def post(made: Form, kind: int, **fields: object) -> bool:
    return made.handle(pygame.event.Event(kind, dict(fields)))


def key(made: Form, code: int, mod: int = 0) -> bool:
    return post(made, pygame.KEYDOWN, key=code, mod=mod)


def click(made: Form, pos: tuple[int, int]) -> None:
    post(made, pygame.MOUSEBUTTONDOWN, pos=pos, button=1)
    post(made, pygame.MOUSEBUTTONUP, pos=pos, button=1)


def slider(cell: Cell, lo: float = 0.0, hi: float = 1.0, reset: Callable[[], None] = lambda: None) -> Slider:
    return Slider("Friction", Knob(0.5, lo, hi, "", "how rough"), cell.number, cell.put, reset, "how rough")


def buttons(count: int) -> Form:
    return form(*(Button(str(i), lambda: None) for i in range(count)))


def shown(made: Form) -> bytes:
    surface = pygame.Surface((800, 720))
    made.draw(surface)
    return pygame.image.tobytes(surface, "RGB")
