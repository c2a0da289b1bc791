"""A player: name, hand, judgement and taste, all of them knobs, so that a file may set them (`player_file`)."""

from __future__ import annotations

from dataclasses import dataclass, field

from ..config.knobs import knob, text
from .stray import Hand


@dataclass(frozen=True, slots=True)
class Judgement:
    """How much a player sees, and how long it weighs what it sees; all are counts, so that a seed decides all.

    It has more attributes than most classes, one for each thing that a player may be better or worse at.
    """

    ways: float = knob(4.0, 1.0, 20.0, "", "how many of the pots that lie open it looks at")
    paces: float = knob(3.0, 1.0, 4.0, "", "how many speeds it knows for each")
    heights: float = knob(3.0, 1.0, 3.0, "", "centre ball, and draw, and follow")
    sides: float = knob(3.0, 1.0, 3.0, "", "no english, and right, and left")
    places: float = knob(10.0, 1.0, 100.0, "", "at how many places for a cue ball in hand it looks in earnest")
    polish: float = knob(
        3.0, 0.0, 20.0, "", "how many of its best pots it varies a little, to leave the cue ball better"
    )
    few: float = knob(4.0, 1.0, 20.0, "", "how many plans it goes through in earnest")
    runs: float = knob(30.0, 0.0, 200.0, "", "how many times it plays each of them in its mind, with its own errors")
    safeties: float = knob(12.0, 0.0, 200.0, "", "how many safeties it looks at")
    kicks: float = knob(60.0, 0.0, 720.0, "", "in how many directions it looks for a way by the cushions")
    banks: float = knob(4.0, 0.0, 40.0, "", "how many banks, and kicks that pot, it looks at")
    combinations: float = knob(4.0, 0.0, 40.0, "", "how many combinations and caroms it looks at")
    cannons: float = knob(300.0, 0.0, 20000.0, "", "how many strokes it tries for a cannon, on a table without pockets")


@dataclass(frozen=True, slots=True)
class Taste:
    """What a player likes."""

    attack: float = knob(0.0, -1.0, 1.0, "", "what it adds to the worth of a pot, in chances to win")
    pace: float = knob(8.0, 1.0, 12.0, "m/s", "how hard it breaks")


@dataclass(frozen=True, slots=True)
class Sayings:
    """What a player says of himself or herself, by language."""

    en: str = text("", 200, "a line or two in English")
    de: str = text("", 200, "a line or two in German")


@dataclass(frozen=True, slots=True)
class Rates:
    """What a player does, as `pool2d players --measure` found it: nothing, where `when` is empty."""

    when: str = text("", 40, "the day on which that was measured")
    how: str = text("", 200, "the command that measured it, and by which version")
    balls: float = knob(0.0, 0.0, 100.0, "", "balls made in ten racks of the drill")
    pots: float = knob(0.0, 0.0, 100.0, "%", "pots that came off, of the fixed set")
    run: float = knob(0.0, 0.0, 1000.0, "", "balls that a visit to the table makes at nine-ball, from the break on")
    break_and_runs: float = knob(0.0, 0.0, 100.0, "%", "racks of nine-ball broken and run out")
    three_cushion: float = knob(0.0, 0.0, 1000.0, "", "points to the inning at three-cushion")
    snooker_break: float = knob(0.0, 0.0, 155.0, "", "the highest break at snooker")


@dataclass(frozen=True, slots=True)
class Player:
    """Somebody to play against; `rank` says where among the others, the weakest first."""

    name: str = text("", 40, "what others call the player")
    title: str = text("", 40, "how good people are who play like that")
    hand: Hand = field(default_factory=Hand)
    judgement: Judgement = field(default_factory=Judgement)
    taste: Taste = field(default_factory=Taste)
    rank: float = knob(50.0, 0.0, 100.0, "", "where the player stands among the others, the weakest at 0")
    words: Sayings = field(default_factory=Sayings)
    measured: Rates = field(default_factory=Rates)
