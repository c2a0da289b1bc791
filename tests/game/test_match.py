"""Matches: whose turn, which frame, what is counted, and the way back."""

from __future__ import annotations

import json
import random

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from benchmarks.random_play import new_match, random_action
from pool2d import Ball, InputError, Layout, Shot, Table, load_table
from pool2d.game.actions import Action, Arrange, Concede, NextFrame, Stalemate, Stroke, as_dict, from_dict
from pool2d.game.match import Match, Moment
from pool2d.game.rules import GAMES, Choice
from pool2d.game.rules.report import Call
from pool2d.game.setup import LOSER, WINNER, Setup
from pool2d.game.tally import after_stroke
from pool2d.physics.values import POCKETED

from ..table.test_position_text import layouts, shots
from .rules import notation

calls = st.builds(Call, ball=st.text(), pocket=st.text(), safety=st.booleans(), push=st.booleans())
number = st.floats(-10.0, 10.0)
actions = st.one_of(
    st.builds(Stroke, shots, calls),
    st.builds(Choice, st.just("place"), number, number),
    st.builds(Choice, st.text(), st.just(0.0), st.just(0.0)),
    st.builds(Concede, st.integers(0, 3)),
    st.sampled_from([NextFrame(), Stalemate()]),
    st.builds(Arrange, layouts),
)


@given(actions)
# One of each kind at least, whatever is drawn.
@example(Stroke(Shot(12.5, 3.0, 0.1, -0.2, 5.0, "cue"), Call("1", "top-left")))
@example(Stroke(Shot(0.0, 1.0), Call(safety=True)))
@example(Stroke(Shot(0.0, 1.0), Call(push=True)))
@example(Choice("place", 0.3, -0.1))
@example(Choice("re-rack"))
@example(Concede(1))
@example(NextFrame())
@example(Stalemate())
@example(Arrange(Layout()))
@example(Arrange(Layout([Ball("cue", 0.5, 0.6), Ball("1", 0.1, 0.2, phase=POCKETED)])))
def test_an_action_comes_back_from_json(action: Action) -> None:
    back = from_dict(json.loads(json.dumps(as_dict(action))), "line")
    assert back == action
    assert repr(back) == repr(action)


@pytest.mark.parametrize(
    "data",
    [
        {}, {"do": "jump"}, {"do": 3}, {"do": "stroke"}, {"do": "stroke", "shot": 3}, {"do": "stroke", "shot": "cue"},
        {"do": "stroke", "shot": "cue:1,2", "call": 3}, {"do": "stroke", "shot": "cue:1,2", "call": {"bal": "1"}},
        {"do": "stroke", "shot": "cue:1,2", "call": {"safety": 1}}, {"do": "choose", "key": "place", "x": "1"},
        {"do": "concede", "player": True}, {"do": "arrange", "position": "cue@"},
    ],
)  # fmt: skip
def test_what_is_no_action_is_refused(data: dict[str, object]) -> None:
    with pytest.raises(InputError, match=r"^line: "):
        from_dict(data, "line")


def same(a: Moment, b: Moment) -> bool:
    """Whether two moments are equal in all that counts."""
    return (a.ruling, a.tallies, a.frame, a.breaker, a.action) == (b.ruling, b.tallies, b.frame, b.breaker, b.action)


@pytest.mark.parametrize("game", GAMES)
def test_undo_and_redo_return_equal_moments(game: str) -> None:
    match, rng = new_match(game, 5, race=2), random.Random(game)
    while len(match.history) < 25 and not match.over:
        match.play(random_action(match, rng))
    history = match.history
    again = new_match(game, 5, race=2)
    for moment in history[1:]:
        assert moment.action is not None
        again.play(moment.action)
    assert all(same(a, b) for a, b in zip(again.history, history, strict=True))
    while match.undo():
        assert match.now is history[len(match.history) - 1]
    assert len(match.history) == 1
    while match.redo():
        assert match.now is history[len(match.history) - 1]
    assert match.history == history
    match.undo()
    match.play(Concede(match.ask.player)) if not match.state.over else match.play(NextFrame())
    assert not match.redo()


def test_frames_are_counted_and_the_break_goes_round(table: Table) -> None:
    def breakers(breaks: str) -> tuple[list[int], Match]:
        match = Match(table, Setup("nine-ball", race=3, breaks=breaks, breaker=1))
        seen = []
        for loser in (1, 1, 0):
            seen.append(match.now.breaker)
            assert match.ask.player == match.now.breaker
            match.play(Concede(loser))
            assert not match.over
            match.play(NextFrame())
        return [*seen, match.now.breaker], match

    assert breakers("alternate")[0] == [1, 0, 1, 0]
    assert breakers(WINNER)[0] == [1, 0, 0, 1]
    order, match = breakers(LOSER)
    assert order == [1, 1, 1, 0]
    assert match.frames == (2, 1)
    assert (match.winner, match.now.frame) == (None, 3)
    match.play(Concede(1))
    assert (match.winner, match.over) == (0, True)
    with pytest.raises(InputError, match="allowed between frames only"):
        match.play(NextFrame())
    with pytest.raises(InputError, match="the frame is over"):
        match.play(Concede(0))
    assert match.undo()
    assert not match.over


def test_a_stalemate_begins_the_frame_again(table: Table) -> None:
    match = Match(table, Setup("eight-ball", breaker=1))
    first = match.layout
    match.play(Stroke(Shot(0.0, 8.0)))
    match.play(Stalemate())
    assert (match.ask.player, match.now.frame, match.now.shooter, match.frames) == (1, 0, -1, (0, 0))
    assert len(match.layout.on_table()) == 16
    assert match.layout != first
    assert match.now.tallies[1].strokes == 1


def test_frames_are_racked_differently(table: Table) -> None:
    match = Match(table, Setup("eight-ball", race=2, breaker=0))
    first = match.layout
    match.play(Concede(0))
    match.play(NextFrame())
    assert match.layout != first


@pytest.mark.parametrize("game", GAMES)
def test_nobody_has_shot_where_a_frame_begins(game: str) -> None:
    match, rng = new_match(game, 6, race=2), random.Random(game)
    assert (match.now.shooter, match.now.frame) == (-1, 0)
    while match.ask.kind != "aim":
        match.play(random_action(match, rng))
    shooter = match.ask.player
    match.play(Stroke(Shot(0.2, 4.0, ball=match.ask.ball)))
    assert match.now.shooter == shooter
    match.play(Concede(match.ask.player))
    if not match.over:
        match.play(NextFrame())
        assert (match.now.shooter, match.now.frame) == (-1, 1)


def test_the_racks_of_a_seed_stay_what_they_are(table: Table) -> None:
    """Else no record of a match could be played again."""
    match = Match(table, Setup("nine-ball", race=3, breaker=0, seed=7))
    seen = []
    for _ in range(3):
        balls = sorted(match.layout.values(), key=lambda ball: (round(ball.x, 3), ball.y))
        seen.append("".join(ball.id for ball in balls if ball.id != "cue"))
        match.play(Concede(len(seen) % 2))
        if not match.over:
            match.play(NextFrame())
    assert seen == ["185792436", "152693784", "138296457"]


def test_a_coin_decides_who_breaks(table: Table) -> None:
    tossed = [Match(table, Setup("nine-ball", seed=seed)).now.breaker for seed in range(40)]
    assert set(tossed) == {0, 1}
    assert tossed == [Match(table, Setup("nine-ball", seed=seed)).now.breaker for seed in range(40)]


def practice(table: Table, *balls: Ball) -> Match:
    match = Match(table, Setup())
    match.play(Arrange(Layout(balls)))
    return match


STRAIGHT = (Ball("cue", 1.27, 0.9), Ball("1", 1.27, 0.3), Ball("2", 0.3, 1.0), Ball("3", 0.4, 1.0))


def test_strokes_are_counted(table: Table) -> None:
    match = practice(table, *STRAIGHT)
    pot, miss = Stroke(Shot(-90.0, 2.0, height=-0.05)), Stroke(Shot(0.0, 0.5))
    assert match.play(pot).ruling.points == (1,)
    (tally,) = match.now.tallies
    assert (tally.strokes, tally.innings, tally.pots, tally.run, tally.best, tally.points) == (1, 1, 1, 1, 1, 1)
    match.play(miss)
    (tally,) = match.now.tallies
    assert (tally.strokes, tally.innings, tally.pots, tally.run, tally.best) == (2, 1, 1, 0, 1)
    assert match.now.report is not None
    assert match.now.rollout is not None


def test_innings_and_fouls_are_counted(table: Table) -> None:
    match = Match(table, Setup("nine-ball", breaker=0))
    match.play(Stroke(Shot(180.0, 1.0)))
    first, second = match.now.tallies
    assert (first.innings, first.fouls, second.innings) == (1, 1, 0)


def test_a_ball_that_scores_nothing_is_no_run_where_points_count(table: Table) -> None:
    match = Match(table, Setup("straight", breaker=0))
    seen = notation.report("cue-1 1>top-left 2| 3| cue|", "5>top-right")
    ruling = match.rules.judge(match.state, notation.without(match.layout, "1"), seen)
    assert not ruling.foul and ruling.points == (0, 0)
    mine = after_stroke(match.now.tallies, 0, False, match.rules, ruling, seen)[0]
    assert (mine.pots, mine.run, mine.best) == (0, 0, 0)


def test_practice_puts_balls_anywhere(table: Table) -> None:
    match = practice(table, Ball("1", 1.0, 1.0))
    assert match.ask.kind == "place"
    assert match.layout["cue"].phase == POCKETED
    with pytest.raises(InputError, match="the ball is off the table"):
        match.play(Arrange(Layout([Ball("1", 9.0, 1.0)])))
    assert len(match.history) == 2
    with pytest.raises(InputError, match="in practice only"):
        Match(table, Setup("nine-ball")).play(Arrange(Layout()))


@pytest.mark.parametrize(
    ("action", "words"),
    [
        (Stroke(Shot(0.0, 1.0, ball="1")), "shot.ball = '1': allowed is cue"),
        (Stroke(Shot(0.0, 99.0)), "allowed is a number from 0 to 50 m/s"),
        (Stroke(Shot(0.0, 1.0), Call(safety=True)), "call = 'safety': allowed is neither"),
        (Stroke(Shot(0.0, 1.0), Call("1", "left")), "call.pocket = 'left'"),
        (Choice("re-rack"), "allowed is place"),
        (Concede(2), "player = 2: allowed is 0 to 1"),
        (Concede(-1), "player = -1: allowed is 0 to 1"),
        (Concede(True), "player = True: allowed is 0 to 1"),
        (NextFrame(), "allowed between frames only"),
    ],
)
def test_what_is_not_asked_for_changes_nothing(table: Table, action: Action, words: str) -> None:
    match = Match(table, Setup("nine-ball", breaker=0))
    match.play(Choice("place", 0.3, 0.6))
    match.undo()
    before = match.now
    with pytest.raises(InputError, match=words):
        match.play(action)
    assert match.now is before
    assert match.redo()


def rolled(*speeds: float) -> Match:
    """Practice on a 9-foot table in which the cue ball was rolled along the table, again and again."""
    match = Match(load_table("pool-9ft"), Setup("practice"))
    match.play(Arrange(Layout([Ball("cue", 0.3, 0.6), Ball("1", 0.3, 0.8)])))
    for speed in speeds:
        match.play(Stroke(Shot(0.0, speed)))
    return match


def test_what_was_undone_is_gone_once_the_table_has_changed() -> None:
    small = load_table("pool-7ft")
    match = rolled(0.8)
    assert match.layout["cue"].x > small.knobs.table.length
    match.undo()
    match.change_table(small)
    assert not match.redo()
    assert small.settle(match.layout) == match.layout
    # What is played on the new table is undone and done again as ever.
    match.play(Stroke(Shot(0.0, 0.5)))
    assert match.undo() and match.redo()


def test_the_way_back_leads_only_to_where_the_balls_fit_on_the_table_as_it_is() -> None:
    large, small = load_table("pool-9ft"), load_table("pool-7ft")
    match = rolled(0.8)
    far = match.now
    match.play(Arrange(Layout([Ball("cue", 0.3, 0.6)])))
    match.change_table(small)
    before = match.now
    assert not match.undo()
    assert match.now is before and not match.redo()
    # Nothing is lost: on the larger table there is room again.
    match.change_table(large)
    assert match.undo() and match.now is far
    while match.undo():
        pass
    assert len(match.history) == 1


def test_balls_that_grow_a_hair_too_large_are_set_apart_on_the_way_back() -> None:
    match = rolled()
    radius = match.table.knobs.ball.radius
    match.play(Arrange(Layout([Ball("cue", 0.3, 0.6), Ball("1", 0.3, 0.6 + 2.0 * radius)])))
    match.play(Stroke(Shot(0.0, 1.0)))
    grown = match.table.with_knobs({"ball.radius": radius + 4e-7})
    match.change_table(grown)
    assert match.undo()
    a, b = match.layout["cue"], match.layout["1"]
    assert b.y - a.y >= 2.0 * (radius + 4e-7) - 1e-9
    assert match.redo() and match.undo()
