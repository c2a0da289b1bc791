"""Saved positions: the question for a name to save one under, and the list to open one from."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from ...errors import InputError
from ...game import saved_positions
from ..scene import Scene
from ..widgets.list_row import ListRow
from ..widgets.widget import Widget
from .dialog import TextPrompt
from .list_page import ListPage


def ask_for_name(below: Scene, keep: Callable[[str], None]) -> TextPrompt:
    """A dialog that asks for a position's name and calls `keep` with it; an InputError of that is shown.

    A name that is taken has to be confirmed by a second Enter before its position is replaced.
    """
    say = below.words.say
    warned = ""

    def take(name: str) -> str:
        nonlocal warned
        if name in saved_positions.positions() and name != warned:
            warned = name
            return say("shelf.replace", name=name)
        try:
            keep(name)
        except InputError as error:
            return error.allowed
        return ""

    kept = saved_positions.positions()
    word = say("shelf.position")
    number = next(number for number in range(1, len(kept) + 2) if f"{word} {number}" not in kept)
    return TextPrompt(below, say("shelf.save"), say("saving.name"), f"{word} {number}", take)


class PositionList(ListPage):
    """The list of saved positions.

    `take` is called with the name of the chosen one; what is wrong it returns as a text or raises as InputError,
    and it is shown.
    """

    def __init__(self, below: Scene, take: Callable[[str], str]) -> None:
        say = below.words.say
        self.take = take
        super().__init__(
            below, lambda: say("shelf.open"), lambda: "" if saved_positions.positions() else say("shelf.empty")
        )

    def entries(self) -> Sequence[Widget]:
        return [
            ListRow(
                name,
                self.reporting(partial(self._open, name)),
                remove=self.reporting(partial(saved_positions.remove, name)),
                sure=self.words.say("entry.sure"),
            )
            for name in saved_positions.positions()
        ]

    def _open(self, name: str) -> str:
        wrong = self.take(name)
        self.done = not wrong
        return wrong
