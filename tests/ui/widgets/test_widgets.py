"""Every widget by mouse and by keyboard, and the form that holds them."""

from __future__ import annotations

import pygame
import pytest

from pool2d.draw import text
from pool2d.ui.widgets.field import TextField
from pool2d.ui.widgets.form import Form
from pool2d.ui.widgets.inputs import ListBox, Selector
from pool2d.ui.widgets.widget import Button, Heading, Tabs, Toggle, Widget

from .widget_events import Cell, click, form, key, post, shown, slider


def test_a_slider_follows_the_pointer_even_outside_itself() -> None:
    cell = Cell(0.5)
    made = form(slider(cell))
    track = made.widgets[0]._track()  # type: ignore[attr-defined]
    post(made, pygame.MOUSEBUTTONDOWN, pos=(track.left + track.width // 4, track.centery), button=1)
    assert cell.number() == pytest.approx(0.25, abs=0.01)
    post(made, pygame.MOUSEMOTION, pos=(track.right + 200, track.centery + 90))
    assert cell.number() == 1.0
    post(made, pygame.MOUSEBUTTONUP, pos=(track.right, track.centery), button=1)
    post(made, pygame.MOUSEMOTION, pos=(track.left, track.centery))
    assert cell.number() == 1.0


def test_a_slider_by_keys() -> None:
    cell, resets = Cell(0.5), []
    made = form(slider(cell, reset=lambda: resets.append(1)))
    key(made, pygame.K_RIGHT)
    assert cell.number() == pytest.approx(0.51)
    key(made, pygame.K_LEFT, pygame.KMOD_CTRL)
    assert cell.number() == pytest.approx(0.41)
    key(made, pygame.K_RIGHT, pygame.KMOD_SHIFT)
    assert cell.number() == pytest.approx(0.411)
    key(made, pygame.K_END)
    assert cell.number() == 1.0
    key(made, pygame.K_RIGHT)
    assert cell.number() == 1.0
    key(made, pygame.K_HOME)
    assert cell.number() == 0.0
    key(made, pygame.K_DELETE)
    assert resets == [1]


def test_a_wide_range_is_moved_in_ratios() -> None:
    cell = Cell(0.01)
    wide = slider(cell, 0.001, 0.1)
    assert wide.part(0.01) == pytest.approx(0.5)
    assert wide.value(0.5) == pytest.approx(0.01)
    assert wide.value(2.0) == 0.1


def test_a_button_acts_where_it_was_pressed_and_released() -> None:
    done: list[int] = []
    made = form(Button("Do", lambda: done.append(1)))
    rect = made.widgets[0].rect
    click(made, rect.center)
    assert len(done) == 1
    post(made, pygame.MOUSEBUTTONDOWN, pos=rect.center, button=1)
    post(made, pygame.MOUSEBUTTONUP, pos=(rect.right + 50, rect.bottom + 50), button=1)
    assert len(done) == 1
    key(made, pygame.K_SPACE)
    key(made, pygame.K_RETURN)
    assert len(done) == 3


def test_a_toggle() -> None:
    cell = Cell(False)
    made = form(Toggle("Guide", cell.flag, cell.put))
    click(made, made.widgets[0].rect.center)
    assert cell.flag()
    key(made, pygame.K_SPACE)
    assert not cell.flag()


def test_a_choice_turns_both_ways_and_round() -> None:
    cell = Cell("a")
    made = form(Selector("Law", lambda: ["a", "b", "c"], cell.text, cell.put))
    key(made, pygame.K_RIGHT)
    assert cell.value == "b"
    key(made, pygame.K_LEFT)
    key(made, pygame.K_LEFT)
    assert cell.value == "c"
    rect = made.widgets[0].rect
    click(made, (rect.right - 4, rect.centery))
    assert cell.value == "a"


def test_tabs() -> None:
    cell = Cell("Cloth")
    made = form(Tabs(["Cloth", "Balls", "Cue"], cell.text, cell.put))
    rect = made.widgets[0].rect
    click(made, (rect.right - 10, rect.centery))
    assert cell.value == "Cue"
    key(made, pygame.K_RIGHT)
    assert cell.value == "Cloth"


def test_a_text_field_takes_what_is_typed_up_to_its_limit() -> None:
    field = TextField("Name", "ab", limit=5)
    made = form(field)
    post(made, pygame.TEXTINPUT, text="c\n\td")
    assert field.value == "abcd"
    post(made, pygame.TEXTINPUT, text="efgh")
    assert field.value == "abcde"
    key(made, pygame.K_BACKSPACE)
    assert field.value == "abcd"
    key(made, pygame.K_BACKSPACE, pygame.KMOD_CTRL)
    assert field.value == ""


def test_a_list_box_keeps_its_choice_in_sight() -> None:
    names = [f"table {i}" for i in range(30)]
    cell = Cell(names[0])
    box = ListBox(lambda: names, cell.text, cell.put, lines=6)
    made = form(box)
    for _ in range(20):
        key(made, pygame.K_DOWN)
    assert cell.value == names[20]
    assert box.first() <= 20 < box.first() + 6
    click(made, (box.rect.centerx, box.rect.top + 3))
    assert cell.value == names[box.first()] or cell.value in names[12:21]
    for _ in range(40):
        key(made, pygame.K_UP)
    assert cell.value == names[0]


@pytest.mark.parametrize("unit", [6, 8, 12, 24])
def test_every_widget_draws_within_its_place(unit: int) -> None:
    widgets: list[Widget] = [
        Heading(lambda: "A heading that is far too long for the panel it stands on, whatever its size", large=True),
        Tabs(["Cloth", "Balls", "Cue"], lambda: "Cloth", lambda _: None),
        slider(Cell(0.5)),
        Toggle("Guide", lambda: True, lambda _: None),
        Selector("Law", lambda: ["a name that is long as well"], lambda: "a name that is long as well", lambda _: None),
        TextField("Name", "x" * 40),
        Button("Do", lambda: None),
        ListBox(lambda: ["one"], lambda: "one", lambda _: None, lines=2),
    ]
    made = Form([[widget] for widget in widgets])
    box = pygame.Rect(50, 50, 42 * unit, 80 * unit)
    made.place(box, unit)
    blank = pygame.Surface((box.right + 50, box.bottom + 50))
    for widget in widgets:
        surface = blank.copy()
        widget.draw(surface, unit, True, True)
        surface.fill((0, 0, 0), widget.rect.inflate(unit, unit))
        left = pygame.mask.from_threshold(surface, (0, 0, 0), (1, 1, 1, 255))
        left.invert()
        assert left.count() == 0, type(widget).__name__


def test_hovered_pressed_and_focused_each_look_their_own() -> None:
    cell = Cell("a")
    for made in (
        form(Button("Do", lambda: None)),
        form(Button("Do", lambda: None, strong=True)),
        form(Toggle("Guide", lambda: True, lambda _: None)),
        form(slider(Cell(0.5))),
        form(Selector("Law", lambda: ["a"], cell.text, cell.put)),
    ):
        rect = made.widgets[0].rect
        focused = shown(made)
        made.by_keys = False
        plain = shown(made)
        post(made, pygame.MOUSEMOTION, pos=rect.center)
        hovered = shown(made)
        post(made, pygame.MOUSEBUTTONDOWN, pos=rect.center, button=1)
        pressed = shown(made)
        assert len({plain, hovered, pressed, focused}) == 4, made.widgets[0]
        post(made, pygame.MOUSEBUTTONUP, pos=rect.center, button=1)
        post(made, pygame.MOUSEMOTION, pos=(5, 5))
        assert shown(made) == plain


def test_a_list_goes_by_pages_and_to_its_ends() -> None:
    names, cell = [str(i) for i in range(30)], Cell("10")
    made = form(ListBox(lambda: names, cell.text, cell.put, lines=8))
    for code, then in ((pygame.K_PAGEDOWN, "17"), (pygame.K_PAGEUP, "10"), (pygame.K_END, "29"),
                       (pygame.K_PAGEDOWN, "29"), (pygame.K_HOME, "0"), (pygame.K_PAGEUP, "0")):  # fmt: skip
        assert key(made, code) and cell.value == then


def test_what_is_cut_says_so() -> None:
    said = "one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen"
    lines = text.in_lines(said, 14, 120, 2)
    assert len(lines) == 2 and lines[-1].endswith("\N{HORIZONTAL ELLIPSIS}")
    assert max(text.font(14).size(line)[0] for line in lines) <= 120
    assert text.in_lines(said, 14, 120, 20) == text.wrap(said, 14, 120)
