"""A cue ball that lies on a pocket's shelf, beyond the noses and short of the drop, is on the table."""

from __future__ import annotations

import math

import pygame
import pytest

from pool2d import Ball, Layout, Table, load_table
from pool2d.game.actions import Stroke
from pool2d.game.match import Match
from pool2d.game.rules import AIM, Choice
from pool2d.game.rules.spotting import ANYWHERE, KITCHEN, may_place, within
from pool2d.game.session import Session
from pool2d.game.setup import Setup
from pool2d.physics.values import Shot

from ..conftest import ONE, Hand
from .test_editing import drag, place

TABLES = ("pool-9ft", "snooker-12ft", "english-7ft")


def on_shelf(table: Table, pocket: str = "bottom-left") -> tuple[float, float]:
    """The place on a pocket's shelf that is farthest from its drop."""
    hole = next(found for found in table.geometry.pockets if found.name == pocket)
    steps = [0.002 * i for i in range(-40, 41)]
    places = [(hole.x + dx, hole.y + dy) for dx in steps for dy in steps]
    radius = table.knobs.ball.radius
    free = [place for place in places if not table.on_surface(*place) and table.has_room(*place, radius, Layout())]
    return max(free, key=lambda place: math.dist(place, (hole.x, hole.y)))


@pytest.mark.parametrize("name", TABLES)
def test_it_may_be_put_there_and_is_within(name: str) -> None:
    table = load_table(name)
    x, y = on_shelf(table)
    layout = Layout([Ball("cue", 0.5, 0.5)])
    for where in (ANYWHERE, KITCHEN, ""):
        assert within(table, where, x, y) and may_place(table, layout, "cue", where, x, y)
    far = on_shelf(table, "top-right")
    assert within(table, ANYWHERE, *far) and not within(table, KITCHEN, *far)
    assert not within(table, ANYWHERE, -0.2, -0.2)


def test_in_practice_it_is_dragged_there_played_and_taken_back(two: Hand) -> None:
    session = two.play.state.session
    x, y = on_shelf(session.table)
    cue = session.cue
    drag(two, (cue.x, cue.y), (x, y), 1)
    assert place(two, "cue") == pytest.approx((x, y), abs=0.003)
    assert session.ask.kind == AIM and not session.in_hand
    two.point(ONE.x, ONE.y)
    two.strike()
    assert session.strokes == 1
    two.key(pygame.K_u)
    assert place(two, "cue") == pytest.approx((x, y), abs=0.003) and not session.in_hand
    two.key(pygame.K_u)
    assert session.cue == cue


def test_in_practice_it_is_pasted_there(two: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    session = two.play.state.session
    x, y = on_shelf(session.table)
    monkeypatch.setattr(pygame.scrap, "get_text", lambda: f"pool-9ft cue@{x!r},{y!r} 1@1.5,0.5")
    two.key(pygame.K_v, pygame.KMOD_CTRL)
    assert (session.cue.x, session.cue.y) == (x, y)
    assert session.ask.kind == AIM and not session.in_hand


def test_a_shot_that_ends_there_leaves_it_on_the_table() -> None:
    """The rules' own cue ball in hand is asked for only where the ball is off the table."""
    table = load_table("pool-9ft")
    x, y = on_shelf(table)
    match = Match(table, Setup("nine-ball", breaker=0, seed=1))
    rules, now = match.rules, match.now
    layout = now.layout.put(now.layout["cue"]._replace(x=x, y=y))
    state = rules.to_play(now.state, layout, 0, KITCHEN, on=("1",))
    assert state.ask.kind == AIM
    placed = rules.choose(now.state, now.layout, Choice("place", x, y))
    assert (placed.layout["cue"].x, placed.layout["cue"].y) == (x, y) and placed.ask.kind == AIM


def test_in_a_match_it_is_put_there_and_played_from_there() -> None:
    table = load_table("pool-9ft")
    session = Session(Match(table, Setup("nine-ball", breaker=0, seed=1)))
    x, y = on_shelf(table)
    assert session.place(x, y)
    assert session.ask.kind == AIM and (session.cue.x, session.cue.y) == (x, y)
    session.play(Shot(angle=20.0, speed=6.0))
    assert isinstance(session.match.now.action, Stroke)
    session.undo()
    session.redo()
    assert session.strokes == 1
