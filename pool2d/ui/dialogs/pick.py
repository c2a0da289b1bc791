"""A list of names to choose one of."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import pygame

from ...draw import theme
from ..scene import Scene
from ..widgets.inputs import ListBox
from ..widgets.widget import Button, Heading, Widget
from .dialog import Dialog

_LINES = 9


class Pick(Dialog):
    """A dialog that lets one of several names, all different, be chosen.

    `take` is called with the index of the chosen name on Enter or the button; it returns the scene to show next, or
    a text that says what is wrong.
    """

    width = 76

    def __init__(
        self, below: Scene, title: str, names: Sequence[str], at: int, button: str,
        take: Callable[[int], Scene | str],
    ) -> None:  # fmt: skip
        self.names = list(names)
        self.chosen = self.names[at] if self.names else ""
        self.wrong = ""
        self._take = take
        self._then: Scene | None = None
        rows: list[list[Widget]] = [
            [ListBox(lambda: self.names, lambda: self.chosen, self._choose, _LINES)],
            [Heading(lambda: self.wrong, theme.WARNING, lines=2)],
            [Button(below.words.say("form.cancel"), self.close), Button(button, self._ok, strong=True)],
        ]
        super().__init__(below, title, rows)

    def handle(self, event: pygame.event.Event) -> Scene | None:
        entered = event.type == pygame.KEYDOWN and event.key in (pygame.K_RETURN, pygame.K_KP_ENTER)
        if entered and isinstance(self.form.focus, ListBox):
            self._ok()
            return self._then or self
        scene = super().handle(event)
        return self._then or scene

    def _choose(self, name: str) -> None:
        self.chosen, self.wrong = name, ""

    def _ok(self) -> None:
        if self.chosen:
            result = self._take(self.names.index(self.chosen))
            if isinstance(result, str):
                self.wrong = result
            else:
                self._then = result
