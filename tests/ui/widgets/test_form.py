"""The form that holds the widgets: focus, scrolling, hints."""

from __future__ import annotations

import pygame

from pool2d.ui.widgets.field import TextField
from pool2d.ui.widgets.form import Form
from pool2d.ui.widgets.inputs import Selector
from pool2d.ui.widgets.widget import Button, Heading, Toggle, ring

from .widget_events import BOX, Cell, buttons, click, form, key, post, slider


def test_the_focus_goes_round_and_passes_what_only_tells() -> None:
    first, last = Button("A", lambda: None), Button("B", lambda: None)
    made = form(first, Heading(lambda: "words"), last)
    assert made.focus is first
    key(made, pygame.K_TAB)
    assert made.focus is last
    key(made, pygame.K_TAB)
    assert made.focus is first
    key(made, pygame.K_TAB, pygame.KMOD_SHIFT)
    assert made.focus is last
    key(made, pygame.K_UP)
    assert made.focus is first


def test_a_form_scrolls_to_its_focus() -> None:
    made = form(*(Button(str(i), lambda: None) for i in range(40)))
    for _ in range(39):
        key(made, pygame.K_TAB)
        made.place(BOX, 8)
    assert made.focus is made.widgets[-1]
    assert BOX.contains(made.widgets[-1].rect)


def test_what_misses_the_form_is_left_to_others() -> None:
    made = form(Button("A", lambda: None))
    assert not post(made, pygame.MOUSEBUTTONDOWN, pos=(10, 10), button=1)
    assert not post(made, pygame.MOUSEMOTION, pos=(10, 10))
    assert not key(made, pygame.K_g)
    assert post(made, pygame.MOUSEBUTTONDOWN, pos=(BOX.left + 2, BOX.bottom - 2), button=1)


def test_a_hint_is_told_after_a_rest() -> None:
    made = form(slider(Cell(0.5)))
    post(made, pygame.MOUSEMOTION, pos=made.widgets[0].rect.center)

    def shown() -> bytes:
        surface = pygame.Surface((800, 720))
        made.draw(surface)
        return pygame.image.tobytes(surface, "RGB")

    before = shown()
    made.update(1.0)
    assert shown() != before


def test_a_form_that_scrolls_has_a_mark_and_one_that_does_not_has_none() -> None:
    assert buttons(3)._mark() is None
    mark = buttons(40)._mark()
    assert mark is not None and BOX.contains(mark)


def test_the_mark_follows_the_wheel_and_is_dragged() -> None:
    made = buttons(40)
    top = made._mark()
    assert top is not None
    post(made, pygame.MOUSEMOTION, pos=BOX.center)
    post(made, pygame.MOUSEWHEEL, x=0, y=-3)
    made.place(BOX, 8)
    below = made._mark()
    assert below is not None and below.top > top.top
    post(made, pygame.MOUSEBUTTONDOWN, pos=below.center, button=1)
    post(made, pygame.MOUSEMOTION, pos=(below.centerx, BOX.bottom + 500))
    made.place(BOX, 8)
    post(made, pygame.MOUSEBUTTONUP, pos=(below.centerx, BOX.bottom + 500), button=1)
    assert BOX.contains(made.widgets[-1].rect)
    end = made._mark()
    assert end is not None and BOX.bottom - end.bottom < 8
    scroll = made.scroll
    post(made, pygame.MOUSEMOTION, pos=BOX.center)
    assert made.scroll == scroll


def test_the_ring_is_for_those_who_use_keys() -> None:
    made = form(Button("A", lambda: None), Button("B", lambda: None))
    click(made, made.widgets[0].rect.center)
    assert not made.by_keys
    key(made, pygame.K_TAB)
    assert made.by_keys and made.focus is made.widgets[1]


def test_the_ring_stands_clear_of_the_labels() -> None:
    made = form(Toggle("Guide", lambda: True, lambda _: None))
    surface = pygame.Surface((800, 720))
    ring(surface, made.widgets[0], 8)
    inside = surface.subsurface(made.widgets[0].rect.inflate(4, -4))
    assert pygame.transform.average_color(inside)[:3] == (0, 0, 0)


def test_left_and_right_go_along_a_row_of_buttons() -> None:
    pressed: list[str] = []
    buttons = [Button(name, lambda name=name: pressed.append(name)) for name in "abc"]  # type: ignore[misc]
    made = Form([[buttons[0], buttons[1]], [buttons[2]]])
    assert made.focus is buttons[0]
    for code in (pygame.K_RIGHT, pygame.K_RIGHT, pygame.K_RETURN, pygame.K_LEFT, pygame.K_RETURN, pygame.K_LEFT):
        made.handle(pygame.event.Event(pygame.KEYDOWN, key=code, mod=0))
    assert pressed == ["b", "a"] and made.focus is buttons[0]


def test_widgets_that_have_just_been_shown_can_be_clicked_before_they_are_drawn() -> None:
    taken: list[str] = []

    def take(name: str) -> None:
        taken.append(name)
        made.set_rows([[Selector("Table", lambda: "abc", lambda: taken[-1], take)]])

    made = Form([[Selector("Table", lambda: "abc", lambda: taken[-1] if taken else "a", take)]])
    made.place(pygame.Rect(0, 0, 400, 100), 8)
    right = (made.widgets[0].rect.right - 5, made.widgets[0].rect.centery)
    for _ in range(3):
        made.handle(pygame.event.Event(pygame.MOUSEBUTTONDOWN, pos=right, button=1))
        made.handle(pygame.event.Event(pygame.MOUSEBUTTONUP, pos=right, button=1))
    assert taken == ["b", "c", "a"]


def test_what_is_held_when_the_focus_goes_is_let_go() -> None:
    cell, pressed = Cell(0.5), list[int]()
    made = form(slider(cell), Button("Go", lambda: pressed.append(1)), TextField("Name", "words"))
    for widget in made.widgets:
        at = widget.rect.center
        post(made, pygame.MOUSEBUTTONDOWN, pos=at, button=1)
        # It is for whatever else is held, too.
        assert not post(made, pygame.WINDOWFOCUSLOST)
        held = cell.value, getattr(widget, "cursor", None)
        post(made, pygame.MOUSEMOTION, pos=(at[0] + 90, at[1]))
        assert (cell.value, getattr(widget, "cursor", None)) == held and not widget.held
        assert not post(made, pygame.MOUSEBUTTONUP, pos=at, button=1)
    assert not pressed


def test_the_mark_that_scrolls_is_let_go_too() -> None:
    made = form(*(Button(str(i), lambda: None) for i in range(60)))
    post(made, pygame.MOUSEBUTTONDOWN, pos=(BOX.right - 4, BOX.top + 20), button=1)
    post(made, pygame.MOUSEMOTION, pos=(BOX.right - 4, BOX.top + 80))
    there = made.scroll
    assert there > 0
    post(made, pygame.WINDOWFOCUSLOST)
    post(made, pygame.MOUSEMOTION, pos=(BOX.right - 4, BOX.top + 200))
    assert made.scroll == there


def test_a_long_form_goes_by_pages_and_to_its_ends() -> None:
    made = form(*(Button(str(i), lambda: None) for i in range(60)))

    def press(code: int) -> int:
        assert key(made, code)
        made.draw(pygame.Surface((800, 720)))
        made.place(BOX, 8)
        assert made.focus is not None and BOX.colliderect(made.focus.rect)
        return made.widgets.index(made.focus)

    first = press(pygame.K_PAGEDOWN)
    assert 5 < first < 20 and abs(press(pygame.K_PAGEDOWN) - 2 * first) <= 1
    assert abs(press(pygame.K_PAGEUP) - first) <= 1
    assert press(pygame.K_END) == 59 and press(pygame.K_PAGEDOWN) == 59
    assert press(pygame.K_HOME) == 0 and press(pygame.K_PAGEUP) == 0
