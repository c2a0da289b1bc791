"""Why a stroke was played, told in words: what was meant, what else was looked at, what was feared, what the hand did.

The English is here; a `Voice` tells it in another language, and calls balls and pockets what they are called there.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, NamedTuple

from ..physics.values import Shot
from .actions import Stroke
from .match import Match, Moment, lagged
from .reasons import Fear, Reasons, Thought
from .rules.notes import Note, ball_name, place_name, say

# Nearer to the middle of the ball, in radii, the tip gives no spin to speak of.
_PLAIN: Final = 0.05
ENGLISH: dict[str, str] = {
    "title": "Why this shot?",
    # What stands before the parts.
    "meant": "Meant",
    "others": "Or else",
    "fears": "Feared",
    "hand": "The hand",
    # What a stroke is meant to be, and of what ball into which pocket.
    "kind.pot": "Pot",
    "kind.combination": "Combination",
    "kind.carom": "Carom",
    "kind.bank": "Bank shot",
    "kind.kick": "Kick shot",
    "kind.cannon": "Cannon",
    "kind.safety": "Safety",
    "kind.break": "Break",
    "kind.push": "Push out",
    "kind.hope": "No plan",
    "aim.bare": "{kind}",
    "aim.ball": "{kind}, the {ball}",
    "aim.pocket": "{kind}, the {ball}, {pocket} pocket",
    # How: its speed, and where the tip was to meet the ball.
    "stroke": "{aim}, {speed} {spin}",
    "plain": "without spin",
    "follow": "with follow",
    "draw": "with draw",
    "english-left": "with left english",
    "english-right": "with right english",
    # What it was held to be.
    "thought": "{aim}: {held}",
    "held": "comes off {chance}, {worth}",
    "win": "wins {percent}",
    "ahead": "{points} points ahead",
    "behind": "{points} points behind",
    "mind": "tries in mind: {runs}; fouls {fouls}, turn lost {lost}",
    "fear": "{share}: {what}",
    "fearless": "nothing: it never went wrong in mind",
    # What the hand made of it.
    "strayed": "{angle} to the {side}, {speed} {pace}, tip {tip} off",
    "left": "left",
    "right": "right",
    "harder": "harder",
    "softer": "softer",
    "true": "as it was meant",
    "untold": "Nobody has told why.",
}


def _english_note(note: Note) -> str:
    return say(note)


@dataclass(frozen=True, slots=True)
class Voice:
    """How a language tells things: its `template` for a key of ENGLISH, its balls, places, notes, numbers, speeds."""

    template: Callable[[str], str] = ENGLISH.__getitem__
    ball: Callable[[str], str] = ball_name
    place: Callable[[str], str] = place_name
    note: Callable[[Note], str] = _english_note
    number: Callable[[float, str], str] = format
    speed: Callable[[float], str] = "{:.2f} m/s".format

    def say(self, key: str, **values: str) -> str:
        """A text with its places filled in."""
        return self.template(key).format(**values)

    def percent(self, share: float) -> str:
        """A share of 1, as a whole percentage from 0 to 100."""
        return f"{100.0 * min(max(share, 0.0), 1.0):.0f} %"


class Explained(NamedTuple):
    """Why a stroke was played, in sentences; `others` and `fears` hold one for each."""

    meant: str
    held: str
    mind: str
    others: tuple[str, ...]
    fears: tuple[str, ...]
    hand: str

    def parts(self) -> list[tuple[str, list[str]]]:
        """What is told under which heading, a key of ENGLISH, in the order of telling; others are numbered from 1."""
        numbered = [f"{number}  {told}" for number, told in enumerate(self.others, 1)]
        meant = [self.meant, self.held, self.mind]
        parts = {"meant": meant, "others": numbered, "fears": list(self.fears), "hand": [self.hand]}
        return [(key, lines) for key, lines in parts.items() if lines]


def told(match: Match, before: Moment, stroke: Stroke, voice: Voice) -> list[tuple[str, list[str]]]:
    """Why a stroke of a match was played at the moment `before` it: lines under headings, which are keys of ENGLISH.

    Of a stroke without reasons nothing is told.
    """
    if stroke.why is None:
        return []
    scored = match.rules_of(lagged(before.state)).scored
    radius, _ = match.table.body_of(before.layout[stroke.shot.ball])
    return explained(stroke.why, stroke.shot, scored, radius, voice).parts()


def explained(why: Reasons, shot: Shot, scored: bool, radius: float, voice: Voice) -> Explained:
    """The reasons of a stroke in words; `shot` is how it was played.

    `scored` says whether the worth of strokes is told in points; `radius` is that of the ball that was struck, m.
    """
    meant = why.meant
    shares = {"fouls": voice.percent(meant.fouls), "lost": voice.percent(meant.lost)}
    return Explained(
        _aim(meant, voice),
        _held(meant, scored, voice),
        voice.say("mind", runs=str(meant.runs), **shares),
        tuple(voice.say("thought", aim=_aim(one, voice), held=_held(one, scored, voice)) for one in why.others),
        tuple(_feared(fear, voice) for fear in why.fears) or (voice.say("fearless"),),
        strayed(meant.shot, shot, radius, voice),
    )


def _aim(thought: Thought, voice: Voice) -> str:
    """What a stroke was meant to be, and how it was to be struck."""
    kind = voice.say(f"kind.{thought.kind}")
    form = "bare" if not thought.ball else "pocket" if thought.pocket else "ball"
    aim = voice.say(f"aim.{form}", kind=kind, ball=voice.ball(thought.ball), pocket=voice.place(thought.pocket))
    return voice.say("stroke", aim=aim, speed=voice.speed(thought.shot.speed), spin=_spin(thought.shot, voice))


def _spin(shot: Shot, voice: Voice) -> str:
    """The greatest of a stroke's spins."""
    if max(abs(shot.side), abs(shot.height)) < _PLAIN:
        return voice.say("plain")
    if abs(shot.height) >= abs(shot.side):
        return voice.say("follow" if shot.height > 0.0 else "draw")
    return voice.say("english-right" if shot.side > 0.0 else "english-left")


def _held(thought: Thought, scored: bool, voice: Voice) -> str:
    worth = _points(thought.value, voice) if scored else voice.say("win", percent=voice.percent(thought.value))
    return voice.say("held", chance=voice.percent(thought.chance), worth=worth)


def _points(value: float, voice: Voice) -> str:
    """Points to a tenth: so few that there are none are not behind."""
    return voice.say("behind" if value <= -0.05 else "ahead", points=voice.number(abs(value), ".1f"))


def _feared(fear: Fear, voice: Voice) -> str:
    return voice.say("fear", share=voice.percent(fear.share), what=voice.note(fear.note))


def strayed(meant: Shot, played: Shot, radius: float, voice: Voice) -> str:
    """How far a stroke came out from how it was meant: its direction, its speed, and the tip's place on the ball."""
    if played == meant:
        return voice.say("true")
    turned = math.remainder(played.angle - meant.angle, 360.0)
    faster = played.speed - meant.speed
    off = 1000.0 * radius * math.dist((meant.side, meant.height), (played.side, played.height))
    return voice.say(
        "strayed",
        angle=voice.number(abs(turned), ".2f") + "\N{DEGREE SIGN}",
        side=voice.say("right" if turned < 0.0 else "left"),
        speed=voice.speed(abs(faster)),
        pace=voice.say("softer" if faster < 0.0 else "harder"),
        tip=voice.number(off, ".1f") + " mm",
    )
