"""A process of its own that thinks for the players of a match, so that whoever asks can go on meanwhile."""

from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from multiprocessing.context import SpawnProcess
from typing import TypeAlias

from ..game.match import Match, lagged
from ..game.rules import Ruling
from ..game.setup import Setup
from ..study.fresh_process import FreshContext, attended
from ..table.table import Table
from .deciding import Decision, decide
from .player import Player

# How much later than others it has the processor: whoever asks comes first.
_YIELDS = 5

# What is asked: where a match stands, who is to decide, and the seed.
Question: TypeAlias = tuple[Ruling, Player, str]


class ThinkerError(RuntimeError):
    """The thinker has died, or what it was asked has failed; it can be asked again."""


class Thinker:
    """Thinks in a process that is started at once and lives until `close`; it ends too where we do, however that is.

    `ask` and `answer` never wait. One that has died is started again when it is asked next.
    """

    def __init__(self, table: Table, setup: Setup) -> None:
        self._match = table, setup
        self._waits = False
        self._process: SpawnProcess | None = None
        self._start()

    @property
    def pid(self) -> int | None:
        """The number of the process; None where there is none."""
        return None if self._process is None else self._process.pid

    def ask(self, ruling: Ruling, player: Player, seed: str) -> None:
        """Ask what a player does, as `decide`; what was asked before and is not answered is forgotten."""
        if self._waits:
            # It would think that to its end first.
            self.close()
        if self._process is None:
            self._start()
        self._waits = True
        # That it has died is told as an answer.
        with suppress(OSError):
            self._line.send((ruling, player, seed))

    def answer(self) -> Decision | None:
        """What was decided; None as long as it is thinking. Raises ThinkerError where nothing will come of it."""
        try:
            if not self._line.poll():
                return None
            found = self._line.recv()
        except (EOFError, OSError):
            self.close()
            raise ThinkerError("it has ended") from None
        self._waits = False
        if isinstance(found, str):
            raise ThinkerError(found)
        assert isinstance(found, Decision)
        return found

    def close(self) -> None:
        """End it at once, whatever it is doing."""
        process, self._process, self._waits = self._process, None, False
        if process is not None:
            # It is gone a moment later; nobody has to wait for that.
            process.kill()
            self._line.close()
            self._alive.close()

    def _start(self) -> None:
        """Start the process. It holds the one end of two lines: to talk over, and to notice that we are gone."""
        context = FreshContext()
        self._line, line = context.Pipe()
        alive, self._alive = context.Pipe(duplex=False)
        self._process = context.Process(target=attended, args=(alive, __name__, think.__name__, line), daemon=True)
        self._process.start()
        # With no other end of ours, that it has died is noticed.
        line.close()
        alive.close()
        with suppress(OSError):
            self._line.send(self._match)


def think(line: Connection) -> None:
    """What the process does: hear which match it is, and answer each question with a decision, or with why there is
    none."""
    if hasattr(os, "nice"):
        os.nice(_YIELDS)
    # Where whoever asks is gone, there is nobody to tell.
    with suppress(EOFError, OSError):
        match = Match(*line.recv())
        while True:
            line.send(_answered(match, line.recv()))


def _answered(match: Match, question: Question, decides: Callable[..., Decision] = decide) -> Decision | str:
    ruling, player, seed = question
    try:
        return decides(match.rules_of(lagged(ruling.state)), ruling, player, seed)
    except Exception as error:
        return f"{type(error).__name__}: {error}"
