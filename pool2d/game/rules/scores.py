"""What each of two players has, and how a stroke changes the score."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeVar

from .notes import Note
from .ruling import State

S = TypeVar("S", bound=State)
T = TypeVar("T")


def changed(values: tuple[T, ...], player: int, value: T) -> tuple[T, ...]:
    """What each player has, with one player's replaced."""
    return tuple(value if i == player else other for i, other in enumerate(values))


def points(scorer: int, count: int) -> tuple[int, ...]:
    """A change of the score for one of two players."""
    return tuple(count if player == scorer else 0 for player in (0, 1))


def added(state: S, change: tuple[int, ...]) -> S:
    """The state with points added to its scores."""
    return replace(state, scores=tuple(score + more for score, more in zip(state.scores, change, strict=True)))


def score_notes(change: tuple[int, ...]) -> tuple[Note, ...]:
    """A change of the score in words."""
    notes = (
        Note("score" if count > 0 else "loses", player, points=abs(count))
        for player, count in enumerate(change)
        if count
    )
    return tuple(notes)
