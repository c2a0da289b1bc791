"""What a player does when it is asked for anything: a choice, or a stroke, or where the cue ball goes and a stroke."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Final

from ..game.actions import Action, Stroke
from ..game.rules import CHOOSE, Choice, Rules, Ruling
from .candidates.find import anything, candidates
from .judgement import Weighed, best, glance
from .lagging import lag
from .player import Player
from .reasoning import reasons
from .turn import Turn
from .worth import Scale, usual_rate

# Who is ahead by no more than this, in chances to win or in points, agrees to begin a frame again.
_HARDLY: Final = 0.05, 1.0


@dataclass(frozen=True, slots=True)
class Decision:
    """What a player does: `actions`, of which a stroke is as it was meant; and what it `weighed`, the best first."""

    actions: tuple[Action, ...]
    weighed: tuple[Weighed, ...] = ()

    @property
    def stroke(self) -> Stroke | None:
        """The stroke that ends the turn, as it is meant."""
        last = self.actions[-1]
        return last if isinstance(last, Stroke) else None


def decide(rules: Rules[Any], ruling: Ruling, player: Player, seed: str) -> Decision:
    """What a player does where a game stands; the same seed gives the same, whatever runs it."""
    turn = Turn(rules, ruling, player)
    if turn.ask.kind == CHOOSE:
        return Decision((_option(turn)[1],))
    if rules.lags:
        return Decision((lag(turn),))
    weighed = _weighed(turn, seed)
    choice = _better(turn, weighed[0].value) if turn.ask.options else None
    return Decision((choice,) if choice else _actions(weighed), tuple(weighed))


def agrees(rules: Rules[Any], ruling: Ruling, player: Player, me: int) -> bool:
    """Whether a player agrees to begin a frame again that the other finds gets nowhere.

    It does where it is hardly ahead: where things as they stand are worth little more than a rack that either may win.
    """
    scale = Scale(rules, player.hand, usual_rate(player.hand))
    anew = ruling.state if rules.lags_again else rules.stalemate(ruling.state).state
    even = scale.ahead(anew, me) if rules.scored else 0.5
    return scale.value(ruling, me) <= even + _HARDLY[rules.scored]


def _better(turn: Turn, value: float) -> Choice | None:
    """The best option where it is worth more than the best stroke.

    One after which the same player shoots has to be worth more than things as they stand too, by the same measure: or
    two starting spots would be changed for each other without end.
    """
    worth, choice = _option(turn)
    stays = turn.chosen(choice).ask.player == turn.me
    least = max(value, turn.worth_of(turn.ruling)) if stays else value
    return choice if worth > least else None


def _option(turn: Turn) -> tuple[float, Choice]:
    """The option that is worth most, the first of equals."""
    choices = [Choice(key) for key in turn.ask.options]
    return max(((turn.worth_of(turn.chosen(choice)), choice) for choice in choices), key=lambda one: one[0])


def _weighed(turn: Turn, seed: str) -> list[Weighed]:
    """What is thought of, the best first; never nothing."""
    found = best(turn, candidates(turn), seed)
    return found or [glance(turn, anything(turn)) or Weighed(anything(turn), 0.0, 0.0)]


def _actions(weighed: list[Weighed]) -> tuple[Action, ...]:
    """The best of what was weighed, with the reasons."""
    place, stroke = weighed[0].candidate.place, replace(weighed[0].candidate.stroke, why=reasons(weighed))
    return (stroke,) if place is None else (place, stroke)
