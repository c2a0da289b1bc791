"""What lies around the table: the menu, the pause, the ends of frames and matches, and the ways between them."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from ...config.settings import Store
from ...errors import InputError
from ...game.aim import Aim
from ...game.records.record import load
from ...game.records.recorder import records, resume, unfinished
from ...game.session import PRACTICE, Session, practice, recorded
from ..dialogs.dialog import Confirm
from ..dialogs.help import Help
from ..dialogs.options import OptionsPage
from ..play.play import Play
from ..replay.record_list import RecordList, about, open_replays
from ..scene import Scene
from ..wording.ruling_text import title
from ..wording.words import Words
from .drill_list import DrillList
from .ended import FrameOver, MatchOver
from .menu import Banner, Menu, MenuEntry, pause_menu
from .new_match import NewMatch
from .table_list import TableList


class Lobby:
    """Leads from one screen to the next; `play` is the table that all of them are shown over.

    `tell` tells what went wrong, `note` what is worth knowing.
    """

    def __init__(self, play: Play, store: Store, tell: Callable[[str], None], note: Callable[[str], None]) -> None:
        self.play = play
        self.words = play.words
        self.store = store
        self.tell = tell
        self.note = note
        self._reported: InputError | None = None
        self._damaged: Path | None = None
        # What is practised, and how the cue is held there, while a match is played.
        self._practice: tuple[Session, Aim] | None = None
        play.paused = self.pause
        play.ended = self.ended

    # The scenes.

    def menu(self) -> Menu:
        """What the game can be asked for."""
        say = self.words.say
        entries = [
            *self._going_on(lambda: menu),
            MenuEntry(lambda: say("menu.new"), lambda: self._new_match(menu)),
            MenuEntry(lambda: title(self.words, PRACTICE), lambda: self.play),
            MenuEntry(lambda: say("menu.tables"), lambda: TableList(menu, self.play)),
            MenuEntry(lambda: say("drill.title"), lambda: DrillList(menu, self.play)),
            MenuEntry(lambda: say("menu.replays"), lambda: open_replays(menu, self.store, self.play.sounds, self.menu)),
            *self._always(lambda: menu),
        ]
        menu = Menu(self.play, Banner(), entries)
        return menu

    def pause(self) -> Scene:
        """What can be done in the middle of a game; where its frame is over, how it ended."""
        say = self.words.say
        if (end := self.ended()) is not None:
            return end
        entries = [MenuEntry(lambda: say("pause.resume"), lambda: self.play)]
        if not (self.play.state.mode.may_arrange or self.play.state.session.match.setup.watched):
            entries.append(MenuEntry(lambda: say("pause.concede"), lambda: self._ask_to_concede(menu)))
            entries.append(MenuEntry(lambda: say("pause.stalemate"), lambda: self._ask_to_begin_again(menu)))
        entries += self._always(lambda: menu)
        entries.insert(-1, MenuEntry(lambda: say("pause.leave"), self.leave))
        menu = pause_menu(self.play, entries)
        return menu

    def ended(self) -> Scene | None:
        """How the frame or the match has ended; None while it goes on."""
        session = self.play.state.session
        if not session.match.state.over:
            return None
        if session.match.over:
            return MatchOver(self.play, session.match, self._again, self.leave)
        return FrameOver(self.play, session.match, self._next_frame, self.leave)

    def begin(self, session: Session) -> Scene:
        """Play a session, in place of the one so far; what follows from where it stands."""
        if self.play.state.mode.may_arrange:
            self._practice = self.play.state.session, self.play.state.hands.aim
        self.play.state.begin(session)
        return self.ended() or self.play

    def leave(self) -> Scene:
        """Go to the menu; a match that is left can be continued, and practice goes on where it was."""
        if not self.play.state.mode.may_arrange:
            session, aim = self._practice or (practice(self.play.state.session.table, _seed()), Aim())
            self.play.state.begin(session)
            self.play.state.hands.aim = aim
        return self.menu()

    def watch(self) -> None:
        """Tell once where the record of the match can no longer be written."""
        recorder = self.play.state.session.recorder
        fault = None if recorder is None else recorder.fault
        # What was told stays so under a drill, which has no record.
        if fault is not None and fault is not self._reported:
            self.tell(str(fault))
            self._reported = fault

    # What entries lead to.

    def _always(self, here: Callable[[], Scene]) -> list[MenuEntry]:
        """The entries that every menu has."""
        say = self.words.say
        return [
            MenuEntry(lambda: say("options.title"), lambda: OptionsPage(here(), self.store)),
            MenuEntry(lambda: say("menu.help"), lambda: Help(here())),
            MenuEntry(lambda: say("menu.quit"), lambda: None),
        ]

    def _going_on(self, here: Callable[[], Scene]) -> list[MenuEntry]:
        """The entries for the latest match that is not finished, and for all of them where there are more."""
        say = self.words.say
        self._look_at_latest()
        paths = unfinished()
        try:
            details = [_match_details(self.words, path) for path in paths[:1]]
        except (InputError, OSError):
            return []
        entries = [MenuEntry(lambda: say("menu.continue"), lambda: self._resume(paths[0]), lines) for lines in details]
        if len(paths) > 1:
            entries.append(MenuEntry(lambda: say("menu.others"), lambda: self._others(here())))
        return entries

    def _others(self, menu: Scene) -> Scene:
        """The matches that can be continued, to choose one of."""
        return RecordList(menu, lambda: self.words.say("menu.others"), unfinished, self._taken_up, self.menu)

    def _look_at_latest(self) -> None:
        """Tell once where the record of the match played last is damaged, as it cannot be continued."""
        path = next(iter(records()), None)
        if path is None or path == self._damaged:
            return
        try:
            load(path, torn=True)
        except InputError as error:
            self._damaged = path
            self.tell(str(error))

    def _resume(self, path: Path) -> Scene | None:
        try:
            return self._taken_up(path)
        except InputError as error:
            self._damaged = path
            self.tell(str(error))
            return self.menu()

    def _taken_up(self, path: Path) -> Scene:
        say = self.words.say
        recorder = resume(path)
        if recorder.outdated:
            self.note(say(f"since.preset_{recorder.outdated}"))
        for change in recorder.changes:
            self.note(say("since.goes_on", why=say(f"since.{change}")))
        return self.begin(Session(recorder.match, recorder))

    def _new_match(self, menu: Scene) -> Scene:
        return NewMatch(menu, self.store, self.play.state.session.table, self.begin)

    def _ask_to_concede(self, menu: Scene) -> Scene:
        say = self.words.say
        session = self.play.state.session
        name = session.match.names[session.gives_up]

        def concede() -> Scene:
            session.concede(session.gives_up)
            return self.ended() or self.play

        return Confirm(menu, say("pause.concedes", name=name), say("pause.concede"), concede)

    def _ask_to_begin_again(self, menu: Scene) -> Scene:
        say = self.words.say
        session = self.play.state.session
        if (refused := self.play.state.mode.no_stalemate) is not None:
            self.note(refused())
            return self.play

        def begin_again() -> Scene:
            session.stalemate()
            self.play.state.drop()
            self.play.state.messages.clear()
            return self.play

        return Confirm(menu, say("pause.stalemates"), say("pause.stalemate"), begin_again)

    def _next_frame(self) -> Scene:
        self.play.state.session.next_frame()
        return self.play

    def _again(self) -> Scene:
        match = self.play.state.session.match
        try:
            return self.begin(recorded(match.table, replace(match.setup, seed=_seed())))
        except InputError as error:
            self.tell(str(error))
            return self.play


def _seed() -> int:
    return random.randrange(1 << 30)


def _match_details(words: Words, path: Path) -> Callable[[], tuple[str, str]]:
    """What the menu says of a match that can be continued."""
    players, game, when = about(path)
    return lambda: (players, f"{title(words, game)}   \N{MIDDLE DOT}   {when}")
