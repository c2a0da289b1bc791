"""What a player who is no person says aloud at the table, and what is said of one."""

from __future__ import annotations

from collections.abc import Callable

from ....game.rules.report import Call
from ...wording import ruling_text, shot_text
from ...wording.words import Words
from ..messages import Message


def thinking(words: Words, name: str) -> Message:
    """That a player thinks."""
    return lambda: words.say("opponent.thinks", name=name)


def chosen(words: Words, name: str, key: str) -> Message:
    """What a player chooses of what is offered."""
    return lambda: words.say("opponent.chooses", name=name, option=ruling_text.option(words, key))


def placing(words: Words, name: str) -> Message:
    """That a player puts the cue ball down."""
    return lambda: words.say("opponent.places", name=name)


def called(words: Words, name: str, call: Call) -> Message:
    """What a player calls before a stroke; where nothing is called, that one aims."""
    return lambda: _spoken(words, name, call)


def chalking(words: Words, name: str, before: Message) -> Message:
    """That a player who has missed chalks up, after what is said besides."""
    return lambda: f"{before()} {words.say('opponent.chalks', name=name)}"


def playing_on(words: Words, name: str) -> Message:
    """That a player does not agree to begin the frame again."""
    return lambda: words.say("opponent.plays-on", name=name)


def stopped(words: Words, name: str, why: str, helpless: bool) -> Message:
    """That thinking has failed, and what is done about it."""
    said = words.say("opponent.helpless", name=name) if helpless else words.say("opponent.again", name=name)
    return lambda: f"{said} ({why})"


def _spoken(words: Words, name: str, call: Call) -> str:
    said = next((say for holds, say in _KINDS if holds(call)), _aims)
    return said(words, name, call)


def _aims(words: Words, name: str, call: Call) -> str:
    return words.say("opponent.aims", name=name)


def _push(words: Words, name: str, call: Call) -> str:
    return words.say("opponent.push", name=name)


def _safety(words: Words, name: str, call: Call) -> str:
    return words.say("opponent.safety", name=name)


def _pocket(words: Words, name: str, call: Call) -> str:
    where = shot_text.place_name(words, call.pocket)
    return words.say("opponent.calls", name=name, ball=ruling_text.ball(words, call.ball), where=where)


def _ball(words: Words, name: str, call: Call) -> str:
    return words.say("opponent.names", name=name, ball=ruling_text.ball(words, call.ball))


# What may be called, the first that holds being said.
_KINDS: tuple[tuple[Callable[[Call], object], Callable[[Words, str, Call], str]], ...] = (
    (lambda call: call.push, _push),
    (lambda call: call.safety, _safety),
    (lambda call: call.pocket, _pocket),
    (lambda call: call.ball, _ball),
)
