"""Menus: a title and lines to choose from, by mouse or by keys, over the table."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import pygame

from ...draw import shapes, text, theme
from ..dialogs.dialog import Dialog
from ..scene import Scene
from ..widgets.widget import Gap, Heading, Widget


class MenuEntry(NamedTuple):
    """A line of a menu: its text, the scene it leads to, None to quit, and perhaps small lines below.

    The texts are asked anew for every picture, as the language may change.
    """

    label: Callable[[], str]
    do: Callable[[], Scene | None]
    details: Callable[[], Sequence[str]] = tuple


class Item(Widget):
    """An entry on the screen; the one that has the focus is marked in gold."""

    ringed = False

    def __init__(self, entry: MenuEntry, choose: Callable[[MenuEntry], None]) -> None:
        super().__init__()
        self.entry = entry
        self.choose = choose
        self.rows = 1.5 + 0.75 * len(entry.details())

    def release(self, pos: tuple[int, int]) -> None:
        if self.rect.collidepoint(pos):
            self.choose(self.entry)

    def key(self, key: int, mod: int) -> bool:
        if key in (pygame.K_RETURN, pygame.K_KP_ENTER, pygame.K_SPACE):
            self.choose(self.entry)
            return True
        return False

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        box = self.rect.inflate(0, -unit // 2)
        if focused:
            shapes.rounded(surface, box, theme.FACE_DOWN if self.pressed else theme.FACE_LIT, unit * 3 // 4)
            mark = pygame.Rect(box.left, box.top + unit, max(2, unit // 2), box.height - 2 * unit)
            shapes.rounded(surface, mark, theme.ACCENT, unit // 2)
        left, width = box.left + 2 * unit, box.width - 4 * unit
        color = theme.ACCENT_LIT if focused else theme.TEXT
        y = box.top + unit * 2
        label = text.fitted(self.entry.label(), unit * 9 // 4, width)
        text.draw(surface, label, unit * 9 // 4, color, (left, y), (0.0, 0.5))
        for detail in self.entry.details():
            y += unit * 9 // 4
            shown = text.fitted(detail, unit * 3 // 2, width)
            text.draw(surface, shown, unit * 3 // 2, theme.QUIET, (left, y), (0.0, 0.5))


class Menu(Dialog):
    """Entries below a title. The pointer and the keys move the same mark; Esc goes back to what is below."""

    width = 44

    def __init__(self, below: Scene, head: Widget, entries: Sequence[MenuEntry]) -> None:
        super().__init__(below, "", [])
        self.items = [Item(entry, self._choose) for entry in entries]
        rows: list[list[Widget]] = [[head], [Gap(0.4)]]
        rows += [[item] for item in self.items]
        self.form.set_rows(rows)
        self.form.focus = self.items[0]

    @property
    def still(self) -> bool:
        return self.bottom.still

    @property
    def opens_pages(self) -> bool:
        return True

    def handle(self, event: pygame.event.Event) -> Scene | None:
        after = super().handle(event)
        if event.type == pygame.MOUSEMOTION:
            under = (item for item in self.items if item.rect.collidepoint(event.pos))
            self.form.focus = next(under, self.form.focus)
        return after

    def _choose(self, entry: MenuEntry) -> None:
        after = entry.do()
        if after is not self:
            self.go(after)


class Banner(Widget):
    """The name of the game over a line of gold."""

    rows = 4.0
    focusable = False

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        left = self.rect.left + 2 * unit
        name = text.draw(surface, "pool2d", 7 * unit, theme.TEXT, (left, self.rect.top + 4 * unit), (0.0, 0.5))
        line = pygame.Rect(left, self.rect.top + 8 * unit + unit // 2, name.width, max(2, unit // 4))
        shapes.rounded(surface, line, theme.ACCENT, unit)


def pause_menu(below: Scene, entries: Sequence[MenuEntry]) -> Menu:
    """The menu in the middle of a game."""
    return Menu(below, Heading(lambda: below.words.say("pause.title"), theme.TEXT, large=True), entries)
