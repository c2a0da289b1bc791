"""What wins say: how sure a share is, and how strong each of several players is."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

# Of a normal distribution, 95 in 100 lie within so many standard deviations.
_Z: Final = 1.959964
# In Elo's scale: the mean of all, and the factor of ten to one.
_MEAN, _TEN = 1500.0, 400.0
# What is added to the wins of either of two who have met, so that who always wins is not infinitely strong.
_PRIOR: Final = 0.5
_ROUNDS: Final = 2000


def wilson(wins: float, played: int) -> tuple[float, float]:
    """The interval in which the chance to win lies, with 95 % confidence (Wilson 1927); all of it where none played.

    Examples:
        >>> [round(end, 3) for end in wilson(65, 100)]
        [0.553, 0.736]
    """
    if played == 0:
        return 0.0, 1.0
    share, z = wins / played, _Z * _Z / played
    middle = share + 0.5 * z
    half = _Z * math.sqrt(share * (1.0 - share) / played + 0.25 * z / played)
    return max(0.0, (middle - half) / (1.0 + z)), min(1.0, (middle + half) / (1.0 + z))


def elo(wins: Sequence[Sequence[int]]) -> list[float]:
    """How strong each player is, `wins[i][j]` being how often `i` has beaten `j`: Elo's scale, its mean at 1500.

    The chance that `i` beats `j` is p_i / (p_i + p_j) (Bradley, Terry 1952), the strengths p the likeliest ones
    (Zermelo's iteration); half a win is added to either side of each pair that has met.
    """
    met = [[float(wins[i][j] + wins[j][i] > 0) for j in range(len(wins))] for i in range(len(wins))]
    won = [[wins[i][j] + _PRIOR * met[i][j] for j in range(len(wins))] for i in range(len(wins))]
    strengths = [1.0] * len(wins)
    for _ in range(_ROUNDS):
        strengths = _likelier(won, strengths)
    logs = [math.log10(strength) for strength in strengths]
    return [_MEAN + _TEN * (one - math.fsum(logs) / len(logs)) for one in logs]


def _likelier(won: Sequence[Sequence[float]], p: Sequence[float]) -> list[float]:
    """Strengths that explain the wins better: p_i = wins of i / sum over j of games_ij / (p_i + p_j)."""
    new = [_strength(won, p, i) for i in range(len(p))]
    scale = math.exp(math.fsum(map(math.log, new)) / len(new))
    return [one / scale for one in new]


def _strength(won: Sequence[Sequence[float]], p: Sequence[float], i: int) -> float:
    games = math.fsum((won[i][j] + won[j][i]) / (p[i] + p[j]) for j in range(len(p)) if j != i)
    return math.fsum(won[i]) / games if games else 1.0
