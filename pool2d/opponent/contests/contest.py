"""A match between two players without a screen, recorded, and what it says of them."""

from __future__ import annotations

import contextlib
import os
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

from ...errors import BudgetError, InputError
from ...game.actions import Concede
from ...game.match import Match, Moment
from ...game.records.recorder import Recorder, record
from ...game.rules import Rules, Ruling
from ...game.setup import NAME, Setup
from ...table.table import Table
from ..candidate import Candidate
from ..deciding import Decision, decide
from ..player import Player
from ..playing import played_out

# What a record is called until it is whole.
DRAFT: Final = ".part"
# Strokes that are to make something.
_TRIES: Final = ("pot", "combination", "carom", "bank", "cannon")


@dataclass(frozen=True, slots=True)
class Contest:
    """A match that is to be played; the two play its racks in pairs, each of which either of them breaks once.

    `files` are the names of the players' files, `path` where the record goes.
    """

    table: Table
    game: str
    files: tuple[str, str]
    players: tuple[Player, Player]
    seed: int
    number: int
    path: Path

    @property
    def setup(self) -> Setup:
        """What is agreed before the match."""
        rack = 100_000 * self.seed + self.number // 2
        names = (self.players[0].name, self.players[1].name)
        files = tuple(Path(file).stem[:NAME] for file in self.files)
        return Setup(self.game, names=names, breaker=self.number % 2, seed=rack, players=files)


@dataclass(slots=True)
class Performance:
    """What one player did: seconds of thought for each decision, strokes that were to make something, and that did."""

    seconds: list[float] = field(default_factory=list)
    attempts: int = 0
    pots: int = 0
    fouls: int = 0

    def add(self, more: Performance) -> None:
        """Count what the player did in another match."""
        self.seconds += more.seconds
        self.attempts += more.attempts
        self.pots += more.pots
        self.fouls += more.fouls


@dataclass(slots=True)
class ContestOutcome:
    """What came of a match: who won, -1 where nobody did; actions that the rules refused; and what either side did."""

    winner: int = -1
    illegal: int = 0
    sides: tuple[Performance, Performance] = field(default_factory=lambda: (Performance(), Performance()))

    def think(self, rules: Rules[Any], ruling: Ruling, player: Player, seed: str) -> Decision:
        """`decide`, with a look at the clock."""
        begun = time.perf_counter()
        decision = decide(rules, ruling, player, seed)
        self.sides[ruling.ask.player].seconds.append(time.perf_counter() - begun)
        return decision

    def count(self, decision: Decision | None, moment: Moment) -> None:
        """Take down what came of a stroke."""
        if decision is None or moment.report is None:
            return
        side = self.sides[moment.shooter]
        side.fouls += moment.ruling.foul
        meant = decision.weighed[0].candidate if decision.weighed else None
        if meant is not None and meant.kind in _TRIES:
            side.attempts += 1
            side.pots += _made(meant, moment)


def _made(meant: Candidate, moment: Moment) -> bool:
    """Whether a stroke did what it was to do."""
    assert moment.report is not None
    fell = not meant.pocket or (meant.ball, meant.pocket) in moment.report.pots
    return fell and not moment.ruling.foul and moment.ruling.ask.player == moment.shooter


def held(contest: Contest) -> ContestOutcome:
    """Play a match and record it; raises InputError where the record cannot be written."""
    match, draft = Match(contest.table, contest.setup), contest.path.with_suffix(DRAFT)
    with contextlib.suppress(OSError):
        draft.unlink()
    with record(match, draft) as recorder:
        outcome = _played(contest, recorder)
        if recorder.fault is not None:
            raise recorder.fault
    os.replace(draft, contest.path)
    return outcome


def _played(contest: Contest, recorder: Recorder) -> ContestOutcome:
    """A match as far as it goes: an action that the rules refuse loses it, a shot that does not end decides nothing."""
    outcome, seed = ContestOutcome(), f"duel {contest.seed} {contest.number}"
    try:
        for decision, moment in played_out(recorder.match, contest.players, seed, outcome.think, recorder.play):
            outcome.count(decision, moment)
    except InputError:
        outcome.illegal = 1
        recorder.play(Concede(recorder.match.ask.player))
    except BudgetError:
        return outcome
    winner = recorder.match.winner
    outcome.winner = -1 if winner is None else winner
    return outcome
