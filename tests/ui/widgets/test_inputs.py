"""Sliders, selectors, list boxes and rows of a list: what they make of places, keys and values at their ends."""

from __future__ import annotations

import pygame
import pytest

from pool2d.config.knobs import Knob
from pool2d.ui.widgets.inputs import ListBox, Selector, Slider
from pool2d.ui.widgets.list_row import ListRow
from pool2d.ui.widgets.widget import Button, Tabs, Toggle, scroll_mark

from .widget_events import Cell, click, form, key, post, shown, slider


@pytest.mark.parametrize(("lo", "hi"), [(0.0, 1.0), (2.0, 6.0), (-1.0, 3.0), (0.1, 4.9), (0.1, 5.0), (0.001, 0.1)])
def test_a_slider_spans_its_range(lo: float, hi: float) -> None:
    made = slider(Cell(lo), lo, hi)
    assert (made.value(0.0), made.value(1.0)) == (lo, hi)
    assert (made.value(-1.0), made.value(2.0)) == (lo, hi)
    assert (made.part(lo), made.part(hi)) == (0.0, 1.0)
    values = [made.value(i / 10.0) for i in range(11)]
    assert values == sorted(set(values))
    assert [made.part(value) for value in values] == pytest.approx([i / 10.0 for i in range(11)], abs=1e-3)
    # Fifty times as much at its end is where equal steps become equal ratios.
    wide = lo > 0.0 and hi >= 50.0 * lo
    assert values[5] == pytest.approx((lo * hi) ** 0.5 if wide else (lo + hi) / 2.0, rel=1e-3)


def test_a_slider_is_set_by_a_press_on_its_line() -> None:
    cell = Cell(2.0)
    made = form(slider(cell, 2.0, 6.0))
    rect = made.widgets[0].rect
    for x, value in ((rect.left + 8, 2.0), (rect.centerx, 4.0), (rect.right - 8, 6.0), (rect.left, 2.0)):
        click(made, (x, rect.centery))
        assert cell.number() == pytest.approx(value, abs=0.02)


def test_keys_that_mean_nothing_to_a_widget_are_left_to_others() -> None:
    cell = Cell("a")
    widgets = (
        slider(Cell(0.5)), Selector("Law", lambda: ["a", "b"], cell.text, cell.put), Button("Do", lambda: None),
        Toggle("On", bool, lambda _: None), Tabs(["a", "b"], cell.text, cell.put), ListRow("a", lambda: None),
        ListBox(lambda: ["a", "b"], cell.text, cell.put),
    )  # fmt: skip
    for widget in widgets:
        assert not widget.key(pygame.K_w, 0)
        assert not widget.key(pygame.K_DELETE, 0) or isinstance(widget, Slider)
    assert cell.value == "a"


@pytest.mark.parametrize("code", [pygame.K_RETURN, pygame.K_KP_ENTER, pygame.K_SPACE])
def test_a_button_by_keys_and_not_while_it_is_barred(code: int) -> None:
    done: list[str] = []
    assert Button("Do", lambda: done.append("a")).key(code, 0)
    assert Button("Do", lambda: done.append("b"), barred=lambda: True).key(code, 0)
    assert done == ["a"]


@pytest.mark.parametrize("code", [pygame.K_RETURN, pygame.K_SPACE, pygame.K_LEFT, pygame.K_RIGHT])
def test_a_toggle_turns_by_every_key(code: int) -> None:
    cell = Cell(False)
    toggle = Toggle("On", cell.flag, cell.put)
    assert toggle.key(code, 0) and cell.flag()
    assert toggle.key(code, 0) and not cell.flag()


def test_a_selector_turns_by_its_halves_and_by_every_key() -> None:
    cell = Cell("b")
    made = form(Selector("Law", lambda: ["a", "b", "c"], cell.text, cell.put))
    rect = made.widgets[0].rect
    for x, value in ((rect.left + rect.width * 7 // 10 - 1, "a"), (rect.left + rect.width * 7 // 10, "b")):
        click(made, (x, rect.centery))
        assert cell.value == value
    for code, value in ((pygame.K_SPACE, "c"), (pygame.K_RETURN, "a"), (pygame.K_LEFT, "c"), (pygame.K_RIGHT, "a")):
        assert key(made, code) and cell.value == value


def test_a_value_that_is_none_of_the_names_counts_as_the_first() -> None:
    cell = Cell("gone")
    selector = Selector("Law", lambda: ["a", "b", "c"], cell.text, cell.put)
    selector.turn(1)
    assert cell.value == "b"
    cell.put("gone")
    box = ListBox(lambda: ["a", "b", "c"], cell.text, cell.put)
    assert box.first() == 0
    assert box.key(pygame.K_DOWN, 0) and cell.value == "a"
    empty = Selector("Law", list, cell.text, cell.put)
    empty.turn(1)
    assert not ListBox(list, cell.text, cell.put).key(pygame.K_DOWN, 0) and cell.value == "a"


def test_every_name_in_sight_of_a_list_box_is_clicked() -> None:
    names = [str(i) for i in range(12)]
    cell = Cell("6")
    box = ListBox(lambda: names, cell.text, cell.put, lines=5)
    made = form(box)
    assert box.first() == 4
    for i in range(5):
        cell.put("6")
        click(made, (box.rect.centerx, box.rect.top + (2 * i + 1) * box.rect.height // 10))
        assert cell.value == names[4 + i]
    few = ListBox(lambda: names[:2], cell.text, cell.put, lines=5)
    made = form(few)
    cell.put("1")
    click(made, (few.rect.centerx, few.rect.bottom - 3))
    assert cell.value == "1" and few.first() == 0


@pytest.mark.parametrize("count", [1, 3, 4])
def test_each_tab_opens_all_over_its_width(count: int) -> None:
    names, cell = [f"page {i}" for i in range(count)], Cell("page 0")
    made = form(Tabs(names, cell.text, cell.put))
    rect = made.widgets[0].rect
    for i, name in enumerate(names):
        for part in (0.05, 0.95):
            click(made, (round(rect.left + (i + part) * rect.width / count), rect.centery))
            assert cell.value == name
    key(made, pygame.K_RIGHT)
    assert cell.value == names[0]
    key(made, pygame.K_LEFT)
    assert cell.value == names[-1]


def test_a_row_is_opened_and_thrown_away_when_asked_twice() -> None:
    done: list[str] = []
    row = ListRow("a", lambda: done.append("open"), remove=lambda: done.append("gone"), sure="Sure?")
    made = form(row, Button("Do", lambda: None))
    plain = shown(made)
    cross = (row.rect.right - 12, row.rect.centery)
    click(made, (row.rect.left + 20, row.rect.centery))
    assert done == ["open"]
    click(made, cross)
    assert done == ["open"] and shown(made) != plain
    click(made, cross)
    assert done == ["open", "gone"]
    key(made, pygame.K_DELETE)
    key(made, pygame.K_DELETE)
    assert done == ["open", "gone", "gone"]
    # Asked once, and then gone elsewhere: it is asked anew.
    key(made, pygame.K_DELETE)
    click(made, made.widgets[1].rect.center)
    key(made, pygame.K_UP)
    key(made, pygame.K_DELETE)
    assert done == ["open", "gone", "gone"]


def test_a_press_that_ends_outside_a_row_does_nothing() -> None:
    done: list[str] = []
    row = ListRow("a", lambda: done.append("open"), remove=lambda: done.append("gone"))
    made = form(row)
    for _ in range(2):
        post(made, pygame.MOUSEBUTTONDOWN, pos=row.rect.center, button=1)
        post(made, pygame.MOUSEBUTTONUP, pos=(row.rect.right - 5, row.rect.bottom + 40), button=1)
    assert done == []


def test_without_what_removes_it_the_right_end_of_a_row_opens_it_too() -> None:
    done: list[str] = []
    row = ListRow("a", lambda: done.append("open"))
    made = form(row)
    click(made, (row.rect.right - 2, row.rect.centery))
    assert done == ["open"]


def test_the_scroll_bar_covers_its_part_of_the_way() -> None:
    rect = pygame.Rect(10, 20, 100, 408)
    assert scroll_mark(rect, 0, 10, 10, 8) is None
    marks = [scroll_mark(rect, first, 10, 40, 8) for first in range(31)]
    assert all(mark is not None and mark.height == 100 and rect.contains(mark) for mark in marks)
    tops = [mark.top for mark in marks if mark is not None]
    assert (tops[0], tops[15], tops[30]) == (24, 174, 324)
    assert tops == sorted(tops)
    least = scroll_mark(rect, 0, 1, 1000, 8)
    assert least is not None and least.height == 16


def test_a_slider_tells_its_value_as_its_owner_has_it() -> None:
    cell = Cell(0.25)
    pictures = {
        shown(form(Slider("a", Knob(0.5, 0.0, 1.0, "", ""), cell.number, cell.put, lambda: None, shown=words)))
        for words in (str, lambda value: f"{100 * value:.0f} %")
    }
    assert len(pictures) == 2
