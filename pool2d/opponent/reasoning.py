"""The reasons of a stroke that a player has decided on, as a record keeps them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from ..game.reasons import Reasons, Thought
from .candidate import Candidate
from .judgement import Weighed

# So many others are told of.
_MOST: Final = 3


def reasons(weighed: Sequence[Weighed]) -> Reasons:
    """Why the first of what was weighed, the best first, is played.

    Of what was meant alike, the same ball into the same pocket, one is told of: it is thought of once, and then how.
    """
    first, *rest = weighed
    others: dict[tuple[str, str, str], Weighed] = {}
    for one in rest:
        others.setdefault(_aim(one.candidate), one)
    return Reasons(_thought(first), tuple(map(_thought, list(others.values())[:_MOST])), first.fears)


def _aim(candidate: Candidate) -> tuple[str, str, str]:
    return candidate.kind, candidate.ball, candidate.pocket


def _thought(weighed: Weighed) -> Thought:
    """What is told of one candidate."""
    of = weighed.candidate
    numbers = (float(weighed.chance), float(weighed.value), weighed.runs, weighed.fouls, weighed.lost)
    place = None if of.place is None else (float(of.place.x), float(of.place.y))
    return Thought(of.kind, of.stroke.shot, of.ball, of.pocket, *numbers, place)
