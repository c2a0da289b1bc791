"""Why a stroke of a match was played, in the player's language; the English is the game's own, as that of rulings."""

from __future__ import annotations

from functools import partial

from ...game.explained import ENGLISH, Voice
from ...game.match import Match
from . import ruling_text
from .shot_text import place_name
from .words import Words


def template(words: Words, key: str) -> str:
    """A text about reasons, its places unfilled."""
    return words.say_or(f"why.{key}", ENGLISH[key])


def voice(words: Words, match: Match) -> Voice:
    """How the player's language tells of the strokes of a match."""
    return Voice(
        partial(template, words),
        lambda ball: ruling_text.ball(words, match.rules.spoken(ball)),
        partial(place_name, words),
        lambda note: ruling_text.note_text(words, note, match.names),
        words.number,
        words.speed,
    )
