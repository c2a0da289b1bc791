"""Records of earlier versions, whose lines tell of each moment no more than a digest of it.

That digest was of all that a state held then. What games have come to hold since is left out, so that those records
open as long as the game stands the same.
"""

from __future__ import annotations

import hashlib
import json
from typing import Any

from ..match import Match
from ..tally import Tally

# What states, and what they ask, held then.
_STATE = frozenset({
    "kind", "who", "ball", "where", "on", "call", "may", "options", "ask", "turn", "breaker", "scores", "fouls",
    "seed", "racks", "shots", "rests", "groups", "opening", "pockets", "held", "owed", "waiting", "visits", "free",
    "trial", "phase", "run", "left", "snookers", "tied", "before", "was", "freed", "misses", "innings", "best",
    "last", "zone",
})  # fmt: skip
# So many fields a ball had, which had no height.
_BALL = 11
_TALLY = ("frames", "points", "strokes", "innings", "pots", "fouls", "run", "best")


def digest(match: Match) -> str:
    """A fingerprint of where a match stands: the state of the game, every bit of the balls, the tallies."""
    now = match.now
    state = json.dumps(_held(now.state.as_dict()), sort_keys=True)
    balls = [tuple(ball)[:_BALL] for ball in now.layout.values()]
    tallies = ", ".join(map(_told, now.tallies)) + ("," if len(now.tallies) == 1 else "")
    return hashlib.sha256(f"({state!r}, {balls!r}, ({tallies}))".encode()).hexdigest()[:16]


def _held(data: dict[str, Any]) -> dict[str, Any]:
    """What a state held then."""
    return {name: _held(value) if isinstance(value, dict) else value for name, value in data.items() if name in _STATE}


def _told(tally: Tally) -> str:
    return f"Tally({', '.join(f'{name}={getattr(tally, name)!r}' for name in _TALLY)})"
