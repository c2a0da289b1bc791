"""What is said of players who are no people, in the player's language."""

from __future__ import annotations

from ...opponent.player import Player
from .words import Words


def title(words: Words, player: Player) -> str:
    """A player's name, and how good people are who play like that."""
    grade = words.say_or(f"grade.{player.title}", player.title)
    return f"{player.name} ({grade})" if grade else player.name


def about(words: Words, player: Player) -> str:
    """A player's own line or two; in English, where there are none in the language."""
    return getattr(player.words, words.language, "") or player.words.en
