"""The chance that a shot comes off: played again and again on the engine with a hand's errors."""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import Final, TypeAlias

from ...errors import InputError
from ...physics.rollout import Rollout
from ...physics.simulate import simulate
from ...physics.values import GONE, Layout, Shot
from ...table.table import Table
from ..stray import Hand, strayed
from .standings import wilson

Judge: TypeAlias = Callable[[Rollout], bool]

# So many runs leave the chance unsure by some 7 in 100 either way.
RUNS: Final = 200


class Chance(float):
    """A chance, as the share of `runs` that came off; between `low` and `high` it is with 95 % confidence (Wilson).

    Examples:
        >>> from pool2d.opponent import Chance
        >>> chance = Chance(150, 200)
        >>> chance > 0.7, round(chance.low, 2), round(chance.high, 2), chance.runs
        (True, 0.69, 0.8, 200)
    """

    low: float
    high: float
    runs: int

    def __new__(cls, came_off: int, runs: int) -> Chance:
        self = super().__new__(cls, came_off / runs)
        self.low, self.high = wilson(came_off, runs)
        self.runs = runs
        return self

    def __getnewargs__(self) -> tuple[int, int]:  # type: ignore[override]
        return round(self * self.runs), self.runs


def chances(
    table: Table,
    layout: Layout,
    shot: Shot,
    hand: Hand,
    *,
    runs: int = RUNS,
    seed: int | str = 0,
    came_off: Judge | None = None,
) -> Chance:
    """The chance that a shot comes off under a hand's errors, of so many runs on the engine.

    Without `came_off`, which is asked of the rollout of each run, a shot comes off that does what it does without
    errors: the ball that falls first then falls into the same pocket; where none falls, the struck ball meets the
    same ball first. The struck ball has to stay on the table. The same seed gives the same chance. Raises InputError
    where `runs` is less than 1, and what `simulate` raises.

    Examples:
        >>> from pool2d import Ball, Layout, Shot, load_table
        >>> from pool2d.opponent import Hand, chances
        >>> layout = Layout([Ball("cue", 1.27, 0.4), Ball("1", 1.27, 0.9)])
        >>> stop = Shot(angle=90.0, speed=1.5, height=-0.3)
        >>> sure, steady, shaky = (chances(load_table("pool-9ft"), layout, stop, Hand(aim)) for aim in (0, 1, 8))
        >>> sure >= steady > shaky, sure.runs
        (True, 200)
    """
    if runs < 1:
        raise InputError("chances", "runs", runs, "allowed is a whole number from 1")
    judge = came_off or as_meant(simulate(table, layout, shot), shot.ball)
    rng = random.Random(f"chances {seed}")
    strokes = (strayed(table, layout, shot, hand, rng) for _ in range(runs))
    return Chance(sum(bool(judge(simulate(table, layout, stroke))) for stroke in strokes), runs)


def as_meant(meant: Rollout, struck: str) -> Judge:
    """Tells of a rollout whether what it was to do, as one without errors did it, has come off."""
    fell = _first_pot(meant, struck)
    first = _first_met(meant, struck)

    def judge(rollout: Rollout) -> bool:
        if rollout.layout()[struck].phase in GONE:
            return False
        return fell in _pots(rollout) if fell else _first_met(rollout, struck) == first

    return judge


def _pots(rollout: Rollout) -> list[tuple[str, str | None]]:
    """Each ball that fell, and its pocket."""
    return [(ball, event.where) for event in rollout.events if event.kind == "ball_pocket" for ball in event.balls]


def _first_pot(rollout: Rollout, struck: str) -> tuple[str, str | None] | None:
    return next((pot for pot in _pots(rollout) if pot[0] != struck), None)


def _first_met(rollout: Rollout, struck: str) -> str:
    """The ball that the struck one meets first, "" for none."""
    pairs = (pair for event in rollout.events for pair in event.pairs if struck in pair)
    return next((a if b == struck else b for a, b in pairs), "")
