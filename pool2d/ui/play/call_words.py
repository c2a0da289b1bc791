"""The referee's words: what a ruling leaves to the player, what has been called, and what the aim would miss."""

from __future__ import annotations

from ...game.rules import AIM, OVER, PLACE, Ask
from ...game.session import Session, placing
from ..wording import ruling_text, shot_text
from ..wording.keys import KEYS
from ..wording.words import say
from .calls import Calls


def off_target(calls: Calls, session: Session, aimed: str) -> str:
    """What to say of an aim that would hit a ball that is not on; empty where all is well."""
    ask = session.ask
    wanted = (calls.ball,) if ask.call == "ball" and calls.ball else ask.on
    free = session.is_practice or calls.push or ask.kind != AIM or ask.cues
    if free or not aimed or not wanted or aimed in wanted:
        return ""
    return say("referee.not_on", ball=ruling_text.ball(aimed))


def called(calls: Calls, session: Session, aimed: str) -> str:
    """What has been called, in words, and what is missing of it; empty where nothing has been pointed out."""
    ball, pocket = calls.meant(session), calls.pocket
    if session.ask.cues or not (ball or pocket):
        return ""
    named = ruling_text.ball(ball or aimed) if ball or aimed else say("referee.aimed_at")
    if session.ask.call == "ball":
        return say("referee.named", ball=named)
    if not pocket:
        return say("referee.pocket_next", ball=named, key=KEYS.shown("call"))
    return say("referee.called", ball=named, where=shot_text.place_name(pocket))


def verdict(calls: Calls, session: Session, held: bool = False) -> str:
    """What the last ruling says, in sentences, and what it leaves to the player, who may have a ball in hand."""
    ask = session.ask
    # To put the cue ball down is no news.
    moment = next(moment for moment in reversed(session.match.history) if not placing(moment))
    said = [ruling_text.verdict(moment, session.match)]
    if ask.kind in (AIM, PLACE) and not session.is_practice:
        said += _on(ask)
    if calls.pockets(session) and not (calls.ball or calls.pocket):
        said.append(say("referee.may_call"))
    if ask.where and ask.kind in (AIM, PLACE):
        said.append(say(f"referee.{'put' if held else 'movable'}.{ask.where}"))
        if held and ask.kind == AIM:
            said.append(say("referee.leave", key=KEYS.shown("cancel")))
    if ask.kind == OVER:
        said.append(say("referee.over", key=KEYS.shown("strike")))
    return " ".join(said)


def _on(ask: Ask) -> list[str]:
    """What may be hit, where that is one ball or one of many alike, or has to be named."""
    names = {ruling_text.ball(ball) for ball in ask.on}
    said = []
    if len(names) == 1:
        alike = len(ask.on) > 1
        said.append(say("referee.on_any", ball=names.pop()) if alike else say("referee.on", ball=names.pop()))
    elif ask.call == "ball":
        said.append(say("referee.name_one"))
    if ask.cues:
        said.append(say("referee.any_strikes"))
    if "push" in ask.may:
        said.append(say("referee.may_push"))
    return said
