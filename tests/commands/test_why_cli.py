"""`pool2d replay --why`: what a record tells of why its strokes were played."""

from __future__ import annotations

from pathlib import Path

import pytest

from pool2d import Shot, load_table
from pool2d.cli import main
from pool2d.game import Fear, Match, Reasons, Setup, Stroke, Thought
from pool2d.game.records.recorder import record
from pool2d.game.rules import Note

WHY = Reasons(
    Thought("break", Shot(0.0, 8.2), "1", chance=0.9, value=0.53, runs=20, fouls=0.1, lost=0.6),
    (Thought("safety", Shot(3.0, 2.0), "1", chance=1.0, value=0.4),),
    (Fear(Note("fear.left", 1), 0.1), Fear(Note("foul.scratch"), 0.05)),
)


@pytest.fixture
def recorded(tmp_path: Path) -> str:
    match = Match(load_table("pool-9ft"), Setup("nine-ball", names=("Ann", "Bob"), breaker=0, seed=3))
    with record(match, tmp_path / "a.jsonl") as recorder:
        recorder.play(Stroke(Shot(0.25, 8.0), why=WHY))
        if recorder.match.ask.kind == "aim":
            recorder.play(Stroke(Shot(180.0, 0.5)))
    return str(tmp_path / "a.jsonl")


def test_every_stroke_is_explained_or_said_to_have_no_reasons(
    recorded: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["replay", recorded, "--why"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[:8] == [
        "   1  Ann",
        "      Meant     Break, the 1, 8.20 m/s without spin",
        "                comes off 90 %, wins 53 %",
        "                tries in mind: 20; fouls 10 %, turn lost 60 %",
        "      Or else   1  Safety, the 1, 2.00 m/s without spin: comes off 100 %, wins 40 %",
        "      Feared    10 %: Bob was left a good shot.",
        "                5 %: The cue ball was pocketed.",
        "      The hand  0.25° to the left, 0.20 m/s softer, tip 0.0 mm off",
    ]
    assert lines[8].startswith("   2  ") and lines[9:] == ["      Nobody has told why."]


def test_one_stroke_is_asked_for_by_its_number(recorded: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["replay", recorded, "--why", "--shot", "2"]) == 0
    assert len(capsys.readouterr().out.splitlines()) == 2
    assert main(["replay", recorded, "--why", "--shot", "7"]) == 2
    assert "--shot = 7: allowed is 1 to 2" in capsys.readouterr().err
