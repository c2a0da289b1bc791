"""Whole matches between players, without a screen."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Final

from ..game.actions import Action, NextFrame, Stroke
from ..game.match import Match, Moment
from .decide import Decision, decide
from .player import Player
from .stray import strayed

# More actions no match takes in which anything comes about.
ENDLESS: Final = 5000


def played_out(match: Match, players: Sequence[Player], seed: str) -> Iterator[tuple[Decision | None, Moment]]:
    """Play a match to its end: each decision, None between frames, and the moments that its actions lead to."""
    while not match.over and len(match.history) < ENDLESS:
        if match.state.over:
            yield None, match.play(NextFrame())
        else:
            yield from _turn(match, players[match.ask.player], f"{seed} {len(match.history)}")


def _turn(match: Match, player: Player, seed: str) -> Iterator[tuple[Decision, Moment]]:
    decision = decide(match.judge, match.now.ruling, player, seed)
    for action in decision.actions:
        yield decision, match.play(by_hand(match, action, player, seed))


def by_hand(match: Match, action: Action, player: Player, seed: str) -> Action:
    """An action as it comes out: of a stroke that was meant, what the player's hand makes of it."""
    if not isinstance(action, Stroke):
        return action
    rng = random.Random(f"hand {seed}")
    return replace(action, shot=strayed(match.table, match.layout, action.shot, player.hand, rng))
