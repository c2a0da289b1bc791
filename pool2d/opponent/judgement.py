"""Weighing candidates: each played on the engine, judged by the rules, and what comes of it valued."""

from __future__ import annotations

import math
import random
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from statistics import fmean
from typing import Final, NamedTuple

from ..errors import BudgetError
from ..game.actions import Stroke
from ..game.judging import Judged, judged
from ..game.reasons import Fear
from ..game.rules import Note
from ..physics.values import Layout
from .candidate import Candidate
from .candidates.pots import varied
from .fears import fears, wrong
from .stray import strayed
from .turn import Turn

# So many times as many candidates are played in mind for a share of the runs, first.
_ROUGHLY: Final = 3
_SHARE: Final = 5
# Strokes hardly differ whose tips are this near, in radii, and whose speeds are by this share.
_TIP: Final = 0.25
_PACE: Final = 0.15
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
    before = turn.placed(candidate.place)
    try:
        return judged(turn.rules, before.state, before.layout, stroke)
    except BudgetError:
        return None


def came_off(turn: Turn, candidate: Candidate, found: Judged) -> bool:
    """Whether a stroke did what it was to do: it was no foul, and what was to go on goes on."""
    quiet = candidate.kind in _QUIET and not candidate.pocket
    return not found.ruling.foul and (quiet or (_goes_on(turn, found) and _fell(candidate, found)))


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
    chance = sure * found.came_off
    return Weighed(candidate, value + _liking(turn, candidate, chance), chance)


def weigh(turn: Turn, weighed: Weighed, runs: int, seed: str) -> Weighed:
    """A candidate as it comes out with the player's own errors, played in mind so many times.

    The same seed draws the same errors for every candidate, so that luck tells less between them.
    """
    outcomes = _in_mind(turn, weighed.candidate, runs, random.Random(f"mind {seed}"))
    return _summed(turn, weighed.candidate, outcomes) if outcomes else weighed


def _in_mind(turn: Turn, candidate: Candidate, runs: int, rng: random.Random) -> list[Trial]:
    layout = turn.placed(candidate.place).layout
    strokes = (_stray(turn, layout, candidate, rng) for _ in range(runs))
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
    return Weighed(
        candidate, value + _liking(turn, candidate, chance), chance, len(outcomes), fouls, lost, fears(faults)
    )


def _liking(turn: Turn, candidate: Candidate, chance: float) -> float:
    """What a player's taste adds, as often as the pot comes off: nobody likes to miss."""
    return chance * turn.player.taste.attack if candidate.kind == "pot" else 0.0


def best(turn: Turn, candidates: Iterable[Candidate], seed: str) -> list[Weighed]:
    """The candidates that are worth most, best first.

    All are looked at once, and the best pots varied a little; those that are left are played in mind a few times, and
    the best few of those as often as the player does.
    """
    seen = _ranked(_glanced(turn, candidates))
    seen = _distinct(_ranked([*seen, *_glanced(turn, _polished(turn, seen))]))
    few, runs = int(turn.player.judgement.few), _runs(turn)
    rough = _weighed(turn, _few(seen, _ROUGHLY * few), runs // _SHARE, seed)
    return _weighed(turn, _few(rough, few), runs, seed)


def _weighed(turn: Turn, some: list[Weighed], runs: int, seed: str) -> list[Weighed]:
    return _ranked(weigh(turn, one, runs, seed) for one in some)


def _distinct(ranked: list[Weighed]) -> list[Weighed]:
    """Of strokes that hardly differ only the best."""
    first: dict[object, Weighed] = {}
    for one in ranked:
        first.setdefault(_bucket(one.candidate), one)
    return list(first.values())


def _bucket(candidate: Candidate) -> object:
    """What strokes that hardly differ have in common: what they are to do, and about how."""
    shot = candidate.stroke.shot
    tip = round(shot.side / _TIP), round(shot.height / _TIP), round(math.log(shot.speed) / _PACE)
    return candidate.kind, candidate.ball, candidate.pocket, candidate.place, round(shot.angle), tip


def _glanced(turn: Turn, candidates: Iterable[Candidate]) -> list[Weighed]:
    return [weighed for candidate in candidates if (weighed := glance(turn, candidate)) is not None]


def _polished(turn: Turn, ranked: list[Weighed]) -> Iterator[Candidate]:
    pots = [one.candidate for one in ranked if one.candidate.line is not None]
    for candidate in pots[: int(turn.player.judgement.polish)]:
        yield from varied(turn.table, turn.placed(candidate.place).layout, candidate)


def _ranked(weighed: Iterable[Weighed]) -> list[Weighed]:
    return sorted(weighed, key=lambda one: -one.value)


def _few(ranked: list[Weighed], count: int) -> list[Weighed]:
    """The first, and the best safety, which a player never leaves out."""
    safe = [one for one in ranked[count:] if one.candidate.kind == "safety"]
    return ranked[:count] + safe[:1]
