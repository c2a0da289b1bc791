"""Weighing candidates: each played on the engine, judged by the rules, and what comes of it valued."""

from __future__ import annotations

import random
from collections.abc import Iterable
from dataclasses import dataclass, replace
from statistics import fmean
from typing import NamedTuple

from ..errors import BudgetError
from ..game.actions import Stroke
from ..game.judging import Judged, judged
from ..game.reasons import Fear
from ..game.rules import Note
from ..physics.values import Layout
from .candidate import Candidate
from .fears import fears, wrong
from .stray import strayed
from .turn import Turn

# What is no pot comes off where it is no foul.
_QUIET = ("safety", "kick", "push", "break", "hope")


class Trial(NamedTuple):
    """What came of one stroke: its worth, whether it came off, was a foul, or lost the turn, and what was `wrong`."""

    value: float
    came_off: bool
    foul: bool
    lost: bool
    wrong: Note | None


@dataclass(frozen=True, slots=True)
class Weighed:
    """A candidate and what it is worth: the `value`, as `Scale` has it, and the `chance` of its coming off.

    It was played in mind `runs` times; `fouls` and `lost` are the shares of those that were fouls, and that brought the
    other player to the table; `fears` what went wrong most often.
    """

    candidate: Candidate
    value: float
    chance: float
    runs: int = 1
    fouls: float = 0.0
    lost: float = 0.0
    fears: tuple[Fear, ...] = ()


def played(turn: Turn, candidate: Candidate, stroke: Stroke) -> Judged | None:
    """What comes of a stroke of a candidate's; None where it does not end."""
    before = turn.ruling if candidate.place is None else turn.chosen(candidate.place)
    try:
        return judged(turn.rules, before.state, before.layout, stroke)
    except BudgetError:
        return None


def came_off(turn: Turn, candidate: Candidate, found: Judged) -> bool:
    """Whether a stroke did what it was to do: it was no foul, and what was to go on goes on."""
    return not found.ruling.foul and (candidate.kind in _QUIET or (_goes_on(turn, found) and _fell(candidate, found)))


def _goes_on(turn: Turn, found: Judged) -> bool:
    state = found.ruling.state
    return state.ask.player == turn.me and (not state.over or state.winner == turn.me)


def _fell(candidate: Candidate, found: Judged) -> bool:
    return not candidate.pocket or (candidate.ball, candidate.pocket) in found.report.pots


def _trial(turn: Turn, candidate: Candidate, stroke: Stroke) -> Trial | None:
    found = played(turn, candidate, stroke)
    if found is None:
        return None
    ruling, value, good = found.ruling, turn.worth_of(found.ruling), came_off(turn, candidate, found)
    fault = wrong(turn, candidate, found, value, good)
    return Trial(value, good, ruling.foul, ruling.ask.player != turn.me, fault)


def glance(turn: Turn, candidate: Candidate) -> Weighed | None:
    """A candidate as it comes out where nothing goes wrong, and as often as geometry holds that it will."""
    found = _trial(turn, candidate, candidate.stroke)
    if found is None:
        return None
    sure = candidate.prior if found.came_off and candidate.prior else 1.0
    value = sure * found.value + (1.0 - sure) * turn.lost
    return Weighed(candidate, value + _liking(turn, candidate), sure * found.came_off)


def weigh(turn: Turn, weighed: Weighed, rng: random.Random) -> Weighed:
    """A candidate as it comes out with the player's own errors, played in mind as often as the player does that."""
    outcomes = _in_mind(turn, weighed.candidate, rng)
    return _summed(turn, weighed.candidate, outcomes) if outcomes else weighed


def _in_mind(turn: Turn, candidate: Candidate, rng: random.Random) -> list[Trial]:
    layout = turn.layout if candidate.place is None else turn.chosen(candidate.place).layout
    strokes = (_stray(turn, layout, candidate, rng) for _ in range(_runs(turn)))
    return [outcome for stroke in strokes if (outcome := _trial(turn, candidate, stroke)) is not None]


def _runs(turn: Turn) -> int:
    """Who never strays needs to look once."""
    runs = int(turn.player.judgement.runs)
    return min(1, runs) if turn.player.hand.steady else runs


def _stray(turn: Turn, layout: Layout, candidate: Candidate, rng: random.Random) -> Stroke:
    stroke = candidate.stroke
    return replace(stroke, shot=strayed(turn.table, layout, stroke.shot, turn.player.hand, rng))


def _summed(turn: Turn, candidate: Candidate, outcomes: list[Trial]) -> Weighed:
    *columns, faults = zip(*outcomes, strict=True)
    value, chance, fouls, lost = (fmean(map(float, column)) for column in columns)
    value += _liking(turn, candidate)
    return Weighed(candidate, value, chance, len(outcomes), fouls, lost, fears(faults))


def _liking(turn: Turn, candidate: Candidate) -> float:
    """What a player's taste adds."""
    return turn.player.taste.attack if candidate.kind == "pot" else 0.0


def best(turn: Turn, candidates: Iterable[Candidate], rng: random.Random) -> list[Weighed]:
    """The candidates that are worth most, best first: all are looked at once, and a few gone through in earnest."""
    seen = [weighed for candidate in candidates if (weighed := glance(turn, candidate)) is not None]
    return _ranked(weigh(turn, one, rng) for one in _few(_ranked(seen), int(turn.player.judgement.few)))


def _ranked(weighed: Iterable[Weighed]) -> list[Weighed]:
    return sorted(weighed, key=lambda one: -one.value)


def _few(ranked: list[Weighed], count: int) -> list[Weighed]:
    """The first, and the best safety, which a player never leaves out."""
    safe = [one for one in ranked[count:] if one.candidate.kind == "safety"]
    return ranked[:count] + safe[:1]
