"""Calls by themselves: which balls and pockets may be meant, and what is said of them."""

from __future__ import annotations

from typing import Any

import pytest

from pool2d import load_table
from pool2d.game.match import Match
from pool2d.game.rules.report import Call
from pool2d.game.session import Session
from pool2d.game.setup import Setup
from pool2d.ui.play.calls import Calls


@pytest.fixture
def session() -> Session:
    """Straight pool, in which every shot names a ball and a pocket."""
    return Session(Match(load_table("pool-9ft"), Setup("straight", names=("Ann", "Bob"), breaker=0, seed=4)))


def test_every_ball_and_pocket_may_be_meant_those_that_are_on_first(session: Session) -> None:
    calls = Calls()
    assert calls.balls(session)[: len(session.ask.on)] == tuple(session.ask.on)
    assert set(calls.balls(session)) == {ball.id for ball in session.layout.on_table()} - {"cue"}
    assert calls.pockets(session) == tuple(pocket.name for pocket in session.table.geometry.pockets)


def test_a_point_near_a_ball_means_it_and_one_in_a_pocket_the_pocket(session: Session) -> None:
    calls, radius = Calls(), session.table.knobs.ball.radius
    one = min((session.layout[ball] for ball in calls.balls(session)), key=lambda ball: ball.x)
    assert calls.under(one.x - 1.2 * radius, one.y, session) == (one.id, "")
    assert calls.under(one.x - 1.3 * radius, one.y, session) == ("", "")
    for pocket in session.table.geometry.pockets:
        assert calls.under(pocket.x + 0.99 * pocket.radius, pocket.y, session) == ("", pocket.name)
        assert calls.under(pocket.x, pocket.y - 1.01 * pocket.radius, session) == ("", "")
    assert not calls.point_out(one.x - 1.3 * radius, one.y, session)


def test_pointing_out_says_it_and_takes_it_back(session: Session) -> None:
    calls, pocket = Calls(), session.table.geometry.pockets[2]
    one = session.layout[calls.balls(session)[0]]
    calls.declare(safety=True)
    assert calls.said(session, one.id) == Call(safety=True)
    assert calls.point_out(pocket.x, pocket.y, session)
    assert calls.said(session, "9") == Call("9", pocket.name)
    assert calls.point_out(one.x, one.y, session)
    assert calls.said(session, "9") == Call(one.id, pocket.name)
    assert calls.point_out(one.x, one.y, session) and calls.ball == ""
    assert calls.point_out(pocket.x, pocket.y, session) and calls.pocket == ""
    assert calls.said(session, "9") == Call()
    calls.declare(push=True)
    assert (calls.push, calls.safety) == (True, False)
    assert calls.point_out(one.x, one.y, session) and not calls.push
    calls.declare(safety=True)
    assert (calls.ball, calls.pocket, calls.safety) == ("", "", True)
    calls.declare()
    assert calls.said(session, "9") == Call()


def test_keys_go_through_all_of_them_both_ways_and_through_none(session: Session) -> None:
    calls = Calls()
    ways: Any = (
        (calls.next_ball, calls.balls(session), lambda: calls.ball),
        (calls.next_pocket, calls.pockets(session), lambda: calls.pocket),
    )
    for go, choices, said in ways:
        seen = []
        for _ in (*choices, ""):
            go(session)
            seen.append(said())
        assert seen == [*choices, ""]
        go(session, -1)
        assert said() == choices[-1]
        go(session)


def test_where_nothing_need_be_said_nothing_is(session: Session) -> None:
    nine: Any = Session(Match(session.table, Setup("nine-ball", names=("Ann", "Bob"), breaker=0, seed=4)))
    calls = Calls()
    assert calls.balls(nine) == calls.pockets(nine) == ()
    pocket = nine.table.geometry.pockets[0]
    assert not calls.point_out(pocket.x, pocket.y, nine)
    assert calls.said(nine, "1") == Call()
