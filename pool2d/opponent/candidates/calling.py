"""What has to be said before a stroke."""

from __future__ import annotations

from ...game.rules import Ask
from ...game.rules.report import Call


def called(ask: Ask, ball: str, pocket: str = "", safety: bool = False) -> Call:
    """What has to be said of a stroke that means this ball, and this pocket."""
    if safety and "safety" in ask.may:
        return Call(safety=True)
    if ask.call == "pocket":
        return Call(ball, pocket)
    return Call(ball) if ask.call == "ball" else Call()
