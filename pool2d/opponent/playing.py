"""Whole matches between players, without a screen."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any, Final, TypeAlias

from ..game.actions import Action, NextFrame, Stroke
from ..game.match import Match, Moment
from ..game.rules import Rules, Ruling
from .deciding import Decision, decide
from .player import Player
from .stray import strayed

# More actions no match takes in which anything comes about.
ENDLESS: Final = 5000


Think: TypeAlias = Callable[[Rules[Any], Ruling, Player, str], Decision]


def played_out(
    match: Match,
    players: Sequence[Player],
    seed: str,
    think: Think = decide,
    play: Callable[[Action], Moment] | None = None,
) -> Iterator[tuple[Decision | None, Moment]]:
    """Play a match to its end: each decision, None between frames, and the moments that its actions lead to.

    `play` carries actions out, as the match itself does, or the recorder that it has.
    """
    play = play or match.play
    while not match.over and len(match.history) < ENDLESS:
        if match.state.over:
            yield None, play(NextFrame())
            continue
        player, turn = players[match.ask.player], f"{seed} {len(match.history)}"
        decision = think(match.judge, match.now.ruling, player, turn)
        yield from ((decision, play(by_hand(match, action, player, turn))) for action in decision.actions)


def by_hand(match: Match, action: Action, player: Player, seed: str) -> Action:
    """An action as it comes out: of a stroke that was meant, what the player's hand makes of it."""
    if not isinstance(action, Stroke):
        return action
    rng = random.Random(f"hand {seed}")
    return replace(action, shot=strayed(match.table, match.layout, action.shot, player.hand, rng))
