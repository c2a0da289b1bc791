"""Every widget by mouse and by keyboard, and the form that holds them."""

from __future__ import annotations

from collections.abc import Callable

import pygame
import pytest

from pool2d.config.knobs import Knob
from pool2d.draw import text
from pool2d.ui.widgets.field import TextField
from pool2d.ui.widgets.form import Form
from pool2d.ui.widgets.inputs import ListBox, Selector, Slider
from pool2d.ui.widgets.widget import Button, Heading, Tabs, Toggle, Widget, ring

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


def buttons(count: int) -> Form:
    return form(*(Button(str(i), lambda: None) for i in range(count)))


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


def shown(made: Form) -> bytes:
    surface = pygame.Surface((800, 720))
    made.draw(surface)
    return pygame.image.tobytes(surface, "RGB")


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
    for key in (pygame.K_RIGHT, pygame.K_RIGHT, pygame.K_RETURN, pygame.K_LEFT, pygame.K_RETURN, pygame.K_LEFT):
        made.handle(pygame.event.Event(pygame.KEYDOWN, key=key, mod=0))
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


def test_a_list_goes_by_pages_and_to_its_ends() -> None:
    names, cell = [str(i) for i in range(30)], Cell("10")
    made = form(ListBox(lambda: names, cell.text, cell.put, lines=8))
    for code, then in ((pygame.K_PAGEDOWN, "17"), (pygame.K_PAGEUP, "10"), (pygame.K_END, "29"),
                       (pygame.K_PAGEDOWN, "29"), (pygame.K_HOME, "0"), (pygame.K_PAGEUP, "0")):  # fmt: skip
        assert key(made, code) and cell.value == then


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


def test_what_is_cut_says_so() -> None:
    said = "one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen"
    lines = text.in_lines(said, 14, 120, 2)
    assert len(lines) == 2 and lines[-1].endswith("\N{HORIZONTAL ELLIPSIS}")
    assert max(text.font(14).size(line)[0] for line in lines) <= 120
    assert text.in_lines(said, 14, 120, 20) == text.wrap(said, 14, 120)
