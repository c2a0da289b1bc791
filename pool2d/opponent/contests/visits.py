"""A visit to the table: what a player does alone, until the turn passes or the game is over."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import replace
from typing import Any, Final

from ...errors import BudgetError
from ...game.actions import Stroke
from ...game.judging import Judged, judged
from ...game.rules import Choice, Rules, Ruling
from ..deciding import decide
from ..player import Player
from ..stray import strayed

# No visit takes more actions in which anything comes about.
_LONGEST: Final = 400


def visit(rules: Rules[Any], ruling: Ruling, player: Player, seed: str) -> Iterator[Judged]:
    """The strokes of a visit to the table; one that does not end ends it."""
    me = ruling.ask.player
    for count in range(_LONGEST):
        if ruling.state.over or ruling.ask.player != me:
            return
        found = _turn(rules, ruling, player, f"{seed} {count}")
        if isinstance(found, Judged):
            yield found
        elif found is None:
            return
        ruling = found.ruling if isinstance(found, Judged) else found


def _turn(rules: Rules[Any], ruling: Ruling, player: Player, seed: str) -> Judged | Ruling | None:
    """What comes of a decision: of a stroke, or of a choice; None where the stroke does not end."""
    for action in decide(rules, ruling, player, seed).actions:
        if isinstance(action, Choice):
            ruling = rules.choose(ruling.state, ruling.layout, action)
        elif isinstance(action, Stroke):
            return _stroke(rules, ruling, action, player, seed)
    return ruling


def _stroke(rules: Rules[Any], ruling: Ruling, meant: Stroke, player: Player, seed: str) -> Judged | None:
    shot = strayed(rules.table, ruling.layout, meant.shot, player.hand, random.Random(f"hand {seed}"))
    try:
        return judged(rules, ruling.state, ruling.layout, replace(meant, shot=shot))
    except BudgetError:
        return None


def potted(rules: Rules[Any], strokes: Iterator[Judged], me: int = 0) -> tuple[int, bool]:
    """How many balls a visit makes, and whether it wins."""
    balls, won = 0, False
    for stroke in strokes:
        balls += len(rules.pots(me, stroke.report, stroke.ruling))
        won = stroke.ruling.state.winner == me
    return balls, won
