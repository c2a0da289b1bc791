"""Positions in which a ball and a pocket can be called, and clicks on the table."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

from pool2d import Layout
from pool2d.game.rules import AIM, Ruling
from pool2d.game.session import Session
from pool2d.physics.values import POCKETED

from ..at_match import begin
from ..conftest import Hand


def lined_up(hand: Hand, game: str = "ten-ball") -> Session:
    """A match whose break is over, with the 1 on, and the 9 lined up behind it for a corner pocket."""
    session = begin(hand, game)
    layout, table = session.layout, session.table
    corner = next(pocket for pocket in table.geometry.pockets if pocket.name == "top-right")
    nine = (corner.x - 0.20, corner.y - 0.20)
    two_r = 2.0 * table.knobs.ball.radius / math.sqrt(2.0)
    one = (nine[0] - two_r - 0.02, nine[1] - two_r - 0.02)
    places = {"cue": (one[0] - 0.4, one[1] - 0.4), "1": one, "9": nine, "10": (0.3, 0.3)}
    layout = Layout(
        ball._replace(x=places[ball.id][0], y=places[ball.id][1])
        if ball.id in places
        else ball._replace(phase=POCKETED)
        for ball in layout.values()
    )
    rules: Any = session.match.rules
    state = replace(session.match.state, shots=3, turn=0)
    if game == "ten-ball":
        state = replace(state, ask=replace(state.ask, kind=AIM, where="", on=("1",), call="pocket", options=()))
    else:
        state = rules.next(state, layout, 0)
    now = session.match.now
    session.match._past[-1] = replace(now, ruling=Ruling(state, layout))
    hand.app.redraw()
    hand.app.step(0.0)
    return session


def click(hand: Hand, x: float, y: float) -> None:
    hand.point(x, y)
    hand.press()
    hand.release()


def at(session: Session, name: str) -> tuple[float, float]:
    """Where a ball or a pocket is."""
    pockets = {pocket.name: (pocket.x, pocket.y) for pocket in session.table.geometry.pockets}
    return pockets.get(name) or (session.layout[name].x, session.layout[name].y)
