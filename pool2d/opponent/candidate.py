"""What a player may do in a turn, before and after it was judged."""

from __future__ import annotations

from dataclasses import dataclass

from ..game.actions import Stroke
from ..game.reasons import StrokeKind
from ..game.rules import Choice
from .pot_lines import PotLine


@dataclass(frozen=True, slots=True)
class Candidate:
    """A stroke that is thought of: of which kind, what ball into what pocket it is to send, and where from.

    `place` puts a cue ball that is in hand. `prior` is how likely geometry holds it to come off, `line` the straight
    pot that it was made of.
    """

    kind: StrokeKind
    stroke: Stroke
    ball: str = ""
    pocket: str = ""
    place: Choice | None = None
    prior: float = 0.0
    line: PotLine | None = None
