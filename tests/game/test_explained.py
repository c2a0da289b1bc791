"""Reasons in words: plain English, and whatever language a voice has."""

from __future__ import annotations

from dataclasses import replace
from typing import get_args

import pytest

from pool2d import Shot, load_table
from pool2d.game import Fear, Match, Reasons, Setup, Stroke, Thought
from pool2d.game.explained import ENGLISH, Voice, explained, strayed, told
from pool2d.game.reasons import StrokeKind
from pool2d.game.rules import Note

ENGLISH_VOICE = Voice()
RADIUS = 0.028575
MEANT = Shot(350.0, 2.1, 0.1, -0.3)
WHY = Reasons(
    Thought("pot", MEANT, "3", "top-right", 0.7, 0.55, 30, 0.1, 0.3),
    (Thought("safety", Shot(170.0, 1.2), "5", chance=1.0, value=0.414),),
    (Fear(Note("fear.left", 1), 0.2), Fear(Note("foul.scratch"), 0.1)),
)


def test_reasons_are_told_in_plain_words() -> None:
    found = explained(WHY, MEANT, False, RADIUS, ENGLISH_VOICE)
    assert found.meant == "Pot, the 3, top right pocket, 2.10 m/s with draw"
    assert found.held == "comes off 70 %, wins 55 %"
    assert found.mind == "tries in mind: 30; fouls 10 %, turn lost 30 %"
    assert found.others == ("Safety, the 5, 1.20 m/s without spin: comes off 100 %, wins 41 %",)
    assert found.fears == ("20 %: Player 2 was left a good shot.", "10 %: The cue ball was pocketed.")
    assert found.hand == "as it was meant"
    headings = [(key, len(lines)) for key, lines in found.parts()]
    assert headings == [("meant", 3), ("others", 1), ("fears", 2), ("hand", 1)]
    assert dict(found.parts())["others"][0].startswith("1  Safety")


@pytest.mark.parametrize(
    ("value", "worth"), [(4.25, "4.2 points ahead"), (-12.0, "12.0 points behind"), (-0.04, "0.0 points ahead")]
)
def test_in_a_game_that_is_scored_the_worth_is_points(value: float, worth: str) -> None:
    why = Reasons(replace(WHY.meant, value=value))
    assert explained(why, MEANT, True, RADIUS, ENGLISH_VOICE).held == f"comes off 70 %, {worth}"


@pytest.mark.parametrize(
    ("played", "said"),
    [
        (replace(MEANT, angle=-9.5), "0.50° to the left, 0.00 m/s harder, tip 0.0 mm off"),
        (replace(MEANT, angle=349.9, speed=2.0), "0.10° to the right, 0.10 m/s softer, tip 0.0 mm off"),
        (replace(MEANT, side=0.2), "0.00° to the left, 0.00 m/s harder, tip 2.9 mm off"),
        (MEANT, "as it was meant"),
    ],
)
def test_how_far_the_hand_strayed(played: Shot, said: str) -> None:
    assert strayed(MEANT, played, RADIUS, ENGLISH_VOICE) == said


@pytest.mark.parametrize(
    ("side", "height", "said"),
    [(0.04, 0.0, "without spin"), (0.3, 0.2, "with right english"), (-0.3, 0.2, "with left english"),
     (0.1, 0.2, "with follow"), (0.1, -0.2, "with draw")],
)  # fmt: skip
def test_the_greatest_spin_is_told(side: float, height: float, said: str) -> None:
    why = Reasons(Thought("kick", Shot(0.0, 2.0, side, height), "5"))
    assert explained(why, MEANT, False, RADIUS, ENGLISH_VOICE).meant == f"Kick shot, the 5, 2.00 m/s {said}"


@pytest.mark.parametrize("kind", get_args(StrokeKind))
def test_every_kind_of_stroke_has_a_name(kind: StrokeKind) -> None:
    assert f"kind.{kind}" in ENGLISH
    why = Reasons(Thought(kind, Shot(0.0, 2.0)))
    assert explained(why, MEANT, False, RADIUS, ENGLISH_VOICE).meant.startswith(ENGLISH[f"kind.{kind}"] + ", 2.00")


def test_worth_beyond_a_sure_win_is_a_sure_win_and_nothing_feared_is_said() -> None:
    found = explained(Reasons(replace(WHY.meant, value=1.3)), MEANT, False, RADIUS, ENGLISH_VOICE)
    assert found.held == "comes off 70 %, wins 100 %"
    assert found.fears == ("nothing: it never went wrong in mind",)
    assert [key for key, _ in found.parts()] == ["meant", "fears", "hand"]


def test_a_stroke_of_a_match_is_told_by_its_game_and_one_without_reasons_is_not() -> None:
    for table, game, worth in (("pool-9ft", "nine-ball", "wins 55 %"), ("snooker-12ft", "snooker", "0.6 points ahead")):
        match = Match(load_table(table), Setup(game, breaker=0))
        parts = dict(told(match, match.now, Stroke(MEANT, why=WHY), ENGLISH_VOICE))
        assert parts["meant"][1] == f"comes off 70 %, {worth}"
        assert told(match, match.now, Stroke(MEANT), ENGLISH_VOICE) == []
