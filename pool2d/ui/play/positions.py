"""Whole positions between shots: the last one again, mirrored, copied and pasted, kept and opened."""

from __future__ import annotations

from collections.abc import Callable

from ...errors import InputError
from ...game import arranging, saved_positions
from ...table.placing import mirrored
from ...table.position_text import Position, read, write
from ...table.scenario import Scenario, scenario_of
from ..dialogs.position_list import PositionList, ask_for_name
from ..scene import Scene
from ..widgets import clipboard
from .state import PlayState


class Positions:
    """What keys do to the position of a scene, by the names of their actions in `keys`."""

    def __init__(self, state: PlayState, scene: Scene) -> None:
        self.state = state
        self.words = state.words
        self.scene = scene
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
        say = self.words.say
        last = arranging.latest(self.state.session)
        if last is None:
            self.state.messages.show(lambda: say("play.no_shot"))
        elif self.state.may_arrange() and self.state.arrange(*last):
            self.state.messages.show(lambda: say("edit.same_shot", key=self.words.key("strike")))

    def mirror(self, ends: bool = False) -> None:
        """Change over the sides of the table, or its ends, and the aim with them."""
        say = self.words.say
        session = self.state.session
        if not self.state.may_arrange():
            return
        aimed = arranging.mirrored_shot(self.state.hands.aim.shot(session.cue.id), ends)
        try:
            layout = mirrored(session.table, session.layout, ends)
        except InputError as error:
            self.state.messages.say(str(error))
            return
        if self.state.arrange(layout, aimed):
            self.state.messages.show(lambda: say("edit.mirrored_ends") if ends else say("edit.mirrored"))

    def copy(self) -> None:
        """Copy the position, with what is aimed, as a line of text."""
        say = self.words.say
        session = self.state.session
        text = write(session.layout, self.state.chosen(), session.table)
        copied = clipboard.put(text)
        self.state.messages.show(lambda: say("edit.copied") if copied else say("edit.no_clipboard"))

    def paste(self) -> None:
        """Set up the position that has been copied."""
        say = self.words.say
        text = clipboard.get()
        if text is None:
            self.state.messages.show(lambda: say("edit.no_clipboard"))
        elif not text.strip():
            self.state.messages.show(lambda: say("edit.nothing_copied"))
        elif self.state.may_arrange():
            try:
                scenario = scenario_of(self._here(read(text, say("edit.clipboard"))))
            except InputError as error:
                self.state.messages.say(str(error))
                return
            if self.load(scenario):
                self.state.messages.show(lambda: say("edit.pasted"))

    def save(self) -> None:
        """Ask for a name to keep the position by."""
        session = self.state.session
        shot = self.state.chosen()

        def keep(name: str) -> None:
            path = saved_positions.save(name, session.table, session.layout, shot)
            self.state.messages.show(lambda: self.words.say("play.saved", path=path))

        self.state.go_to(ask_for_name(self.scene, keep))

    def open(self) -> None:
        """Choose one of the positions that are kept."""
        if self.state.may_arrange():
            self.state.go_to(PositionList(self.scene, self._open))

    def load(self, scenario: Scenario) -> bool:
        """Set up a scenario, on its own table; False, and nothing is changed, where it is no position to play."""
        state, table = self.state, scenario.table
        here = state.session.table
        if (table.source, table.conditions, table.set) != (here.source, here.conditions, here.set):
            try:
                state.take_table(table, scenario.layout)
            except InputError as error:
                state.messages.say(str(error))
                return False
            state.aim_as(scenario.shot)
            return True
        return self.state.arrange(scenario.layout, scenario.shot)

    def _open(self, name: str) -> str:
        """Set up a position by name; returns what is wrong with it, or nothing. Raises InputError for its file."""
        if not self.load(saved_positions.load(name)):
            return self.state.messages.text
        self.state.messages.show(lambda: self.words.say("edit.opened", name=name))
        return ""

    def _here(self, position: Position) -> Position:
        """A position that names no table, on the one that is played on; one of a shot alone, with its balls."""
        session = self.state.session
        if position.table:
            return position
        return Position(
            position.layout or session.layout,
            position.shot,
            session.table.source,
            (*session.table.conditions, *position.conditions),
            {**session.table.set, **position.set},
        )
