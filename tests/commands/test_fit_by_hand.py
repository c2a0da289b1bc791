"""`pool2d fit --by-hand`: measurements in, knobs and a preset out."""

from __future__ import annotations

import io
import re
from pathlib import Path

import pytest

from pool2d import load_table
from pool2d.cli import main
from pool2d.commands import fit_by_hand

from .cli_runs import ROOT, Capture, refusal

FILE = """
table = "pool-8ft"
[spin]
turns = "14 15"
seconds = 4.3
[rebound]
kept = 0.58
"""


class Terminal(io.StringIO):
    """Somebody who types these lines."""

    def isatty(self) -> bool:
        return True


@pytest.fixture(autouse=True)
def data(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path / "data"))


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "mine.toml"
    path.write_text(FILE)
    return path


def told(capsys: Capture) -> dict[str, list[str]]:
    """The table of knobs: what each was, what it is, its error and what tells it."""
    rows = [line.split(maxsplit=4) for line in capsys.readouterr().out.splitlines()]
    return {row[0]: row[1:] for row in rows if row and row[0].startswith(("cloth.", "cushion."))}


def test_a_file_gives_a_table_of_knobs(file: Path, capsys: Capture) -> None:
    assert main(["fit", "--by-hand", str(file)]) == 0
    knobs = told(capsys)
    assert list(knobs) == ["cloth.mu_spin", "cushion.restitution"]
    was, now, error, by = knobs["cushion.restitution"]
    assert (was, by) == ("0.92", "rebound")
    assert 0.92 < float(now) < 0.98 and 0.0 < float(error) < 0.1


def test_the_example_of_the_page_gives_what_the_page_says(file: Path, capsys: Capture) -> None:
    page = (ROOT / "docs" / "fitting.md").read_text(encoding="utf-8")
    example = re.search(r"```toml\n(.*?)```", page, re.DOTALL)
    answer = re.search(r"```\n\$ pool2d fit --by-hand[^\n]*\n(.*?)```", page, re.DOTALL)
    assert example is not None and answer is not None
    file.write_text(example[1])
    assert main(["fit", "--by-hand", str(file)]) == 0
    knobs = told(capsys)
    shown = {row[0]: row[1:] for row in (line.split(maxsplit=4) for line in answer[1].splitlines()[1:])}
    assert list(knobs) == list(shown)
    for name, (_, now, error, by) in shown.items():
        assert float(knobs[name][1]) == pytest.approx(float(now), abs=float(error)), (
            "the presets have changed: run it again"
        )
        assert knobs[name][3] == by


def test_a_preset_of_ones_own_says_what_it_rests_on(file: Path, tmp_path: Path, capsys: Capture) -> None:
    assert main(["fit", "--by-hand", str(file), "--out", "ours"]) == 0
    knobs = told(capsys)
    mine, base = load_table("ours").knobs, load_table("pool-8ft").knobs
    assert mine.cushion.restitution == float(knobs["cushion.restitution"][1])
    assert mine.cloth.mu_spin == float(knobs["cloth.mu_spin"][1])
    assert (mine.table, mine.cloth.mu_roll) == (base.table, base.cloth.mu_roll)
    text = (tmp_path / "data" / "tables" / "ours.toml").read_text()
    assert text.startswith("# Measured by hand; what was not measured is as on pool-8ft.\n")
    assert "# rebound.kept = 0.58 +- 0.02: " in text and "# spin.turns = 14.5 +- 0.38 turns: " in text


def test_a_preset_may_go_to_a_file(file: Path, tmp_path: Path) -> None:
    out = tmp_path / "there.toml"
    assert main(["fit", "--by-hand", str(file), "--table", "pool-9ft", "--out", str(out)]) == 0
    assert 'base = "pool-9ft"' in out.read_text()
    assert load_table(out).knobs.cushion.restitution > 0.92


def test_what_is_laid_over_the_table_counts(file: Path, capsys: Capture) -> None:
    assert main(["fit", "--by-hand", str(file), "--set", "cushion.friction=0.25"]) == 0
    rough = told(capsys)
    assert main(["fit", "--by-hand", str(file)]) == 0
    assert rough["cushion.restitution"][1] != told(capsys)["cushion.restitution"][1]


def answered(monkeypatch: pytest.MonkeyPatch, lines: str, *words: str) -> int:
    monkeypatch.setattr("sys.stdin", Terminal(lines))
    return main(["fit", "--by-hand", *words])


def test_questions_are_asked_and_enter_skips_them(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a measurement that was not made no more is asked."""
    assert answered(monkeypatch, "8,4 8.6 +-0.1\n\n\n\n\n0.58\n") == 0
    out = capsys.readouterr().out
    assert "lag.gap" in out and "hard.lengths" in out and "hard.first" not in out and "spin.seconds" not in out
    assert "cloth.mu_roll" in out and "cushion.restitution" in out and "cloth.mu_spin" not in out


def test_an_answer_that_is_not_understood_is_asked_for_again(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    assert answered(monkeypatch, "\n\n\n\nmuch\n7\n0.58\n") == 0
    caught = capsys.readouterr()
    assert caught.err.count("\n") == 2
    assert "rebound.kept = 'much'" in caught.err and "rebound.kept = 7.0" in caught.err
    assert "cushion.restitution" in caught.out


def test_elsewhere_than_at_a_terminal_it_ends_the_command(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO("much\n"))
    assert main(["fit", "--by-hand"]) == 2
    assert "lag.seconds = 'much'" in capsys.readouterr().err


@pytest.mark.parametrize("stdin", [io.StringIO(""), None])
def test_without_answers_nothing_is_measured(
    stdin: io.StringIO | None, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.stdin", stdin)
    assert main(["fit", "--by-hand"]) == 2
    assert "answers: nothing was measured; any of " in capsys.readouterr().err


def test_who_has_had_enough_leaves(monkeypatch: pytest.MonkeyPatch) -> None:
    def stop(_question: str) -> str:
        raise KeyboardInterrupt

    monkeypatch.setattr(fit_by_hand, "_line", stop)
    assert main(["fit", "--by-hand"]) == 130


def test_what_the_knobs_cannot_give_is_told_with_its_line(file: Path, tmp_path: Path, capsys: Capture) -> None:
    file.write_text(FILE.replace("0.58", "0.9"))
    line = refusal(capsys, "fit", "--by-hand", str(file), "--out", str(tmp_path / "out.toml"))
    assert line.startswith(f"pool2d: {file}, line 7: rebound.kept = 0.9: allowed is 0 to 0.")
    assert line.endswith("which is what cushion.restitution from 0 to 1 gives on this table")
    assert not (tmp_path / "out.toml").exists()


def test_measurements_that_contradict_each_other_are_told(file: Path, capsys: Capture) -> None:
    file.write_text("[hard]\nlengths = 3.4\nfirst = 0.5\n[rebound]\nkept = 0.46\n")
    assert main(["fit", "--by-hand", str(file)]) == 0
    assert "times as far apart as their errors" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "wrong"),
    [
        (["--seed", "1"], "--seed = '1': allowed is without --by-hand"),
        (["--make", "x.csv"], "--make = 'x.csv': allowed is without --by-hand"),
        (["--out", ""], "--out = ''"),
        (["--out", "pool-9ft"], "allowed is another name than a shipped preset's"),
        (["--out", "a/b"], "plain file name"),
        (["--table", "nowhere"], "nowhere"),
        (["--set", "cloth.mu_roll=9"], "cloth.mu_roll"),
    ],
)
def test_what_does_not_go_with_it_is_told_before_anything_is_asked(
    words: list[str], wrong: str, capsys: Capture
) -> None:
    assert wrong in refusal(capsys, "fit", "--by-hand", *words)
