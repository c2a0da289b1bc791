"""What goes wrong when a stroke is played in mind, and how often: what a player fears of it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Final

from ..game.judging import Judged
from ..game.reasons import Fear
from ..game.rules import Note
from .candidate import Candidate
from .turn import Turn

# So many of a stroke's fears are kept, the worst.
_MOST: Final = 3


def wrong(turn: Turn, candidate: Candidate, found: Judged, value: float, came_off: bool) -> Note | None:
    """The worst of what went wrong with a stroke of that `value`; None where nothing did."""
    ruling = found.ruling
    if ruling.state.over and ruling.state.winner not in (turn.me, None):
        return Note("fear.frame")
    if ruling.foul:
        return ruling.fouls[0]
    # Worth less than if the other player came to the table as things stood before: a better chance than most.
    if ruling.ask.player == turn.rules.other(turn.me) and value < turn.lost:
        return Note("fear.left", ruling.ask.player)
    return None if came_off else _missed(turn, candidate)


def _missed(turn: Turn, candidate: Candidate) -> Note:
    pocket = bool(candidate.ball and candidate.pocket)
    return Note("fear.missed", ball=turn.rules.spoken(candidate.ball)) if pocket else Note("fear.nothing")


def fears(faults: Sequence[Note | None]) -> tuple[Fear, ...]:
    """What went wrong most often, in what share of all the times."""
    counted = Counter(fault for fault in faults if fault is not None)
    return tuple(Fear(fault, count / len(faults)) for fault, count in counted.most_common(_MOST))
