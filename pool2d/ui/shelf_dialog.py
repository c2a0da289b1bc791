"""Positions that the player keeps: asking for a name, and the list to open one from."""

from __future__ import annotations

from collections.abc import Callable

from ..errors import InputError
from ..game import shelf
from . import theme
from .dialog import Ask, Dialog
from .entry import Entry
from .scene import Scene
from .widgets import Button, Gap, Heading, Widget
from .words import say


def ask_for_name(below: Scene, keep: Callable[[str], None]) -> Ask:
    """A question for the position's name; `keep` gets it, and may raise InputError.

    A name that is taken already is asked for twice before what it names is replaced.
    """
    warned = ""

    def take(name: str) -> str:
        nonlocal warned
        if name in shelf.positions() and name != warned:
            warned = name
            return say("shelf.replace", name=name)
        try:
            keep(name)
        except InputError as error:
            return error.allowed
        return ""

    kept = shelf.positions()
    word = say("shelf.position")
    number = next(number for number in range(1, len(kept) + 2) if f"{word} {number}" not in kept)
    return Ask(below, say("shelf.save"), say("saving.name"), f"{word} {number}", take)


class Positions(Dialog):
    """The positions kept; `take` gets the name of the one chosen, and returns what is wrong with it, or nothing."""

    def __init__(self, below: Scene, take: Callable[[str], str]) -> None:
        super().__init__(below, "", [])
        self.take = take
        self.wrong = ""
        self._lay_out()

    def _lay_out(self) -> None:
        kept = shelf.positions()
        empty: list[Widget] = [] if kept else [Heading(lambda: say("shelf.empty"), lines=2)]
        entries = [Entry(name, self._opener(name), remove=self._remover(name)) for name in kept]
        wrong: list[Widget] = [Heading(lambda: self.wrong, theme.WARNING, lines=3)] if self.wrong else []
        self.form.set_rows(
            [
                [Heading(lambda: say("shelf.open"), theme.TEXT, large=True)],
                [Gap(0.3)],
                *([widget] for widget in (*wrong, *empty, *entries)),
                [Button(say("form.close"), self._close)],
            ]
        )

    def _opener(self, name: str) -> Callable[[], None]:
        def do() -> None:
            self._told(self.take(name))
            self.done = not self.wrong

        return do

    def _remover(self, name: str) -> Callable[[], None]:
        def do() -> None:
            try:
                shelf.remove(name)
                self._told("")
            except InputError as error:
                self._told(str(error))

        return do

    def _told(self, wrong: str) -> None:
        self.wrong = wrong
        self._lay_out()

    def _close(self) -> None:
        self.done = True
