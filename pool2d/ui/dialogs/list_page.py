"""A page that lists things to open: positions, drills, replays, unfinished matches. Some can be deleted."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ...draw import theme
from ...errors import InputError
from ..scene import Scene
from ..widgets.widget import Button, Gap, Heading, Widget
from .dialog import Dialog


class ListPage(Dialog):
    """A dialog with a heading, perhaps a text, and a list of rows, which `entries` gives.

    An error that opening or deleting a row has caused is shown above the rows.
    """

    width = 76

    def __init__(self, below: Scene, heading: Callable[[], str], intro: Callable[[], str] = str) -> None:
        super().__init__(below, "", [])
        self.heading = heading
        self.intro = intro
        self.wrong = ""
        self._fill()

    def entries(self) -> Sequence[Widget]:
        """The rows; asked for again whenever one of them has done something."""
        raise NotImplementedError

    def reporting(self, do: Callable[[], str | None]) -> Callable[[], None]:
        """A row's action; the error that `do` returns as a text, or raises as InputError, is shown on the page."""

        def done() -> None:
            try:
                self.wrong = do() or ""
            except InputError as error:
                self.wrong = str(error)
            if not self.done:
                self._fill()

        return done

    def _fill(self) -> None:
        rows: list[Widget] = [Heading(self.heading, theme.TEXT, large=True)]
        rows += [Heading(self.intro)] if self.intro() else [Gap(0.3)]
        rows += [Heading(lambda: self.wrong, theme.WARNING, lines=3)] if self.wrong else []
        rows += [*self.entries(), Button(self.words.say("form.close"), self.close)]
        self.form.set_rows([[row] for row in rows])
