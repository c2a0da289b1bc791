"""Eight-ball: what follows from the choices after the break, and what the table of clauses cannot say."""

from __future__ import annotations

import pytest

from pool2d.game.rules import Choice
from pool2d.game.rules.pool.pool import GroupsState

from .cases import POOL, Case, judged, line, rules_of

RULES = rules_of("eight-ball")


@pytest.mark.parametrize(
    ("clause", "shot", "key", "ruling", "left"),
    [
        ("4.3 (e) (1)", "cue-1 8>", "spot-eight", "0 aims; spotted 8", 15),
        ("4.3 (e) (2)", "cue-1 8>", "re-rack", "0 aims kitchen", 15),
        ("4.3 (f) (1)", "cue-1 8> cue>", "spot-eight", "1 places kitchen; spotted 8", 15),
        ("4.3 (f) (2)", "cue-1 8> cue>", "re-rack", "1 aims kitchen", 15),
        ("4.3 (d) (1)", "cue-1 1|", "accept", "1 aims", 15),
        ("4.3 (d) (2)", "cue-1 1|", "re-rack", "1 aims kitchen", 15),
        ("4.3 (d) (3)", "cue-1 1|", "opponent-breaks", "0 aims kitchen", 15),
        ("4.3 (g) (1)", "cue-1 5^ 1| 2| 3|", "accept", "1 aims", 14),
        ("4.3 (g) (2)", "cue-1 5^ 1| 2| 3|", "kitchen", "1 aims kitchen", 14),
    ],
)
def test_choice_after_the_break(clause: str, shot: str, key: str, ruling: str, left: int) -> None:
    _, asked = judged("eight-ball", Case(clause, "", "break", "", shot, ""))
    result = RULES.choose(asked.state, asked.layout, Choice(key))
    assert line(result) == ruling
    assert len(RULES.on_table(result.layout)) == left


def test_a_group_gives_the_balls_on() -> None:
    """4.5: one's own group, and the eight when it is gone."""
    layout = RULES.start().layout
    state = GroupsState(groups=("solid", "stripe"), shots=3)
    assert set(RULES.on(state, layout, 0)) == set("1234567")
    assert set(RULES.on(state, layout.without(*"1234567"), 0)) == {"8"}
    assert set(RULES.on(state, layout, 1)) == {"9", "10", "11", "12", "13", "14", "15"}


def test_a_ball_behind_the_head_string_may_be_spotted() -> None:
    """1.6: with the cue ball in the kitchen and no ball on beyond the line, the nearest may be spotted."""
    layout = RULES.start().layout.without("11", "12", "13", "14", "15")
    layout = layout.put(*(layout[ball]._replace(x=x, y=0.3) for ball, x in (("9", 0.6), ("10", 0.3))))
    state = RULES.next(GroupsState(groups=("solid", "stripe"), shots=3), layout, 1, "kitchen")
    assert state.ask.options == ("spot",)
    result = RULES.choose(state, layout.without("1", "5", "3", "7", "2"), Choice("spot"))
    assert line(result) == "1 aims kitchen; spotted 9"
    assert result.layout["9"].x >= POOL.furniture.spots["foot"][0]
    assert RULES.next(state, result.layout, 1, "kitchen").ask.options == ()


def test_a_stalemate_is_broken_by_who_broke() -> None:
    """4.11."""
    assert line(RULES.stalemate(GroupsState(breaker=1, turn=0))) == "1 aims kitchen"


def test_who_concedes_loses() -> None:
    """1.12."""
    start = RULES.start()
    assert line(RULES.conceded(start.state, start.layout, 0)) == "1 wins"


def test_who_wins_has_to_pot_a_group_and_the_eight() -> None:
    """4.2; while the table is open, the group of which fewer are left."""
    layout = RULES.start().layout.without("9", "10", "1")
    state = GroupsState(groups=("solid", "stripe"), shots=3)
    assert set(RULES.to_pot(state, layout, 0)) == set("2345678")
    assert set(RULES.to_pot(state, layout, 1)) == {"8", "11", "12", "13", "14", "15"}
    assert RULES.to_pot(GroupsState(shots=3), layout, 0) == RULES.to_pot(state, layout, 1)
