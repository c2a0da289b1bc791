"""A match without a screen: recorded to the bit, and lost by who does what the rules refuse."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from pool2d import BudgetError, InputError, Shot, load_table
from pool2d.game import Stroke
from pool2d.game.records.record import load
from pool2d.game.records.replaying import restored
from pool2d.opponent.contests import contest as contests
from pool2d.opponent.contests.contest import Contest, held
from pool2d.opponent.contests.score import scored
from pool2d.opponent.deciding import Decision

from .quick_players import STEADY, WILD

TABLE = load_table("pool-9ft")


def contest(path: Path, number: int = 0) -> Contest:
    return Contest(TABLE, "nine-ball", ("steady", "wild"), (STEADY, WILD), 4, number, path)


def test_a_match_is_recorded_and_replays(tmp_path: Path) -> None:
    outcome = held(contest(tmp_path / "a.jsonl", 1))
    kept = load(tmp_path / "a.jsonl")
    match, changes = restored(kept)
    assert (kept.over, changes, match.winner) == (True, (), outcome.winner)
    assert match.setup.players == ("steady", "wild")
    assert match.names == ("Steady", "Wild")
    assert tuple(side.fouls for side in outcome.sides) == tuple(tally.fouls for tally in match.now.tallies)
    strokes = sum(tally.strokes for tally in match.now.tallies)
    assert 0 < sum(side.pots for side in outcome.sides) <= sum(side.attempts for side in outcome.sides) <= strokes
    assert [path.name for path in tmp_path.iterdir()] == ["a.jsonl"]


def test_a_seed_gives_the_same_record(tmp_path: Path) -> None:
    for name in "ab":
        held(contest(tmp_path / f"{name}.jsonl"))
    assert (tmp_path / "a.jsonl").read_bytes() == (tmp_path / "b.jsonl").read_bytes()


def test_two_break_each_rack_in_turn(tmp_path: Path) -> None:
    setups = [contest(tmp_path / "a.jsonl", number).setup for number in range(4)]
    assert [setup.breaker for setup in setups] == [0, 1, 0, 1]
    assert setups[0].seed == setups[1].seed != setups[2].seed == setups[3].seed


def _refused(*_: Any) -> Decision:
    return Decision((Stroke(Shot(angle=0.0, speed=2.0, ball="5")),))


def _endless(*_: Any) -> Decision:
    raise BudgetError(1, 0.0, {})


def test_what_the_rules_refuse_loses_the_match(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(contests, "decide", _refused)
    outcome = held(contest(tmp_path / "a.jsonl", 1))
    # The second breaks, and it is the first who wins.
    assert (outcome.illegal, outcome.winner) == (1, 0)
    assert load(tmp_path / "a.jsonl").over


def test_a_shot_without_end_decides_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(contests, "decide", _endless)
    outcome = held(contest(tmp_path / "a.jsonl"))
    assert (outcome.illegal, outcome.winner) == (0, -1)
    assert scored([outcome]).wins == [0, 0]


def test_a_record_that_cannot_be_written_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="cannot be written"):
        held(contest(tmp_path / "file" / "a.jsonl"))


def test_a_draft_that_a_kill_has_left_is_written_anew(tmp_path: Path) -> None:
    (tmp_path / "a.part").write_text("half a line")
    assert held(contest(tmp_path / "a.jsonl")).winner in (0, 1)
    assert [path.name for path in tmp_path.iterdir()] == ["a.jsonl"]


def test_scores_add_up(tmp_path: Path) -> None:
    outcomes = [held(contest(tmp_path / f"{number}.jsonl", number)) for number in range(2)]
    score = scored(outcomes)
    assert (score.matches, sum(score.wins), score.illegal) == (2, 2, 0)
    data = score.as_dict()
    for column in ("pots", "attempts", "fouls"):
        assert data[column] == [sum(getattr(one.sides[side], column) for one in outcomes) for side in (0, 1)]
    assert all(0.0 < usual <= longest for usual, longest in data["seconds_per_shot"])
    assert scored([]).as_dict()["seconds_per_shot"] == [[0.0, 0.0], [0.0, 0.0]]


def test_the_names_of_files_are_no_part_of_what_is_played(tmp_path: Path) -> None:
    held(contest(tmp_path / "a.jsonl"))
    held(replace(contest(tmp_path / "b.jsonl"), files=("x", "y")))
    one, two = (restored(load(tmp_path / f"{name}.jsonl"))[0] for name in "ab")
    assert [moment.action for moment in one.history] == [moment.action for moment in two.history]
