"""Free practice: what is counted, what comes back, and that nothing is a foul."""

from __future__ import annotations

import pytest

from pool2d import Ball, InputError, Layout, load_table
from pool2d.game.rules.notes import Note
from pool2d.game.rules.practice import Practice
from pool2d.physics.values import POCKETED

from .notation import after, report

TABLE = load_table("pool-9ft")
RULES = Practice(TABLE)


@pytest.mark.parametrize(
    ("said", "points", "back"),
    [
        ("cue-1 1> 2>", 2, ()),
        ("cue-1 1>", 1, ()),
        ("cue-1 1|", 0, ()),
        ("cue-1 cue>", 0, ()),
        ("cue-1 1> 2^right", 1, ("2",)),
        ("cue-1 1> 2~right", 1, ("2",)),
        ("cue-1 1> cue^left", 1, ()),
    ],
)
def test_a_stroke(said: str, points: int, back: tuple[str, ...]) -> None:
    start = RULES.start(seed=3)
    seen = report(said)
    ruling = RULES.judge(start.state, after(start.layout, seen), seen)
    assert ruling.points == (points,) and ruling.state.scores == (points,)
    assert ruling.notes == ((Note("score", 0, points=points),) if points else ())
    assert not ruling.foul
    assert (ruling.state.shots, ruling.state.racks) == (1, 1)
    assert tuple(ball for ball, _ in ruling.spotted) == back
    assert (ruling.ask.kind == "place") == ("cue>" in said or "cue^" in said) and ruling.ask.where == "anywhere"
    twice = RULES.judge(ruling.state, ruling.layout, report("cue-3 3>"))
    assert (twice.state.scores, twice.state.shots, twice.points) == ((points + 1,), 2, (1,))


def test_balls_that_are_set_up_by_hand() -> None:
    state = RULES.start(seed=3).state
    ruling = RULES.arranged(state, Layout([Ball("1", 1.0, 0.5)]))
    assert ruling.layout["cue"].phase == POCKETED and ruling.ask.kind == "place"
    assert ruling.ask.on == ("1",) and ruling.state.shots == 0
    with pytest.raises(InputError):
        RULES.arranged(state, Layout([Ball("1", 1.0, 0.5), Ball("2", 1.01, 0.5)]))
