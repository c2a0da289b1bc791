"""What is counted of a player: which balls are pots, and what a run is."""

from __future__ import annotations

import random
from dataclasses import asdict
from itertools import pairwise

import pytest

from benchmarks.random_play import new_match, random_action
from pool2d import Table, load_table
from pool2d.game.rules import GAMES
from pool2d.game.tally import Tally, after_frame, after_stroke

from .rules import test_carom, test_english_eight_ball, test_more_games, test_snooker
from .rules.cases import Case, given, rules_of, situation
from .rules.notation import after, report
from .rules.rule_scenes import judged as scene_judged

BEFORE = (Tally(innings=1, run=2, best=3, pots=4), Tally())


def counted(name: str, setting: str, said: str, shot: str) -> tuple[int, int, int]:
    """The pots that a stroke adds, then run and best; player 0 had a run of 2 and a best of 3."""
    case = Case("", "", setting, said, shot, "")
    rules = rules_of(name, case)
    state, layout = situation(rules, case)
    seen = report(shot, said, start=layout, **given(case).report)
    ruling = rules.judge(state, after(layout, seen), seen)
    mine = after_stroke(BEFORE, 0, True, rules, ruling, seen)[0]
    return mine.pots - 4, mine.run, mine.best


@pytest.mark.parametrize(
    ("name", "setting", "said", "shot", "pots", "run"),
    [
        # Eight-ball: the ball called, and no other.
        ("eight-ball", "solids", "3>", "cue-3 3>", 1, 3),
        ("eight-ball", "solids", "3>", "cue-3 3> 4> 9>", 1, 3),
        ("eight-ball", "solids", "3>top-right", "cue-3 4>", 0, 0),
        ("eight-ball", "solids", "3>bottom-left", "cue-3 3>top-left", 0, 0),
        ("eight-ball", "solids", "safety", "cue-3 3>", 0, 0),
        ("eight-ball", "solids", "3>", "cue-3 3> cue>", 0, 0),
        ("eight-ball", "break", "", "cue-1 1> 9>", 2, 4),
        ("eight-ball", "break", "", "cue-1 8> 9>", 0, 0),
        ("eight-ball", "solids, balls 8 9", "8>", "cue-8 8>", 1, 3),
        ("eight-ball", "solids, balls 3 8 9", "3>", "cue-3 8>", 0, 0),
        # Nine-ball: whatever stays down and keeps the player at the table.
        ("nine-ball", "", "", "cue-1 5> 3>", 2, 4),
        ("nine-ball", "", "", "cue-1 9>", 1, 3),
        ("nine-ball", "", "", "cue-2 5>", 0, 0),
        ("nine-ball", "may push", "push", "cue-5 5>", 0, 0),
        ("nine-ball", "break, option nine_on_break spotted", "", "cue-1 9> 2>", 1, 3),
        ("nine-ball", "break, option three_ball yes", "", "cue-1 2>", 0, 0),
        # Ten-ball: called again.
        ("ten-ball", "", "2>", "cue-1 2>", 1, 3),
        ("ten-ball", "", "2>", "cue-1 2> 5>", 1, 3),
        ("ten-ball", "", "2>", "cue-1 5>", 0, 0),
        ("ten-ball", "", "10>", "cue-1 10>", 0, 0),
        # Straight pool: all that fall with the ball called are points.
        ("straight", "", "5>", "cue-5 5> 6>", 2, 4),
        ("straight", "", "5>top-right", "cue-5 6>", 0, 0),
        ("straight", "", "safety", "cue-5 5>", 0, 0),
        ("straight", "", "5>", "cue-5 5> cue>", 0, 0),
        # One-pocket: one's own pocket.
        ("one-pocket", "", "", "cue-3 3>bottom-right 4>top-right 5>top-left", 1, 3),
        ("one-pocket", "", "", "cue-3 3>top-right", 0, 0),
    ],
)
def test_what_counts_as_a_pot(name: str, setting: str, said: str, shot: str, pots: int, run: int) -> None:
    assert counted(name, setting, said, shot) == (pots, run, max(3, run))


@pytest.mark.parametrize(
    ("setting", "said", "shot", "pots"),
    [
        ("phase color", "blue", "cue-blue blue>", 1),
        ("", "", "cue-red1 red1> red2>", 2),
        ("", "", "cue-red1 red1> cue>", 0),
    ],
)
def test_colors_that_are_spotted_are_pots_at_snooker(setting: str, said: str, shot: str, pots: int) -> None:
    case = Case("", "", setting, said, shot, "")
    rules, ruling = scene_judged("snooker", test_snooker.TABLE, case, test_snooker.asks)
    assert len(rules.pots(0, report(shot, said), ruling)) == pots


@pytest.mark.parametrize(
    ("setting", "shot", "pots"),
    [
        ("groups red yellow", "cue-red1 red1>", 1),
        ("shots 0, where kitchen", "cue-red1 red3> yellow2>", 2),
        ("shots 0, where kitchen", "cue-red1 black> red3>", 0),
        ("trial red, visits 2", "cue-red1 yellow2>", 0),
        ("trial red, visits 2", "cue-red1 red2>", 1),
    ],
)
def test_pots_at_english_eight_ball(setting: str, shot: str, pots: int) -> None:
    case = Case("", "", setting, "", shot, "")
    table = load_table("english-7ft")
    rules, ruling = scene_judged("english-eight-ball", table, case, test_english_eight_ball.asks)
    assert rules.name in GAMES
    assert len(rules.pots(0, report(shot), ruling)) == pots


SNOOKER, CAROM, PYRAMID = test_snooker.TABLE, test_carom.TABLE, test_more_games.PYRAMID


@pytest.mark.parametrize(
    ("name", "table", "setting", "said", "shot", "run"),
    [
        ("snooker", SNOOKER, "phase color", "blue", "cue-blue blue>", 5),
        ("snooker", SNOOKER, "", "", "cue-red1 red1> red2>", 2),
        ("six-red", SNOOKER, "phase color", "pink", "cue-pink pink>", 6),
        ("three-cushion", CAROM, "", "", "cue-red cue| cue| cue| cue-yellow", 1),
        ("straight-rail", CAROM, "", "", "cue-red cue-yellow", 1),
        ("four-ball", CAROM, "", "", "cue-red cue-red2", 1),
        ("free-pyramid", PYRAMID, "", "", "cue-1 1> 7> cue>", 3),
        # What gives no point, or gives the other player one, ends the run.
        ("snooker", SNOOKER, "", "", "cue-red1 red1> cue>", 0),
        ("three-cushion", CAROM, "", "", "cue-red cue| cue-yellow", 0),
        ("four-ball", CAROM, "", "", "cue-red cue-yellow", 0),
        ("free-pyramid", PYRAMID, "", "", "cue-1", 0),
    ],
)
def test_where_points_count_a_run_is_of_points(
    name: str, table: Table, setting: str, said: str, shot: str, run: int
) -> None:
    asks = {SNOOKER: test_snooker.asks, CAROM: test_carom.asks, PYRAMID: test_more_games.shoots}[table]
    rules, ruling = scene_judged(name, table, Case("", "", setting, said, shot, ""), asks)
    assert rules.scored
    before = (Tally(innings=1, run=2, best=3, points=7), Tally())
    gone_on = after_stroke(before, 0, True, rules, ruling, report(shot, said))
    assert (gone_on[0].run, gone_on[0].best) == (2 + run if run else 0, max(3, 2 + run if run else 0))
    assert [tally.points for tally in gone_on] == [7 + ruling.points[0], ruling.points[1]]
    # A visit that begins with it has this stroke alone.
    begun = after_stroke(before, 0, False, rules, ruling, report(shot, said))
    assert (begun[0].run, begun[0].best, begun[0].innings) == (run, max(3, run), 2)


@pytest.mark.parametrize("name", GAMES)
def test_nothing_is_counted_before_the_first_stroke(name: str) -> None:
    assert all(set(asdict(tally).values()) == {0} for tally in new_match(name, 3).now.tallies)


@pytest.mark.parametrize("name", GAMES)
def test_what_is_counted_is_what_was_played(name: str) -> None:
    """Counted again from the whole match: strokes and fouls, visits, points and frames; a lag counts for nothing."""
    match, rng = new_match(name, 11, race=3), random.Random(f"{name} tally")
    while len(match.history) < 30 and not match.over:
        match.play(random_action(match, rng))
    players = range(match.rules.players)
    strokes = [moment for moment in match.history if moment.report is not None]
    visits = [
        moment.shooter
        for before, moment in pairwise(match.history)
        if moment.report is not None and before.shooter != moment.shooter
    ]
    ended = [moment.state.winner for moment in match.history if moment.state.over]
    for player in players:
        tally, mine = match.now.tallies[player], [moment for moment in strokes if moment.shooter == player]
        assert tally.strokes == len(mine)
        assert tally.fouls == sum(moment.ruling.foul for moment in mine)
        assert tally.innings == visits.count(player)
        assert tally.points == sum(moment.ruling.points[player] for moment in strokes)
        assert tally.frames == ended.count(player)
        runs = [moment.tallies[player].run for moment in match.history]
        assert (tally.run, tally.best) == (runs[-1], max(runs))


def test_a_frame_counts_for_its_winner_and_a_draw_for_nobody() -> None:
    before = (Tally(frames=2, points=5), Tally(frames=1, points=9))
    assert [tally.frames for tally in after_frame(before, 1)] == [2, 2]
    assert after_frame(before, None) == before
    assert [tally.points for tally in after_frame(before, 0)] == [5, 9]
