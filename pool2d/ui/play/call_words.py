"""The referee's words: what a ruling leaves to the player, what has been called, and what the aim would miss."""

from __future__ import annotations

from ...game.rules import AIM, OVER, PLACE, Ask
from ...game.session import Session, placing
from ..wording import ruling_text, shot_text
from ..wording.words import Words
from .calls import Calls


def off_target(words: Words, calls: Calls, session: Session, aimed: str) -> str:
    """What to say of an aim that would hit a ball that is not on; empty where all is well."""
    ask = session.ask
    wanted = (calls.ball,) if ask.call == "ball" and calls.ball else ask.on
    free = session.is_practice or calls.push or ask.kind != AIM or ask.cues
    if free or not aimed or not wanted or aimed in wanted:
        return ""
    return words.say("referee.not_on", ball=ruling_text.ball(words, aimed))


def called(words: Words, calls: Calls, session: Session, aimed: str) -> str:
    """What has been called, in words, and what is missing of it; empty where nothing has been pointed out."""
    ball, pocket = calls.meant(session), calls.pocket
    if session.ask.cues or not (ball or pocket):
        return ""
    named = ruling_text.ball(words, ball or aimed) if ball or aimed else words.say("referee.aimed_at")
    if session.ask.call == "ball":
        return words.say("referee.named", ball=named)
    if not pocket:
        return words.say("referee.pocket_next", ball=named, key=words.key("call"))
    return words.say("referee.called", ball=named, where=shot_text.place_name(words, pocket))


def verdict(words: Words, calls: Calls, session: Session, held: bool = False) -> str:
    """What the last ruling says, in sentences, and what it leaves to the player, who may have a ball in hand."""
    ask = session.ask
    said = [ruled(words, session)]
    if ask.kind in (AIM, PLACE) and not session.is_practice:
        said += _on(words, ask)
    if calls.pockets(session) and not (calls.ball or calls.pocket):
        said.append(words.say("referee.may_call"))
    if ask.where and ask.kind in (AIM, PLACE):
        said.append(words.say(f"referee.{'put' if held else 'movable'}.{ask.where}"))
        if held and ask.kind == AIM:
            said.append(words.say("referee.leave", key=words.key("cancel")))
    if ask.kind == OVER:
        said.append(words.say("referee.over", key=words.key("strike")))
    return " ".join(said)


def ruled(words: Words, session: Session) -> str:
    """What the last ruling says, in sentences."""
    # To put the cue ball down is no news.
    moment = next(moment for moment in reversed(session.match.history) if not placing(moment))
    return ruling_text.verdict(words, moment, session.match)


def _on(words: Words, ask: Ask) -> list[str]:
    """What may be hit, where that is one ball or one of many alike, or has to be named."""
    names = {ruling_text.ball(words, ball) for ball in ask.on}
    said = []
    if len(names) == 1:
        ball = names.pop()
        said.append(words.say("referee.on_any", ball=ball) if len(ask.on) > 1 else words.say("referee.on", ball=ball))
    elif ask.call == "ball":
        said.append(words.say("referee.name_one"))
    if ask.cues:
        said.append(words.say("referee.any_strikes"))
    if "push" in ask.may:
        said.append(words.say("referee.may_push"))
    return said
