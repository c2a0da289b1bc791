"""A stroke that a player plays says why: what was meant, how likely, what else there was, what was feared."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import islice

import pytest

from pool2d import Ball, Layout, Shot, load_table
from pool2d.game import Match, Setup, Stroke
from pool2d.game.actions import as_dict, from_dict
from pool2d.game.reasons import Reasons
from pool2d.game.rules import Note
from pool2d.opponent.candidate import Candidate
from pool2d.opponent.deciding import decide
from pool2d.opponent.fears import fears
from pool2d.opponent.judgement import Weighed
from pool2d.opponent.player import Judgement, Player, Taste
from pool2d.opponent.playing import by_hand, played_out
from pool2d.opponent.reasoning import reasons
from pool2d.opponent.stray import Hand

TABLE = load_table("pool-9ft")
QUICK = Judgement(
    ways=2, paces=2, heights=1, sides=1, few=3, runs=10, safeties=4, kicks=24, banks=1, combinations=1, cannons=20
)
# So fond of pots that it plays no safety.
WILD = Player("wild", hand=Hand(6.0, 6.0, 6.0), judgement=QUICK, taste=Taste(attack=1.0))
STEADY = Player("steady", hand=Hand(0.0, 0.0, 0.0, 0.0), judgement=QUICK)


def nine_ball(*balls: Ball) -> Match:
    """Nine-ball with these balls left, Player 1 to play."""
    match = Match(TABLE, Setup("nine-ball", breaker=0, seed=3))
    ruling = match.now.ruling
    state = ruling.state
    lost = [Ball(ball, 0.0, 0.0, phase="pocketed") for ball in ruling.layout if ball not in {one.id for one in balls}]
    ask = replace(state.ask, where="", on=(balls[1].id,), options=(), may=())
    standing = ruling._replace(state=replace(state, ask=ask, shots=1), layout=Layout([*balls, *lost]))
    match.accept(replace(match.now, ruling=standing))
    return match


# The 1 lies before a corner, and the 9 in the middle of the table.
EASY = (Ball("cue", 1.9, 0.7), Ball("1", 2.2, 0.95), Ball("9", 1.2, 0.5))


def why(match: Match, player: Player) -> tuple[Stroke, Reasons]:
    stroke = decide(match.judge, match.now.ruling, player, "a").stroke
    assert stroke is not None and stroke.why is not None
    return stroke, stroke.why


def test_a_pot_says_what_was_meant_and_how_likely_it_was() -> None:
    stroke, told = why(nine_ball(*EASY), WILD)
    assert (told.meant.kind, told.meant.ball, told.meant.pocket) == ("pot", "1", "top-right")
    assert told.meant.shot == stroke.shot
    assert told.meant.runs == 10 and 0.0 < told.meant.chance < 1.0
    # What is told of as gone wrong is what did not come off, or was left to the other.
    assert sum(fear.share for fear in told.fears) >= 1.0 - told.meant.chance - 1e-9
    assert all(other.value <= told.meant.value for other in told.others)


def test_who_never_misses_fears_nothing() -> None:
    _, told = why(nine_ball(*EASY), STEADY)
    assert (told.meant.chance, told.fears) == (1.0, ())


def test_the_hand_strays_from_what_was_meant_and_leaves_the_reasons_alone() -> None:
    match = nine_ball(*EASY)
    stroke, told = why(match, WILD)
    played = by_hand(match, stroke, WILD, "a")
    assert isinstance(played, Stroke)
    assert played.why == told and played.shot != told.meant.shot
    assert math.isclose(played.shot.angle, told.meant.shot.angle, abs_tol=10.0)
    assert from_dict(as_dict(played), "a") == played


def test_the_same_seed_has_the_same_reasons() -> None:
    assert why(nine_ball(*EASY), WILD) == why(nine_ball(*EASY), WILD)


def weighed(kind: str, ball: str, value: float, pocket: str = "") -> Weighed:
    return Weighed(Candidate(kind, Stroke(Shot(1.0, 2.0)), ball, pocket), value, 0.5)  # type: ignore[arg-type]


def test_one_pot_that_is_thought_of_in_several_ways_is_told_of_once() -> None:
    left = [weighed("pot", "1", value, "top-left") for value in (0.9, 0.8, 0.7)]
    more = [weighed("safety", "1", 0.6), weighed("pot", "1", 0.5, "top-right"), weighed("kick", "1", 0.4)]
    told = reasons([*left, *more])
    assert told.meant.value == 0.9
    assert [other.value for other in told.others] == [0.8, 0.6, 0.5]


def test_the_most_frequent_fears_come_first_with_their_shares() -> None:
    scratch, left = Note("foul.scratch"), Note("fear.left", 1)
    told = fears([left, None, scratch, left, None])
    assert [(fear.note, fear.share) for fear in told] == [(left, 0.4), (scratch, 0.2)]
    assert fears([None, None]) == ()


@pytest.mark.parametrize(("table", "game"), [("snooker-12ft", "snooker"), ("pool-9ft", "straight")])
def test_every_stroke_of_a_match_says_why(table: str, game: str) -> None:
    player = Player("quick", hand=Hand(2.0), judgement=Judgement(1, 1, 1, 1, 1, 2, 2, 24))
    match = Match(load_table(table), Setup(game, breaker=0, seed=3))
    moments = [moment for _, moment in islice(played_out(match, (player, player), "a"), 6)]
    strokes = [moment.action for moment in moments if isinstance(moment.action, Stroke)]
    assert strokes
    for stroke in strokes:
        assert stroke.why is not None
        assert from_dict(as_dict(stroke), "a") == stroke
