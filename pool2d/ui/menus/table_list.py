"""The tables to practise on."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from ...errors import InputError
from ...game.rules import games_for
from ...game.session import PRACTICE
from ...table.preset import load_table, presets
from ..dialogs.list_page import ListPage
from ..play.play import Play
from ..scene import Scene
from ..widgets.list_row import ListRow
from ..widgets.widget import Widget
from ..wording.ruling_text import table_title, title


class TableList(ListPage):
    """Every preset, one's own too, with the games that it has the balls for; practice goes on there."""

    def __init__(self, below: Scene, play: Play) -> None:
        self.play = play
        super().__init__(below, lambda: below.words.say("menu.tables"))

    def entries(self) -> Sequence[Widget]:
        return [self._entry(name) for name in presets()]

    def _entry(self, name: str) -> Widget:
        do = self.reporting(partial(self._open, name))
        try:
            table = load_table(name)
        except InputError as error:
            return ListRow(name, do, below=str(error))
        games = ", ".join(title(self.words, game) for game in games_for(table) if game != PRACTICE)
        return ListRow(table_title(self.words, table), do, below=games)

    def _open(self, name: str) -> None:
        self.play.state.open_table(name)
        self.go(self.play)
