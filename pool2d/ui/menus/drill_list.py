"""The list of drills to choose one from."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from ...draw import theme
from ...errors import InputError
from ...game.drills.best_results import best
from ...game.drills.drill import Drill
from ...game.drills.drill_file import drills, load
from ..dialogs.list_page import ListPage
from ..play.play import Play
from ..scene import Scene
from ..widgets.list_row import ListRow
from ..widgets.widget import Heading, Widget
from ..wording import ruling_text


class DrillList(ListPage):
    """Every drill with its goal and the best result; it is played on `play` over what is played there."""

    def __init__(self, below: Scene, play: Play) -> None:
        say = below.words.say
        self.play = play
        super().__init__(below, lambda: say("drill.title"), lambda: say("drill.intro"))

    def entries(self) -> Sequence[Widget]:
        return [self._entry(name) for name in drills()]

    def _entry(self, name: str) -> Widget:
        try:
            drill = load(name)
        except InputError as error:
            wrong = str(error)
            return Heading(lambda: wrong, theme.WARNING, lines=2)
        record = best(drill.id)
        note = "" if record is None else self.words.say("drill.best", best=record, most=drill.most)
        wording = ruling_text.wording(self.words, drill)
        return ListRow(wording.name, partial(self._open, drill), note, wording.text)

    def _open(self, drill: Drill) -> None:
        self.go(self.play.drill(drill, self.below))
