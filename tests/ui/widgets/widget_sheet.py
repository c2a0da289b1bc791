"""Every widget in every state that looks its own, on one picture."""

from __future__ import annotations

import pygame

from pool2d.config.knobs import Knob
from pool2d.draw import theme
from pool2d.ui.widgets.ball_row import BallRow
from pool2d.ui.widgets.field import TextField
from pool2d.ui.widgets.form import Form
from pool2d.ui.widgets.inputs import ListBox, Selector, Slider
from pool2d.ui.widgets.list_row import ListRow
from pool2d.ui.widgets.widget import Button, Heading, Tabs, Toggle, Widget

NAMES = tuple(f"table {i}" for i in range(9))
LONG = "a name that is much too long for the place it stands in, whatever its size"


def widgets() -> list[Widget]:
    """One of each kind and make."""
    chosen = TextField("Chosen", "some words")
    chosen.select_all()
    asked = ListRow("To go", lambda: None, remove=lambda: None, sure="Sure?")
    asked.key(pygame.K_DELETE, 0)
    return [
        Heading(lambda: "A heading", large=True),
        Heading(lambda: LONG, color=theme.TEXT, lines=2),
        Button("Do", lambda: None),
        Button("Do", lambda: None, strong=True),
        Button("Do", lambda: None, barred=lambda: True),
        Button(LONG, lambda: None),
        Toggle("On", lambda: True, lambda _: None),
        Toggle(LONG, lambda: False, lambda _: None),
        Tabs(["Cloth", "Balls", "Cue"], lambda: "Balls", lambda _: None),
        Slider("Friction", Knob(0.5, 0.0, 1.0, "", ""), lambda: 0.3, lambda _: None, lambda: None),
        Slider(
            "Wide", Knob(0.5, 0.001, 0.1, "", ""), lambda: 0.01, lambda _: None, lambda: None, shown=lambda _: "1/100"
        ),
        Slider(LONG, Knob(0.5, 0.0, 1.0, "", ""), lambda: 0.9, lambda _: None, lambda: None, shown=lambda _: LONG),
        Selector("Law", lambda: NAMES, lambda: NAMES[3], lambda _: None),
        Selector(LONG, lambda: (LONG,), lambda: LONG, lambda _: None),
        TextField("Name", "some words"),
        TextField("Name", LONG, limit=100),
        TextField("Name"),
        TextField(LONG, ""),
        chosen,
        ListBox(lambda: NAMES, lambda: NAMES[4], lambda _: None, lines=4),
        ListBox(lambda: NAMES[:3], lambda: NAMES[2], lambda _: None, lines=4),
        ListRow("A table", lambda: None),
        ListRow(LONG, lambda: None, note=LONG, below=LONG, remove=lambda: None),
        ListRow("A table", lambda: None, note="9 feet", remove=lambda: None),
        asked,
        BallRow(lambda: theme.PLAIN),
        BallRow(lambda: theme.Style(theme.PALETTES["high contrast"], patterned=True)),
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


def scrolled() -> pygame.Surface:
    """A form that is longer than its panel, moved by the wheel, with the ring of the focus, and a hint beside it."""
    surface = pygame.Surface((420, 240))
    form = Form([[Button(f"{i}", lambda: None, hint=LONG), Toggle(f"{i}", bool, lambda _: None)] for i in range(20)])
    form.place(pygame.Rect(200, 10, 210, 220), 8)
    form.draw(surface)
    for kind, fields in (
        (pygame.KEYDOWN, {"key": pygame.K_PAGEDOWN}),
        (pygame.MOUSEMOTION, {"pos": form.rect.center}),
        (pygame.MOUSEWHEEL, {"y": -1}),
    ):
        form.handle(pygame.event.Event(kind, fields))
        form.place(form.rect, form.unit)
    hinted = next(widget for widget in form.widgets if widget.hint and widget.rect.top > form.rect.centery)
    form.handle(pygame.event.Event(pygame.MOUSEMOTION, pos=hinted.rect.center))
    form.update(1.0)
    surface.fill((0, 0, 0))
    form.draw(surface)
    return surface
