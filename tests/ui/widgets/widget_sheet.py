"""Every widget in every state that looks its own, on one picture."""

from __future__ import annotations

import pygame

from pool2d.config.knobs import Knob
from pool2d.draw import theme
from pool2d.ui.widgets.field import TextField
from pool2d.ui.widgets.form import Form
from pool2d.ui.widgets.inputs import ListBox, Selector, Slider
from pool2d.ui.widgets.widget import Button, Heading, Tabs, Toggle, Widget

NAMES = tuple(f"table {i}" for i in range(9))
LONG = "a name that is much too long for the place it stands in, whatever its size"


def widgets() -> list[Widget]:
    """One of each kind and make."""
    chosen = TextField("Chosen", "some words")
    chosen.select_all()
    return [
        Heading(lambda: "A heading", large=True),
        Heading(lambda: LONG, color=theme.TEXT, lines=2),
        Button("Do", lambda: None),
        Button("Do", lambda: None, strong=True),
        Button("Do", lambda: None, barred=lambda: True),
        Toggle("On", lambda: True, lambda _: None),
        Toggle(LONG, lambda: False, lambda _: None),
        Tabs(["Cloth", "Balls", "Cue"], lambda: "Balls", lambda _: None),
        Slider("Friction", Knob(0.5, 0.0, 1.0, "", ""), lambda: 0.3, lambda _: None, lambda: None),
        Slider(
            "Wide", Knob(0.5, 0.001, 0.1, "", ""), lambda: 0.01, lambda _: None, lambda: None, shown=lambda _: "1/100"
        ),
        Selector("Law", lambda: NAMES, lambda: NAMES[3], lambda _: None),
        TextField("Name", "some words"),
        TextField("Name", LONG, limit=100),
        TextField("Name"),
        chosen,
        ListBox(lambda: NAMES, lambda: NAMES[4], lambda _: None, lines=4),
        ListBox(lambda: NAMES[:3], lambda: NAMES[2], lambda _: None, lines=4),
    ]


def sheet(unit: int) -> pygame.Surface:
    """Side by side: at rest, under the pointer at its left and at its right, pressed, with the focus."""
    columns = [Form([[widget] for widget in widgets()]) for _ in range(5)]
    height = columns[0].height(unit) + 4 * unit
    surface = pygame.Surface((len(columns) * 24 * unit, height))
    for i, column in enumerate(columns):
        column.place(pygame.Rect(i * 24 * unit, 0, 24 * unit, height), unit)
        for widget in column.widgets:
            if 1 <= i <= 3:
                widget.pointer = (
                    (widget.rect.left + unit, widget.rect.top + unit)
                    if i == 1
                    else (widget.rect.right - unit, widget.rect.bottom - unit)
                )
            widget.held = i == 3
            if isinstance(widget, TextField):
                widget.instead = "nothing yet"
            widget.draw(surface, unit, i == 4, 1 <= i <= 3)
    return surface
