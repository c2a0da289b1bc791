"""What `pool2d duel` does: have the matches played and recorded, and tell what they say of the players."""

from __future__ import annotations

import contextlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from typing import Any, TypeAlias

from ..errors import InputError
from ..game.records.record import ENDING
from ..opponent.contests.contest import DRAFT, Contest, ContestOutcome, held
from ..opponent.contests.score import DuelScore, pace, scored
from ..opponent.contests.standings import elo, wilson
from ..opponent.player import Player
from ..study.crew import crew
from ..table.table import Table
from . import terminal
from .progress import Progress

Pair: TypeAlias = tuple[str, str]


@dataclass(frozen=True, slots=True)
class DuelPlan:
    """Who plays what on what, how often each two of them, from what seed; where it goes, and who does it."""

    table: Table
    game: str
    players: Mapping[str, Player]
    files: tuple[str, ...]
    matches: int
    seed: int
    folder: Path
    jobs: int
    as_json: bool = False

    @property
    def pairs(self) -> list[Pair]:
        """Each two of the players."""
        return list(combinations(self.files, 2))

    def contests(self) -> list[Contest]:
        """Every match."""
        return [self._contest(pair, number) for pair in self.pairs for number in range(self.matches)]

    def _contest(self, pair: Pair, number: int) -> Contest:
        one, two = pair
        path = self.folder / f"{Path(one).stem} - {Path(two).stem} {number + 1:04d}{ENDING}"
        players = self.players[one], self.players[two]
        return Contest(self.table, self.game, pair, players, self.seed, number, path)

    def name(self, file: str) -> str:
        """What a player is called."""
        return self.players[file].name


def duel(plan: DuelPlan) -> int:
    """Play the matches and tell what came of them; the exit status."""
    contests = plan.contests()
    for contest in contests:
        if contest.path.exists():
            raise InputError(str(contest.path), "", None, "is there already; allowed is a folder without these matches")
    outcomes: list[ContestOutcome] = []
    try:
        _play(plan, contests, outcomes)
    except KeyboardInterrupt:
        terminal.complain(f"pool2d: interrupted; {len(outcomes)} of {len(contests)} matches are played, and counted")
    finally:
        for contest in contests[len(outcomes) :]:
            with contextlib.suppress(OSError):
                contest.path.with_suffix(DRAFT).unlink(missing_ok=True)
    _tell(plan, contests, outcomes)
    return 0 if len(outcomes) == len(contests) else terminal.INTERRUPTED


def _play(plan: DuelPlan, contests: list[Contest], outcomes: list[ContestOutcome]) -> None:
    """Have the matches played, in their order as far as it is told."""
    progress = Progress(len(contests), 0)
    try:
        with crew(plan.jobs, progress.went) as team:
            outcomes.extend(team.stream(held, [(contest,) for contest in contests]))
    finally:
        progress.end()


def _tell(plan: DuelPlan, contests: list[Contest], outcomes: list[ContestOutcome]) -> None:
    done = list(zip(contests, outcomes, strict=False))
    scores = {pair: scored(one for contest, one in done if contest.files == pair) for pair in plan.pairs}
    if len(plan.files) == 2:
        _tell_pair(plan, scores[plan.pairs[0]])
    else:
        _tell_all(plan, scores)
    if not plan.as_json:
        terminal.tell(f"{plan.folder}: {len(outcomes)} records")


def _tell_pair(plan: DuelPlan, score: DuelScore) -> None:
    if plan.as_json:
        about = {"game": plan.game, "seed": plan.seed, "matches": score.matches}
        terminal.write(json.dumps({**about, **score.as_dict()}))
        return
    terminal.tell(f"{plan.game} on {plan.table.source}, seed {plan.seed}: {score.matches} matches")
    for side, file in enumerate(plan.files):
        terminal.tell(f"  {plan.name(file):<12} {_line(score, side)}")
    if score.illegal or sum(score.wins) < score.matches:
        terminal.tell(f"  illegal actions {score.illegal}, undecided {score.matches - sum(score.wins)}")


def _line(score: DuelScore, side: int) -> str:
    """What a player did, in a line."""
    did, wins = score.sides[side], score.wins[side]
    low, high = wilson(wins, score.matches)
    usual, longest = pace(did)
    share = 100.0 * wins / max(1, score.matches)
    won = f"{wins:>4} won, {share:3.0f} % ({100 * low:.0f} to {100 * high:.0f})"
    made = f"{did.pots} of {did.attempts} tries made, {did.fouls} fouls"
    return f"{won}; {made}; {usual:.2f} s a decision, the longest {longest:.2f} s"


def _tell_all(plan: DuelPlan, scores: Mapping[Pair, DuelScore]) -> None:
    wins = [[_wins(scores, one, other) for other in plan.files] for one in plan.files]
    ratings = [round(rating) for rating in elo(wins)]
    if plan.as_json:
        terminal.write(json.dumps(_as_dict(plan, scores, wins, ratings)))
        return
    terminal.tell(f"{plan.game} on {plan.table.source}, seed {plan.seed}: {plan.matches} matches of each two")
    terminal.tell(f"{'':<12} {'Elo':>5} {'won':>5}  " + " ".join(f"{plan.name(file)[:7]:>7}" for file in plan.files))
    for row, (file, rating) in enumerate(zip(plan.files, ratings, strict=True)):
        cells = " ".join(f"{won if other != row else '-':>7}" for other, won in enumerate(wins[row]))
        terminal.tell(f"{plan.name(file):<12} {rating:>5} {sum(wins[row]):>5}  {cells}")


def _wins(scores: Mapping[Pair, DuelScore], one: str, other: str) -> int:
    """How often one has beaten the other."""
    if (one, other) in scores:
        return scores[one, other].wins[0]
    return scores[other, one].wins[1] if (other, one) in scores else 0


def _as_dict(
    plan: DuelPlan, scores: Mapping[Pair, DuelScore], wins: list[list[int]], ratings: list[int]
) -> dict[str, Any]:
    illegal = sum(score.illegal for score in scores.values())
    about = {"game": plan.game, "seed": plan.seed, "matches": plan.matches, "players": list(plan.files)}
    return {**about, "wins": wins, "elo": ratings, "illegal": illegal}
