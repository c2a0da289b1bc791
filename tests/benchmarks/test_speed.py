"""What `benchmarks.speed` prints and keeps; how fast anything is, no test says."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from benchmarks import speed, speed_cases
from pool2d import load_table, simulate


def test_the_table_tells_medians_their_spread_and_what_they_are_to_the_first_column() -> None:
    told = speed.table(
        {
            "interpreted": {"loop": [0.02, 0.03, 0.04], "break": [0.8, 1.0, 1.2, 1.0, 1.0], "import": [2.0]},
            "compiled": {"loop": [0.03], "break": [0.1, 0.1, 0.1]},
        }
    ).splitlines()
    assert "30.0 ms" in told[0]
    assert told[1].split() == ["interpreted", "compiled"]
    assert told[2].split() == ["break", "1", "20", "%", "0.1", "0", "%", "0.10x"]
    # What a column has not is told as such.
    assert told[3].split() == ["import", "2", "0", "%", "-"]


def test_a_run_is_kept_and_shown_beside_another(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    saved = tmp_path / "run.json"
    command = ["speed", "--turns", "1", "--only", "two balls"]
    monkeypatch.setattr(sys, "argv", [*command, "--save", str(saved)])
    assert speed.main() == 0
    kept = json.loads(saved.read_text())
    assert len(kept["interpreted"]["two balls"]) >= 3
    assert min(kept["interpreted"]["two balls"]) > 0.0
    monkeypatch.setattr(sys, "argv", [*command, "--against", str(saved)])
    capfd.readouterr()
    assert speed.main() == 0
    told = capfd.readouterr().out.splitlines()
    assert "interpreted, saved" in told[1]
    assert told[2].startswith("two balls") and told[2].rstrip().endswith("x")


def test_a_case_that_is_none_is_told(monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(sys, "argv", ["speed", "--only", "brake"])
    with pytest.raises(SystemExit):
        speed.main()
    assert "brake" in capfd.readouterr().err


@pytest.mark.parametrize("count", speed_cases.CROWDS)
def test_a_crowd_stands_free_on_its_table_and_moves(count: int) -> None:
    table, layout = speed_cases.crowd(count, 1)
    assert len(layout) == count
    assert len(simulate(table, layout, events=20).events) == 20


def test_the_break_off_of_snooker_reaches_the_reds() -> None:
    table = load_table("snooker-12ft")
    first = next(event for event in simulate(table, *speed_cases.snooker_break(table, 1)).events if event.pairs)
    assert any(ball.startswith("red") for pair in first.pairs for ball in pair)
