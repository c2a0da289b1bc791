"""What follows from the choices that the rules offer, game by game."""

from __future__ import annotations

import pytest

from pool2d import InputError
from pool2d.game.rules import Choice

from .cases import Case, judged, line, rules_of

CHOICES = [
    # game, clause, given, said, shot, choice, ruling
    ("nine-ball", "5.4", "may push", "push", "cue-5 5|", "play", "1 aims"),
    ("nine-ball", "5.4", "may push", "push", "cue-5 5|", "pass", "0 aims"),
    ("nine-ball", "Reg 16 (a)", "break, option three_ball yes", "", "cue-1 1| 2| 3| 4|", "play", "1 aims"),
    (
        "nine-ball",
        "Reg 16 (b)",
        "break, option three_ball yes",
        "",
        "cue-1 1| 2| 3| 4|",
        "hand-back",
        "0 aims; may push",
    ),
    ("ten-ball", "6.6", "", "2>", "cue-1 5>", "play", "1 aims"),
    ("ten-ball", "6.6", "", "2>", "cue-1 5>", "pass", "0 aims"),
    ("straight", "7.3", "break", "safety", "cue-1 1|", "accept", "1 aims"),
    ("straight", "7.3", "break", "safety", "cue-1 1|", "opponent-breaks", "0 aims kitchen"),
    ("straight", "7.3", "break", "safety", "cue-1 1| cue>", "kitchen", "1 places kitchen"),
]


@pytest.mark.parametrize(("name", "clause", "given", "said", "shot", "key", "ruling"), CHOICES)
def test_choice(name: str, clause: str, given: str, said: str, shot: str, key: str, ruling: str) -> None:
    case = Case(clause, "", given, said, shot, "")
    _, asked = judged(name, case)
    assert line(rules_of(name, case).choose(asked.state, asked.layout, Choice(key))) == ruling


def test_a_rebreak_keeps_the_score() -> None:
    """7.10: each failure costs two more."""
    rules = rules_of("straight")
    _, asked = judged("straight", Case("7.10", "", "break", "safety", "cue-1 1|", ""))
    again = rules.choose(asked.state, asked.layout, Choice("opponent-breaks"))
    assert again.state.scores == (-2, 0)
    assert len(rules.on_table(again.layout)) == 15


def test_the_breaker_chooses_a_pocket() -> None:
    """One-pocket, 2.1."""
    rules = rules_of("one-pocket")
    start = rules.start(breaker=1)
    assert line(start) == "1 chooses pocket:bottom-right/pocket:top-right"
    chosen = rules.choose(start.state, start.layout, Choice("pocket:top-right"))
    assert line(chosen, start.state) == "1 aims kitchen; pockets bottom-right / top-right"


def test_a_pocket_at_the_head_may_not_be_chosen() -> None:
    rules = rules_of("one-pocket")
    start = rules.start()
    with pytest.raises(InputError, match="allowed is pocket:bottom-right, pocket:top-right"):
        rules.choose(start.state, start.layout, Choice("pocket:top-left"))


def test_a_cue_ball_in_hand_behind_the_head_string_stays_there() -> None:
    rules = rules_of("nine-ball")
    start = rules.start()
    assert start.layout["cue"].x < 0.635
    with pytest.raises(InputError, match="allowed is behind the head string, clear of other balls"):
        rules.choose(start.state, start.layout, Choice("place", 0.7, 0.3))
    moved = rules.choose(start.state, start.layout, Choice("place", 0.2, 0.3))
    assert rules.choose(moved.state, moved.layout, Choice("place", 0.3, 0.3)).layout["cue"].x == 0.3


@pytest.mark.parametrize(
    ("name", "fouls", "options", "told"),
    [
        ("nine-ball", 1, "", True),
        ("nine-ball", 0, "", False),
        ("nine-ball", 1, ", option three_foul no", False),
        ("ten-ball", 1, "", True),
        ("straight", 1, "", True),
        ("one-pocket", 1, "", True),
    ],
)
def test_the_second_foul_in_a_row_is_told(name: str, fouls: int, options: str, told: bool) -> None:
    """3.13: so that who is on two fouls knows of it."""
    _, ruling = judged(name, Case("3.13", "", f"fouls {fouls}{options}", "", "cue|", ""))
    assert ruling.foul
    assert ("Second foul in a row by Player 1." in [note.text for note in ruling.notes]) is told
