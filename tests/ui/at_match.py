"""What tests of matches in the window have in common."""

from __future__ import annotations

from pool2d import load_table
from pool2d.game.rules import CHOOSE
from pool2d.game.session import Session, recorded
from pool2d.game.setup import Setup

from .conftest import Hand


def begin(hand: Hand, game: str = "eight-ball", table: str = "pool-9ft", **more: object) -> Session:
    """Start a match in the window."""
    setup = Setup(game=game, names=("Ann", "Bob"), breaker=0, seed=4, **more)  # type: ignore[arg-type]
    session = recorded(load_table(table), setup)
    hand.play.state.begin(session)
    hand.app.redraw()
    hand.app.step(0.0)
    return session


def in_hand(hand: Hand) -> Session:
    """An eight-ball match in which a player has the cue ball in hand and may call a safety."""
    session = begin(hand)
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(9.0).toward(1.0, 0.02)
    hand.strike()
    while session.ask.kind == CHOOSE:
        session.choose(session.ask.options[0])
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(0.6).toward(-1.0, 0.0)
    hand.strike()
    assert session.ask.where == "anywhere" and "safety" in session.ask.may
    return session


def place(hand: Hand, x: float = 0.4) -> None:
    """Put the cue ball, which is in hand, somewhere near a place."""
    session = hand.play.state.session
    for y in (0.2, 0.4, 0.6, 0.8, 1.0):
        if session.place(x, y):
            break
    hand.app.redraw()
    hand.app.step(0.0)
