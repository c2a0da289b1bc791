"""What rulings say, in English.

A `Note` is a key and what fills its gaps. `say` makes a sentence of it; names of players are put in by
whoever shows it, and so are other words and names of balls where it is shown in another language.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from ...errors import InputError

ENGLISH: dict[str, str] = {
    # Fouls.
    "foul.scratch": "the cue ball was pocketed",
    "foul.cue-off": "the cue ball left the table",
    "foul.cue-over": "the cue ball left the table over the {where} cushion",
    "foul.cue-on-rail": "the cue ball came to rest on the {where} rail",
    "foul.off": "the {ball} left the table",
    "foul.over": "the {ball} left the table over the {where} cushion",
    "foul.on-rail": "the {ball} came to rest on the {where} rail",
    "foul.jump": "the cue ball jumped over the {ball}",
    "foul.no-hit": "the cue ball hit no ball",
    "foul.wrong-ball": "the {ball} was hit first, and it was not on",
    "foul.no-rail": "no ball was driven to a cushion after the hit",
    "foul.kitchen": "the ball hit first was behind the head string",
    "foul.stayed": "the cue ball did not leave the kitchen",
    "foul.double-hit": "the tip was still on the cue ball when it met the {ball}",
    "foul.second-hit": "the tip struck the cue ball twice",
    "foul.scoop": "the tip dug under the cue ball and lifted it",
    "foul.push": "push stroke",
    "foul.break": "the break was not legal",
    "foul.three": "third foul in a row",
    "foul.two-at-once": "two balls were hit at once",
    "foul.potted": "the {ball} was pocketed, and it was not on",
    "foul.free-snooker": "the {ball} was the free ball, and snookers",
    "foul.into-rail": "the cue ball was played into the cushion it lay on",
    "foul.inside": "no ball was driven out of the corner",
    "foul.not-red": "the red was not hit first",
    "foul.not-far": "the far red was not hit first",
    "foul.no-red": "no red was hit",
    "foul.other-ball": "the {ball} was hit, which is the opponent's",
    "foul.color-snooker": "the {ball} was nominated, and snookers",
    # What happened.
    "break": "{player} breaks",
    "turn": "{player} to play",
    "in-hand.anywhere": "{player} has the cue ball in hand, anywhere",
    "in-hand.kitchen": "{player} has the cue ball in hand, behind the head string",
    "in-hand.baulk": "{player} has the cue ball in hand, in baulk",
    "in-hand.d": "{player} has the cue ball in hand, in the D",
    "chooses": "{player} chooses",
    "spotted": "the {ball} is spotted",
    "score": "{player} scores {points}",
    "loses": "{player} loses {points}",
    "concedes": "{player} concedes",
    "wins": "{player} wins",
    "draw": "nobody wins",
    "not-called": "the {ball} was not called",
    "illegal-break": "the break was not legal",
    "group.solid": "{player} has the solids",
    "group.stripe": "{player} has the stripes",
    "loss.eight-off": "{player} drove the 8 off the table",
    "loss.eight-foul": "{player} pocketed the 8 on a foul",
    "loss.eight-early": "{player} pocketed the 8 too early",
    "loss.eight-pocket": "{player} pocketed the 8 where it was not called",
    "owes": "{player} owes a ball",
    "re-racked": "the balls are racked again",
    "miss": "foul and a miss",
    "warned": "{player} will lose the frame by another miss",
    "free-ball": "free ball",
    "tie": "the scores are level; the black is spotted again",
    "claims": "{player} claims the frame",
    "group.red": "{player} has the reds",
    "group.yellow": "{player} has the yellows",
    "loss.black-foul": "{player} pocketed the black on a foul",
    "loss.black-early": "{player} pocketed the black too early",
    "two-visits": "{player} has two visits",
    "free-shot": "{player} has a free shot, at any ball, and a visit",
    "last-miss": "after another miss of {player} the cue ball may be placed anywhere",
    "own-ball": "the ball that {player} struck has fallen, and counts",
    "no-finish": "{player} needs a cannon by three cushions to finish",
    "missed.none": "no ball was met",
    "missed.one": "only the {ball} was met",
    "cushions.0": "no cushion before the second ball",
    "cushions.1": "one cushion before the second ball",
    "cushions.2": "two cushions before the second ball",
    "second-foul": "second foul in a row by {player}",
    "last-inning": "{player} has the last inning, from the starting position",
    # The lag.
    "lag.turn": "{player} lags: off the far (foot) cushion and back, as near to the head cushion as can be",
    "lag.rest": "{player} comes to rest {points} mm from the head cushion",
    "lag.bad": "the lag of {player} is bad",
    "lag.lost": "the ball did not stay on the table",
    "lag.foot": "the ball has to meet the foot cushion once, and only once",
    "lag.side": "the ball touched a side cushion",
    "lag.astray": "the ball went over to the other side, or met the other ball",
    "lag.jaws": "the ball lies between the jaws of a corner",
    "lag.won": "{player} wins the lag",
    "lag.again": "nobody has won the lag",
    # What who plans a stroke fears of it.
    "fear.frame": "the frame was lost",
    "fear.left": "{player} was left a good shot",
    "fear.missed": "the {ball} missed the pocket",
    "fear.nothing": "nothing came of it",
    # What may be chosen, as short as a button wants it; after a colon comes what it is about.
    "choice.accept": "Play the balls as they lie",
    "choice.kitchen": "Cue ball to the kitchen",
    "choice.play": "Play",
    "choice.pass": "Let the opponent play",
    "choice.hand-back": "Hand the shot back",
    "choice.re-rack": "Rack again and break",
    "choice.break": "Break",
    "choice.give-break": "Let the opponent break",
    "choice.opponent-breaks": "Opponent breaks again",
    "choice.spot": "Spot the nearest ball",
    "choice.spot-eight": "Spot the 8 and play on",
    "choice.play-again": "Opponent plays again",
    "choice.put-back": "Put the balls back",
    "choice.baulk": "Cue ball to baulk",
    "choice.anywhere": "Cue ball anywhere",
    "choice.claim": "Claim the frame",
    "choice.group": "Play the {what}s",
    "choice.respot": "Spot touching balls",
    "choice.start-spot": "From the {what} spot",
    "choice.pocket": "The {what} pocket",
}


@dataclass(frozen=True, slots=True)
class Note:
    """Something to say: a key of the words, and what fills the gaps.

    `player` is a player's number, -1 where none is meant; `where` the name of a cushion.
    """

    key: str
    player: int = -1
    ball: str = ""
    points: int = 0
    where: str = ""

    @property
    def text(self) -> str:
        return say(self)

    def as_dict(self) -> dict[str, Any]:
        return asdict(self)


def written(note: Note) -> dict[str, Any]:
    """A note in JSON's types without what it leaves out; `note_of` reads it."""
    return {name: value for name, value in note.as_dict().items() if value != _PLAIN[name]}


def note_of(data: Any, source: str, key: str) -> Note:
    """The note that `written` made it of; raises InputError naming `key` where it is none.

    What a later version says may have no words in `ENGLISH`.
    """
    if not isinstance(data, dict) or any(type(data[name]) is not type(_PLAIN.get(name)) for name in data):
        raise InputError(source, key, data, f"allowed are notes, of {', '.join(_PLAIN)}")
    return Note(**{**_PLAIN, **data})


_PLAIN = Note("").as_dict()


def ball_name(ball: str) -> str:
    """What a ball is called: of many alike, such as red7, the number is of no interest."""
    if ball.isdigit():
        return ball
    # Only at carom is the ball named cue spoken of by its name: there it is the white of two cue balls.
    return "white" if ball == "cue" else ball.rstrip("0123456789")


def place_name(name: str) -> str:
    """What a cushion is called."""
    return name.replace("-", " ")


def say(
    note: Note,
    names: Sequence[str] = ("Player 1", "Player 2"),
    words: Mapping[str, str] = ENGLISH,
    name_ball: Callable[[str], str] = ball_name,
    name_place: Callable[[str], str] = place_name,
) -> str:
    """A note as a sentence; `name_ball` says what a ball is called, `name_place` what a cushion is."""
    player = names[note.player] if 0 <= note.player < len(names) else ""
    where = name_place(note.where)
    text = words[note.key].format(player=player, ball=name_ball(note.ball), points=note.points, where=where)
    return text[:1].upper() + text[1:] + "."


def label(key: str, words: Mapping[str, str] = ENGLISH, name_it: Callable[[str], str] = str) -> str:
    """What an option is called; `name_it` says what that is called which it is about."""
    name, _, what = key.partition(":")
    return words[f"choice.{name}"].format(what=name_it(what))
