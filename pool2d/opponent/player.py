"""A player as a file: name, hand, judgement and taste."""

from __future__ import annotations

from dataclasses import dataclass, field

from ..config.knobs import knob
from .stray import Hand


@dataclass(frozen=True, slots=True)
class Judgement:
    """How much a player sees, and how long it weighs what it sees; all are counts, so that a seed decides all."""

    ways: float = knob(4.0, 1.0, 20.0, "", "how many of the pots that lie open it looks at")
    paces: float = knob(3.0, 1.0, 4.0, "", "how many speeds it knows for each")
    heights: float = knob(3.0, 1.0, 3.0, "", "centre ball, and draw, and follow")
    sides: float = knob(3.0, 1.0, 3.0, "", "no english, and right, and left")
    few: float = knob(4.0, 1.0, 20.0, "", "how many plans it goes through in earnest")
    runs: float = knob(30.0, 0.0, 200.0, "", "how many times it plays each of them in its mind, with its own errors")
    safeties: float = knob(12.0, 0.0, 200.0, "", "how many safeties it looks at")
    kicks: float = knob(60.0, 0.0, 720.0, "", "in how many directions it looks for a way by the cushions")
    banks: float = knob(4.0, 0.0, 40.0, "", "how many banks and combinations it looks at")


@dataclass(frozen=True, slots=True)
class Taste:
    """What a player likes."""

    attack: float = knob(0.0, -1.0, 1.0, "", "what it adds to the worth of a pot, in chances to win")
    pace: float = knob(8.0, 1.0, 12.0, "m/s", "how hard it breaks")


@dataclass(frozen=True, slots=True)
class Player:
    """Somebody to play against."""

    name: str
    title: str = ""
    hand: Hand = field(default_factory=Hand)
    judgement: Judgement = field(default_factory=Judgement)
    taste: Taste = field(default_factory=Taste)
