"""Whole positions between shots: the last one again, mirrored, copied and pasted, kept and opened."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from ...errors import InputError
from ...game import arranging, saved_positions
from ...table.placing import mirrored
from ...table.position_text import Position, read, write
from ...table.scenario import Scenario, scenario_of
from ..dialogs.position_list import PositionList, ask_for_name
from ..widgets import clipboard
from ..wording.keys import KEYS
from ..wording.words import say

if TYPE_CHECKING:
    from .play import Play


class Positions:
    """What keys do to the position of a scene, by the names of their actions in `keys`."""

    def __init__(self, play: Play) -> None:
        self.play = play
        self.keys: dict[str, Callable[[], None]] = {
            "same_shot": self.same_shot,
            "mirror": self.mirror,
            "mirror_ends": lambda: self.mirror(ends=True),
            "copy": self.copy,
            "paste": self.paste,
            "save_position": self.save,
            "open_position": self.open,
        }

    def same_shot(self) -> None:
        """Put the balls back as they were before the last stroke, and aim it again."""
        last = arranging.latest(self.play.session)
        if last is None:
            self._tell(lambda: say("play.no_shot"))
        elif self.play.practising() and self.play.arrange(*last):
            self._tell(lambda: say("edit.same_shot", key=KEYS.shown("strike")))

    def mirror(self, ends: bool = False) -> None:
        """Change over the sides of the table, or its ends, and the aim with them."""
        session = self.play.session
        if not self.play.practising():
            return
        aimed = arranging.mirrored_shot(self.play.hands.aim.shot(session.cue.id), ends)
        try:
            layout = mirrored(session.table, session.layout, ends)
        except InputError as error:
            self.play.tell(str(error))
            return
        if self.play.arrange(layout, aimed):
            self._tell(lambda: say("edit.mirrored_ends") if ends else say("edit.mirrored"))

    def copy(self) -> None:
        """Copy the position, with what is aimed, as a line of text."""
        session = self.play.session
        text = write(session.layout, self.play.hands.aim.shot(session.cue.id), session.table)
        copied = clipboard.put(text)
        self._tell(lambda: say("edit.copied") if copied else say("edit.no_clipboard"))

    def paste(self) -> None:
        """Set up the position that has been copied."""
        text = clipboard.get()
        if text is None:
            self._tell(lambda: say("edit.no_clipboard"))
        elif not text.strip():
            self._tell(lambda: say("edit.nothing_copied"))
        elif self.play.practising():
            try:
                scenario = scenario_of(self._here(read(text, say("edit.clipboard"))))
            except InputError as error:
                self.play.tell(str(error))
                return
            if self.load(scenario):
                self._tell(lambda: say("edit.pasted"))

    def save(self) -> None:
        """Ask for a name to keep the position by."""
        session = self.play.session
        shot = self.play.hands.aim.shot(session.cue.id)

        def keep(name: str) -> None:
            path = saved_positions.save(name, session.table, session.layout, shot)
            self._tell(lambda: say("play.saved", path=path))

        self.play.go_to(ask_for_name(self.play, keep))

    def open(self) -> None:
        """Choose one of the positions that are kept."""
        if self.play.practising():
            self.play.go_to(PositionList(self.play, self._open))

    def load(self, scenario: Scenario) -> bool:
        """Set up a scenario, on its own table; False, and nothing is changed, where it is no position to play."""
        play, table = self.play, scenario.table
        here = play.session.table
        if (table.source, table.conditions, table.set) != (here.source, here.conditions, here.set):
            try:
                play.take_table(table, scenario.layout)
            except InputError as error:
                play.tell(str(error))
                return False
            play.aim_as(scenario.shot)
            return True
        return self.play.arrange(scenario.layout, scenario.shot)

    def _open(self, name: str) -> str:
        """Set up a position by name; returns what is wrong with it, or nothing. Raises InputError for its file."""
        if not self.load(saved_positions.load(name)):
            return self.play.message_text
        self._tell(lambda: say("edit.opened", name=name))
        return ""

    def _here(self, position: Position) -> Position:
        """A position that names no table, on the one that is played on; one of a shot alone, with its balls."""
        session = self.play.session
        if position.table:
            return position
        return Position(
            position.layout or session.layout,
            position.shot,
            session.table.source,
            (*session.table.conditions, *position.conditions),
            {**session.table.set, **position.set},
        )

    def _tell(self, told: Callable[[], str]) -> None:
        self.play.message = told
