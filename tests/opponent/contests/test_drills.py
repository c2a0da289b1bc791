"""The drill by ten racks, its scale, and the fixed set of pots."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

import pytest

from pool2d import load_table
from pool2d.game.judging import Judged
from pool2d.game.rules import Ruling
from pool2d.game.rules.pool.ten_ball import TenBall
from pool2d.game.rules.report import BALL, POCKET, RAIL, Call, Contact, Report
from pool2d.opponent.contests.pot_set import pots_in, shots
from pool2d.opponent.contests.ten_racks import BallsCounted, attacking, grade, in_hand, made, one_rack
from pool2d.opponent.contests.visits import potted, visit
from pool2d.opponent.pot_lines import pot_lines
from pool2d.opponent.worth import Scale
from pool2d.physics.values import POCKETED, Layout

from .quick_players import STEADY, WILD

TABLE = load_table("pool-9ft")


@pytest.mark.parametrize(
    ("balls", "letters"),
    [
        (0, "D"), (29, "D"), (30, "D+"), (35, "D+"), (36, "C"), (40, "C"), (41, "C+"), (46, "B"), (50, "B"), (51, "B+"),
        (56, "A"), (61, "A+"), (66, "A++"), (70, "A++"), (71, "professional"), (100, "professional"),
    ],
)  # fmt: skip
def test_the_scale_is_the_published_one(balls: float, letters: str) -> None:
    assert grade(balls) == letters


def broken(*contacts: Contact, gone: str) -> Judged:
    """A break with these contacts after which one ball is gone, as the rules judge it."""
    rules = TenBall(TABLE)
    begun = rules.start(0, 1)
    layout = begun.layout.put(begun.layout[gone]._replace(phase=POCKETED))
    report = Report(contacts=contacts, start=begun.layout, first=("1",))
    return Judged(None, report, rules.judge(begun.state, layout, report))  # type: ignore[arg-type]


HIT, FELL, RAILS = (
    Contact(BALL, "cue", "1"),
    Contact(POCKET, "3", "top-left"),
    [Contact(RAIL, ball, "head") for ball in "4567"],
)


def test_after_the_break_the_cue_ball_is_in_hand_and_what_it_made_stays_down() -> None:
    after = in_hand(TenBall(TABLE), broken(HIT, FELL, *RAILS, gone="3"))
    assert (after.ask.player, after.ask.where, after.ask.on) == (0, "anywhere", ("1",))
    assert after.layout["3"].phase == POCKETED


def test_a_break_counts_what_stays_down() -> None:
    assert made(broken(HIT, FELL, *RAILS, gone="3")) == 1
    assert made(broken(HIT, FELL, *RAILS, Contact(POCKET, "cue", "top-right"), gone="3")) == 0
    # The ten is spotted.
    assert made(broken(HIT, Contact(POCKET, "10", "top-left"), *RAILS, gone="10")) == 0


def test_what_a_foul_makes_is_spotted() -> None:
    scratched = broken(HIT, FELL, *RAILS, Contact(POCKET, "cue", "top-right"), gone="3")
    assert scratched.ruling.foul
    after = in_hand(TenBall(TABLE), scratched)
    assert (after.ask.player, after.ask.where) == (0, "anywhere")
    assert "3" in TenBall(TABLE).on_table(after.layout)


def test_in_the_drill_a_ball_is_a_point_and_the_first_miss_ends_it() -> None:
    rules = BallsCounted(TABLE)
    after = in_hand(rules, broken(HIT, FELL, *RAILS, gone="3"))
    state = replace(after.state, ask=replace(after.ask, kind="aim"))

    def ruled(layout: Layout, last: Contact) -> Ruling:
        report = Report(call=Call("1", "top-left"), contacts=(HIT, last), start=after.layout, first=("1",))
        return rules.judge(state, layout, report)

    gone = after.layout.put(after.layout["1"]._replace(phase=POCKETED))
    made = ruled(gone, Contact(POCKET, "1", "top-left"))
    missed = ruled(after.layout, Contact(RAIL, "1", "head"))
    assert not missed.foul
    assert (made.state.scores, made.ask.player, made.state.over) == ((1, 0), 0, False)
    assert (missed.state.scores, missed.state.over, missed.state.winner) == ((0, 0), True, None)


def test_alone_at_the_table_a_bad_leave_is_worth_no_less_than_what_was_made() -> None:
    """Nobody comes to the table after a miss, so a ball more is a point more, whatever lies open."""
    rules = BallsCounted(TABLE)
    scale = Scale(rules, WILD.hand, 0.5)
    after = in_hand(rules, broken(HIT, FELL, *RAILS, gone="3"))
    made = after._replace(state=replace(after.state, scores=(1, 0)))
    over = after._replace(state=rules.ended(after.state, -1))
    assert scale.value(over, 0) == 0.0
    assert scale.value(made, 0) >= 1.0 + scale.value(over, 0)
    assert scale.passed(made, 0) == 1.0


def test_a_visit_lasts_until_the_turn_passes() -> None:
    rules = TenBall(TABLE)
    strokes = list(visit(rules, rules.start(0, 5), attacking(STEADY), "a"))
    assert all(stroke.ruling.ask.player == 0 for stroke in strokes[:-1])
    last = strokes[-1].ruling
    assert last.state.over or last.ask.player == 1
    balls, won = potted(rules, iter(strokes))
    assert balls == sum(len(rules.pots(0, stroke.report, stroke.ruling)) for stroke in strokes)
    assert won == (last.state.winner == 0)


def test_a_rack_is_the_same_again_and_makes_ten_balls_at_most() -> None:
    assert 0 <= one_rack(TABLE, WILD, 3, 1) == one_rack(TABLE, WILD, 3, 1) <= 10


def test_who_is_to_pot_plays_no_safety() -> None:
    eager = attacking(STEADY)
    assert (eager.judgement.safeties, eager.taste, eager.hand) == (0.0, STEADY.taste, STEADY.hand)


def test_the_set_is_the_same_for_all_and_a_pot_lies_open_in_each() -> None:
    mine, yours = (list(islice(shots(TABLE, player), 20)) for player in (STEADY, WILD))
    assert mine == yours
    assert all(pot_lines(TABLE, layout, layout["cue"], ("9",), STEADY.hand) for layout in mine)
    assert len({(layout["9"].x, layout["9"].y) for layout in mine}) == 20


def test_a_steady_hand_pots_what_a_wild_one_misses() -> None:
    steady, wild = (pots_in(TABLE, player, 0, 0, 6) for player in (STEADY, WILD))
    assert steady >= 5
    assert wild <= 3
    assert steady == sum(pots_in(TABLE, STEADY, 0, first, 3) for first in (0, 3))
